#include <algorithm>
#include <utility>

#include "app/lab/refusal_text.h"
#include "app/lab/session.h"
#include "physics/preset/preset_file.h"
#include "physics/scene/edit_rules.h"
#include "physics/scene/validate.h"
#include "widgets/scene/new_body.h"

// The edits of a session: what each makes of the document, and of the runs.
namespace carom {
namespace {

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
  DocumentEdit::What made = what;
  if (is_of_scene(change)) made.selection = selection_;
  edits_.push(new DocumentEdit(*this, made, assign(change, what.begins)));
}

DocumentChange Session::assign(const DocumentChange& change, bool begins) {
  const std::vector<Plot> plots = document_.preset.plots;
  const std::vector<Stop> stops = document_.preset.stops;
  DocumentChange back = apply_change(document_, change);
  ++revision_;
  if (stops != document_.preset.stops) runs_.watch_stops();
  if (begins) runs_.await_begin();
  if (is_of_scene(change)) {
    bodies_ = all_bodies(document_.preset);
    emit bodiesChanged();
  } else if (plots != document_.preset.plots) {
    emit plotsChanged();
  }
  emit documentChanged();
  return back;
}

DocumentChange Session::take_back(const DocumentChange& change, const DocumentEdit::What& what) {
  if (what.run != nullptr) {
    runs_.take_back(*what.run);
    return {};
  }
  // What was done to the runs that a cut left is in these alone.
  if (what.left != 0 && what.cuts && !what.begins && what.runs != 0) runs_.undo_or_redo(what.runs);
  DocumentChange forth = what.left == 0 ? go_to(change, what) : assign(change, true);
  if (what.left != 0) {
    runs_.return_to(what.left);
    if (!what.cuts && what.runs != 0) runs_.undo_or_redo(what.runs);
  }
  if (!what.selection.empty()) emit selectionReturned(what.selection);
  return forth;
}

DocumentChange Session::make_again(const DocumentChange& change, const DocumentEdit::What& what) {
  if (what.run != nullptr) {
    runs_.make_again(*what.run);
    return {};
  }
  if (what.cuts && !what.begins) {
    runs_.cut(what.left);
  } else if (what.left != 0) {
    if (!what.cuts && what.runs != 0) runs_.undo_or_redo(what.runs);
    runs_.keep(what.left);
  }
  return go_to(change, what);
}

DocumentChange Session::go_to(const DocumentChange& change, const DocumentEdit::What& what) {
  runs_.forget_wait();
  const ReferenceId before = document_.reference;
  DocumentChange back = assign(change, what.begins);
  if (what.begins) {
    runs_.begin();
  } else if (what.runs != 0) {
    runs_.undo_or_redo(what.runs);
  } else if (before != document_.reference) {
    runs_.worker().set_reference(document_.reference);
  }
  return back;
}

const DocumentEdit* Session::last_edit() const {
  return edits_.index() == 0 ? nullptr : static_cast<const DocumentEdit*>(edits_.command(edits_.index() - 1));
}

void Session::edit(const SceneEdits& asked, const QString& text, int drag) {
  if (!may_edit_moment()) return;
  const bool begins = runs_.at_start();
  if (!begins && (runs_.frame()->playing || runs_.replayed()))
    return runs_.when_still(text, [=, this] { edit(asked, text, drag); });
  if (!begins && runs_.scene() == nullptr) return emit editRefused(tr("Restart the run first."));
  const double time = runs_.frame() == nullptr ? 0.0 : runs_.frame()->time;
  const Scene now = begins ? document_.preset.scene : *runs_.scene();
  SceneEdits edits = asked;
  number_new_parts(document_.preset.scene, edits);
  // Bodies that are removed leave their place to others, which only runs that begin anew can follow.
  const bool from_here = !begins && std::any_of(edits.begin(), edits.end(), [&now](const SceneEdit& each) {
    return is_about_motion(now, each) || std::holds_alternative<Remove<Body>>(each);
  });
  Document changed = document_;
  try {
    DocumentChange change = begins      ? change_of_start(document_, edits)
                            : from_here ? change_to_moment(document_, now, time, edits)
                                        : change_of_start(document_, at_the_start(document_.preset, edits));
    apply_change(changed, change);
    validate(changed.preset);
    DocumentEdit::What what{.text = text, .begins = begins || from_here};
    if (drag > 0) what.drag = drag;
    if (from_here || (begins && goes_on_with_new_start(drag))) name_new_start(time, edits, text, change, what);
    runs_.forget_wait();
    if (!what.begins) {
      if (runs_.in_past()) change.emplace_back(SetLateBodies{edits_left()});
      cut_at_shown(what);
      what.runs = edit_runs(with_followers(now, edits), change, drag, what.runs);
    } else if (from_here || runs_.in_past()) {
      what.left = runs_.keep();
    }
    push(what, change);
    if (what.begins) runs_.begin();
  } catch (const std::exception& error) {
    emit editRefused(refusal_text(error.what(), changed.preset.scene));
  }
}

// Whether an edit of this drag has made the start.
bool Session::goes_on_with_new_start(int drag) const {
  const DocumentEdit* last = last_edit();
  return drag > 0 && document_.start.from && last != nullptr && last->what().drag == drag &&
         last->what().leaves != nullptr && edits_.index() != edits_.cleanIndex();
}

// `time` (s): the moment of the edit, unless an earlier edit of the same drag has made the start.
void Session::name_new_start(double time, const SceneEdits& edits, const QString& by, DocumentChange& change,
                             DocumentEdit::What& what) {
  const bool goes_on = what.drag && goes_on_with_new_start(*what.drag);
  const double from = goes_on ? *document_.start.from : time;
  if (!goes_on) what.leaves = std::make_shared<const Start>(start_of(document_));
  what.asked = edits;
  what.text = tr("New start from %1 s: %2").arg(from, 0, 'f', 3).arg(by);
  change.emplace_back(SetOrigin{{.from = from, .by = by}});
}

bool Session::may_edit_moment() {
  if (runs_.there()) return true;
  emit editRefused(tr("The shown moment is still being computed."));
  return false;
}

// What comes later is gone where the runs are cut, but for the edits of the file.
std::vector<RunEdit> Session::edits_left() const {
  std::vector<RunEdit> left = document_.preset.edits;
  if (!runs_.in_past()) return left;
  std::erase_if(left,
                [now = runs_.shown_time()](const RunEdit& edit) { return edit.id != 0 && edit.time > now; });
  return left;
}

// Where a moment of the past is shown, the runs go on from there, under the methods of the document.
void Session::cut_at_shown(DocumentEdit::What& what) {
  if (!runs_.in_past()) return;
  std::vector<std::pair<std::size_t, Method>> methods;
  const Methods now = document_.methods();
  for (std::size_t i = 0; i < runs_.frames().size() && i <= now.others.size(); ++i) {
    const Method& method = i == 0 ? now.own : now.others[i - 1];
    if (!(runs_.frames()[i]->method == method)) methods.emplace_back(i, method);
  }
  what.left = runs_.cut();
  what.cuts = true;
  if (!methods.empty()) what.runs = runs_.worker().set_methods(methods);
}

void Session::go_on_from_here() {
  if (!runs_.in_past() || !may_edit_moment()) return;
  DocumentEdit::What what{.text = tr("Go on from %1 s").arg(runs_.shown_time(), 0, 'f', 3), .is_work = false};
  const DocumentChange change = {SetLateBodies{edits_left()}};
  cut_at_shown(what);
  push(what, change);
}

// The edits in the runs as they go on, with the methods that the change sets: one edit of the runs for a whole
// drag.
Worker::EditId Session::edit_runs(const SceneEdits& edits, const DocumentChange& change, int drag,
                                  Worker::EditId part_of) {
  const DocumentEdit* last = drag > 0 && edits_.index() != edits_.cleanIndex() ? last_edit() : nullptr;
  const Worker::EditId id =
      part_of == 0 && last != nullptr && last->what().drag == drag ? last->what().runs : part_of;
  std::vector<std::pair<std::size_t, Method>> methods;
  for (const auto& part : change) {
    const auto* set = std::get_if<SetMethods>(&part);
    if (set == nullptr) continue;
    methods = {{0, set->methods.own}};
    for (const Method& method : set->methods.others) methods.emplace_back(methods.size(), method);
  }
  return runs_.edit(methods, edits, id);
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
  if (run > document_.preset.compare.size() || !may_edit_moment()) return;
  Methods after = document_.methods();
  const Method before = std::exchange(method_of(after, run), method);
  if (before == method) return;
  DocumentChange change = {SetMethods{after, document_.before_usual}};
  if (runs_.in_past()) change.emplace_back(SetLateBodies{edits_left()});
  DocumentEdit::What what{.text = text_of_change(before, method)};
  cut_at_shown(what);
  what.runs = runs_.worker().set_methods({{run, method}}, what.runs);
  push(what, change);
}

void Session::change_step(double step, const std::vector<std::size_t>& runs, int drag) {
  Methods after = document_.methods();
  std::vector<std::pair<std::size_t, Method>> changed;
  for (const std::size_t run : runs) {
    if (run > document_.preset.compare.size()) continue;
    Method& now = method_of(after, run);
    if (std::exchange(now.step, step) != step) changed.emplace_back(run, now);
  }
  if (changed.empty() || !may_edit_moment()) return;
  // As the undo stack merges them: not with a saved state.
  const DocumentEdit* before = edits_.index() == edits_.cleanIndex() ? nullptr : last_edit();
  const bool same_drag = !runs_.in_past() && before != nullptr && before->what().drag == drag;
  DocumentChange change = {SetMethods{after, document_.before_usual}};
  if (runs_.in_past()) change.emplace_back(SetLateBodies{edits_left()});
  DocumentEdit::What what{.text = tr("change of step"), .runs = same_drag ? before->what().runs : 0};
  cut_at_shown(what);
  what.runs = runs_.worker().set_methods(changed, what.runs);
  what.drag = drag;
  push(what, change);
}

void Session::add_method(const Method& method) {
  Methods after = document_.methods();
  const bool full = after.others.size() == kMostCompared;
  if (full) after.others.pop_back();
  after.others.push_back(method);
  const Worker::EditId runs =
      full ? runs_.worker().set_method(method, kMostCompared) : runs_.worker().add_method(method);
  if (after.reference == ReferenceId::kNone) {
    after.reference = first_reference(document_.preset);
    runs_.worker().set_reference(after.reference);
  }
  push({tr("added method"), runs}, {SetMethods{after, document_.before_usual}});
}

void Session::remove_method(std::size_t run) {
  if (run == 0 || run > document_.preset.compare.size()) return;
  Methods after = document_.methods();
  after.others.erase(after.others.begin() + static_cast<std::ptrdiff_t>(run) - 1);
  push({tr("removed method"), runs_.worker().remove_method(run)}, {SetMethods{after, document_.before_usual}});
}

void Session::choose_reference(ReferenceId reference) {
  if (reference == document_.reference) return;
  Methods after = document_.methods();
  after.reference = reference;
  runs_.worker().set_reference(reference);
  DocumentEdit::What what{.text = tr("choice of reference"), .is_work = false};  // not saved in files
  push(what, {SetMethods{after, document_.before_usual}});
}

// The exact run becomes the scene's own run meanwhile: the others are compared with it, and a preset saved
// then stays valid.
void Session::compare_usual(const std::vector<Plot>& plots, const std::vector<Curve>& curves) {
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
    set.methods = {reference_for(setup, document_.preset.method, usual_reference(setup)),
                   {euler, rk4},
                   first_reference(document_.preset)};
  }
  const Worker::EditId runs = runs_.begin_with(set.methods, curves);
  push({tr("comparison with the exact run"), runs}, {set, SetPlots{plots}});
}

