#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

#include "physics/measure/observables.h"
#include "physics/motion/integrators.h"
#include "physics/preset/check.h"
#include "physics/preset/names.h"
#include "physics/preset/preset.h"
#include "physics/preset/setting.h"
#include "tests/physics/scenes.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> preset_files() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(CAROM_PRESET_DIR)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string content(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

// Characters, not bytes.
std::size_t length(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

// A folder of its own for a test, gone afterwards.
class PresetFiles : public testing::Test {
 protected:
  PresetFiles()
      : folder_(fs::path(testing::TempDir()) /
                (std::string("carom-") + testing::UnitTest::GetInstance()->current_test_info()->name())) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~PresetFiles() override { fs::remove_all(folder_); }
  fs::path folder_;
};

TEST(Presets, MeetTheirExpectations) {
  ASSERT_GE(preset_files().size(), 24U);
  for (const fs::path& file : preset_files()) {
    const Scene s = read_preset(file);
    EXPECT_FALSE(s.expect.empty()) << file;
    const std::vector<Outcome> outcomes = check_expectations(s);
    ASSERT_EQ(outcomes.size(), s.expect.size());
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      EXPECT_TRUE(outcomes[i].good) << file << " /expect/" << i << " " << s.expect[i].observable
                                    << ": measured " << outcomes[i].measured << ", expected "
                                    << s.expect[i].value;
      EXPECT_FALSE(s.expect[i].source.empty()) << file;
    }
  }
}

TEST(Presets, AreWrittenForPeople) {
  for (const fs::path& file : preset_files()) {
    const Scene s = read_preset(file);
    EXPECT_GE(length(s.title), 4U) << file;
    EXPECT_LE(length(s.title), 30U) << file;
    EXPECT_GE(length(s.observe), 4U) << file;
    EXPECT_LE(length(s.observe), 34U) << file;
    EXPECT_GE(length(s.about), 200U) << file;
    EXPECT_FALSE(s.plots.empty()) << file;
    EXPECT_TRUE(s.view.has_value()) << file;
    EXPECT_EQ(s.topic, file.parent_path().filename().string());
  }
}

TEST_F(PresetFiles, LoadingWhatWasSavedGivesTheSameScene) {
  std::vector<Scene> scenes;
  for (const fs::path& file : preset_files()) scenes.push_back(read_preset(file));
  Scene odd = test::scene({test::disc("a \"quoted\", näme: \\", {0.1, 1.0 / 3.0}, {1e-300, -0.0})}, 0.1, 0.2);
  odd.bodies[0].angle = 1e-17;
  odd.extra = R"({"kept":[1,{"as":"it is, : \" "}],"x":null})";
  odd.view = View{{0.1, 0.2}, 3.0};
  scenes.push_back(odd);
  for (const Scene& s : scenes) {
    const std::string text = write_preset(s);
    EXPECT_EQ(write_preset(parse_preset(text, "again")), text);
    save_preset(s, folder_ / "saved.json");
    const Scene again = read_preset(folder_ / "saved.json");
    EXPECT_EQ(write_preset(again), text);
    EXPECT_EQ(again.extra, s.extra);
    ASSERT_EQ(again.bodies.size(), s.bodies.size());
    for (std::size_t i = 0; i < s.bodies.size(); ++i) {
      EXPECT_EQ(again.bodies[i].name, s.bodies[i].name);
      EXPECT_EQ(again.bodies[i].position, s.bodies[i].position);
      EXPECT_EQ(again.bodies[i].velocity, s.bodies[i].velocity);
      EXPECT_EQ(again.bodies[i].angle, s.bodies[i].angle);
      EXPECT_EQ(again.bodies[i].mass, s.bodies[i].mass);
    }
    Simulation one(s);
    Simulation two(again);
    for (int i = 0; i < 20; ++i) {
      one.step();
      two.step();
    }
    EXPECT_TRUE(test::same_bytes(one.state(), two.state())) << s.title;
  }
}

