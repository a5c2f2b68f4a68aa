#pragma once

#include <array>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "physics/scene/method.h"
#include "physics/scene/scene.h"

// The hard cases: scenes at which contact, friction, impacts and integrators are known to fail, each with
// figures that theory or another engine's measured value bounds.
namespace carom {

// Of a figure that nothing bounds: it is only told.
inline constexpr double kNoLimit = std::numeric_limits<double>::infinity();

// What a case measures. It is within its limit if its size is not larger.
struct StressFigure {
  std::string_view name;
  std::string_view unit;
  double limit = kNoLimit;           // in the figure's unit, >= 0
  std::string_view limit_from = {};  // theory or a peer, in words
  // The limit where theory makes it depend on the method, in place of `limit`.
  double (*limit_for)(const Method&) = nullptr;
};

struct StressSetting {
  Method method;
  bool longer = false;  // the run of an hour instead of that of seconds, where a case has one
};

inline constexpr std::array kEulerAndRk4 = {IntegratorId::kExplicitEuler, IntegratorId::kRk4};
inline constexpr std::array kSixtieth = {1.0 / 60.0};  // s

// One case: scenes that it builds, runs and reads figures from, one value for each of `figures`; NaN where a
// run did not come so far. It is run under each of `integrators`, impacts at their own time and contacts that
// last, at each of `steps` (s) and at a quarter of it.
struct StressCase {
  std::string_view id;
  std::string_view about;
  std::vector<double> (*measure)(const StressSetting&) = nullptr;
  std::span<const StressFigure> figures;
  std::span<const IntegratorId> integrators = kEulerAndRk4;
  std::span<const double> steps = kSixtieth;
};

// All cases, in the order of the table.
[[nodiscard]] std::vector<StressCase> stress_cases();
// Those of these ids, each once, in the order given; all if there are none. Throws SceneError for an unknown
// id.
[[nodiscard]] std::vector<StressCase> stress_cases(const std::vector<std::string>& ids);

enum class StressVerdict { kWithin, kBeyond, kReportedOnly };

// One figure of one run.
struct StressRow {
  std::string_view id;  // of the case
  Method method;
  bool refined = false;  // at a quarter of the case's step
  StressFigure figure;
  double value = std::numeric_limits<double>::quiet_NaN();
  double limit = kNoLimit;  // the one that holds for this method
  StressVerdict verdict = StressVerdict::kReportedOnly;
  double cpu_time = 0.0;  // s, of the whole run
};

// Good up to the limit itself; what is no number falls short of any limit.
[[nodiscard]] StressVerdict verdict_of(double value, double limit);

// The runs of some cases, each to be done once, in any order and on any thread.
class StressSuite {
 public:
  explicit StressSuite(std::vector<StressCase> cases, bool longer = false);

  [[nodiscard]] int runs() const { return static_cast<int>(runs_.size()); }
  // Different runs may go on at the same time.
  void run(int index);
  // When all runs are done: case by case, figure by figure, method by method, the step before its quarter. All
  // but the CPU times is independent of who ran what.
  [[nodiscard]] std::vector<StressRow> rows() const;

 private:
  struct Run {
    std::size_t of;  // the case
    Method method;
    bool refined;
    std::vector<double> values;
    double cpu_time = 0.0;  // s
  };
  std::vector<StressCase> cases_;
  bool longer_;
  std::vector<Run> runs_;  // in the order of the cases
};

}  // namespace carom
