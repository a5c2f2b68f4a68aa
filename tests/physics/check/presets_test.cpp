#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <set>
#include <sstream>

#include "physics/check/check.h"
#include "physics/dynamics/integrators/integrators.h"
#include "physics/observe/observables.h"
#include "physics/preset/key_table.h"
#include "physics/preset/names.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/preset/preset_json.h"
#include "tests/support/preset_files.h"
#include "tests/support/scenes.h"
#include "tests/support/source_folder.h"

namespace carom {
namespace {

namespace fs = std::filesystem;
using test::content;
using test::preset_files;
using test::PresetFiles;

// Characters, not bytes.
std::size_t length(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

TEST(Presets, MeetTheirExpectations) {
  ASSERT_GE(preset_files().size(), 41U);
  for (const fs::path& file : preset_files()) {
    const Preset s = read_preset(file);
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
    const Preset s = read_preset(file);
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
  std::vector<Preset> scenes;
  for (const fs::path& file : preset_files()) scenes.push_back(read_preset(file));
  Preset odd =
      test::preset_with({test::disc("a \"quoted\", näme: \\", {0.1, 1.0 / 3.0}, {1e-300, -0.0})}, 0.1, 0.2);
  odd.scene.bodies[0].angle = 1e-17;
  odd.extra = R"({"kept":[1,{"as":"it is, : \" "}],"x":null})";
  odd.view = View{{0.1, 0.2}, 3.0};
  scenes.push_back(odd);
  for (const Preset& s : scenes) {
    const std::string text = write_preset(s);
    EXPECT_EQ(write_preset(parse_preset(text, "again")), text);
    save_preset(s, folder_ / "saved.json");
    const Preset again = read_preset(folder_ / "saved.json");
    EXPECT_EQ(write_preset(again), text);
    EXPECT_EQ(again.extra, s.extra);
    ASSERT_EQ(again.scene.bodies.size(), s.scene.bodies.size());
    for (std::size_t i = 0; i < s.scene.bodies.size(); ++i) {
      EXPECT_EQ(again.scene.bodies[i].name, s.scene.bodies[i].name);
      EXPECT_EQ(again.scene.bodies[i].position, s.scene.bodies[i].position);
      EXPECT_EQ(again.scene.bodies[i].velocity, s.scene.bodies[i].velocity);
      EXPECT_EQ(again.scene.bodies[i].angle, s.scene.bodies[i].angle);
      EXPECT_EQ(again.scene.bodies[i].mass, s.scene.bodies[i].mass);
    }
    Simulation one(setup_of(s));
    Simulation two(setup_of(again));
    for (int i = 0; i < 20; ++i) {
      one.step();
      two.step();
    }
    EXPECT_TRUE(test::same_bytes(one.state(), two.state())) << s.title;
  }
}

TEST(Presets, ContactsLastWhereAFileDoesNotSay) {
  const auto method = [](const std::string& stated) {
    return parse_preset(R"({"format": "carom-preset", "version": 1, "title": "t")" + stated + "}", "t").method;
  };
  EXPECT_EQ(method("").contacts, ContactsId::kLasting);
  EXPECT_EQ(method(R"(, "method": {"step": 0.01})").contacts, ContactsId::kLasting);
  EXPECT_EQ(method(R"(, "method": {"contacts": "impulse"})").contacts, ContactsId::kImpulse);
  const Preset impulse = test::preset_with({test::disc("a", {0, 0}, {1, 0})});
  EXPECT_EQ(parse_preset(write_preset(impulse), "written").method.contacts, ContactsId::kImpulse);
}

