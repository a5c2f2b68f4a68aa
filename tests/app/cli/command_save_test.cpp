#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/program.h"

// A run saved by `run --save` continues like the uninterrupted run, to rounding.
namespace carom {
namespace {

using Json = nlohmann::json;

constexpr const char* kHead = R"({"format": "carom-preset", "version": 1, "title": "t", "duration": 2.0,)";
constexpr const char* kFloor =
    R"({"name": "floor", "shape": {"type": "box", "width": 9, "height": 1}, "position": [0, -0.5], "fixed": true})";

std::string with(const std::string& more) { return std::string(kHead) + more + "}"; }
std::string disc(const std::string& name, const std::string& position, const std::string& velocity) {
  return R"({"name": ")" + name + R"(", "shape": {"type": "disc", "radius": 0.1}, "position": )" + position +
         R"(, "velocity": )" + velocity + R"(, "mass": 1})";
}

bool near(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max(1.0, std::abs(b)); }

// The same but for rounding.
bool near(const Json& a, const Json& b) {
  if (a.is_number() && b.is_number()) return near(a.get<double>(), b.get<double>());
  if (a.type() != b.type() || a.size() != b.size()) return false;
  if (!a.is_structured()) return a == b;
  if (a.is_array())
    return std::equal(a.begin(), a.end(), b.begin(), [](const Json& x, const Json& y) { return near(x, y); });
  return std::all_of(a.items().begin(), a.items().end(), [&](const auto& item) {
    return b.contains(item.key()) && near(item.value(), b[item.key()]);
  });
}

void expect_near(const std::vector<QByteArray>& lines, const std::vector<QByteArray>& others) {
  ASSERT_EQ(lines.size(), others.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const QList<QByteArray> fields = lines[i].split(',');
    const QList<QByteArray> expected = others[i].split(',');
    ASSERT_EQ(fields.size(), expected.size());
    for (int k = 0; k < fields.size(); ++k) {
      bool number = false;
      const double value = fields[k].toDouble(&number);
      EXPECT_TRUE(number ? near(value, expected[k].toDouble()) : fields[k] == expected[k])
          << lines[i].toStdString() << "\n"
          << others[i].toStdString();
    }
  }
}

class CommandSave : public testing::Test {
 protected:
  [[nodiscard]] Json run(const QStringList& arguments) const {
    const ProgramResult result = carom_(QStringList{"run"} + arguments + QStringList{"--json"});
    EXPECT_EQ(result.code, 0) << result.err;
    Json j = Json::parse(result.out, nullptr, false);
    // What is computed, not how: the adaptive method chooses its steps anew.
    for (const char* key : {"preset", "evaluations", "rejected_steps"}) j.erase(key);
    return j;
  }
  // The lines of a table after its header with a first column beyond `time`.
  [[nodiscard]] std::vector<QByteArray> lines_after(const QString& file, double time) const {
    std::vector<QByteArray> lines;
    for (const QByteArray& line : carom_.read(file).split('\n')) {
      bool number = false;
      const double at = line.split(',').constFirst().toDouble(&number);
      if (number && at > time) lines.push_back(line);
    }
    return lines;
  }
  void expect_same(const std::string& preset, const QStringList& method = {}) const {
    carom_.write("whole.json", QByteArray::fromStdString(preset));
    const Json whole =
        run(QStringList{"whole.json", "--until", "1.2", "--csv", "whole.csv", "--events", "whole-events.csv"} +
            method);
    (void)run(QStringList{"whole.json", "--until", "0.6", "--save", "mid.json"} + method);
    const Json rest = run({"mid.json", "--until", "1.2", "--csv", "rest.csv", "--events", "rest-events.csv"});
    EXPECT_TRUE(near(rest, whole)) << rest << "\n" << whole;
    EXPECT_EQ(whole["status"], run({"mid.json", "--until", "1.2"})["status"]);
    expect_near(lines_after("rest.csv", 0.601), lines_after("whole.csv", 0.601));
    EXPECT_FALSE(lines_after("rest.csv", 0.601).empty());
    expect_near(lines_after("rest-events.csv", 0.6), lines_after("whole-events.csv", 0.6));
    EXPECT_DOUBLE_EQ(run({"mid.json"})["time"].get<double>(), 2.0);  // the run's duration
  }
  Program carom_;
};

TEST_F(CommandSave, ADrivenBody) {
  const std::string preset = with(
      R"("gravity": [0, -9.81], "materials": [{"name": "default", "restitution": 0.7}], "bodies": [
      {"name": "table", "shape": {"type": "box", "width": 4, "height": 1}, "position": [0, -0.5],
       "drive": {"velocity": [0.1, 0], "amplitude": [0, 0.05], "angular_frequency": 12, "phase": 0.3}},)" +
      disc("ball", "[0, 0.5]", "[0.1, 0]") + "]");
  expect_same(preset);
  expect_same(preset, {"--integrator", "exact-flight"});
  expect_same(preset, {"--integrator", "dormand-prince-adaptive"});
}

TEST_F(CommandSave, ATimedForce) {
  expect_same(
      with(R"("bodies": [)" + disc("ball", "[0, 0]", "[0.1, 0]") +
           R"(], "forces": [{"type": "force", "body": "ball", "force": [1, 2], "torque": 0.1, "start": 0.4,
      "rise": 0.5, "end": 1.1}])"));
}

