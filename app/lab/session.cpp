#include "app/lab/session.h"

#include <algorithm>
#include <utility>

#include "physics/model/mass.h"
#include "physics/preset/preset_file.h"
#include "physics/scene/edit_rules.h"
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

Method& method_of(Methods& methods, std::size_t run) {
  return run == 0 ? methods.own : methods.others[run - 1];
}

bool is_of_scene(const DocumentChange& change) {
  return std::any_of(change.begin(), change.end(), [](const auto& part) {
    return std::holds_alternative<SceneEdits>(part) || std::holds_alternative<SetScene>(part) ||
           std::holds_alternative<SetLateBodies>(part);
  });
}

// As scene_now() gives it at the start of a run.
std::shared_ptr<const Scene> scene_at_start(const Scene& start) {
  auto scene = std::make_shared<Scene>(start);
  scene->bodies = all_bodies(start);
  for (std::size_t i = 0; i < scene->bodies.size(); ++i) {
    Id<Body>& id = scene->bodies[i].id;
    if (id.number == 0) id.number = kFirstGenerated + static_cast<std::uint32_t>(i);
  }
  return scene;
}

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

// --- edits
// -----------------------------------------------------------------------------------------------------------

void Session::push(const DocumentEdit::What& what, const DocumentChange& change) {
  edits_.push(new DocumentEdit(*this, what, assign(change)));
}

DocumentChange Session::assign(const DocumentChange& change) {
  const std::vector<Plot> plots = document_.preset.plots;
  DocumentChange back = apply_change(document_, change);
  ++revision_;
  if (is_of_scene(change)) {
    bodies_ = all_bodies(document_.preset);
    emit bodiesChanged();
  } else if (plots != document_.preset.plots) {
    emit plotsChanged();
  }
  emit documentChanged();
  return back;
}

DocumentChange Session::go_to(const DocumentChange& change, const DocumentEdit::What& what,
                              void (Worker::*runs)(Worker::EditId, const Preset&, ReferenceId)) {
  forget_wait();
  const ReferenceId before = document_.reference;
  will_begin_ = what.begins;
  awaited_ = 0;
  DocumentChange back = assign(change);
  if (what.begins) {
    scene_ = scene_at_start(document_.preset.scene);
    begin_runs();
  } else if (what.runs != 0) {
    (worker_.*runs)(what.runs, document_.preset, document_.reference);
  } else if (before != document_.reference) {
    worker_.set_reference(document_.reference);
  }
  return back;
}

const DocumentEdit* Session::last_edit() const {
  return edits_.index() == 0 ? nullptr : static_cast<const DocumentEdit*>(edits_.command(edits_.index() - 1));
}

bool Session::at_start() const {
  return begins_ || frames_.empty() || frames_.front()->time <= start_time(document_.preset.saved);
}

void Session::begin_runs() {
  begins_ = true;
  replayed_.reset();
  will_begin_ = false;
  worker_.start_from(document_.preset, curves_, document_.reference);
}

void Session::edit(const SceneEdits& asked, const QString& text, int drag) {
  const bool begins = at_start();
  if (!begins && (frames_.front()->playing || replayed_))
    return when_still(text, [=, this] { edit(asked, text, drag); });
  if (!begins && scene_ == nullptr) return emit editRefused(tr("Restart the run first."));
  const Scene now = begins ? document_.preset.scene : *scene_;
  SceneEdits edits = asked;
  number_new_parts(document_.preset.scene, edits);
  // Bodies that are removed leave their place to others, which only runs that begin anew can follow.
  const bool from_here = !begins && std::any_of(edits.begin(), edits.end(), [&now](const SceneEdit& each) {
    return is_about_motion(now, each) || std::holds_alternative<Remove<Body>>(each);
  });
  try {
    const DocumentChange change = begins ? change_of_start(document_, edits)
                                  : from_here
                                      ? change_to_moment(document_, now, frames_.front()->time, edits)
                                      : change_of_start(document_, at_the_start(document_.preset, edits));
    Document changed = document_;
    apply_change(changed, change);
    validate(changed.preset);
    DocumentEdit::What what{.text = text, .begins = begins || from_here};
    if (drag > 0) what.drag = drag;
    forget_wait();
    will_begin_ = what.begins;
    if (what.begins) {
      scene_ = scene_at_start(changed.preset.scene);
      awaited_ = 0;
    } else {
      const SceneEdits all = with_followers(now, edits);
      auto next = std::make_shared<Scene>(now);
      apply_edits(*next, all);
      scene_ = next;
      what.runs = awaited_ = edit_runs(all, change, drag);
    }
    push(what, change);
    if (what.begins) begin_runs();
  } catch (const std::exception& error) {
    emit editRefused(QString::fromUtf8(error.what()));
  }
}

