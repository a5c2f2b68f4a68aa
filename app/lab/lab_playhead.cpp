#include <algorithm>
#include <utility>

#include "app/lab/lab_runs.h"
#include "physics/record/impact_moments.h"
#include "physics/worker/impact_scout.h"
#include "widgets/scene/drawing.h"

// The playhead of the lab's runs: which moment of their record is shown.
namespace carom {

std::optional<double> LabRuns::picked() const {
  if (playhead_ && playhead_->impact) return playhead_->impact;
  if (!picks_last_ || frames().empty() || !there()) return std::nullopt;
  const Frame& shown = *frames().front();
  if (shown.playing || shown.jumps.empty()) return std::nullopt;
  const double time = shown.jumps.back()->time();
  const double rounding = kSameMoment * shown.method.step;
  const bool within = time > shown.time - shown.method.step + rounding && time <= shown.time + rounding;
  return within ? std::optional(time) : std::nullopt;
}

void LabRuns::go_to(double time) {
  if (!has_record()) return;
  picks_last_ = false;
  if (time >= frames_.front()->time) return go_to_end();
  seek({std::max(time, start_time(document_.preset.saved))});
}

void LabRuns::go_to_start() { go_to(start_time(document_.preset.saved)); }

void LabRuns::go_to_end() {
  picks_last_ = false;
  leave_past();
}

void LabRuns::show_end() {
  if (has_record() && !frames_.front()->playing && !recorders_.front()->met().empty()) {
    const MetStop& last = recorders_.front()->met().back();
    const double passed = frames_.front()->time - last.step_start;
    if (last.part > 0.0 && passed <= (1.0 + kSameMoment) * frames_.front()->method.step) return show_stop(last);
  }
  go_to_end();
}

void LabRuns::leave_past() {
  if (!std::exchange(playhead_, std::nullopt)) return;
  for (std::size_t i = 0; i < frames_.size(); ++i) frames_[i] = with_impacts(*frames_[i], i);
  show_speeds(frames_);
  emit framesChanged();
}

void LabRuns::go_to_impact(double time) {
  if (!has_record()) return;
  if (frames_.front()->playing) worker_.set_playing(false);
  stand_at_impact(time);
  emit framesChanged();
}

void LabRuns::stand_at_impact(double time) {
  picks_last_ = true;  // where it is at the end of the newest step
  const double just_before = 2.0 * kSameMoment * frames_.front()->method.step;
  stand_at({.time = time - just_before, .impact = time}, time);
}

void LabRuns::go_by_impact(bool forward) {
  if (!has_record()) return;
  const Frame& shown = *frames().front();
  const double step = shown.method.step;
  const double rounding = kSameMoment * step;
  const std::optional<double> asked = playhead_ ? playhead_->impact : std::nullopt;
  const bool within = playhead_ && (playhead_->moment.part > 0.0 || playhead_->moment.impact);
  const Recorder& recorder = *recorders_.front();
  // The impacts of a step that ends here are those of this moment.
  const std::optional<double> found =
      forward ? impact_after(recorder, asked ? *asked + rounding : shown_time() + rounding)
              : impact_until(recorder, asked    ? *asked - rounding
                                       : within ? shown_time() - rounding
                                                : shown_time() - step + rounding);
  if (found) return go_to_impact(*found);
  forward ? go_to_end() : go_to_start();
}

LabRuns::ShownMoment LabRuns::shown_moment() const {
  if (!playhead_) return {.picks_last = picks_last_};
  return {playhead_->moment, playhead_->impact, picks_last_};
}

void LabRuns::go_back_to(const ShownMoment& shown) {
  if (!has_record()) return;
  picks_last_ = shown.picks_last;
  if (!shown.past) return leave_past();
  seek(*shown.past, shown.impact);
}

void LabRuns::step_by(int steps) {
  picks_last_ = steps > 0;
  if (!playhead_ && steps > 0) return worker_.step_once();
  if (!has_record()) return;
  if (!playhead_ && frames_.front()->time <= start_time(document_.preset.saved)) return;
  if (playhead_ && playhead_->moment.impact) return step_from_impact(steps);
  PastMoment moment{frames().front()->time, steps};
  if (playhead_ && playhead_->moment.part > 0.0 && there() && steps < 0) ++moment.steps;  // to its step's start
  if (!there()) moment = {playhead_->moment.time, playhead_->moment.steps + steps};
  seek(moment);
}

// Whole steps from the moment of an impact, so that as many steps back lead there again.
void LabRuns::step_from_impact(int steps) {
  PastMoment moment = playhead_->moment;
  moment.steps += steps;
  const double time = *moment.impact + static_cast<double>(moment.steps) * frames_.front()->method.step;
  if (time >= frames_.front()->time) return leave_past();
  if (time <= start_time(document_.preset.saved)) return go_to_start();
  seek(moment, moment.steps == 0 ? moment.impact : std::nullopt);
}

double LabRuns::shown_time() const {
  if (frames().empty()) return start_time(document_.preset.saved);
  if (there()) return frames().front()->time;
  const PastMoment& moment = playhead_->moment;
  if (moment.impact) return *moment.impact + static_cast<double>(moment.steps) * frames().front()->method.step;
  return moment.time + static_cast<double>(moment.steps) * frames().front()->method.step + moment.part;
}

// Of runs that are recomputed there will be another one.
bool LabRuns::has_record() const {
  return !frames_.empty() && !begins_ && !will_begin_ && !replayed_ && frames_.front()->setup != nullptr;
}

void LabRuns::seek(const PastMoment& moment, std::optional<double> impact) {
  if (frames_.front()->playing) worker_.set_playing(false);
  stand_at(moment, impact);
  emit framesChanged();
}

void LabRuns::stand_at(const PastMoment& moment, std::optional<double> impact) {
  if (!playhead_) playhead_ = Playhead{};
  playhead_->impact = impact;
  playhead_->plays = false;
  ask_worker(moment);
}

void LabRuns::ask_worker(const PastMoment& moment) {
  playhead_->moment = moment;
  playhead_->there = false;
  playhead_->last = worker_.show(moment);
  if (playhead_->first == 0) playhead_->first = playhead_->last;
  playhead_->runs.clear();
  for (const auto& frame : frames_) playhead_->runs.push_back(frame->setup);
}

void LabRuns::play_past(bool playing) {
  if (!playing) return seek({frames().front()->time});
  playhead_->plays = true;
  playhead_->impact.reset();
  playhead_->passed = shown_time();
  begin_past_pace(shown_time());
}

void LabRuns::begin_past_pace(double time) {
  const auto now = Pace::Clock::now();
  pace_.begin(time, now);
  pace_.begin_measurement(time, now);
}

// What is due now at the present pace: no more than the moment from which on it plays slowly, near an impact of
// the first run.
double LabRuns::past_due(Pace::Clock::time_point now) {
  constexpr double kLeast = 1e-6;  // s
  const double due = pace_.due(now);
  const double passed = playhead_->passed;
  if (!slows_near_impacts_) return pace_.due_near_impacts(due, passed, due, now);
  const Frame& newest = *frames_.front();
  const double from = std::max(passed - kNearImpact, start_time(document_.preset.saved));
  const double to = std::min(std::max(passed, due) + kNearImpact, newest.time);
  std::vector<double> times;
  for (const ImpactRecord& impact : impacts_between(*recorders().front(), from, to))
    times.push_back(impact.time);
  const KnownImpacts known{times, from, to, newest.method.step, newest.time};
  return pace_.due_near_impacts(free_until(known, passed, due, kLeast), passed, due, now);
}

void LabRuns::play_past_on() {
  const auto now = Pace::Clock::now();
  const double due = past_due(now);
  if (const MetStop* met = stop_until(due)) return show_stop(*met);
  playhead_->passed = due;
  if (due >= frames_.front()->time) {
    go_to_end();
    if (!at_end()) worker_.set_playing(true, document_.preset.duration);
    return;
  }
  if (!playhead_->there && !playhead_->frames.empty())
    pace_.give_up_lag(playhead_->frames.front()->time, due, now);
  ask_worker({due});
}

void LabRuns::take_shown() {
  const Worker::Shown shown = worker_.take_shown();
  if (shown.frames.empty() || shown.number < playhead_->first) return;
  playhead_->there = shown.there && shown.number == playhead_->last;
  playhead_->on_the_way = !shown.there;
  const Frame& first_shown = *shown.frames.front();
  const bool is_newest =
      first_shown.steps >= frames_.front()->steps && first_shown.time >= frames_.front()->time;
  if (playhead_->there && !playhead_->plays && is_newest) return leave_past();
  Frames frames;
  for (const auto& each : shown.frames) frames.push_back(with_impacts(*each, frames.size()));
  show_speeds(frames);
  auto first = std::make_shared<Frame>(*frames.front());
  first->playing = playhead_->plays;
  if (playhead_->plays) pace_.measure(first->time, Pace::Clock::now());
  first->realised_speed = playhead_->plays ? pace_.reached() : 0.0;
  if (!playhead_->there || playhead_->plays) first->scene.reset();
  frames.front() = std::move(first);
  playhead_->frames = std::move(frames);
  emit framesChanged();
}

void LabRuns::show_speeds(const Frames& frames) {
  for (std::size_t i = 0; i < std::min(frames.size(), recorders_.size()); ++i) recorders_[i]->show(*frames[i]);
}

// Other runs than those of which a moment was asked for have another past.
void LabRuns::follow_runs() {
  show_speeds(frames());
  if (replayed_) return;
  const bool same = std::equal(frames_.begin(), frames_.end(), playhead_->runs.begin(), playhead_->runs.end(),
                               [](const auto& frame, const auto& setup) { return frame->setup == setup; });
  if (same) return;
  if (frames_.front()->time <= shown_time()) {
    playhead_.reset();
  } else {
    playhead_->first = 0;
    ask_worker(playhead_->moment);
  }
}

std::shared_ptr<const Frame> LabRuns::with_impacts(const Frame& frame, std::size_t run) const {
  auto copy = std::make_shared<Frame>(frame);
  copy->impacts_of_late = true;
  copy->impacts.clear();
  if (run < recorders_.size())
    copy->impacts = impacts_between(*recorders_[run], frame.time - kImpactShown, frame.time);
  return copy;
}

}  // namespace carom
