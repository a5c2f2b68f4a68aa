#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

#include "physics/measure/expectation.h"
#include "physics/preset/preset.h"
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
  ASSERT_GE(preset_files().size(), 8U);
  for (const fs::path& file : preset_files()) {
    const Scene s = read_preset(file);
    EXPECT_FALSE(s.expect.empty()) << file;
    const std::vector<Outcome> outcomes = measure_expectations(s);
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
