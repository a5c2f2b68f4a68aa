#include "app/lab/lab_runs.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <utility>

#include "physics/preset/start_fingerprint.h"

namespace carom {
namespace {

bool has_edit(const Frame& frame, Worker::EditId edit) {
  const std::vector<RunEdit>& edits = frame.setup->edits;
  return std::any_of(edits.begin(), edits.end(), [edit](const RunEdit& each) { return each.id == edit; });
}

}  // namespace

LabRuns::LabRuns(const Document& document) : document_(document), worker_(document.preset) {
  connect(&timer_, &QTimer::timeout, this, &LabRuns::poll);
  constexpr int kPeriod = 16;  // ms
  timer_.start(kPeriod);
}

// --- the clock
// -----------------------------------------------------------------------------------------------------------

void LabRuns::set_playing(bool playing) {
  picks_last_ = false;
  if (replayed_) return worker_.end_replay();
  if (playing) forget_wait();
  if (playhead_) return play_past(playing);
  worker_.set_playing(playing, document_.preset.duration);
}

void LabRuns::play_on() {
  forget_wait();
  go_to_end();
  worker_.set_playing(true);
}

bool LabRuns::at_end() const {
  if (frames_.empty() || frames_.front()->playing) return false;
  const double step = frames_.front()->method.step;
  const double time = frames_.front()->time;
  const double end = document_.preset.duration;
  return time < end + 0.5 * step && step_towards(end, time, step) < step;
}

void LabRuns::restart() {
  picks_last_ = false;
  forget_wait();
  show_start();
  playhead_.reset();
  replayed_.reset();
  begins_ = true;
  worker_.restart(document_.preset);
}

void LabRuns::set_speed(double speed) {
  speed_ = speed;
  pace_.set_speed(speed);
  if (playhead_ && !frames().empty()) begin_past_pace(frames().front()->time);
  worker_.set_speed(speed);
}

void LabRuns::slow_near_impacts(bool slow) {
  slows_near_impacts_ = slow;
  worker_.slow_near_impacts(slow);
}

bool LabRuns::slow() const {
  return playhead_ ? playhead_->plays && pace_.slow() : !frames_.empty() && frames_.front()->slow;
}

void LabRuns::run_until(double time) {
  picks_last_ = false;
  const auto wait_until = [this](const auto& fulfilled) {
    while (!fulfilled()) {
      worker_.wait_for_frames(std::chrono::milliseconds(100));
      poll();
    }
  };
  wait_until([this] { return !frames_.empty(); });  // shows the start too
  go_to_end();
  worker_.run_until(time);
  // Waits until the worker has stopped at the time; the first frames may still be older.
  wait_until([&] {
    const Frame& now = *frames_.front();
    return !now.playing &&
           (now.time >= time - (1.0 + kSameMoment) * document_.preset.method.step || lost() != nullptr);
  });
}

void LabRuns::when_still(const QString& what, std::function<void()> then) {
  if (playhead_ && playhead_->plays) play_past(false);
  worker_.set_playing(false);
  forget_wait();
  if (frames_.empty() || (!frames_.front()->playing && !replayed_ && there())) return then();
  then_ = std::move(then);
  waits_ = what;
  emit noticesChanged();
}

void LabRuns::forget_wait() {
  then_ = nullptr;
  if (waits_.isEmpty()) return;
  waits_.clear();
  emit noticesChanged();
}

// --- what is known of them
// -----------------------------------------------------------------------------------------------------------

void LabRuns::record(const std::vector<Curve>& curves) {
  if (std::exchange(curves_, curves) == curves) return;
  for (const auto& recorder : recorders_) recorder->keep(curves);
  if (!will_begin_) worker_.record(curves);
}

const Frame* LabRuns::lost() const {
  const auto lost =
      std::find_if(frames_.begin(), frames_.end(), [](const auto& frame) { return frame->lost.has_value(); });
  return lost == frames_.end() ? nullptr : lost->get();
}

std::shared_ptr<const Scene> LabRuns::shown_scene() {
  return scene() != nullptr || !plays() ? scene() : playing_scene_.at(frame());
}

std::shared_ptr<const Scene> LabRuns::shown_parts() {
  return scene() != nullptr || !plays() ? scene() : playing_scene_.parts(frame());
}

bool LabRuns::at_start() const {
  return begins_ || will_begin_ || frames().empty() ||
         (there() && frames().front()->time <= start_time(document_.preset.saved));
}

bool LabRuns::have_begun() const {
  if (begins_ || will_begin_ || frames_.empty()) return false;
  return replayed_ || frames_.front()->playing || frames_.front()->time > start_time(document_.preset.saved);
}

void LabRuns::poll() {
  const Frames news = worker_.take_frames();
  if (!news.empty()) take_news(news);
  if (playhead_) take_shown();
  if (playhead_ && playhead_->plays) play_past_on();
  // Deferred: not within the signal that reported the frame.
  if (then_ != nullptr && !frames_.front()->playing && !replayed_ && there()) {
    QTimer::singleShot(0, this, std::exchange(then_, nullptr));
    forget_wait();
  }
}

void LabRuns::show_soon() {
  const auto take = [this] {
    if (!begins_ && awaited_ == 0) return;            // is shown already
    constexpr std::chrono::milliseconds kLongest{4};  // it is ready after 1 ms for a thousand bodies
    worker_.wait_for_frames(kLongest);
    poll();
  };
  QMetaObject::invokeMethod(this, take, Qt::QueuedConnection);
}

void LabRuns::take_news(const Frames& news) {
  begins_ = false;
  // Each run keeps its recorder, whatever runs were added or removed before it.
  std::vector<std::shared_ptr<Recorder>> recorders;
  for (const auto& frame : news) {
    const auto own = std::find_if(recorders_.begin(), recorders_.end(),
                                  [&](const auto& recorder) { return recorder->run() == frame->run; });
    recorders.push_back(own == recorders_.end() ? std::make_shared<Recorder>() : *own);
    recorders.back()->add(*frame);
  }
  replayed_.reset();
  if (news.front()->replay_until) replayed_ = news.front()->time;
  recorders_ = std::move(recorders);
  const Frames before = std::exchange(frames_, news);
  if (has_edit(*frames_.front(), awaited_)) awaited_ = 0;
  if (awaited_ == 0 || frames_.front()->playing) scene_ = frames_.front()->scene;
  if (!frames_.front()->playing) playing_scene_.forget_expected();
  if (playhead_) follow_runs();
  take_halt(before);
  emit framesChanged();
}

// --- changes of the document
// -----------------------------------------------------------------------------------------------------------

void LabRuns::load(const std::vector<Curve>& curves) {
  picks_last_ = false;
  forget_wait();
  frames_.clear();
  playhead_.reset();
  scene_.reset();
  awaited_ = 0;
  recorders_.clear();
  left_.clear();
  before_.reset();
  before_left_.reset();
  replayed_.reset();
  curves_ = curves;
  begins_ = true;
  worker_.load(document_.preset, curves, document_.reference);
}

void LabRuns::show_start() {
  scene_ = scene_at_start(document_.preset.scene);
  awaited_ = 0;
}

void LabRuns::await_begin() {
  forget_wait();
  will_begin_ = true;
  playhead_.reset();
  show_start();
}

void LabRuns::begin() {
  picks_last_ = false;
  begins_ = true;
  replayed_.reset();
  will_begin_ = false;
  // A start that was not edited since leaves what was pale beside its run.
  if (before_left_ && before_ && before_->begin == fingerprint_of_start(document_.preset))
    before_ = before_left_;
  before_left_.reset();
  worker_.start_from(document_.preset, curves_, document_.reference);
  show_soon();
}

Worker::EditId LabRuns::keep(Worker::EditId again) {
  const Worker::EditId edit = worker_.keep_runs(again);
  if (again == 0) {
    // Edits that are taken back can't be made again after a new one.
    std::erase_if(left_, [](const auto& each) { return each.second.returned; });
    left_[edit] = {.frames = frames_, .scene = scene_, .playhead = playhead_};
    left_[edit].stand_still();
  }
  const auto left = left_.find(edit);
  left->second.returned = false;
  left->second.recorders = recorders_;
  // Of a run that was added just before, the first frame may have come since.
  if (left->second.frames.size() != recorders_.size()) {
    left->second.frames = frames_;
    left->second.scene = scene_;
    left->second.playhead = playhead_;
    left->second.stand_still();
  }
  left->second.before = before_;
  if (have_begun()) leave_run();
  for (auto& recorder : recorders_) recorder = std::make_shared<Recorder>();
  if (std::distance(left_.begin(), left) >= RunGroup::kMostKept)
    std::prev(left, RunGroup::kMostKept)->second.keep_picture();
  return edit;
}

void LabRuns::leave_run() {
  RunBefore left = as_before();
  const bool same_method = frames_.front()->setup->method == document_.preset.method;
  before_left_ = same_method && before_ && before_->begin != left.begin ? before_ : std::nullopt;
  before_ = std::move(left);
}

// The whole run, as it stands.
RunBefore LabRuns::as_before() const {
  const Frame& newest = *frames_.front();
  const double start = start_time(document_.preset.saved);
  return {.recorder = recorders_.front(),
          .bodies = newest.bodies,
          .start = start,
          .from = start,
          .begin = fingerprint_of_start(newest.setup->scene, newest.setup->saved, newest.setup->edits),
          .lost = newest.lost.has_value()};
}

Worker::EditId LabRuns::cut(Worker::EditId again) {
  const Worker::EditId edit = keep(again);
  before_left_.reset();
  const Left& left = left_.at(edit);
  // They go on with what is recorded until then.
  std::transform(left.recorders.begin(), left.recorders.end(), recorders_.begin(),
                 [](const auto& recorder) { return std::make_shared<Recorder>(*recorder); });
  frames_ = left.playhead->frames;
  picks_last_ = false;
  if (before_) before_->from = frames_.front()->time;
  scene_ = frames_.front()->scene;
  awaited_ = 0;
  playhead_.reset();
  replayed_.reset();
  std::vector<RunEdit> of_file = document_.preset.edits;
  std::erase_if(of_file, [](const RunEdit& each) { return each.id != 0; });
  worker_.cut(edit, frames_.front()->time, of_file);
  emit framesChanged();
  return edit;
}

void LabRuns::Left::stand_still() {
  const auto still = [](const auto& frame) {
    auto copy = std::make_shared<Frame>(*frame);
    copy->playing = false;
    return copy;
  };
  if (!frames.empty() && frames.front()->playing) frames.front() = still(frames.front());
  if (!playhead || !playhead->plays) return;
  playhead->plays = false;
  if (!playhead->frames.empty()) playhead->frames.front() = still(playhead->frames.front());
}

void LabRuns::Left::keep_picture() {
  recorders.assign(frames.size(), std::make_shared<Recorder>());
  before.reset();
  for (auto& frame : frames) {
    auto picture = std::make_shared<Frame>(*frame);
    picture->key_frames.clear();
    picture->rows.clear();
    picture->impacts.clear();
    frame = picture;
  }
}

// What was shown at an earlier time, until the runs are there.
void LabRuns::show_again(const Frames& frames, const std::shared_ptr<const Scene>& scene,
                         const std::optional<Playhead>& playhead) {
  if (!frames.empty()) frames_ = frames;
  scene_ = scene;
  // The moment of the past is asked for when the runs are there.
  playhead_ = playhead;
  if (playhead_) {
    playhead_->runs.clear();
    playhead_->there = false;
  }
  awaited_ = 0;
  replayed_.reset();
  // A run that was just begun may have shown nothing yet: the picture of the other run stays, without its
  // record.
  begins_ = frames.empty();
  will_begin_ = false;
  recorders_.resize(frames_.size());
  for (auto& recorder : recorders_) {
    if (recorder == nullptr || begins_) recorder = std::make_shared<Recorder>();
  }
}

void LabRuns::return_to(Worker::EditId edit) {
  picks_last_ = false;
  Left& left = left_.at(edit);
  left.returned = true;
  recorders_ = std::move(left.recorders);
  before_ = left.before;
  show_again(left.frames, left.scene, left.playhead);
  left.keep_picture();
  for (const auto& recorder : recorders_) recorder->keep(curves_);
  worker_.return_to(edit, curves_, document_.reference);
  watch_stops();
  if (!frames_.empty()) emit framesChanged();
}

std::shared_ptr<LabRuns::Entered> LabRuns::enter() const {
  auto run = std::make_shared<Entered>();
  run->time = start_time(document_.preset.saved);
  if (begins_ || will_begin_ || frames_.empty()) return run;
  Left shown{.frames = frames_, .scene = scene_, .playhead = playhead_};
  shown.keep_picture();
  run->time = frames_.front()->time;
  run->frames = shown.frames;
  run->scene = shown.scene;
  run->playhead = shown.playhead;
  return run;
}

void LabRuns::take_back(Entered& run) {
  picks_last_ = false;
  forget_wait();
  run.kept = worker_.keep_taken_back();
  // What is shown until the first frame has come is the run before.
  Left left{.frames = begins_ ? Frames() : frames_, .scene = scene_, .playhead = playhead_, .returned = true};
  left.stand_still();
  left.recorders = recorders_;
  left.before = before_;
  left_[run.kept] = std::move(left);
  show_again(run.frames, run.scene, run.playhead);
  for (auto& recorder : recorders_) recorder = std::make_shared<Recorder>(*recorder);
  worker_.cut(run.kept, run.time, document_.preset.edits);
  // Play may have been pressed before the first frame came: the next one shows the start.
  if (!frames_.empty()) emit framesChanged();
}

void LabRuns::make_again(const Entered& run) { return_to(run.kept); }

Worker::EditId LabRuns::begin_with(const Methods& methods, const std::vector<Curve>& curves) {
  forget_wait();
  playhead_.reset();
  curves_ = curves;
  Preset start = document_.preset;
  start.method = methods.own;
  start.compare = methods.others;
  begins_ = true;
  return worker_.restart(start, curves, methods.reference);
}

Worker::EditId LabRuns::edit(const std::vector<std::pair<std::size_t, Method>>& methods,
                             const SceneEdits& edits, Worker::EditId part_of) {
  forget_wait();
  if (scene_ != nullptr) {
    auto next = std::make_shared<Scene>(*scene_);
    apply_edits(*next, edits);
    scene_ = next;
  }
  if (!methods.empty()) part_of = worker_.set_methods(methods, part_of);
  awaited_ = worker_.edit_scene(edits, part_of);
  if (scene_ == nullptr) playing_scene_.expect(awaited_, edits);
  show_soon();
  return awaited_;
}

void LabRuns::undo_or_redo(Worker::EditId edit) {
  awaited_ = 0;
  playing_scene_.forget_expected();
  worker_.undo_or_redo(edit, document_.preset, document_.reference);
}

}  // namespace carom
