#include "app/lab/session.h"

#include <algorithm>
#include <utility>

#include "physics/model/mass.h"
#include "physics/preset/preset_file.h"
#include "physics/scene/facts.h"
#include "physics/scene/validate.h"

namespace carom {
namespace {

// With more moving bodies the costly reference runs only on request.
constexpr std::ptrdiff_t kMostWithReference = 200;

// Whether the user made it: own plots and notes.
std::vector<Plot> own_plots(std::vector<Plot> plots) {
  std::erase_if(plots, [](const Plot& plot) { return !plot.id.empty() && plot.notes.empty(); });
  return plots;
}

std::vector<Plot> without_notes(std::vector<Plot> plots) {
  for (Plot& plot : plots) plot.notes.clear();
  return plots;
}

QString text_of_change(const Method& from, Method to) {
  Method same = from;
  same.step = to.step;
  if (same == to) return Session::tr("change of step");
  same.tolerance = std::exchange(to.tolerance, from.tolerance);
  return to == from ? Session::tr("change of tolerance") : Session::tr("change of method");
}

void add_edit(std::vector<RunEdit>& edits, const RunEdit& edit) {
  edits.insert(std::upper_bound(edits.begin(), edits.end(), edit, is_earlier), edit);
}

// Adding a body is the only edit of the runs that a document holds.
bool same_bodies(const std::vector<RunEdit>& a, const std::vector<RunEdit>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const RunEdit& x, const RunEdit& y) {
    return added_body(x).name == added_body(y).name;
  });
}

Preset empty_document() {
  Preset empty;
  empty.title = "Empty scene";
  return empty;
}

}  // namespace

Session::Session(QObject* parent) : QObject(parent), worker_(empty_document()), document_(empty_document()) {
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
  document_ = preset;
  document_.plots = plots;
  give_ids(document_.scene);
  name_ = name;
  file_ = file;
  bodies_ = all_bodies(preset);
  before_usual_.reset();
  reference_ = preset.compare.empty() ? ReferenceId::kNone : usual_reference(setup_of(preset));
  frames_.clear();
  recorders_.clear();
  replayed_.reset();
  curves_ = curves;
  worker_.load(document_, curves, reference_);
  ++revision_;
  edits_.clear();
  edits_.setClean();
  check_modified();
  emit documentChanged();
}

