#include "physics/worker/impact_scout.h"

#include <algorithm>

#include "physics/step/run_clock.h"

namespace carom {
namespace {

constexpr double kNearlyEach = 0.8;  // of the steps
constexpr int kMostLate = 5;         // looks, before they pause
constexpr int kPause = 60;           // looks

}  // namespace

bool near_impact(const KnownImpacts& impacts, double time) {
  const double from = std::max(impacts.from, time - kNearImpact);
  const double to = std::min(impacts.to, time + kNearImpact);
  const auto first = std::lower_bound(impacts.times.begin(), impacts.times.end(), from);
  const auto last = std::upper_bound(first, impacts.times.end(), to);
  if (first == last) return false;
  // An impact at the end of a step is one of that step.
  const auto step_of = [&impacts](double t) { return -whole_steps(impacts.step_end - t, impacts.step); };
  double with_impact = 0.0;
  double counted = step_of(from) - 1.0;
  for (auto impact = first; impact != last; ++impact) {
    const double number = step_of(*impact);
    if (number > counted) ++with_impact;
    counted = std::max(counted, number);
  }
  const double steps = whole_steps(to - from, impacts.step);
  return steps < 2.0 || with_impact < kNearlyEach * steps;
}

std::optional<double> free_until(const KnownImpacts& impacts, double time, double until, double least) {
  if (near_impact(impacts, time)) return std::nullopt;
  auto impact = std::upper_bound(impacts.times.begin(), impacts.times.end(), time + kNearImpact);
  for (; impact != impacts.times.end(); ++impact) {
    const double free = *impact - kNearImpact;
    if (free >= std::max(until, time + least)) break;
    if (!near_impact(impacts, *impact)) continue;
    if (free < time + least) return std::nullopt;
    return std::min(free, until);
  }
  return until;
}

bool ImpactScout::follows(const LiveRun& run) const {
  return ahead_ && setup_ == run.shared_setup() && run.time() >= run_time_ && run.time() <= ahead_->time() &&
         run.simulation().method() == ahead_->method();
}

void ImpactScout::begin(const LiveRun& run) {
  // After an edit of the run, what it has passed stays.
  const bool goes_on = ahead_ && run.time() >= run_time_ && run.time() <= ahead_->time();
  if (goes_on) {
    impacts_.erase(std::upper_bound(impacts_.begin(), impacts_.end(), run.time()), impacts_.end());
  } else {
    impacts_.clear();
    begun_ = run.time();
  }
  ahead_.emplace(run.simulation().compiled(), run.simulation().run_state());
  ahead_->interrupt_on(run.interrupt());
  setup_ = run.shared_setup();
  ahead_->set_edits(setup_->edits);
}

std::optional<KnownImpacts> ImpactScout::look(const LiveRun& run, double until, Clock::time_point deadline) {
  if (late_ >= kMostLate && ++late_ < kMostLate + kPause) return std::nullopt;
  if (late_ >= kMostLate) forget();
  const double now = run.time();
  if (!follows(run)) begin(run);
  run_time_ = now;
  const double wanted = std::max(now, until) + kNearImpact;
  while (ahead_->time() < wanted && !ahead_->lost()) {
    if (Clock::now() >= deadline) {
      ++late_;
      return std::nullopt;
    }
    ahead_->step();
    for (const ImpactRecord& impact : ahead_->last_impacts()) impacts_.push_back(impact.time);
  }
  late_ = 0;
  const auto old = std::lower_bound(impacts_.begin(), impacts_.end(), now - kNearImpact);
  impacts_.erase(impacts_.begin(), old);
  return KnownImpacts{impacts_, std::max(now - kNearImpact, begun_), ahead_->time(),
                      run.simulation().method().step, now};
}

}  // namespace carom
