#include "app/lab/session.h"

#include <algorithm>
#include <utility>

#include "physics/preset/preset_file.h"

namespace carom {
namespace {

bool has_edit(const Frame& frame, Worker::EditId edit) {
  const std::vector<RunEdit>& edits = frame.setup->edits;
  return std::any_of(edits.begin(), edits.end(), [edit](const RunEdit& each) { return each.id == edit; });
}

Preset empty_document() {
  Preset empty;
  empty.title = "Empty scene";
  return empty;
}

}  // namespace

Session::Session(QObject* parent) : QObject(parent), worker_(empty_document()), document_{empty_document()} {
  connect(&edits_, &QUndoStack::indexChanged, this, &Session::check_modified);
  connect(&edits_, &QUndoStack::cleanChanged, this, &Session::check_modified);
  connect(&timer_, &QTimer::timeout, this, &Session::poll);
  constexpr int kPeriod = 16;  // ms
  timer_.start(kPeriod);
}

// --- the document
// -----------------------------------------------------------------------------------------------------------

void Session::open(const Preset& preset, const std::vector<Plot>& plots, const std::vector<Curve>& curves,
                   const QString& name, const QString& file) {
  forget_wait();
  document_ = {preset,
               preset.compare.empty() ? ReferenceId::kNone : usual_reference(setup_of(preset)),
               {},
               !name.isEmpty()};
  document_.preset.plots = plots;
  give_ids(document_.preset.scene);
  name_ = name;
  file_ = file;
  bodies_ = all_bodies(preset);
  frames_.clear();
  scene_.reset();
  awaited_ = 0;
  recorders_.clear();
  replayed_.reset();
  curves_ = curves;
  begins_ = true;
  worker_.load(document_.preset, curves, document_.reference);
  ++revision_;
  edits_.clear();
  edits_.setClean();
  check_modified();
  emit documentChanged();
}

void Session::save(const QString& file) {
  save_preset(document_.preset, file.toStdString());
  file_ = file;
  edits_.setClean();
}

bool Session::modified() const {
  const int clean = edits_.cleanIndex();
  if (clean < 0) return true;
  const auto [from, to] = std::minmax({clean, edits_.index()});
  for (int i = from; i < to; ++i) {
    if (static_cast<const DocumentEdit*>(edits_.command(i))->what().is_work) return true;
  }
  return false;
}

void Session::check_modified() {
  const bool now = modified();
  if (std::exchange(was_modified_, now) != now) emit modifiedChanged(now);
}

// --- the runs
// -----------------------------------------------------------------------------------------------------------

void Session::set_playing(bool playing) {
  if (replayed_) return worker_.end_replay();
  if (playing) forget_wait();
  worker_.set_playing(playing, document_.preset.duration);
}

void Session::restart() {
  forget_wait();
  replayed_.reset();
  begins_ = true;
  scene_ = scene_at_start(document_.preset.scene);
  awaited_ = 0;
  worker_.restart(document_.preset);
}

void Session::set_speed(double speed) {
  speed_ = speed;
  worker_.set_speed(speed);
}

void Session::run_until(double time) {
  const auto wait_until = [this](const auto& fulfilled) {
    while (!fulfilled()) {
      worker_.wait_for_frames(std::chrono::milliseconds(100));
      poll();
    }
  };
  wait_until([this] { return !frames_.empty(); });  // shows the start too
  worker_.run_until(time);
  // Waits until the worker has stopped at the time; the first frames may still be older.
  wait_until([&] {
    const Frame& now = *frames_.front();
    return !now.playing &&
           (now.time >= time - (1.0 + 1e-9) * document_.preset.method.step || lost() != nullptr);
  });
}

void Session::record(const std::vector<Curve>& curves) {
  if (std::exchange(curves_, curves) == curves) return;
  for (const auto& recorder : recorders_) recorder->keep(curves);
  if (!will_begin_) worker_.record(curves);
}

const Frame* Session::lost() const {
  const auto lost =
      std::find_if(frames_.begin(), frames_.end(), [](const auto& frame) { return frame->lost.has_value(); });
  return lost == frames_.end() ? nullptr : lost->get();
}

void Session::poll() {
  const std::vector<std::shared_ptr<const Frame>> news = worker_.take_frames();
  if (news.empty()) return;
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
  frames_ = news;
  if (has_edit(*frames_.front(), awaited_)) awaited_ = 0;
  if (awaited_ == 0 || frames_.front()->playing) scene_ = frames_.front()->scene;
  take_times_of_edits();
  emit framesChanged();
  // Deferred: not within the signal that reported the frame.
  if (then_ != nullptr && !frames_.front()->playing && !replayed_) {
    QTimer::singleShot(0, this, std::exchange(then_, nullptr));
    forget_wait();
  }
}

void Session::when_still(const QString& what, std::function<void()> then) {
  worker_.set_playing(false);
  forget_wait();
  if (!frames_.front()->playing && !replayed_) return then();
  then_ = std::move(then);
  waits_ = what;
  emit noticesChanged();
}

void Session::forget_wait() {
  then_ = nullptr;
  if (waits_.isEmpty()) return;
  waits_.clear();
  emit noticesChanged();
}

}  // namespace carom
