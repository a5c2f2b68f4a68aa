#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "tests/support/program.h"
#include "tests/support/source_folder.h"

namespace carom {
namespace {

using Json = nlohmann::json;

std::set<std::string> keys_of(const Json& object) {
  std::set<std::string> keys;
  for (const auto& item : object.items()) keys.insert(item.key());
  return keys;
}

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == at) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

// The lines of a file; every line must end with a line feed.
std::vector<std::string> lines_of(const QByteArray& bytes) {
  std::vector<std::string> lines = split(bytes.toStdString(), '\n');
  EXPECT_EQ(lines.back(), "") << "the last line has no end";
  lines.pop_back();
  return lines;
}

class CommandLine : public testing::Test {
 protected:
  // The JSON of a run that must succeed.
  [[nodiscard]] Json run(const QStringList& arguments) const {
    const ProgramResult result = carom_(QStringList{"run"} + arguments + QStringList{"--json"});
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.err, "");
    return Json::parse(result.out, nullptr, false);
  }
  Program carom_;
};

TEST_F(CommandLine, ListNamesEveryPreset) {
  const ProgramResult result = carom_({"list"});
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.err, "");
  std::set<std::string> listed;
  for (const std::string& line : split(result.out, '\n')) {
    if (line.starts_with("  ")) listed.insert(line.substr(2, line.find(' ', 2) - 2));
  }
  std::set<std::string> there;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(test::source("presets"))) {
    if (entry.path().extension() == ".json") there.insert(entry.path().stem().string());
  }
  EXPECT_FALSE(there.empty());
  EXPECT_EQ(listed, there);
}

TEST_F(CommandLine, HelpAndVersionAreGood) {
  EXPECT_EQ(carom_({"--help"}).code, 0);
  EXPECT_NE(carom_({"--help"}).out.find("picture"), std::string::npos);
  EXPECT_EQ(carom_({"--version"}).code, 0);
}

TEST_F(CommandLine, JsonHasExactlyItsKeys) {
  const Json j = run({"head-on"});
  EXPECT_EQ(keys_of(j), (std::set<std::string>{"preset", "method", "time", "steps", "impacts", "bodies",
                                               "kinetic_energy", "rotational_energy", "potential_energy",
                                               "total_energy", "momentum", "angular_momentum", "ledger",
                                               "status", "order", "evaluations", "rejected_steps"}));
  EXPECT_EQ(keys_of(j["method"]), (std::set<std::string>{"integrator", "impacts", "contacts", "step"}));
  EXPECT_EQ(keys_of(j["ledger"]),
            (std::set<std::string>{"initial", "lost_to_restitution", "lost_to_friction", "lost_to_rolling",
                                   "lost_to_sticking", "lost_to_drag", "lost_to_dampers", "lost_to_links",
                                   "overlap_correction", "put_in_by_drives", "put_in_by_user",
                                   "numerical_drift", "momentum", "angular_momentum"}));
  EXPECT_EQ(keys_of(j["ledger"]["angular_momentum"]), keys_of(j["ledger"]["momentum"]));
  EXPECT_EQ(keys_of(j["ledger"]["momentum"]),
            (std::set<std::string>{"initial", "from_gravity", "from_forces", "from_user", "to_walls",
                                   "numerical_drift"}));
  ASSERT_EQ(j["bodies"].size(), 2U);
  for (const Json& body : j["bodies"]) {
    EXPECT_EQ(keys_of(body), (std::set<std::string>{"name", "position", "angle", "velocity", "spin"}));
  }
}