void Session::save(const QString& file) {
  save_preset(document_, file.toStdString());
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

// --- edits
// -----------------------------------------------------------------------------------------------------------

Edited Session::edited() const {
  return {{document_.method, document_.compare, reference_}, before_usual_, document_.edits, document_.plots};
}

void Session::push(const DocumentEdit::What& what, const Edited& after) {
  auto edit = std::make_unique<DocumentEdit>(*this, what, edited(), after);
  assign(after);
  edits_.push(edit.release());
}

void Session::assign(const Edited& to) {
  document_.method = to.methods.own;
  document_.compare = to.methods.others;
  reference_ = to.methods.reference;
  before_usual_ = to.before_usual;
  const bool other_plots = std::exchange(document_.plots, to.plots) != to.plots;
  assign_added(to.added);
  ++revision_;
  if (other_plots) emit plotsChanged();
  emit documentChanged();
}

void Session::assign_added(const std::vector<RunEdit>& added) {
  const std::vector<RunEdit> old = std::exchange(document_.edits, added);
  if (same_bodies(old, added)) return;
  bodies_ = all_bodies(document_);
  emit bodiesChanged();
}

void Session::undo(const Edited& before, Worker::EditId runs) { go_to(before, runs, &Worker::undo); }

void Session::redo(const Edited& after, Worker::EditId runs) { go_to(after, runs, &Worker::redo); }

void Session::go_to(const Edited& to, Worker::EditId runs,
                    void (Worker::*change)(Worker::EditId, const Preset&, ReferenceId)) {
  forget_wait();
  const ReferenceId before = reference_;
  assign(to);
  if (runs != 0) {
    (worker_.*change)(runs, document_, reference_);
  } else if (before != reference_) {
    worker_.set_reference(reference_);
  }
}

void Session::change_method(const Method& method, std::size_t run) {
  if (run > document_.compare.size()) return;
  Edited after = edited();
  Method& now = run == 0 ? after.methods.own : after.methods.others[run - 1];
  const Method before = std::exchange(now, method);
  if (before == method) return;
  push({text_of_change(before, method), worker_.set_method(method, run)}, after);
}

void Session::change_step(double step, const std::vector<std::size_t>& runs, int drag) {
  Edited after = edited();
  std::vector<std::pair<std::size_t, Method>> changed;
  for (const std::size_t run : runs) {
    if (run > document_.compare.size()) continue;
    Method& now = run == 0 ? after.methods.own : after.methods.others[run - 1];
    if (std::exchange(now.step, step) != step) changed.emplace_back(run, now);
  }
  if (changed.empty()) return;
  // As the undo stack merges them: not with a saved state.
  const int last = edits_.index() == edits_.cleanIndex() ? -1 : edits_.index() - 1;
  const auto* before = last < 0 ? nullptr : static_cast<const DocumentEdit*>(edits_.command(last));
  const bool same_drag = before != nullptr && before->what().drag == drag;
  const Worker::EditId edit = worker_.set_methods(changed, same_drag ? before->what().runs : 0);
  push({tr("change of step"), edit, true, drag}, after);
}

void Session::add_method(const Method& method) {
  Edited after = edited();
  const bool full = after.methods.others.size() == kMostCompared;
  if (full) after.methods.others.pop_back();
  after.methods.others.push_back(method);
  const Worker::EditId runs = full ? worker_.set_method(method, kMostCompared) : worker_.add_method(method);
  if (reference_ == ReferenceId::kNone) {
    after.methods.reference = first_reference();
    worker_.set_reference(after.methods.reference);
  }
  push({tr("added method"), runs}, after);
}

void Session::compare_with(const Method& method) {
  const std::vector<Method>& others = document_.compare;
  const bool there =
      document_.method == method || std::find(others.begin(), others.end(), method) != others.end();
  if (!there) add_method(method);
}

void Session::remove_method(std::size_t run) {
  if (run == 0 || run > document_.compare.size()) return;
  Edited after = edited();
  after.methods.others.erase(after.methods.others.begin() + static_cast<std::ptrdiff_t>(run) - 1);
  push({tr("removed method"), worker_.remove_method(run)}, after);
}

void Session::choose_reference(ReferenceId reference) {
  if (reference == reference_) return;
  Edited after = edited();
  after.methods.reference = reference;
  worker_.set_reference(reference);
  push({tr("choice of reference"), 0, false}, after);  // not saved in files
}

ReferenceId Session::first_reference() const {
  const auto moving =
      std::count_if(bodies_.begin(), bodies_.end(), [](const Body& b) { return !has_infinite_mass(b); });
  return moving > kMostWithReference ? ReferenceId::kNone : usual_reference(setup_of(document_));
}

// The exact run becomes the scene's own run meanwhile: the others are compared with it, and a preset saved
// then stays valid.
void Session::compare_usual(const std::vector<Plot>& plots, const std::vector<Curve>& curves) {
  forget_wait();
  Edited after = edited();
  after.plots = plots;
  if (before_usual_) {
    after.methods = *std::exchange(after.before_usual, std::nullopt);
  } else {
    after.before_usual = after.methods;
    Method euler = document_.method;
    euler.integrator = IntegratorId::kExplicitEuler;
    Method rk4 = document_.method;
    rk4.integrator = IntegratorId::kRk4;
    const RunSetup setup = setup_of(document_);
    after.methods = {
        reference_for(setup, document_.method, usual_reference(setup)), {euler, rk4}, first_reference()};
  }
  curves_ = curves;
  Preset start = document_;
  start.method = after.methods.own;
  start.compare = after.methods.others;
  const Worker::EditId runs = worker_.restart(start, curves, after.methods.reference);
  push({tr("comparison with the exact run"), runs}, after);
}

void Session::add_body(double x, double y) {
  Preset with = document_;
  // A disc like the existing ones, between half and one and a half times their radius; in a scene without any,
  // a twentieth of the view.
  Body body;
  double radius = with.view ? with.view->width / 20.0 : 0.1;
  body.density = 1.0;
  for (const Body& b : bodies_) {
    const auto* disc = std::get_if<Disc>(&b.shape);
    if (has_infinite_mass(b) || disc == nullptr || disc->radius == 0.0) continue;
    radius = disc->radius;
    body.density = mass_of(b) / area(b.shape);
    body.material = b.material;
    break;
  }
  body.name = free_body_name(bodies_, "new");
  body.id.number = with.scene.ids_given + 1;
  body.shape = Disc{radius * (0.5 + sizes_.generateDouble())};
  body.position = {x, y};
  const SceneEdits edits = {Add<Body>{body}};
  // The time is the displayed one until the runs tell when they had it.
  const double now = frames_.empty() ? start_time(with.saved) : frames_.front()->time;
  add_edit(with.edits, {now, 0, edits});
  validate(with);
  ++document_.scene.ids_given;
  Edited after = edited();
  const Worker::EditId edit = worker_.edit_scene(edits);
  add_edit(after.added, {now, edit, edits});
  push({tr("added body"), edit}, after);
}

// The choice of named plots of a built-in experiment is not work that could be lost.
void Session::change_plots(const std::vector<Plot>& plots) {
  if (plots == document_.plots) return;
  Edited after = edited();
  after.plots = plots;
  const bool is_work = !file_.isEmpty() || own_plots(plots) != own_plots(document_.plots);
  const bool notes = without_notes(plots) == without_notes(document_.plots);
  push({notes ? tr("change of notes") : tr("change of plots"), 0, is_work}, after);
}

// --- the runs
// -----------------------------------------------------------------------------------------------------------

void Session::set_playing(bool playing) {
  if (replayed_) return worker_.end_replay();
  if (playing) forget_wait();
  worker_.set_playing(playing, document_.duration);
}

void Session::restart() {
  forget_wait();
  replayed_.reset();
  worker_.restart(document_);
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
    return !now.playing && (now.time >= time - (1.0 + 1e-9) * document_.method.step || lost() != nullptr);
  });
}