// A scene with every key that a preset can have, none at its default.
constexpr const char* kEveryKey = R"({
  "format": "carom-preset", "version": 1, "title": "all", "about": "about", "observe": "look", "duration": 2,
  "gravity": [0.5, -9.81], "method": {"integrator": "explicit-euler", "impacts": "step-end", "step": 0.01},
  "compare": [{"integrator": "velocity-verlet", "impacts": "step-end", "contacts": "lasting", "step": 0.25}],
  "materials": [{"name": "m", "restitution": 0.5, "tangential_restitution": 0.25, "static_friction": 0.5,
                 "kinetic_friction": 0.25}, {"name": "ice"}, {"name": "clay", "sticks": true}],
  "impact_law": "newton",
  "material_pairs": [{"materials": ["ice", "m"], "restitution": 0.75, "kinetic_friction": 0.125,
                      "sticks": true}],
  "bodies": [
    {"name": "a", "shape": {"type": "disc", "radius": 1}, "position": [0, 0], "angle": 1, "velocity": [1, 2],
     "spin": 3, "mass": 4, "material": "m"},
    {"name": "b", "shape": {"type": "disc", "radius": 1}, "position": [9, 0], "density": 5},
    {"name": "piston", "shape": {"type": "box", "width": 1, "height": 2}, "position": [-9, 0], "angle": 0.5,
     "drive": {"velocity": [1, 2], "amplitude": [3, 4], "angular_frequency": 5, "phase": -6}},
    {"name": "w", "shape": {"type": "box", "width": 1, "height": 2}, "position": [-9, 9], "fixed": true},
    {"name": "tile", "shape": {"type": "polygon", "vertices": [[0, 0], [2, 0], [0, 1]], "rounding": 0.5},
     "position": [30, 0], "density": 2, "inertia": 3, "group": "tiles"},
    {"name": "plank", "shape": {"type": "wall", "length": 4}, "position": [40, 0], "mass": 2, "group": "tiles"},
    {"name": "ground", "shape": {"type": "wall"}, "position": [0, -50], "fixed": true},
    {"name": "c", "shape": {"type": "disc", "radius": 1}, "position": [9, -20], "mass": 1}],
  "forces": [
    {"type": "force", "body": "a", "force": [1, 2], "torque": 3, "start": 4, "rise": 5, "end": 6},
    {"type": "spring", "name": "s", "body": "a", "to": "piston", "stiffness": 1, "damping": 2, "rest_length": 3,
     "acts": "while-short"},
    {"type": "attraction", "constant": 1, "softening": 2},
    {"type": "quadratic_drag", "coefficient": 0.5},
    {"type": "spring", "body": "b", "anchor": [1, 2], "stiffness": 7, "acts": "push"},
    {"type": "spring", "body": "b", "point": [0.1, 0.2], "to": "a", "anchor": [0.3, 0.4], "stiffness": 8,
     "acts": "pull"},
    {"type": "linear_drag", "coefficient": 0.25},
    {"type": "force", "body": "b", "point": [-0.1, 0.5]}],
  "generators": [{"type": "grid", "name": "g", "columns": 2, "rows": 3, "origin": [20, 20], "spacing": [3, 4],
                  "jitter": 0.5, "radius": [0.1, 0.2], "speed": 1, "density": 2, "material": "m", "seed": 7}],
  "links": [
    {"type": "rod", "name": "r", "body": "c", "point": [0.5, 0.25], "to": "w", "anchor": [-0.5, 0],
     "length": 34.461029},
    {"type": "string", "body": "c", "anchor": [9, -18], "length": 4},
    {"type": "pin", "body": "c", "point": [0.5, 0], "anchor": [9.5, -20]},
    {"type": "weld", "body": "plank", "point": [-2, 0], "to": "ground", "anchor": [38, 50], "angle": 0}],
  "plots": ["energy", {"title": "both", "y": [{"observable": "speed", "bodies": ["a"]}, {"observable": "time"}],
    "x": {"observable": "kinetic_energy"}, "logarithmic": true},
    {"y": [{"observable": "time", "theory": "t"}, {"observable": "time", "theory": "2*t", "residual": true}],
     "notes": [{"at": [1, 2], "text": "here"}]},
    {"plot": "drift", "notes": [{"at": [1, -2.5], "text": "a"}, {"at": [3, 0], "text": "b"}]}], "view": {"center": [1, 2], "width": 3},
  "expect": [
    {"observable": "speed", "bodies": ["a"], "reduction": "count", "above": 1.5, "from": 0.5, "until": 1.5,
     "with": {"/bodies/0/mass": 100, "/forces/4/stiffness": 9},
     "over": {"place": "/generators/0/seed", "values": [3, 1, 2], "reduction": "mean"},
     "value": 0.5, "tolerance": 0.1, "source": "made up"},
    {"observable": "time", "reduction": "fit", "value": 1, "tolerance": 0},
    {"observable": "time", "reduction": "impact", "impact": 3, "until": 7, "value": 1, "tolerance": 0,
     "over": {"place": "/forces/6/coefficient", "values": [1, 2, 4], "reduction": "exponent"}}]
})";

