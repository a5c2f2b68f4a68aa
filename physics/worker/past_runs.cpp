#include "physics/worker/past_runs.h"

#include <algorithm>
#include <utility>

#include "physics/run/scene_now.h"

namespace carom {

void PastRuns::seek(const PastMoment& moment, std::span<const Original> runs,
                    const std::stop_token& interrupt) {
  std::vector<PastRun> copies;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Original& from = runs[i];
    const auto same = std::find_if(runs_.begin(), runs_.end(),
                                   [&from](const PastRun& copy) { return copy.is_of(from.run, from.id); });
    copies.push_back(same == runs_.end() ? PastRun(from.run, from.id, interrupt) : std::move(*same));
    copies.back().follow(from.run);
  }
  runs_ = std::move(copies);
  const Simulation& newest = runs.front().run.simulation();
  sought_ = Sought{.time = std::min(moment.time, newest.time()),
                   .by = moment.steps,
                   .newest = newest.steps(),
                   .part = moment.part,
                   .impact = moment.impact};
  const bool from_newest = moment.steps != 0 && !moment.impact && moment.time >= newest.time();
  for (PastRun& run : std::span(runs_).subspan(from_newest ? 1 : 0)) run.stand_before(sought_->time);
  if (from_newest) go_to_step(newest.steps() + std::exchange(sought_->by, 0));
}

void PastRuns::go_to_step(std::int64_t steps) {
  sought_->steps = std::min(steps, sought_->newest);
  runs_.front().stand_before_step(*sought_->steps);
}

bool PastRuns::step() {
  if (sought_->steps) return step_first();
  const auto farthest_behind = std::min_element(
      runs_.begin(), runs_.end(), [](const PastRun& a, const PastRun& b) { return a.next() < b.next(); });
  if (farthest_behind->may_step(sought_->time)) {
    farthest_behind->step();
  } else if (sought_->impact && !sought_->others_follow) {
    go_to_impact();
  } else if (sought_->by != 0) {
    go_to_step(runs_.front().simulation().steps() + std::exchange(sought_->by, 0));
  } else if (!sought_->others_follow) {
    follow_first();
  } else {
    make_parts();
    sought_.reset();
  }
  return seeks();
}

bool PastRuns::step_first() {
  PastRun& first = runs_.front();
  if (!first.simulation().lost() && first.simulation().steps() < *sought_->steps) {
    first.step();
    return true;
  }
  sought_->steps.reset();
  follow_first();
  return true;
}

// By a part of the first run's next step, or by the whole step.
void PastRuns::go_to_impact() {
  const Simulation& first = runs_.front().simulation();
  const double step = first.next_step();
  const double part = *sought_->impact - first.time() - 0.5 * kSameMoment * step;
  const bool whole = !(part > 0.0 && part < (1.0 - kSameMoment) * step);
  if (!whole) sought_->part = part;
  if (whole && sought_->by == 0) sought_->at_end = sought_->impact;
  if (whole || sought_->by != 0) sought_->impact.reset();
  if (whole) ++sought_->by;
  if (sought_->by == 0) return follow_first();
  go_to_step(first.steps() + std::exchange(sought_->by, 0));
}

// The others to where the first run is.
void PastRuns::follow_first() {
  sought_->others_follow = true;
  sought_->time = runs_.front().simulation().time() + sought_->part;
  for (PastRun& run : std::span(runs_).subspan(1)) run.stand_before(sought_->time);
}

void PastRuns::make_parts() {
  if (sought_->at_end) runs_.front().look_ahead_for(*sought_->at_end);
  if (sought_->part == 0.0) return;
  runs_.front().make_part(sought_->part, sought_->impact.has_value());
  const double time = runs_.front().shown().time();
  for (PastRun& run : std::span(runs_).subspan(1)) run.make_part(run.simulation().next_step(time));
}

std::vector<std::shared_ptr<Frame>> PastRuns::frames() const {
  std::vector<std::shared_ptr<Frame>> frames;
  for (const PastRun& run : runs_) frames.push_back(run.frame());
  if (!seeks()) frames.front()->scene = std::make_shared<const Scene>(scene_now(runs_.front().shown()));
  return frames;
}

}  // namespace carom