// A scene with every key that a preset can have, none at its default.
constexpr const char* kEveryKey = R"({
  "format": "carom-preset", "version": 1, "title": "all", "about": "about", "observe": "look", "duration": 2,
  "gravity": [0.5, -9.81], "method": {"integrator": "explicit-euler", "impacts": "step-end", "step": 0.01},
  "materials": [{"name": "m", "restitution": 0.5, "tangential_restitution": 0.25, "static_friction": 0.5,
                 "kinetic_friction": 0.25}],
  "bodies": [
    {"name": "a", "shape": {"type": "disc", "radius": 1}, "position": [0, 0], "angle": 1, "velocity": [1, 2],
     "spin": 3, "mass": 4, "material": "m"},
    {"name": "b", "shape": {"type": "disc", "radius": 1}, "position": [9, 0], "density": 5},
    {"name": "piston", "shape": {"type": "box", "width": 1, "height": 2}, "position": [-9, 0], "angle": 0.5,
     "drive": {"velocity": [1, 2], "amplitude": [3, 4], "angular_frequency": 5, "phase": -6}},
    {"name": "w", "shape": {"type": "box", "width": 1, "height": 2}, "position": [-9, 9], "fixed": true}],
  "forces": [
    {"type": "force", "body": "a", "force": [1, 2], "torque": 3, "start": 4, "rise": 5, "end": 6},
    {"type": "spring", "name": "s", "body": "a", "to": "piston", "stiffness": 1, "damping": 2, "rest_length": 3,
     "acts": "while-short"},
    {"type": "attraction", "constant": 1, "softening": 2},
    {"type": "quadratic_drag", "coefficient": 0.5},
    {"type": "spring", "body": "b", "anchor": [1, 2], "stiffness": 7, "acts": "push"},
    {"type": "spring", "body": "b", "to": "a", "stiffness": 8, "acts": "pull"},
    {"type": "linear_drag", "coefficient": 0.25},
    {"type": "force", "body": "b"}],
  "generators": [{"type": "grid", "name": "g", "columns": 2, "rows": 3, "origin": [20, 20], "spacing": [3, 4],
                  "jitter": 0.5, "radius": [0.1, 0.2], "speed": 1, "density": 2, "material": "m", "seed": 7}],
  "plots": ["energy"], "view": {"center": [1, 2], "width": 3},
  "expect": [
    {"observable": "speed", "bodies": ["a"], "reduction": "count", "above": 1.5, "from": 0.5, "until": 1.5,
     "with": {"/bodies/0/mass": 100, "/forces/4/stiffness": 9},
     "over": {"place": "/generators/0/seed", "values": [3, 1, 2], "reduction": "mean"},
     "value": 0.5, "tolerance": 0.1, "source": "made up"},
    {"observable": "time", "reduction": "fit", "value": 1, "tolerance": 0},
    {"observable": "time", "reduction": "impact", "impact": 3, "until": 7, "value": 1, "tolerance": 0,
     "over": {"place": "/forces/6/coefficient", "values": [1, 2, 4], "reduction": "exponent"}}]
})";

void expect_every_key(const Scene& s) {
  const Body& piston = s.bodies[2];
  ASSERT_TRUE(piston.drive.has_value());
  EXPECT_EQ(piston.drive->velocity, Vec2(1, 2));
  EXPECT_EQ(piston.drive->amplitude, Vec2(3, 4));
  EXPECT_EQ(piston.drive->angular_frequency, 5);
  EXPECT_EQ(piston.drive->phase, -6);
  EXPECT_TRUE(is_immovable(piston));
  const Forces& f = s.forces;
  EXPECT_EQ(f.linear_drag, 0.25);
  EXPECT_EQ(f.quadratic_drag, 0.5);
  ASSERT_TRUE(f.attraction.has_value());
  EXPECT_EQ(f.attraction->constant, 1);
  EXPECT_EQ(f.attraction->softening, 2);
  ASSERT_EQ(f.springs.size(), 3U);
  EXPECT_EQ(f.springs[0].name, "s");
  EXPECT_EQ(f.springs[0].to, "piston");
  EXPECT_EQ(f.springs[0].damping, 2);
  EXPECT_EQ(f.springs[0].rest_length, 3);
  EXPECT_EQ(f.springs[0].acts, SpringActs::kWhileShort);
  EXPECT_EQ(f.springs[1].anchor, Vec2(1, 2));
  EXPECT_EQ(f.springs[1].acts, SpringActs::kPush);
  EXPECT_EQ(f.springs[2].acts, SpringActs::kPull);
  ASSERT_EQ(f.applied.size(), 2U);
  EXPECT_EQ(f.applied[0].force, Vec2(1, 2));
  EXPECT_EQ(f.applied[0].torque, 3);
  EXPECT_EQ(f.applied[0].start, 4);
  EXPECT_EQ(f.applied[0].rise, 5);
  EXPECT_EQ(f.applied[0].end, 6);
  EXPECT_EQ(f.applied[1].end, std::nullopt);

  ASSERT_EQ(s.expect.size(), 3U);
  const Expectation& e = s.expect[0];
  EXPECT_EQ(e.reduction, Expectation::Reduction::kCount);
  EXPECT_EQ(e.above, 1.5);
  EXPECT_EQ(e.from, 0.5);
  EXPECT_EQ(e.until, 1.5);
  ASSERT_EQ(e.settings.size(), 2U);
  EXPECT_EQ(e.settings[0].place, "/bodies/0/mass");
  EXPECT_EQ(e.settings[0].value, 100);
  ASSERT_TRUE(e.over.has_value());
  EXPECT_EQ(e.over->values, (std::vector<double>{3, 1, 2}));
  EXPECT_EQ(e.over->reduction, Sweep::Reduction::kMean);
  EXPECT_EQ(s.expect[1].reduction, Expectation::Reduction::kFit);
  EXPECT_EQ(s.expect[2].over->reduction, Sweep::Reduction::kExponent);
}