std::string Session::add_body(double x, double y) {
  const Preset& preset = document_.preset;
  // A disc like the existing ones, between half and one and a half times their radius; in a scene without any,
  // a twentieth of the view.
  const Body* model = model_disc(bodies_);
  const double radius = model != nullptr ? std::get<Disc>(model->shape).radius
                        : preset.view    ? preset.view->width / 20.0
                                         : 0.1;
  Body body = new_body(bodies_, Disc{radius * (0.5 + sizes_.generateDouble())}, {x, y});
  body.id.number = preset.scene.ids_given + 1;
  const SceneEdits edits = {Add<Body>{body}};
  const QString text = tr("Add disc %1").arg(QString::fromStdString(body.name));
  if (runs_.at_start()) {
    edit(edits, text);
    return body.name;
  }
  if (!may_edit_moment()) return {};
  // The time is the displayed one until the runs tell when they had it.
  const double now = runs_.frame()->time;
  Preset with = preset;
  with.edits = edits_left();
  add_edit(with.edits, {now, 0, edits});
  validate(with);
  ++document_.preset.scene.ids_given;
  std::vector<RunEdit> late = edits_left();
  DocumentEdit::What what{.text = text};
  cut_at_shown(what);
  what.runs = runs_.worker().edit_scene(edits, what.runs);
  add_edit(late, {now, what.runs, edits});
  push(what, {SetLateBodies{late}});
  return body.name;
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

void Session::change_stops(const std::vector<Stop>& stops, const QString& text) {
  if (stops == document_.preset.stops) return;
  Document changed = document_;
  changed.preset.stops = stops;
  try {
    validate(changed.preset);
    push({.text = text}, {SetStops{stops}});
  } catch (const SceneError& error) {
    emit editRefused(refusal_text(error.what(), changed.preset.scene));
  }
}

// An edit is timed by the runs. Its time decides the order of bodies, and plots know these by their index.
void Session::take_times_of_edits() {
  const std::vector<RunEdit>& known = runs_.newest().front()->setup->edits;
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
  assign({SetLateBodies{timed}}, false);
}

}  // namespace carom