void expect_every_key(const Preset& s) {
  const Body& piston = s.scene.bodies[2];
  ASSERT_TRUE(piston.drive.has_value());
  EXPECT_EQ(piston.drive->velocity, Vec2(1, 2));
  EXPECT_EQ(piston.drive->amplitude, Vec2(3, 4));
  EXPECT_EQ(piston.drive->angular_frequency, 5);
  EXPECT_EQ(piston.drive->phase, -6);
  EXPECT_TRUE(has_infinite_mass(piston));
  const auto& tile = std::get<Polygon>(s.scene.bodies[4].shape);
  EXPECT_EQ(tile.vertices, (std::vector<Vec2>{{0, 0}, {2, 0}, {0, 1}}));
  EXPECT_EQ(tile.rounding, 0.5);
  EXPECT_EQ(s.scene.bodies[4].inertia, 3);
  EXPECT_EQ(s.scene.bodies[4].group, "tiles");
  EXPECT_EQ(std::get<Wall>(s.scene.bodies[5].shape).length, 4);
  EXPECT_EQ(std::get<Wall>(s.scene.bodies[6].shape).length, std::nullopt);
  EXPECT_EQ(s.scene.impact_law, ImpactLawId::kNewton);
  ASSERT_EQ(s.compare.size(), 1U);
  EXPECT_EQ(s.compare[0].integrator, IntegratorId::kVelocityVerlet);
  EXPECT_EQ(s.compare[0].contacts, ContactsId::kLasting);
  EXPECT_EQ(s.compare[0].step, 0.25);
  const Plot both{"", "both", {{"speed", {"a"}}, {"time", {}}}, QuantityName{"kinetic_energy", {}}, true};
  const Plot theories{"",           "",    {{"time", {}, "t"}, {"time", {}, "2*t", true}},
                      std::nullopt, false, {{1, 2, "here"}}};
  const Plot drift{"drift", "", {}, std::nullopt, false, {{1, -2.5, "a"}, {3, 0, "b"}}};
  EXPECT_EQ(s.plots, (std::vector<Plot>{{"energy", "", {}, {}, false}, both, theories, drift}));
  ASSERT_EQ(s.scene.pairs.size(), 1U);
  EXPECT_EQ(s.scene.pairs[0].a, "ice");
  EXPECT_EQ(s.scene.pairs[0].b, "m");
  EXPECT_EQ(combined_material(s.scene, "m", "ice").restitution, 0.75);
  EXPECT_EQ(combined_material(s.scene, "ice", "m").static_friction, 0.125);
  EXPECT_EQ(combined_material(s.scene, "m", "m").restitution, 0.5);
  const Forces& f = s.scene.forces;
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
  EXPECT_EQ(f.springs[2].point, Vec2(0.1, 0.2));
  EXPECT_EQ(f.springs[2].anchor, Vec2(0.3, 0.4));
  EXPECT_EQ(f.springs[1].acts, SpringActs::kPush);
  EXPECT_EQ(f.springs[2].acts, SpringActs::kPull);
  ASSERT_EQ(f.applied.size(), 2U);
  EXPECT_EQ(f.applied[0].force, Vec2(1, 2));
  EXPECT_EQ(f.applied[0].torque, 3);
  EXPECT_EQ(f.applied[0].start, 4);
  EXPECT_EQ(f.applied[0].rise, 5);
  EXPECT_EQ(f.applied[0].end, 6);
  EXPECT_EQ(f.applied[1].point, Vec2(-0.1, 0.5));
  EXPECT_EQ(f.applied[1].end, std::nullopt);

  ASSERT_EQ(s.scene.joints.size(), 4U);
  EXPECT_EQ(s.scene.joints[0].kind, JointKind::kRod);
  EXPECT_EQ(s.scene.joints[0].name, "r");
  EXPECT_EQ(s.scene.joints[0].body, "c");
  EXPECT_EQ(s.scene.joints[0].point, Vec2(0.5, 0.25));
  EXPECT_EQ(s.scene.joints[0].to, "w");
  EXPECT_EQ(s.scene.joints[0].anchor, Vec2(-0.5, 0));
  EXPECT_EQ(s.scene.joints[0].length, 34.461029);
  EXPECT_EQ(s.scene.joints[1].kind, JointKind::kString);
  EXPECT_EQ(s.scene.joints[1].anchor, Vec2(9, -18));
  EXPECT_EQ(s.scene.joints[2].kind, JointKind::kPin);
  EXPECT_EQ(s.scene.joints[2].length, std::nullopt);
  EXPECT_EQ(s.scene.joints[2].angle, std::nullopt);
  EXPECT_EQ(s.scene.joints[3].kind, JointKind::kWeld);
  EXPECT_EQ(s.scene.joints[3].angle, 0.0);
  EXPECT_TRUE(combined_material(s.scene, "m", "ice").sticks);
  EXPECT_TRUE(combined_material(s.scene, "m", "clay").sticks);
  EXPECT_FALSE(combined_material(s.scene, "m", "m").sticks);

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
  const Preset s = parse_preset(kEveryKey, "every.json");
  expect_every_key(s);
  const std::string text = write_preset(s);
  const Preset again = parse_preset(text, "again");
  expect_every_key(again);
  EXPECT_EQ(write_preset(again), text);
}