TEST(Preset, EveryKeyIsReadAndWritten) {
  const Scene s = parse_preset(kEveryKey, "every.json");
  expect_every_key(s);
  const std::string text = write_preset(s);
  const Scene again = parse_preset(text, "again");
  expect_every_key(again);
  EXPECT_EQ(write_preset(again), text);
}

TEST(Preset, DefaultsAreLeftOut) {
  Scene s = test::scene({test::disc("a", {0, 0}, {0, 0}), test::disc("b", {9, 0}, {0, 0})});
  s.bodies.push_back(test::wall("table", {0, -9}, 1, 1));
  s.bodies.back().fixed = false;
  s.bodies.back().drive = Drive{};
  s.forces.springs.resize(1);
  s.forces.springs[0].body = "a";
  s.forces.springs[0].to = "b";
  s.forces.applied.resize(1);
  s.forces.applied[0].body = "a";
  const std::string text = write_preset(s);
  EXPECT_NE(text.find(R"({"type": "spring", "body": "a", "to": "b", "stiffness": 1.0})"), std::string::npos)
      << text;
  EXPECT_NE(text.find(R"({"type": "force", "body": "a"})"), std::string::npos) << text;
  EXPECT_NE(text.find(R"("drive": {})"), std::string::npos) << text;
  EXPECT_EQ(text.find("\"tolerance\""), std::string::npos) << text;
  s.method.integrator = IntegratorId::kAdaptiveDormandPrince;
  EXPECT_NE(write_preset(s).find("\"tolerance\": 1e-09"), std::string::npos) << write_preset(s);
}

// Places of forces are those of the file, also where Carom writes them in another order.
TEST(Preset, VariantsChangeTheNumberThatTheFileNames) {
  const Scene s = parse_preset(kEveryKey, "every.json");
  Scene v = variant(s, s.expect[0].settings);
  EXPECT_EQ(v.bodies[0].mass, 100);
  EXPECT_EQ(v.forces.springs[1].stiffness, 9);
  EXPECT_EQ(v.forces.springs[0].stiffness, 1);
  EXPECT_TRUE(v.expect.empty());
  v = variant(s, {{s.expect[2].over->place, 3.5}});
  EXPECT_EQ(v.forces.linear_drag, 3.5);
  // Again after a file that Carom wrote.
  const Scene again = parse_preset(write_preset(s), "again");
  EXPECT_EQ(variant(again, again.expect[0].settings).forces.springs[1].stiffness, 9);

  // What a file leaves out has its place too, and whole numbers stay whole.
  v = variant(s, {{"/bodies/1/angle", 2.0}, {"/bodies/1/velocity/1", 3.0}, {"/generators/0/seed", 11}});
  EXPECT_EQ(v.bodies[1].angle, 2.0);
  EXPECT_EQ(v.bodies[1].velocity, Vec2(0, 3));
  EXPECT_EQ(v.generators[0].seed, 11U);
  EXPECT_EQ(variant(s, {{"/method/tolerance", 1e-6}}).method.tolerance, 1e-6);
  EXPECT_THROW((void)variant(s, {{"/bodies/0/name", 1}}), SceneError);
  EXPECT_THROW((void)variant(s, {{"/bodies/0/mass", -1}}), SceneError);
  EXPECT_THROW((void)variant(s, {{"/generators/0/seed", 1.5}}), SceneError);
}

