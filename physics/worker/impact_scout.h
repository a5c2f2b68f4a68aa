#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "physics/worker/live_run.h"

namespace carom {

inline constexpr double kNearImpact = 0.05;  // s, before and after an impact

// The impacts of a run in the time from `from` to `to` (s), in which all are known.
struct KnownImpacts {
  std::span<const double> times;  // s, ascending
  double from = 0.0;
  double to = 0.0;
  double step = 0.0;      // s, of the method
  double step_end = 0.0;  // s, of any of its steps
};

// True if there are impacts within kNearImpact of `time` (s), but not in nearly each of the steps there: bodies
// that rest on others under impulses alone have one in every step.
[[nodiscard]] bool near_impact(const KnownImpacts& impacts, double time);
// s: how far a run at `time` goes before it is near an impact, at most `until`. Nothing if it is near one now,
// or will be after less than `least` s.
[[nodiscard]] std::optional<double> free_until(const KnownImpacts& impacts, double time, double until,
                                               double least);

// Runs ahead of a run that plays, to know of its impacts before they come.
class ImpactScout {
 public:
  using Clock = std::chrono::steady_clock;

  // The impacts of the run about its present moment, as far as `until` (s) and what is near to it. Nothing
  // where that takes longer than until `deadline`, as of a run with large steps: it is not asked again for a
  // while then. Throws StepInterrupted as the run does.
  [[nodiscard]] std::optional<KnownImpacts> look(const LiveRun& run, double until, Clock::time_point deadline);
  void forget() {
    ahead_.reset();
    late_ = 0;
  }

 private:
  [[nodiscard]] bool follows(const LiveRun& run) const;
  void begin(const LiveRun& run);

  std::optional<Simulation> ahead_;
  std::shared_ptr<const RunSetup> setup_;  // of the run when it was looked at last
  double begun_ = 0.0;                     // s: earlier impacts are not known
  double run_time_ = 0.0;                  // s, when it was looked at last
  std::vector<double> impacts_;            // s, ascending
  int late_ = 0;                           // looks one after the other that took too long
};

}  // namespace carom