// 1 kg at 2 m/s meets 2.5 kg at -1 m/s with e = 0.6, 1 m apart: closed forms of the textbook.
TEST_F(CommandLine, JsonHasTheTextbooksNumbers) {
  const Json j = run({"head-on"});
  EXPECT_EQ(j["preset"], "head-on");
  EXPECT_EQ(j["method"],
            (Json{{"integrator", "rk4"}, {"impacts", "located"}, {"contacts", "impulse"}, {"step", 0.005}}));
  EXPECT_DOUBLE_EQ(j["time"].get<double>(), 1.0);
  EXPECT_EQ(j["steps"], 200);
  EXPECT_EQ(j["impacts"], 1);
  EXPECT_EQ(j["status"], "ok");

  const double light = -10.0 / 7.0;
  const double heavy = 13.0 / 35.0;
  const double lost = 72.0 / 35.0;
  const double before = 1.0 / 3.0;  // s until the impact
  const Json& a = j["bodies"][0];
  const Json& b = j["bodies"][1];
  EXPECT_EQ(a["name"], "light");
  EXPECT_EQ(b["name"], "heavy");
  EXPECT_NEAR(a["velocity"][0].get<double>(), light, 1e-12);
  EXPECT_NEAR(b["velocity"][0].get<double>(), heavy, 1e-12);
  EXPECT_NEAR(a["position"][0].get<double>(), -0.6 + 2.0 * before + light * (1.0 - before), 1e-12);
  EXPECT_NEAR(b["position"][0].get<double>(), 0.65 - before + heavy * (1.0 - before), 1e-12);
  for (const Json* body : {&a, &b}) {
    EXPECT_EQ((*body)["velocity"][1], 0.0);
    EXPECT_EQ((*body)["angle"], 0.0);
    EXPECT_EQ((*body)["spin"], 0.0);
  }
  EXPECT_NEAR(j["kinetic_energy"].get<double>(), 3.25 - lost, 1e-12);
  EXPECT_EQ(j["potential_energy"], 0.0);
  EXPECT_NEAR(j["momentum"][0].get<double>(), -0.5, 1e-12);
  EXPECT_EQ(j["momentum"][1], 0.0);
  EXPECT_EQ(j["angular_momentum"], 0.0);
  EXPECT_DOUBLE_EQ(j["ledger"]["initial"].get<double>(), 3.25);
  EXPECT_NEAR(j["ledger"]["lost_to_restitution"].get<double>(), lost, 1e-12);
  EXPECT_EQ(j["ledger"]["lost_to_friction"], 0.0);
  EXPECT_NEAR(j["ledger"]["numerical_drift"].get<double>(), 0.0, 1e-12);
}

TEST_F(CommandLine, TwoRunsGiveTheSameBytes) {
  const auto run_into = [&](const QString& n) {
    return carom_({"run", "drag-projectile", "--json", "--csv", n + ".csv", "--events", n + ".events"});
  };
  const ProgramResult first = run_into("first");
  const ProgramResult second = run_into("second");
  EXPECT_EQ(first.code, 0);
  EXPECT_FALSE(first.out.empty());
  EXPECT_EQ(first.out, second.out);
  for (const char* kind : {".csv", ".events"}) {
    EXPECT_FALSE(carom_.read(QString("first") + kind).isEmpty());
    EXPECT_EQ(carom_.read(QString("first") + kind), carom_.read(QString("second") + kind));
  }
}

TEST_F(CommandLine, OptionsChangeTheMethodAndTheEnd) {
  const Json plain = run({"drag-projectile"});
  const Json euler = run({"drag-projectile", "--integrator", "explicit-euler", "--impacts", "step-end",
                          "--contacts", "impulse", "--step", "0.002", "--until", "0.5"});
  EXPECT_EQ(euler["method"], (Json{{"integrator", "explicit-euler"},
                                   {"impacts", "step-end"},
                                   {"contacts", "impulse"},
                                   {"step", 0.002}}));
  EXPECT_NEAR(euler["time"].get<double>(), 0.5, 1e-12);
  EXPECT_EQ(euler["steps"], 250);
  EXPECT_NEAR(plain["time"].get<double>(), 2.0, 1e-12);
  EXPECT_NE(run({"drag-projectile", "--integrator", "semi-implicit-euler"})["bodies"], plain["bodies"]);
  EXPECT_EQ(run({"head-on", "--until", "0"})["steps"], 0);
}