TEST(Preset, ExactFlightIsRefusedWhereItIsNotPossible) {
  Scene s = test::scene({test::disc("a", {0, 0}, {0, 0})});
  s.method.integrator = IntegratorId::kExactFlight;
  validate(s);
  s.forces.linear_drag = 1.0;
  try {
    validate(s);
    ADD_FAILURE() << "accepted";
  } catch (const SceneError& error) {
    EXPECT_EQ(std::string(error.what())
                  .rfind("/method/integrator: exact flight is not possible with drag; allowed: ", 0),
              0U)
        << error.what();
  }
}

TEST_F(PresetFiles, AFailedSaveLeavesTheOldFile) {
  const Scene s = test::scene({test::disc("a", {0, 0}, {1, 0})});
  const fs::path file = folder_ / "old.json";
  save_preset(s, file);
  const std::string before = content(file);
  // The place for the new file is taken by a folder, so it cannot be written.
  fs::create_directories(folder_ / "old.json.part" / "x");
  EXPECT_THROW(save_preset(Scene(), file), SceneError);
  EXPECT_EQ(content(file), before);
  EXPECT_THROW(save_preset(s, folder_ / "no such folder" / "a.json"), SceneError);
  EXPECT_THROW(save_preset(s, folder_), SceneError);
  EXPECT_FALSE(fs::exists(folder_.string() + ".part"));
}

// The reference for people names every word that a file can hold, and its example is a good preset.
TEST(PresetHelp, NamesEveryWordAndItsExampleIsMet) {
  const std::string page = content(fs::path(CAROM_PRESET_DIR) / "../app/help/presets.md");
  const auto expect_word = [&](std::string_view word) {
    EXPECT_NE(page.find("`" + std::string(word) + "`"), std::string::npos) << word;
  };
  for (const Observable& o : observables()) expect_word(o.name);
  for (const auto& [id, name] : kReductionNames) expect_word(name);
  for (const auto& [id, name] : kSweepNames) expect_word(name);
  for (const auto& [id, name] : kSpringActsNames) expect_word(name);
  for (const auto& choice : kIntegrators) expect_word(choice.name);
  for (const auto& choice : kImpacts) expect_word(choice.name);
  for (const auto& choice : kContacts) expect_word(choice.name);

  const std::size_t from = page.find("```json\n") + 8;
  const Scene s = parse_preset(page.substr(from, page.find("```", from) - from), "presets.md");
  ASSERT_EQ(s.expect.size(), 1U);
  EXPECT_TRUE(check_expectations(s)[0].good) << check_expectations(s)[0].measured;
}

struct Bad {
  std::string what;
  std::string text;
  std::string place;  // must stand in the message
};

std::string repeated(const std::string& part, std::size_t bytes) {
  std::string text;
  text.reserve(bytes + part.size());
  while (text.size() < bytes) text += part;
  return text;
}