void Session::record(const std::vector<Curve>& curves) {
  if (std::exchange(curves_, curves) == curves) return;
  for (const auto& recorder : recorders_) recorder->keep(curves);
  worker_.record(curves);
}

const Frame* Session::lost() const {
  const auto lost =
      std::find_if(frames_.begin(), frames_.end(), [](const auto& frame) { return frame->lost.has_value(); });
  return lost == frames_.end() ? nullptr : lost->get();
}

void Session::poll() {
  const std::vector<std::shared_ptr<const Frame>> news = worker_.take_frames();
  if (news.empty()) return;
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
  take_times_of_edits();
  emit framesChanged();
  // Deferred: not within the signal that reported the frame.
  if (then_ != nullptr && !frames_.front()->playing && !replayed_) {
    QTimer::singleShot(0, this, std::exchange(then_, nullptr));
    forget_wait();
  }
}

// An edit is timed by the runs. Its time decides the order of bodies, and plots know these by their index.
void Session::take_times_of_edits() {
  const std::vector<RunEdit>& known = frames_.front()->setup->edits;
  const auto time_of = [&known](const RunEdit& edit) {
    const auto found =
        std::find_if(known.begin(), known.end(), [&edit](const RunEdit& k) { return k.id == edit.id; });
    return edit.id == 0 || found == known.end() ? edit.time : found->time;
  };
  if (std::all_of(document_.edits.begin(), document_.edits.end(),
                  [&](const RunEdit& edit) { return edit.time == time_of(edit); }))
    return;
  std::vector<RunEdit> timed;
  for (RunEdit edit : document_.edits) {
    edit.time = time_of(edit);
    add_edit(timed, edit);
  }
  ++revision_;
  assign_added(timed);
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
