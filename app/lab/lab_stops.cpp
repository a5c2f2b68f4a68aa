#include <algorithm>
#include <utility>

#include "app/lab/lab_runs.h"

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

void LabRuns::show_stop(const MetStop& met) {
  if (met.part == 0.0 && met.time >= frames_.front()->time) return go_to_end();
  if (!playhead_) playhead_ = Playhead{};
  playhead_->impact.reset();
  playhead_->plays = false;
  ask_worker({.time = met.part == 0.0 ? met.time : met.step_start, .part = met.part});
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
  const double time = frames().front()->time;
  const auto met = std::find_if(recorder.met().begin(), recorder.met().end(),
                                [time](const MetStop& each) { return each.time == time; });
  if (met == recorder.met().end()) return std::nullopt;
  return recorder.stops()->at(met->stop);
}

}  // namespace carom
