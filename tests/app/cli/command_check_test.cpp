#include <filesystem>
#include <fmt/format.h>
#include <sstream>

#include "tests/support/program.h"
#include "tests/support/source_folder.h"

namespace carom {
namespace {

// A disc that moves at 2 m/s for a second, and its expectations.
QByteArray preset_with(const std::string& expectations) {
  return QByteArray::fromStdString(fmt::format(
      R"({{"format": "carom-preset", "version": 1, "title": "t", "duration": 1, "bodies": [{{"name": "a, b",
          "shape": {{"type": "disc", "radius": 0.1}}, "position": [0, 0], "velocity": [2, 0]}}],
          "expect": [{}]}})",
      expectations));
}

constexpr const char* kRight =
    R"({"observable": "x", "bodies": ["a, b"], "reduction": "final", "value": 2, "tolerance": 1e-9})";
constexpr const char* kWrong =
    R"({"observable": "x", "bodies": ["a, b"], "reduction": "final", "value": 2.5, "tolerance": 0.1})";
constexpr const char* kSwept =
    R"({"observable": "x", "bodies": ["a, b"], "reduction": "final", "with": {"/bodies/0/position/0": 1},
        "over": {"place": "/bodies/0/velocity/0", "values": [1, 2, 6], "reduction": "mean"}, "value": 4,
        "tolerance": 1e-9})";
constexpr const char* kNever =
    R"({"observable": "time", "reduction": "impact", "impact": 1, "value": 1, "tolerance": 1})";

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(CheckCommand, GoodExpectationsGiveZero) {
  const Program carom;
  carom.write("right.json", preset_with(std::string(kRight) + "," + kSwept));
  const ProgramResult result = carom({"check", "right.json"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err, "");  // no progress in a pipe
  EXPECT_TRUE(holds(result.out, "2 of 2 expectations of 1 preset are met.")) << result.out;
  EXPECT_FALSE(holds(result.out, "FELL SHORT"));
  EXPECT_EQ(carom.files(), QStringList{"right.json"});
}

TEST(CheckCommand, AWrongExpectationGivesOne) {
  const Program carom;
  carom.write("wrong.json", preset_with(std::string(kRight) + "," + kWrong));
  const ProgramResult result = carom({"check", "wrong.json"});
  EXPECT_EQ(result.code, 1) << result.err;
  EXPECT_TRUE(holds(result.out, "1 of 2 expectations of 1 preset are met.")) << result.out;
  const std::vector<std::string> lines = lines_of(result.out);
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_TRUE(holds(lines[0], "preset") && holds(lines[0], "verdict"));
  EXPECT_TRUE(holds(lines[1], "good")) << lines[1];
  EXPECT_TRUE(holds(lines[2], "FELL SHORT") && holds(lines[2], "-5.0e-01")) << lines[2];
  // Columns are aligned.
  EXPECT_EQ(lines[1].find("good"), lines[0].find("verdict"));
  EXPECT_EQ(lines[2].find("FELL SHORT"), lines[0].find("verdict"));
}

TEST(CheckCommand, AMomentThatNeverComesGivesOne) {
  const Program carom;
  carom.write("never.json", preset_with(kNever));
  const ProgramResult result = carom({"check", "never.json"});
  EXPECT_EQ(result.code, 1);
  EXPECT_TRUE(holds(result.out, "NEVER CAME")) << result.out;
}

// A ball on a floor weighs 9.81 N. Under impulses alone nothing says so, and 0 would be a lie.
TEST(CheckCommand, AContactForceUnderImpulsesIsNotKnown) {
  const Program carom;
  carom.write("weight.json",
              R"({"format": "carom-preset", "version": 1, "title": "t", "duration": 1, "gravity": [0, -9.81],
          "materials": [{"name": "default", "restitution": 0}],
          "bodies": [{"name": "ball", "mass": 1, "shape": {"type": "disc", "radius": 0.1}, "position": [0, 0.1]},
            {"name": "floor", "fixed": true, "shape": {"type": "box", "width": 1, "height": 1}, "position": [0, -0.5]}],
          "expect": [{"observable": "contact_force", "bodies": ["ball", "floor"], "reduction": "final",
            "value": 9.81, "tolerance": 1e-9}]})");
  ProgramResult result = carom({"check", "weight.json", "--contacts", "lasting"});
  EXPECT_EQ(result.code, 0) << result.out << result.err;
  result = carom({"check", "weight.json", "--contacts", "impulse"});
  EXPECT_EQ(result.code, 1) << result.err;
  EXPECT_TRUE(holds(result.out, "NOT KNOWN: there are no contact forces under impulses only")) << result.out;
}