TEST_F(CommandSave, WhatHasStuck) {
  expect_same(with(R"("gravity": [0, -9.81], "materials": [{"name": "default", "sticks": true}], "bodies": [)" +
                   std::string(kFloor) + "," + disc("a", "[-1, 1.2]", "[2, 0]") + "," +
                   disc("b", "[1, 1.2]", "[-2, 0]") + "]"));
}

TEST_F(CommandSave, TautAndSlackStrings) {
  expect_same(with(R"("gravity": [0, -9.81], "bodies": [)" + disc("a", "[1, 0]", "[0, 0]") + "," +
                   disc("b", "[2.3, 0]", "[0.4, 1]") +
                   R"(], "links": [{"type": "string", "body": "a", "anchor": [0, 0], "length": 1},
      {"type": "string", "body": "b", "anchor": [2, 0], "length": 1}])"));
}

TEST_F(CommandSave, AStackWithFriction) {
  std::string boxes = kFloor;
  for (int i = 0; i < 4; ++i) {
    boxes += R"(,{"name": "box-)" + std::to_string(i) +
             R"(", "shape": {"type": "box", "width": 0.4, "height": 0.4},
        "position": [)" +
             std::to_string(0.05 * i) + "," + std::to_string(0.2 + 0.41 * i) + R"(], "mass": 1})";
  }
  expect_same(
      with(R"("gravity": [0, -9.81], "method": {"contacts": "lasting"}, "materials": [{"name": "default",
      "restitution": 0.2, "kinetic_friction": 0.4}], "bodies": [)" +
           boxes + "]"));
}

TEST_F(CommandSave, AChangedFileIsReported) {
  carom_.write("whole.json",
               QByteArray::fromStdString(with(R"("bodies": [)" + disc("a", "[0, 0]", "[1, 0]") + "]")));
  (void)run({"whole.json", "--until", "0.5", "--save", "mid.json"});
  QByteArray text = carom_.read("mid.json");
  text.replace(R"("mass": 1.0)", R"("mass": 2.0)");
  carom_.write("mid.json", text);
  const Json j = run({"mid.json", "--until", "1"});
  EXPECT_NE(j["status"].get<std::string>().find("the scene was changed after the run was saved"),
            std::string::npos);
  EXPECT_EQ(j["time"], 1.0);
  EXPECT_NEAR(j["bodies"][0]["position"][0].get<double>(), 1.0, 1e-12);
}

}  // namespace
}  // namespace carom