std::vector<Bad> bad_presets() {
  const std::string head = R"({"format": "carom-preset", "version": 1, "title": "t")";
  const auto with = [&](const std::string& more) { return head + ", " + more + "}"; };
  const auto body = [&](const std::string& more) {
    return with(R"("bodies": [{"name": "a", "shape": {"type": "disc", "radius": 0.1}, "position": [0, 0])" +
                more + "}]");
  };
  const auto forces = [&](const std::string& list) {
    return with(R"("bodies": [{"name": "a", "shape": {"type": "disc", "radius": 1}, "position": [0, 0]},
        {"name": "b", "shape": {"type": "disc", "radius": 1}, "position": [9, 0]},
        {"name": "w", "shape": {"type": "disc", "radius": 1}, "position": [0, 9], "fixed": true}],
        "forces": [)" +
                list + "]");
  };
  const auto expect = [&](const std::string& more) {
    return with(R"("expect": [{"observable": "time", "value": 0, "tolerance": 0, )" + more + "}]");
  };
  return {
      {"empty", "", "line 1"},
      {"not JSON", "hello\nworld", "line 1"},
      {"truncated", head + R"(, "bodies": [{"na)", "line 1"},
      {"an array", "[]", "/"},
      {"null", "null", "/"},
      {"no format", R"({"version": 1, "title": "t"})", "format"},
      {"another format", R"({"format": "x", "version": 1, "title": "t"})", "/format"},
      {"newer version", R"({"format": "carom-preset", "version": 2, "title": "t"})", "newer"},
      {"version 0", R"({"format": "carom-preset", "version": 0, "title": "t"})", "/version"},
      {"version 1.5", R"({"format": "carom-preset", "version": 1.5, "title": "t"})", "/version"},
      {"huge version", R"({"format": "carom-preset", "version": 18446744073709551615, "title": "t"})", "newer"},
      {"unknown key", with(R"("gravitation": [0, 0])"), "/gravitation"},
      {"unknown key inside", body(R"(, "colour": "red")"), "/bodies/0/colour"},
      {"duplicate key", with(R"("title": "u")"), "/title"},
      {"duplicate key inside", body(R"(, "mass": 1, "mass": 2)"), "/bodies/0/mass"},
      {"negative mass", body(R"(, "mass": -1)"), "/bodies/0/mass"},
      {"mass 0", body(R"(, "mass": 0)"), "/bodies/0/mass"},
      {"NaN", body(R"(, "mass": NaN)"), "line 1"},
      {"1e999", body(R"(, "mass": 1e999)"), "too large"},
      {"-1e999", body(R"(, "spin": -1e999)"), "too large"},
      {"1e300", body(R"(, "spin": 1e300)"), "/bodies/0/spin"},
      {"text for a number", body(R"(, "mass": "1")"), "/bodies/0/mass"},
      {"number for a text", body(R"(, "material": 1)"), "/bodies/0/material"},
      {"three coordinates", body(R"(, "velocity": [1, 2, 3])"), "/bodies/0/velocity"},
      {"mass and density", body(R"(, "mass": 1, "density": 1)"), "/bodies/0/density"},
      {"unknown material", body(R"(, "material": "cheese")"), "/bodies/0/material"},
      {"one name twice",
       with(R"("bodies": [{"name": "a", "shape": {"type": "disc", "radius": 1}, "position": [0, 0]},
            {"name": "a", "shape": {"type": "disc", "radius": 1}, "position": [9, 0]}])"),
       "/bodies/1/name"},
      {"a moving box",
       with(
           R"("bodies": [{"name": "a", "shape": {"type": "box", "width": 1, "height": 1}, "position": [0, 0]}])"),
       "/bodies/0/fixed"},
      {"a moving fixed body", body(R"(, "fixed": true, "velocity": [1, 0])"), "/bodies/0/velocity"},
      {"no radius", with(R"("bodies": [{"name": "a", "shape": {"type": "disc"}, "position": [0, 0]}])"),
       "/bodies/0/shape"},
      {"unknown shape", with(R"("bodies": [{"name": "a", "shape": {"type": "star"}, "position": [0, 0]}])"),
       "/bodies/0/shape/type"},
      {"spring of nobody",
       with(R"("forces": [{"type": "spring", "body": "b", "anchor": [0, 0], "stiffness": 1}])"), "\"b\""},
      {"unknown force", with(R"("forces": [{"type": "magic"}])"), "/forces/0/type"},
      {"restitution 2", with(R"("materials": [{"name": "m", "restitution": 2}])"), "/materials/0/restitution"},
      {"static below kinetic",
       with(R"("materials": [{"name": "m", "kinetic_friction": 0.5, "static_friction": 0.2}])"),
       "/materials/0/static_friction"},
      {"step 0", with(R"("method": {"step": 0})"), "/method/step"},
      {"unknown integrator", with(R"("method": {"integrator": "rk5"})"), "/method/integrator"},
      {"duration 0", with(R"("duration": 0)"), "/duration"},
      {"unknown plot", with(R"("plots": ["heat"])"), "/plots/0"},
      {"unknown observable",
       with(R"("expect": [{"observable": "luck", "reduction": "final", "value": 1, "tolerance": 0}])"),
       "/expect/0/observable"},
      {"too few bodies",
       with(R"("expect": [{"observable": "x", "reduction": "final", "value": 1, "tolerance": 0}])"),
       "/expect/0/bodies"},
      {"unknown body",
       with(
           R"("expect": [{"observable": "x", "bodies": ["z"], "reduction": "final", "value": 1, "tolerance": 0}])"),
       "/expect/0/bodies/0"},
      {"a billion bodies", with(R"("generators": [{"type": "grid", "columns": 100000, "rows": 10000}])"),
       "/generators/0"},
      {"generator repeats a name",
       with(R"("generators": [{"type": "grid", "name": "g"}, {"type": "grid", "name": "g"}])"), "/generators"},
      {"seed -1",
       with(
           R"("generators": [{"type": "grid", "name": "g", "origin": [0, 0], "spacing": [1, 1], "radius": [0.1, 0.1], "seed": -1}])"),
       "/generators/0/seed"},
      {"drive of a fixed body", body(R"(, "fixed": true, "drive": {"velocity": [1, 0]})"), "/bodies/0/fixed"},
      {"drive and velocity", body(R"(, "velocity": [1, 0], "drive": {})"), "/bodies/0/velocity"},
      {"drive and spin", body(R"(, "spin": 1, "drive": {})"), "/bodies/0/spin"},
      {"drive and mass", body(R"(, "mass": 1, "drive": {})"), "/bodies/0/mass"},
      {"drive and density", body(R"(, "density": 1, "drive": {})"), "/bodies/0/density"},
      {"drive backwards", body(R"(, "drive": {"angular_frequency": -1})"), "/bodies/0/drive/angular_frequency"},
      {"drive with an unknown key", body(R"(, "drive": {"speed": 1})"), "/bodies/0/drive/speed"},
      {"two linear drags", forces(R"({"type": "linear_drag", "coefficient": 1},
           {"type": "linear_drag", "coefficient": 1})"),
       "/forces/1"},
      {"linear drag below 0", forces(R"({"type": "linear_drag", "coefficient": -1})"), "/forces/0/coefficient"},
      {"spring without other end", forces(R"({"type": "spring", "body": "a", "stiffness": 1})"),
       "/forces/0/anchor"},
      {"spring with two other ends",
       forces(R"({"type": "spring", "body": "a", "stiffness": 1, "anchor": [0, 0], "to": "b"})"),
       "/forces/0/anchor"},
      {"spring to itself", forces(R"({"type": "spring", "body": "a", "stiffness": 1, "to": "a"})"),
       "/forces/0/to"},
      {"spring to nobody", forces(R"({"type": "spring", "body": "a", "stiffness": 1, "to": "z"})"),
       "/forces/0/to"},
      {"spring to no name", forces(R"({"type": "spring", "body": "a", "stiffness": 1, "to": ""})"),
       "/forces/0/to"},
      {"spring of a fixed body", forces(R"({"type": "spring", "body": "w", "stiffness": 1, "to": "a"})"),
       "/forces/0/body"},
      {"second of two springs", forces(R"({"type": "spring", "body": "a", "stiffness": 1, "to": "b"},
              {"type": "quadratic_drag", "coefficient": 1},
              {"type": "spring", "body": "a", "stiffness": 0, "to": "b"})"),
       "/forces/2/stiffness"},
      {"one spring name twice",
       forces(R"({"type": "spring", "name": "s", "body": "a", "stiffness": 1, "to": "b"},
              {"type": "spring", "name": "s", "body": "b", "stiffness": 1, "to": "a"})"),
       "/forces/1/name"},
      {"damping below 0",
       forces(R"({"type": "spring", "body": "a", "stiffness": 1, "to": "b", "damping": -1})"),
       "/forces/0/damping"},
      {"unknown way to act",
       forces(R"({"type": "spring", "body": "a", "stiffness": 1, "to": "b", "acts": "never"})"),
       "/forces/0/acts"},
      {"two attractions",
       forces(R"({"type": "attraction", "constant": 1}, {"type": "attraction", "constant": 1})"), "/forces/1"},
      {"attraction 0", forces(R"({"type": "attraction", "constant": 0})"), "/forces/0/constant"},
      {"force on nobody", forces(R"({"type": "force", "body": "z"})"), "/forces/0/body"},
      {"force on a wall", forces(R"({"type": "force", "body": "w", "force": [1, 0]})"), "/forces/0/body"},
      {"force that ends before it starts", forces(R"({"type": "force", "body": "a", "start": 2, "end": 1})"),
       "/forces/0/end"},
      {"tolerance 1", with(R"("method": {"tolerance": 1})"), "/method/tolerance"},
      {"unknown reduction", expect(R"("reduction": "sum")"), "/expect/0/reduction"},
      {"count without a bound", expect(R"("reduction": "count")"), "\"above\" is missing"},
      {"until before from", expect(R"("reduction": "mean", "from": 2, "until": 1)"), "/expect/0/until"},
      {"from where nothing is looked over", expect(R"("reduction": "final", "from": 2)"), "/expect/0/from"},
      {"setting of nothing", expect(R"("reduction": "final", "with": {"/bodies/7/mass": 1})"),
       "/bodies/7/mass"},
      {"setting of a text", expect(R"("reduction": "final", "with": {"/title": 1})"), "\"/title\""},
      {"setting without a slash", expect(R"("reduction": "final", "with": {"gravity": 1})"), "\"gravity\""},
      {"setting that is a text", expect(R"("reduction": "final", "with": {"/duration": "1"})"),
       "/expect/0/with /duration"},
      {"sweep of nothing",
       expect(R"("reduction": "final", "over": {"place": "/x", "values": [1], "reduction": "mean"})"),
       "/expect/0/over/place"},
      {"sweep over nothing",
       expect(R"("reduction": "final", "over": {"place": "/duration", "values": [], "reduction": "mean"})"),
       "/expect/0/over/values"},
      {"exponent of one value",
       expect(
           R"("reduction": "final", "over": {"place": "/duration", "values": [1], "reduction": "exponent"})"),
       "/expect/0/over/values"},
      {"exponent through zero",
       expect(
           R"("reduction": "final", "over": {"place": "/duration", "values": [0, 1], "reduction": "exponent"})"),
       "/expect/0/over/values/0"},
      {"parabola of values in disorder", expect(R"("reduction": "final",
              "over": {"place": "/duration", "values": [1, 3, 2], "reduction": "where-maximum"})"),
       "/expect/0/over/values/2"},
      {"extra is a number", with(R"("extra": 1)"), "/extra"},
      {"not UTF-8", head + ", \"about\": \"\xff\xfe\"}", "line 1"},
      {"50 MB of brackets", repeated("[", 50'000'000), "nested deeper"},
      {"50 MB of braces", repeated(R"({"a":)", 50'000'000), "nested deeper"},
  };
}

