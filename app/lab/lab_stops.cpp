#include <algorithm>
#include <cmath>
#include <utility>

#include "app/lab/lab_runs.h"
#include "physics/record/impact_moments.h"

// The stops of the lab's runs: playing ends at their moments, the newest ones and those of the record.
namespace carom {

void LabRuns::watch_stops() { worker_.watch_stops(document_.preset.stops); }

void LabRuns::watch_duration() {
  if (plays() && !playhead_) worker_.set_playing(true, document_.preset.duration);
}

// Until the moment is there, what was shown before stays.
void LabRuns::take_halt(const Frames& before) {
  const std::optional<Halt>& halt = frames_.front()->halt;
  if (!halt || std::exchange(halts_, halt->number) == halt->number || playhead_) return;
  show_stop(halt->at);
  const bool same_runs = std::equal(before.begin(), before.end(), frames_.begin(), frames_.end(),
                                    [](const auto& a, const auto& b) { return a->run == b->run; });
  if (!playhead_ || !same_runs) return;
  playhead_->frames = before;
  auto first = std::make_shared<Frame>(*before.front());
  first->playing = false;
  first->scene.reset();
  playhead_->frames.front() = std::move(first);
}

// s, of the impact at which a stop was met; nothing for other stops.
std::optional<double> LabRuns::impact_of(const MetStop& met) const {
  const Recorder& recorder = *recorders_.front();
  // The stops may have been changed since.
  if (recorder.stops() == nullptr || met.stop >= recorder.stops()->size()) return std::nullopt;
  const StopKind kind = (*recorder.stops())[met.stop].kind;
  if (kind != StopKind::kImpact && kind != StopKind::kEveryImpact) return std::nullopt;
  // It is met just after its own impact, but in a step of another length.
  const double rounding = kSameMoment * frames_.front()->method.step;
  for (const double until : {met.time, met.time + rounding}) {
    const std::optional<double> impact = impact_until(recorder, until);
    if (impact && *impact > met.time - rounding) return impact;
  }
  return std::nullopt;
}

void LabRuns::show_stop(const MetStop& met) {
  if (const std::optional<double> impact = impact_of(met)) return stand_at_impact(*impact);
  picks_last_ = false;
  if (met.part == 0.0 && met.time >= frames_.front()->time) return go_to_end();
  stand_at({.time = met.part == 0.0 ? met.time : met.step_start, .part = met.part});
}

// The next one of the record up to this moment (s), while it plays there.
const MetStop* LabRuns::stop_until(double time) const {
  const double rounding = kSameMoment * frames_.front()->method.step;
  const std::vector<MetStop>& met = recorders_.front()->met();
  const auto next = std::upper_bound(met.begin(), met.end(), playhead_->passed + rounding,
                                     [](double passed, const MetStop& each) { return passed < each.time; });
  return next == met.end() || next->time > time ? nullptr : &*next;
}

std::optional<Stop> LabRuns::stopped() const {
  if (frames().empty() || frames().front()->playing || !there() || recorders_.empty()) return std::nullopt;
  const Recorder& recorder = *recorders_.front();
  const double time = picked().value_or(frames().front()->time);
  const double rounding = kSameMoment * frames().front()->method.step;
  const auto met = std::find_if(recorder.met().begin(), recorder.met().end(),
                                [&](const MetStop& each) { return std::abs(each.time - time) <= rounding; });
  if (met == recorder.met().end()) return std::nullopt;
  if (recorder.stops() == nullptr || met->stop >= recorder.stops()->size()) return std::nullopt;
  return (*recorder.stops())[met->stop];
}

}  // namespace carom