// The ledger balances energy and momentum.
TEST_F(CommandLine, LedgerClosesInJson) {
  const Json j = run({"drag-projectile"});
  const Json& l = j["ledger"];
  const auto joules = [&](const char* key) { return l[key].get<double>(); };
  EXPECT_GT(joules("lost_to_restitution"), 0.1);
  EXPECT_GT(joules("lost_to_drag"), 0.1);
  EXPECT_NEAR(joules("initial") - joules("lost_to_restitution") - joules("lost_to_friction") -
                  joules("lost_to_rolling") - joules("lost_to_sticking") - joules("lost_to_drag") -
                  joules("lost_to_dampers") - joules("lost_to_links") + joules("overlap_correction") +
                  joules("put_in_by_drives") + joules("put_in_by_user") + joules("numerical_drift"),
              j["total_energy"].get<double>(), 1e-12);
  for (int i = 0; i < 2; ++i) {
    const auto share = [&](const char* key) { return l["momentum"][key][i].get<double>(); };
    EXPECT_GT(std::abs(share("to_walls")), 1.0);
    EXPECT_NEAR(share("initial") + share("from_gravity") + share("from_forces") + share("from_user") -
                    share("to_walls") + share("numerical_drift"),
                j["momentum"][i].get<double>(), 1e-12);
  }
}

TEST_F(CommandLine, CostOfTheMethodIsPrinted) {
  const Json rk4 = run({"spring-box", "--impacts", "step-end"});
  EXPECT_EQ(rk4["order"], 4);
  EXPECT_EQ(rk4["evaluations"], 4 * rk4["steps"].get<int>());
  EXPECT_EQ(rk4["rejected_steps"], 0);
  const Json adaptive = run({"spring-box", "--integrator", "dormand-prince-adaptive", "--tolerance", "1e-6"});
  EXPECT_EQ(adaptive["method"], (Json{{"integrator", "dormand-prince-adaptive"},
                                      {"impacts", "located"},
                                      {"contacts", "impulse"},
                                      {"tolerance", 1e-6}}));
  EXPECT_EQ(adaptive["order"], 5);
  EXPECT_GT(
      run({"spring-box", "--integrator", "dormand-prince-adaptive", "--tolerance", "1e-12"})["evaluations"],
      adaptive["evaluations"]);
  EXPECT_EQ(run({"head-on", "--integrator", "exact-flight"})["order"], 0);

  const auto text = [this](const QStringList& arguments) {
    return carom_(QStringList{"run", "head-on"} + arguments).out;
  };
  EXPECT_NE(text({}).find("order 4, "), std::string::npos);
  EXPECT_NE(text({}).find(" evaluations of a body's acceleration, 0 rejected steps\n"), std::string::npos);
  EXPECT_NE(text({"--integrator", "dormand-prince-adaptive"}).find("tolerance 1e-09\n"), std::string::npos);
  EXPECT_NE(text({"--integrator", "exact-flight"}).find("results every 0.005 s\nexact, "), std::string::npos);
}

TEST_F(CommandLine, TextShowsBeforeAndAfter) {
  const ProgramResult result = carom_({"run", "head-on"});
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.err, "");
  for (const char* part : {"-1.42857", "0.371429", "1 impact\n", "2.05714", "status: ok"}) {
    EXPECT_NE(result.out.find(part), std::string::npos) << part;
  }
}