// The edits in the runs as they go on, with the methods that the change sets: one edit of the runs for a whole
// drag.
Worker::EditId Session::edit_runs(const SceneEdits& edits, const DocumentChange& change, int drag) {
  const DocumentEdit* last = drag > 0 && edits_.index() != edits_.cleanIndex() ? last_edit() : nullptr;
  Worker::EditId id = last != nullptr && last->what().drag == drag ? last->what().runs : 0;
  for (const auto& part : change) {
    const auto* set = std::get_if<SetMethods>(&part);
    if (set == nullptr) continue;
    std::vector<std::pair<std::size_t, Method>> methods = {{0, set->methods.own}};
    for (const Method& method : set->methods.others) methods.emplace_back(methods.size(), method);
    id = worker_.set_methods(methods, id);
  }
  return worker_.edit_scene(edits, id);
}

void Session::cancel(int drag) {
  const DocumentEdit* last = last_edit();
  if (last == nullptr || last->what().drag != drag) return;
  auto* edit = const_cast<QUndoCommand*>(edits_.command(edits_.index() - 1));
  edit->undo();
  edit->setObsolete(true);  // the stack drops it instead of keeping it for redo
  edits_.undo();
}

void Session::change_method(const Method& method, std::size_t run) {
  if (run > document_.preset.compare.size()) return;
  Methods after = document_.methods();
  const Method before = std::exchange(method_of(after, run), method);
  if (before == method) return;
  push({text_of_change(before, method), worker_.set_method(method, run)},
       {SetMethods{after, document_.before_usual}});
}

void Session::change_step(double step, const std::vector<std::size_t>& runs, int drag) {
  Methods after = document_.methods();
  std::vector<std::pair<std::size_t, Method>> changed;
  for (const std::size_t run : runs) {
    if (run > document_.preset.compare.size()) continue;
    Method& now = method_of(after, run);
    if (std::exchange(now.step, step) != step) changed.emplace_back(run, now);
  }
  if (changed.empty()) return;
  // As the undo stack merges them: not with a saved state.
  const DocumentEdit* before = edits_.index() == edits_.cleanIndex() ? nullptr : last_edit();
  const bool same_drag = before != nullptr && before->what().drag == drag;
  DocumentEdit::What what{.text = tr("change of step"),
                          .runs = worker_.set_methods(changed, same_drag ? before->what().runs : 0)};
  what.drag = drag;
  push(what, {SetMethods{after, document_.before_usual}});
}

void Session::add_method(const Method& method) {
  Methods after = document_.methods();
  const bool full = after.others.size() == kMostCompared;
  if (full) after.others.pop_back();
  after.others.push_back(method);
  const Worker::EditId runs = full ? worker_.set_method(method, kMostCompared) : worker_.add_method(method);
  if (after.reference == ReferenceId::kNone) {
    after.reference = first_reference();
    worker_.set_reference(after.reference);
  }
  push({tr("added method"), runs}, {SetMethods{after, document_.before_usual}});
}

void Session::compare_with(const Method& method) {
  const std::vector<Method>& others = document_.preset.compare;
  const bool there =
      document_.preset.method == method || std::find(others.begin(), others.end(), method) != others.end();
  if (!there) add_method(method);
}

void Session::remove_method(std::size_t run) {
  if (run == 0 || run > document_.preset.compare.size()) return;
  Methods after = document_.methods();
  after.others.erase(after.others.begin() + static_cast<std::ptrdiff_t>(run) - 1);
  push({tr("removed method"), worker_.remove_method(run)}, {SetMethods{after, document_.before_usual}});
}

