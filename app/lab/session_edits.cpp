#include <algorithm>
#include <utility>

#include "app/lab/session.h"
#include "physics/preset/preset_file.h"
#include "physics/scene/edit_rules.h"
#include "physics/scene/validate.h"
#include "widgets/scene/new_disc.h"

// The edits of a session: what each makes of the document, and of the runs.
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

}  // namespace

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
  const Body* model = model_disc(bodies_);
  const double radius = model != nullptr ? std::get<Disc>(model->shape).radius
                        : preset.view    ? preset.view->width / 20.0
                                         : 0.1;
  Body body = new_disc(bodies_, {x, y}, radius * (0.5 + sizes_.generateDouble()));
  body.id.number = preset.scene.ids_given + 1;
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

}  // namespace carom
