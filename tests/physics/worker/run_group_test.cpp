#include "physics/worker/run_group.h"

#include <gtest/gtest.h>
#include <memory>
#include <vector>

#include "tests/support/gas_in_a_room.h"

namespace carom {
namespace {

constexpr double kStep = 0.005;       // s, of the first run
constexpr double kOtherStep = 0.003;  // s

Preset gas() {
  Preset preset = test::gas_in_a_room(0.95, 0.1);
  preset.method = {.integrator = IntegratorId::kRk4, .step = kStep};
  preset.compare = {{.integrator = IntegratorId::kExplicitEuler, .step = kOtherStep}};
  return preset;
}

Curve curve(const char* observable, const char* over = nullptr) {
  Curve curve{{find_observable(observable), {}}, {}};
  if (over != nullptr) curve.x = {find_observable(over), {}};
  return curve;
}

class RunGroupTest : public testing::Test {
 protected:
  void begin(const std::vector<Curve>& curves) {
    group_.load(gas(), curves, ReferenceId::kNone);
    group_.begin({});
  }
  void advance_to(double time) {
    const auto result = group_.advance_to(time, RunGroup::Clock::time_point::max(), [] { return false; });
    ASSERT_EQ(result, RunGroup::Advance::kReached);
  }
  // The values of this curve in the frame, by time.
  [[nodiscard]] static std::vector<std::vector<double>> values(const Frame& frame, const Curve& wanted) {
    std::vector<std::vector<double>> all;
    for (const Rows& rows : frame.rows) {
      std::size_t width = 0;
      std::size_t column = 0;
      bool has = false;
      for (const Curve& each : *rows.curves) {
        if (each == wanted) {
          has = true;
          column = width;
        }
        width += each.x ? 2 : 1;
      }
      EXPECT_EQ(rows.values.size(), width * rows.size());
      for (std::size_t row = 0; has && row < rows.size(); ++row) {
        std::vector<double> point = {rows.times[row], rows.values[row * width + column]};
        if (wanted.x) point.push_back(rows.values[row * width + column + 1]);
        all.push_back(point);
      }
    }
    return all;
  }

  RunGroup group_;
};

// Wherever the first run is halted, between the ends of the others' steps too: a return to that moment would
// else find other runs than were left there, and an edit at it would come too late for them.
TEST_F(RunGroupTest, NoRunPassesTheFirst) {
  begin({});
  for (int i = 1; i < 700; ++i) {
    const double time = 0.001 * i;
    advance_to(time);
    const auto frames = group_.take_frames();
    EXPECT_NEAR(frames[0]->time, kStep * (i / 5), 1e-12) << time;
    EXPECT_NEAR(frames[1]->time, kOtherStep * (5 * (i / 5) / 3), 1e-12) << time;
  }
}

// What is recorded no more when the runs return, and what is recorded again only then, would else be a curve
// with a gap.
TEST_F(RunGroupTest, FramesThatNobodyTookReturnWithTheWantedCurvesAlone) {
  const Curve energy = curve("kinetic_energy");
  const Curve path = curve("momentum_x", "momentum_y");
  const Curve other = curve("total_energy");
  begin({path, energy, other});
  advance_to(0.3);
  const auto untaken = group_.take_frames();
  const auto of_energy = values(*untaken[1], energy);
  const auto of_other = values(*untaken[1], other);
  ASSERT_GT(of_energy.size(), 90U);
  group_.keep_runs(1, untaken);
  group_.begin({});
  const auto returned = group_.return_to(1, {other, energy}, ReferenceId::kNone, {});
  ASSERT_EQ(returned.size(), 2U);
  for (const auto& frame : returned) EXPECT_TRUE(values(*frame, path).empty());
  EXPECT_EQ(values(*returned[1], energy), of_energy);
  EXPECT_EQ(values(*returned[1], other), of_other);
}

}  // namespace
}  // namespace carom