TEST_F(CommandLine, CsvHasUnitsALineAStepAndAllDigits) {
  const Json j = run({"drag-projectile", "--csv", "run.csv"});
  const std::vector<std::string> lines = lines_of(carom_.read("run.csv"));
  ASSERT_EQ(lines.size(), 2U + j["steps"].get<std::size_t>());  // header, start, steps
  const std::vector<std::string> names = split(lines[0], ',');
  for (const std::string& name : names) {
    EXPECT_TRUE(name.ends_with(']') && name.find(" [") != std::string::npos) << name;
  }
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::vector<std::string> fields = split(lines[i], ',');
    ASSERT_EQ(fields.size(), names.size()) << lines[i];
    for (const std::string& field : fields) {
      char* end = nullptr;
      const double value = std::strtod(field.c_str(), &end);
      ASSERT_EQ(*end, '\0') << field;
      ASSERT_EQ(fmt::format("{}", value), field);
    }
  }
  // The last line equals the JSON's state to the last bit.
  std::map<std::string, double> last;
  const std::vector<std::string> fields = split(lines.back(), ',');
  for (std::size_t i = 0; i < names.size(); ++i) last[names[i]] = std::strtod(fields[i].c_str(), nullptr);
  EXPECT_EQ(last.at("time [s]"), j["time"].get<double>());
  EXPECT_EQ(last.at("kinetic_energy [J]"), j["kinetic_energy"].get<double>());
  EXPECT_EQ(last.at("momentum_y [N s]"), j["momentum"][1].get<double>());
  EXPECT_EQ(last.at("numerical_drift [J]"), j["ledger"]["numerical_drift"].get<double>());
  for (const char* key :
       {"lost_to_restitution", "lost_to_friction", "lost_to_rolling", "lost_to_sticking", "lost_to_drag",
        "lost_to_dampers", "lost_to_links", "put_in_by_drives", "put_in_by_user", "overlap_correction"}) {
    EXPECT_EQ(last.at(std::string(key) + " [J]"), j["ledger"][key].get<double>()) << key;
  }
  const Json& momentum = j["ledger"]["momentum"];
  EXPECT_EQ(last.at("momentum_drift_x [N s]"), momentum["numerical_drift"][0].get<double>());
  EXPECT_EQ(last.at("momentum_to_walls_y [N s]"), momentum["to_walls"][1].get<double>());
  const Json& angular = j["ledger"]["angular_momentum"];
  EXPECT_EQ(last.at("angular_momentum_drift [kg m^2/s]"), angular["numerical_drift"].get<double>());
  for (const char* key : {"from_gravity", "from_forces", "from_user", "to_walls"}) {
    EXPECT_EQ(last.at(fmt::format("angular_momentum_{} [kg m^2/s]", key)), angular[key].get<double>()) << key;
  }
  bool found = false;
  for (const Json& body : j["bodies"]) {
    if (body["name"] != "disc") continue;
    found = true;
    EXPECT_EQ(last.at("disc x [m]"), body["position"][0].get<double>());
    EXPECT_EQ(last.at("disc velocity_y [m/s]"), body["velocity"][1].get<double>());
    EXPECT_EQ(last.at("disc angle [rad]"), body["angle"].get<double>());
    EXPECT_EQ(last.at("disc spin [rad/s]"), body["spin"].get<double>());
  }
  EXPECT_TRUE(found);
  EXPECT_EQ(carom_.files(), QStringList{"run.csv"});
}

TEST_F(CommandLine, EventsHaveALineAnImpact) {
  const Json j = run({"bouncing-ball", "--events", "events.csv"});
  const std::vector<std::string> lines = lines_of(carom_.read("events.csv"));
  ASSERT_GT(j["impacts"], 10);
  ASSERT_EQ(lines.size(), 1U + j["impacts"].get<std::size_t>());
  EXPECT_TRUE(lines[0].starts_with("time [s],body_a,body_b,point_x [m],"));
  // The ball falls 1 m: t = sqrt(2h/g).
  EXPECT_NEAR(std::strtod(lines[1].c_str(), nullptr), std::sqrt(2.0 / 9.81), 1e-12);
  double before = 0.0;
  double lost = 0.0;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::vector<std::string> fields = split(lines[i], ',');
    ASSERT_EQ(fields.size(), split(lines[0], ',').size());
    EXPECT_EQ((std::set<std::string>{fields[1], fields[2]}), (std::set<std::string>{"ball", "floor"}));
    const double time = std::strtod(fields[0].c_str(), nullptr);
    EXPECT_GE(time, before);
    before = time;
    lost += std::strtod(fields[10].c_str(), nullptr);
  }
  EXPECT_NEAR(lost, j["ledger"]["lost_to_restitution"].get<double>(), 1e-9);
}