TEST(CheckCommand, CsvHasAllDigits) {
  const Program carom;
  carom.write("two.json", preset_with(std::string(kWrong) + "," + kSwept + "," + kNever));
  EXPECT_EQ(carom({"check", "two.json", "--csv", "out.csv"}).code, 1);
  const std::vector<std::string> lines = lines_of(carom.read("out.csv").toStdString());
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0], "preset,expectation,measured,expected,error,tolerance,verdict");
  EXPECT_TRUE(lines[1].starts_with("two,\"x of a, b at the end\",2")) << lines[1];
  EXPECT_TRUE(lines[1].ends_with(",0.1,fell short")) << lines[1];
  EXPECT_TRUE(holds(lines[2], "with position/0 of a, b = 1; mean over velocity/0 of a, b = 1...6")) << lines[2];
  EXPECT_TRUE(lines[2].ends_with(",1e-09,good")) << lines[2];
  EXPECT_TRUE(holds(lines[3], ",nan,1,nan,1,fell short")) << lines[3];
}

// Free fall of 1 s: explicit Euler is off by g h/2 times 1 s, also where an expectation sets the step itself.
TEST(CheckCommand, RunsUnderAnotherMethodAndFiner) {
  const Program carom;
  constexpr const char* kFall =
      R"({"observable": "y", "bodies": ["a, b"], "reduction": "final", "value": -5, "tolerance": 1e-9})";
  constexpr const char* kCoarse =
      R"({"observable": "y", "bodies": ["a, b"], "reduction": "final", "value": -5, "tolerance": 1e-9,
          "with": {"/method/step": 0.04}})";
  QByteArray fall = preset_with(std::string(kFall) + "," + kCoarse);
  fall.replace("\"duration\": 1,", R"("duration": 1, "gravity": [0, -10], "method": {"step": 0.02},)");
  carom.write("fall.json", fall);
  EXPECT_EQ(carom({"check", "fall.json", "--integrator", "rk4"}).code, 0);
  const ProgramResult whole = carom({"check", "fall.json", "--integrator", "explicit-euler"});
  EXPECT_EQ(whole.code, 1);
  EXPECT_TRUE(holds(whole.out, "1.0e-01") && holds(whole.out, "2.0e-01")) << whole.out;
  const ProgramResult half = carom({"check", "fall.json", "--integrator", "explicit-euler", "--finer", "2"});
  EXPECT_TRUE(holds(half.out, "5.0e-02") && holds(half.out, "1.0e-01")) << half.out;
  expect_refused(carom({"check", "fall.json", "--finer", "0"}), "--finer");
  expect_refused(carom({"check", "drag-projectile", "--integrator", "exact-flight"}), "--integrator");
}

// Without names, all presets that Carom ships; golden_outputs_test checks each of them.
TEST(CheckCommand, AllPresetsOrThoseThatAreNamed) {
  const Program carom;
  const std::string folder = test::source("presets/first-collisions").string();
  const ProgramResult all =
      carom.shell(QString::fromStdString("CAROM_PRESETS='" + folder + "' \"$carom\" check"));
  EXPECT_EQ(all.code, 0) << all.out << all.err;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    EXPECT_TRUE(holds(all.out, entry.path().stem().string() + " ")) << all.out;
  const ProgramResult two = carom({"check", "head-on", "glancing"});
  EXPECT_EQ(two.code, 0) << two.out;
  EXPECT_TRUE(holds(two.out, " of 2 presets are met."));
}

TEST(CheckCommand, BadInputIsRefused) {
  const Program carom;
  carom.write("bad.json", preset_with(R"({"observable": "luck"})"));
  carom.write("place.json",
              preset_with(R"({"observable": "time", "reduction": "final", "value": 1, "tolerance": 0,
      "with": {"/bodies/3/mass": 1}})"));
  carom.write("number.json",
              preset_with(R"({"observable": "time", "reduction": "final", "value": 1, "tolerance": 0,
      "with": {"/bodies/0/shape/radius": -1}})"));
  expect_refused(carom({"check", "no-such"}), "no-such: no such file or experiment");
  expect_refused(carom({"check", "head-on", "bad.json"}), "bad.json: /expect/0/observable");
  expect_refused(carom({"check", "place.json"}), "/bodies/3/mass");
  expect_refused(carom({"check", "number.json"}),
                 "number.json: /expect/0: with its settings: /bodies/0/shape/radius");
  expect_refused(carom({"check", "head-on", "--csv", "no/such/out.csv"}), "no/such/out.csv");
  expect_refused(carom({"check", "head-on", "--bogus"}), "--bogus");
}

}  // namespace
}  // namespace carom
