#include "physics/worker/impact_scout.h"

#include <algorithm>
#include <cmath>

namespace carom {

bool stands_out(std::span<const double> impacts, double from, double to, double step) {
  constexpr double kFewSteps = 4.0;
  const auto first = std::lower_bound(impacts.begin(), impacts.end(), from);
  const auto last = std::upper_bound(first, impacts.end(), to);
  if (first == last) return false;
  double with_impact = 0.0;
  double counted = -1.0;
  for (auto impact = first; impact != last; ++impact) {
    const double number = std::floor((*impact - from) / step);
    if (number > counted) ++with_impact;
    counted = number;
  }
  const double steps = (to - from) / step;
  return steps < kFewSteps || with_impact < steps - 1.0;
}

bool ImpactScout::follows(const LiveRun& run) const {
  return ahead_ && setup_ == run.shared_setup() && run.time() >= run_time_ && run.time() <= ahead_->time() &&
         run.simulation().method() == ahead_->method();
}

void ImpactScout::begin(const LiveRun& run) {
  ahead_.emplace(run.simulation().compiled(), run.simulation().run_state());
  setup_ = run.shared_setup();
  ahead_->set_edits(setup_->edits);
  begun_ = run.time();
  impacts_.clear();
}

bool ImpactScout::near_impact(const LiveRun& run, Clock::time_point deadline) {
  const double now = run.time();
  if (!follows(run)) begin(run);
  run_time_ = now;
  while (ahead_->time() < now + kNearImpact && !ahead_->lost() && Clock::now() < deadline) {
    ahead_->step();
    for (const ImpactRecord& impact : ahead_->last_impacts()) impacts_.push_back(impact.time);
  }
  const auto old = std::lower_bound(impacts_.begin(), impacts_.end(), now - kNearImpact);
  impacts_.erase(impacts_.begin(), old);
  const double from = std::max(now - kNearImpact, begun_);
  return stands_out(impacts_, from, std::min(now + kNearImpact, ahead_->time()),
                    run.simulation().method().step);
}

}  // namespace carom