TEST_F(CommandLine, NothingIsMinusZero) {
  for (const char* impacts : {"step-end", "located"}) {
    (void)run({"head-on", "--impacts", impacts, "--events", "events.csv"});
    const std::vector<std::string> lines = lines_of(carom_.read("events.csv"));
    ASSERT_EQ(lines.size(), 2U);
    for (const std::string& field : split(lines[1], ',')) EXPECT_NE(field, "-0");
  }
}

TEST_F(CommandLine, NamesWithCommasAreQuotedInCsv) {
  carom_.write("odd.json",
               R"({"format": "carom-preset", "version": 1, "title": "t", "duration": 0.01, "bodies": [
      {"name": "a, \"b\"", "shape": {"type": "disc", "radius": 1}, "position": [0, 0]}]})");
  EXPECT_EQ(carom_({"run", "odd.json", "--csv", "odd.csv"}).code, 0);
  EXPECT_NE(lines_of(carom_.read("odd.csv"))[0].find(R"(,"a, ""b"" x [m]",)"), std::string::npos);
}

TEST_F(CommandLine, SavedEndRunsOn) {
  const Json end = run({"head-on", "--save", "end.json"});
  const auto until = [&](double after) { return QString::number(end["time"].get<double>() + after, 'g', 17); };
  const Json again = run({"end.json", "--until", until(0.0)});
  EXPECT_EQ(again["preset"], "end");
  EXPECT_EQ(again["bodies"], end["bodies"]);
  // The clock continues.
  const Json on = run({"./end.json", "--until", until(0.7)});
  EXPECT_EQ(on["impacts"], end["impacts"]);
  EXPECT_NEAR(on["bodies"][1]["position"][0].get<double>(),
              end["bodies"][1]["position"][0].get<double>() + 0.7 * 13.0 / 35.0, 1e-12);
}

// A time that has passed is no end of a saved run, and no moment of it.
TEST_F(CommandLine, TimesBeforeASavedRunAreRefused) {
  (void)run({"head-on", "--until", "0.5", "--save", "mid.json"});
  const QStringList files = carom_.files();
  const auto expect_passed = [&](const QStringList& arguments, const std::string& option) {
    expect_refused(carom_(arguments),
                   "mid.json: the run is already at t = 0.5 s; allowed: " + option + " from 0.5 on");
  };
  expect_passed({"run", "mid.json", "--until", "0.1"}, "--until");
  expect_passed({"picture", "mid.json", "--at", "0.1", "-o", "a.png"}, "--at");
  expect_passed({"film", "mid.json", "--from", "0.1", "--to", "0.6", "-o", "film"}, "--from");
  expect_passed({"study", "mid.json", "--until", "0.1"}, "--until");
  expect_refused(carom_({"study", "mid.json", "--until", "0.5"}), "allowed: a time above 0.5");
  EXPECT_EQ(carom_.files(), files);
  EXPECT_FALSE(QDir(carom_.path("film")).exists());

  // Its start is one, and a film begins there.
  EXPECT_EQ(carom_({"picture", "mid.json", "--at", "0.5", "-o", "a.png"}).code, 0);
  EXPECT_EQ(carom_({"film", "mid.json", "--to", "0.7", "--rate", "10", "--width", "320", "--height", "240",
                    "-o", "film"})
                .code,
            0);
  EXPECT_EQ(QDir(carom_.path("film")).entryList(QDir::Files).size(), 3);
}

TEST_F(CommandLine, SavedPileHasAllItsBodies) {
  const Json end = run({"pile", "--until", "0.02", "--save", "end.json"});
  const Json again = run({"end.json", "--until", QString::number(end["time"].get<double>(), 'g', 17)});
  EXPECT_GT(end["bodies"].size(), 10U);
  EXPECT_EQ(again["bodies"], end["bodies"]);
}

}  // namespace
}  // namespace carom