TEST(Preset, DefaultsAreLeftOut) {
  Preset s = test::preset_with({test::disc("a", {0, 0}, {0, 0}), test::disc("b", {9, 0}, {0, 0})});
  s.scene.bodies.push_back(test::wall("table", {0, -9}, 1, 1));
  s.scene.bodies.back().fixed = false;
  s.scene.bodies.back().drive = Drive{};
  s.scene.forces.springs.resize(1);
  s.scene.forces.springs[0].body = "a";
  s.scene.forces.springs[0].to = "b";
  s.scene.forces.applied.resize(1);
  s.scene.forces.applied[0].body = "a";
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
  const Preset s = parse_preset(kEveryKey, "every.json");
  Preset v = variant(s, s.expect[0].settings);
  EXPECT_EQ(v.scene.bodies[0].mass, 100);
  EXPECT_EQ(v.scene.forces.springs[1].stiffness, 9);
  EXPECT_EQ(v.scene.forces.springs[0].stiffness, 1);
  EXPECT_TRUE(v.expect.empty());
  v = variant(s, {{s.expect[2].over->place, 3.5}});
  EXPECT_EQ(v.scene.forces.linear_drag, 3.5);
  // Again after a file that Carom wrote.
  const Preset again = parse_preset(write_preset(s), "again");
  EXPECT_EQ(variant(again, again.expect[0].settings).scene.forces.springs[1].stiffness, 9);

  // What a file leaves out has its place too, and whole numbers stay whole.
  v = variant(s, {{"/bodies/1/angle", 2.0}, {"/bodies/1/velocity/1", 3.0}, {"/generators/0/seed", 11}});
  EXPECT_EQ(v.scene.bodies[1].angle, 2.0);
  EXPECT_EQ(v.scene.bodies[1].velocity, Vec2(0, 3));
  EXPECT_EQ(v.scene.generators[0].seed, 11U);
  EXPECT_EQ(variant(s, {{"/method/tolerance", 1e-6}}).method.tolerance, 1e-6);
  EXPECT_EQ(variant(s, {{"/links/1/length", 3.0}}).scene.joints[1].length, 3.0);
  EXPECT_THROW((void)variant(s, {{"/bodies/0/name", 1}}), SceneError);
  EXPECT_THROW((void)variant(s, {{"/bodies/0/mass", -1}}), SceneError);
  EXPECT_THROW((void)variant(s, {{"/generators/0/seed", 1.5}}), SceneError);
}

TEST(Preset, SimultaneousImpactsKeepTheirWord) {
  Preset s = test::preset_with({test::disc("a", {0, 0}, {0, 0})});
  s.scene.several_impacts = SeveralImpactsId::kSimultaneous;
  EXPECT_EQ(parse_preset(write_preset(s), "again").scene.several_impacts, SeveralImpactsId::kSimultaneous);
}

