#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/program.h"

// `run --stop` and the stops of a preset.
namespace carom {
namespace {

using Json = nlohmann::json;

// A ball falls 1 m onto a floor; `more` are keys of the preset.
QByteArray preset(const char* more = "") {
  return QByteArray(R"({"format": "carom-preset", "version": 1, "title": "t", "gravity": [0, -9.81],
    "materials": [{"name": "default", "restitution": 0.8}], "bodies": [
      {"name": "floor", "shape": {"type": "wall"}, "position": [0, 0], "fixed": true},
      {"name": "ball", "shape": {"type": "disc", "radius": 0.1}, "position": [0, 1.1], "mass": 1}])") +
         more + "}";
}

const double kFall = std::sqrt(2.0 / 9.81);  // s

class CommandStop : public testing::Test {
 protected:
  [[nodiscard]] Json run(const QStringList& arguments) const {
    const ProgramResult result = carom_(QStringList{"run", "a.json", "--json"} + arguments);
    EXPECT_EQ(result.code, 0) << result.err;
    return Json::parse(result.out, nullptr, false);
  }
  Program carom_;
};

TEST_F(CommandStop, EndsTheRunAtTheFirstOfTheSentences) {
  carom_.write("a.json", preset());
  const Json end = run({"--stop", "when ball passes y = 0.5 m downwards", "--stop", "at the 1st impact"});
  EXPECT_EQ(end["stopped"], "when ball passes y = 0.5 m downwards");
  EXPECT_NEAR(end["time"], std::sqrt(1.2 / 9.81), 1e-13);
  EXPECT_NEAR(end["bodies"][1]["position"][1], 0.5, 1e-13);
  const Json impact = run({"--stop", "at the 2nd impact of ball with a wall"});
  EXPECT_NEAR(impact["time"], 2.6 * kFall, 1e-13);
  EXPECT_EQ(impact["impacts"], 2);
  const Json never = run({"--stop", "at the 99th impact", "--until", "0.7"});
  EXPECT_TRUE(never["stopped"].is_null());
  EXPECT_NEAR(never["time"], 0.7, 1e-15);
  EXPECT_FALSE(run({}).contains("stopped"));
}

TEST_F(CommandStop, SaysSoAndWritesThatMoment) {
  carom_.write("a.json", preset(R"(, "stop": [{"type": "impact", "number": 1}])"));
  const ProgramResult result =
      carom_({"run", "a.json", "--csv", "a.csv", "--events", "e.csv", "--save", "mid.json"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.out.find("\nstopped at the 1st impact\n"), std::string::npos) << result.out;
  const QList<QByteArray> rows = carom_.read("a.csv").trimmed().split('\n');
  EXPECT_NEAR(rows.back().split(',').front().toDouble(), kFall, 1e-13);
  EXPECT_EQ(carom_.read("e.csv").trimmed().split('\n').size(), 2);
  EXPECT_NEAR(Json::parse(carom_.read("mid.json").toStdString())["state"]["time"], kFall, 1e-13);
  // A run that goes on counts anew.
  const ProgramResult on = carom_({"run", "mid.json", "--json"});
  EXPECT_NEAR(Json::parse(on.out)["time"], 2.6 * kFall, 1e-12);
  const ProgramResult before = carom_({"run", "a.json", "--until", "0.1"});
  EXPECT_NE(before.out.find("\nnone of its stops came\n"), std::string::npos) << before.out;
}

TEST_F(CommandStop, RefusesWhatIsNoSentenceOrNamesNobody) {
  carom_.write("a.json", preset());
  expect_refused(carom_({"run", "a.json", "--stop", "at noon"}),
                 "--stop: \"at noon\" is not allowed; allowed: \"at 2.5 s\", \"at the 3rd impact\"");
  expect_refused(carom_({"run", "a.json", "--stop", "at every impact of bal"}),
                 "--stop/body: \"bal\" is not allowed; allowed: the name of a body");
  expect_refused(carom_({"run", "a.json", "--stop", "at every impact of ball with ball"}),
                 "--stop/with: \"ball\" again is not allowed; allowed: another body");
  carom_.write("b.json",
               preset(R"(, "stop": [{"type": "rest"}, {"type": "passing", "body": "b", "value": 1}])"));
  expect_refused(carom_({"run", "b.json"}), "b.json: /stop/1/body: \"b\" is not allowed");
}

}  // namespace
}  // namespace carom