void Session::choose_reference(ReferenceId reference) {
  if (reference == document_.reference) return;
  Methods after = document_.methods();
  after.reference = reference;
  worker_.set_reference(reference);
  DocumentEdit::What what{.text = tr("choice of reference"), .is_work = false};  // not saved in files
  push(what, {SetMethods{after, document_.before_usual}});
}

ReferenceId Session::first_reference() const {
  const auto moving =
      std::count_if(bodies_.begin(), bodies_.end(), [](const Body& b) { return !has_infinite_mass(b); });
  return moving > kMostWithReference ? ReferenceId::kNone : usual_reference(setup_of(document_.preset));
}

// The exact run becomes the scene's own run meanwhile: the others are compared with it, and a preset saved
// then stays valid.
void Session::compare_usual(const std::vector<Plot>& plots, const std::vector<Curve>& curves) {
  forget_wait();
  SetMethods set{document_.methods(), document_.before_usual};
  if (set.before_usual) {
    set.methods = *std::exchange(set.before_usual, std::nullopt);
  } else {
    set.before_usual = set.methods;
    Method euler = document_.preset.method;
    euler.integrator = IntegratorId::kExplicitEuler;
    Method rk4 = document_.preset.method;
    rk4.integrator = IntegratorId::kRk4;
    const RunSetup setup = setup_of(document_.preset);
    set.methods = {
        reference_for(setup, document_.preset.method, usual_reference(setup)), {euler, rk4}, first_reference()};
  }
  curves_ = curves;
  Preset start = document_.preset;
  start.method = set.methods.own;
  start.compare = set.methods.others;
  begins_ = true;
  const Worker::EditId runs = worker_.restart(start, curves, set.methods.reference);
  push({tr("comparison with the exact run"), runs}, {set, SetPlots{plots}});
}

void Session::add_body(double x, double y) {
  const Preset& preset = document_.preset;
  // A disc like the existing ones, between half and one and a half times their radius; in a scene without any,
  // a twentieth of the view.
  Body body;
  double radius = preset.view ? preset.view->width / 20.0 : 0.1;
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
  body.id.number = preset.scene.ids_given + 1;
  body.shape = Disc{radius * (0.5 + sizes_.generateDouble())};
  body.position = {x, y};
  const SceneEdits edits = {Add<Body>{body}};
  if (at_start()) return edit(edits, tr("added body"));
  // The time is the displayed one until the runs tell when they had it.
  const double now = frames_.front()->time;
  Preset with = preset;
  add_edit(with.edits, {now, 0, edits});
  validate(with);
  ++document_.preset.scene.ids_given;
  const Worker::EditId edit = worker_.edit_scene(edits);
  std::vector<RunEdit> late = preset.edits;
  add_edit(late, {now, edit, edits});
  push({tr("added body"), edit}, {SetLateBodies{late}});
}

// The choice of named plots of a built-in experiment is not work that could be lost.
void Session::change_plots(const std::vector<Plot>& plots) {
  const std::vector<Plot>& before = document_.preset.plots;
  if (plots == before) return;
  const bool notes = without_notes(plots) == without_notes(before);
  DocumentEdit::What what{.text = notes ? tr("change of notes") : tr("change of plots")};
  what.is_work = !file_.isEmpty() || own_plots(plots) != own_plots(before);
  push(what, {SetPlots{plots}});
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

// An edit is timed by the runs. Its time decides the order of bodies, and plots know these by their index.
void Session::take_times_of_edits() {
  const std::vector<RunEdit>& known = frames_.front()->setup->edits;
  const auto time_of = [&known](const RunEdit& edit) {
    const auto found =
        std::find_if(known.begin(), known.end(), [&edit](const RunEdit& k) { return k.id == edit.id; });
    return edit.id == 0 || found == known.end() ? edit.time : found->time;
  };
  const std::vector<RunEdit>& late = document_.preset.edits;
  if (std::all_of(late.begin(), late.end(), [&](const RunEdit& edit) { return edit.time == time_of(edit); }))
    return;
  std::vector<RunEdit> timed;
  for (RunEdit edit : late) {
    edit.time = time_of(edit);
    add_edit(timed, edit);
  }
  assign({SetLateBodies{timed}});
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