TEST(Preset, ExactFlightIsRefusedWhereItIsNotPossible) {
  Preset s = test::preset_with({test::disc("a", {0, 0}, {0, 0})});
  s.method.integrator = IntegratorId::kExactFlight;
  validate(s);
  s.scene.forces.linear_drag = 1.0;
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
  const Preset s = test::preset_with({test::disc("a", {0, 0}, {1, 0})});
  const fs::path file = folder_ / "old.json";
  save_preset(s, file);
  const std::string before = content(file);
  fs::permissions(file, fs::perms::owner_read);
  EXPECT_THROW(save_preset(Preset(), file), SceneError);
  EXPECT_EQ(content(file), before);
  EXPECT_THROW(save_preset(s, folder_ / "no such folder" / "a.json"), SceneError);
  EXPECT_THROW(save_preset(s, folder_), SceneError);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST(PresetStops, AreWrittenAsTheyAreRead) {
  Preset preset = parse_preset(content(test::source("tests/fuzz/seeds/every-key.json")), "every-key.json");
  ASSERT_EQ(preset.stops.size(), 6U);
  preset.stops.push_back(stop_of("", "at the 1st impact"));
  preset.stops.push_back(stop_of("", "when a passes x = 0 m"));
  EXPECT_EQ(parse_preset(write_preset(preset), "written").stops, preset.stops);
  EXPECT_EQ(variant(preset, {{"/stop/0/time", 0.25}, {"/stop/7/value", 2.0}}).stops[7].value, 2.0);
  EXPECT_NE(write_preset(preset).find(R"({"type": "impact", "number": 1})"), std::string::npos);
  preset.stops.back().body = "nobody";
  EXPECT_THROW(validate(preset), SceneError);
}

// The tables of the reference for people are those that `carom validate --keys` prints.
TEST(PresetHelp, HasTheTablesOfTheFields) {
  const std::string page = content(test::source("app/help/presets.md"));
  for (const auto& [title, rows] : key_sections()) {
    const std::string table = markdown_of(rows);
    EXPECT_NE(page.find("\n" + table + "\n"), std::string::npos) << "another table of " << title << ":\n"
                                                                 << table;
  }
}

// The keys of one object that the schema has, of every form of it.
std::set<std::string> keys_of(const Json& object) {
  std::set<std::string> keys;
  if (object.contains("properties")) {
    for (const auto& item : object.at("properties").items()) keys.insert(item.key());
  }
  if (object.contains("anyOf")) {
    for (const Json& form : object.at("anyOf")) keys.merge(keys_of(form));
  }
  return keys;
}

// Those that a table has, without the words of cases and the keys of objects within.
std::set<std::string> keys_of(const std::vector<KeyRow>& rows) {
  std::set<std::string> keys;
  for (const KeyRow& row : rows) {
    if (row.key.find('/') != std::string::npos) continue;
    const std::size_t word = row.key.find("`: ");
    keys.insert(word == std::string::npos ? row.key : row.key.substr(word + 3));
  }
  return keys;
}

TEST(PresetHelp, TablesHaveEveryKeyOfAScene) {
  const Json schema = preset_schema();
  std::set<std::string> expected = keys_of(schema);
  // What the file is, and what is none of a scene.
  for (const char* other : {"format", "version", "compare", "plots", "state", "extra"}) expected.erase(other);
  std::set<std::string> found;
  for (const auto& [title, rows] : key_sections()) {
    if (title == "the whole") {
      found.merge(keys_of(rows));
      continue;
    }
    found.emplace(title);
    const Json& part = schema["properties"][std::string(title)];
    EXPECT_EQ(keys_of(rows), keys_of(part.contains("items") ? part["items"] : part)) << title;
  }
  EXPECT_EQ(found, expected);
}

TEST(PresetHelp, TablesHaveEveryForceThatASceneHasOnce) {
  std::string text;
  for (const auto& [title, rows] : key_sections()) text += markdown_of(rows);
  const CommonForces forces;
  each_common_force(forces, [&](const CommonForce& force, const auto&...) {
    EXPECT_NE(text.find(fmt::format("| `{}`: **", force.type)), std::string::npos) << force.type;
  });
  // A bar in a meaning does not end the cell.
  EXPECT_NE(text.find("c in F = -c \\|v\\| v |\n"), std::string::npos) << text;
}

// The reference for people names every word that a file can hold, and its example is a good preset.
TEST(PresetHelp, NamesEveryWordAndItsExampleIsMet) {
  const std::string page = content(test::source("app/help/presets.md"));
  const auto expect_word = [&](std::string_view word) {
    EXPECT_NE(page.find("`" + std::string(word) + "`"), std::string::npos) << word;
  };
  for (const Observable& o : observables()) expect_word(o.name);
  for (const auto& [id, name] : kReductionNames) expect_word(name);
  for (const auto& [id, name] : kSweepNames) expect_word(name);
  for (const auto& [id, name] : kSpringActsNames) expect_word(name);
  for (const auto& [id, name] : kJointNames) expect_word(name);
  for (const auto& choice : kIntegrators) expect_word(choice.name);
  for (const auto& choice : kImpacts) expect_word(choice.name);
  for (const auto& choice : kContacts) expect_word(choice.name);

  const std::size_t from = page.find("```json\n") + 8;
  const Preset s = parse_preset(page.substr(from, page.find("```", from) - from), "presets.md");
  ASSERT_EQ(s.expect.size(), 1U);
  EXPECT_TRUE(check_expectations(s)[0].good) << check_expectations(s)[0].measured;
}

}  // namespace
}  // namespace carom