void expect_clear(const std::string& what, const std::string& message, const std::string& place) {
  EXPECT_EQ(message.find('\n'), std::string::npos) << what << ": " << message;
  EXPECT_LT(message.size(), 400U) << what << ": " << message;
  EXPECT_NE(message.find(place), std::string::npos) << what << ": " << message;
  EXPECT_TRUE(message.find("allowed") != std::string::npos ||
              message.find("reads up to") != std::string::npos ||
              message.find("needs five") != std::string::npos)
      << what << ": " << message;
}

TEST(BadPresets, AreRefusedInOneClearLine) {
  for (const Bad& bad : bad_presets()) {
    try {
      (void)parse_preset(bad.text, "bad.json");
      ADD_FAILURE() << bad.what << " was accepted";
    } catch (const SceneError& error) {
      const std::string message = error.what();
      EXPECT_EQ(message.rfind("bad.json: ", 0), 0U) << message;
      expect_clear(bad.what, message, bad.place);
    }
  }
}

TEST_F(PresetFiles, MissingFileAndFolder) {
  for (const fs::path& file : {folder_ / "missing.json", folder_}) {
    try {
      (void)read_preset(file);
      ADD_FAILURE() << file << " was accepted";
    } catch (const SceneError& error) {
      expect_clear(file.string(), error.what(), file.string());
    }
  }
}

// Every way to cut or to damage a preset by one byte ends in a scene or in a SceneError.
TEST(BadPresets, DamagedBytes) {
  const std::string good = content(fs::path(CAROM_PRESET_DIR) / "first-collisions/head-on.json");
  for (std::size_t i = 0; i < good.size(); i += 3) {
    std::string cut = good.substr(0, i);
    std::string damaged = good;
    damaged[i] = static_cast<char>(damaged[i] ^ (1 << (i % 8)));
    for (const std::string& text : {cut, damaged}) {
      try {
        (void)parse_preset(text, "damaged.json");
      } catch (const SceneError& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      }
    }
  }
}

}  // namespace
}  // namespace carom
