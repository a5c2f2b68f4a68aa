#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "physics/worker/live_run.h"

namespace carom {

inline constexpr double kNearImpact = 0.05;  // s, before and after an impact

// True if there is an impact at one of these times (s, ascending) from `from` to `to`, but not in each of the
// steps there: bodies that rest on others under impulses alone have one in every step.
[[nodiscard]] bool stands_out(std::span<const double> impacts, double from, double to, double step);

// Runs ahead of a run that plays, to know of its impacts before they come.
class ImpactScout {
 public:
  using Clock = std::chrono::steady_clock;

  // True if an impact of the run lies within kNearImpact of its present moment. Looks ahead no longer than
  // until `deadline`: of a run whose steps take that long nothing is known.
  [[nodiscard]] bool near_impact(const LiveRun& run, Clock::time_point deadline);
  void forget() { ahead_.reset(); }

 private:
  [[nodiscard]] bool follows(const LiveRun& run) const;
  void begin(const LiveRun& run);

  std::optional<Simulation> ahead_;
  std::shared_ptr<const RunSetup> setup_;  // of the run when it was looked at last
  double begun_ = 0.0;                     // s: earlier impacts are not known
  double run_time_ = 0.0;                  // s, when it was looked at last
  std::vector<double> impacts_;            // s, ascending
};

}  // namespace carom
