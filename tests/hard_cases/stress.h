#pragma once

#include <array>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "physics/scene/method.h"
#include "physics/scene/scene.h"

// The hard cases: scenes in which contact, friction, impacts and integrators are known to fail, each with
// figures that are bounded by theory or by another engine's measured value.
namespace carom {

// Of a figure without a bound, which is only reported.
inline constexpr double kNoLimit = std::numeric_limits<double>::infinity();

// A measured figure of a case. It is within its limit if its absolute value is at most that.
struct StressFigure {
  std::string_view name;
  std::string_view unit;
  double limit = kNoLimit;           // in the figure's unit, >= 0
  std::string_view limit_from = {};  // theory or a peer, in words
  // The limit if theory makes it depend on the method, in place of `limit`.
  double (*limit_for)(const Method&) = nullptr;
};

struct StressSetting {
  Method method;
  bool longer = false;  // runs for an hour instead of seconds, if the case has such a run
};

inline constexpr std::array kEulerAndRk4 = {IntegratorId::kExplicitEuler, IntegratorId::kRk4};
inline constexpr std::array kSixtieth = {1.0 / 60.0};  // s

// One case: it builds and runs scenes and reads one value for each of `figures`; NaN if a run did not get
// that far. It is run under each of `integrators`, with impacts at their own time and resting contacts, at
// each of `steps` (s) and at a quarter of it.
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
// The cases with these ids, without duplicates, in the given order; all if there are none. Throws SceneError
// for an unknown id.
[[nodiscard]] std::vector<StressCase> stress_cases(const std::vector<std::string>& ids);

enum class StressVerdict { kWithin, kBeyond, kReportedOnly };

// One figure of one run.
struct StressRow {
  std::string_view id;  // of the case
  Method method;
  bool refined = false;  // at a quarter of the case's step
  StressFigure figure;
  double value = std::numeric_limits<double>::quiet_NaN();
  double limit = kNoLimit;  // for this method
  StressVerdict verdict = StressVerdict::kReportedOnly;
  double cpu_time = 0.0;  // s, of the whole run
};

// Within up to and including the limit; NaN is beyond any limit.
[[nodiscard]] StressVerdict verdict_of(double value, double limit);

// The runs of some cases. Construct, call run() once for each index, in any order and on any threads, then
// read rows().
class StressSuite {
 public:
  explicit StressSuite(std::vector<StressCase> cases, bool longer = false);

  [[nodiscard]] int runs() const { return static_cast<int>(runs_.size()); }
  // Thread-safe for different runs.
  void run(int index);
  // When all runs are done: by case, then figure, then method, each step before its quarter. Everything but
  // the CPU times is independent of the threads.
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
