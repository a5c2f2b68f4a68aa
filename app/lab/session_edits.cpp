#include <algorithm>
#include <cmath>
#include <utility>

#include "app/lab/new_parts.h"
#include "app/lab/refusal_text.h"
#include "app/lab/session.h"
#include "physics/preset/preset_file.h"
#include "physics/preset/start_fingerprint.h"
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

void add_edit(std::vector<RunEdit>& edits, const RunEdit& edit) {
  edits.insert(std::upper_bound(edits.begin(), edits.end(), edit, is_earlier), edit);
}

// Bodies that are removed leave their place to others, which only runs that begin anew can follow.
bool need_new_start(const Scene& now, const SceneEdits& edits) {
  return std::any_of(edits.begin(), edits.end(), [&now](const SceneEdit& each) {
    return is_about_motion(now, each) || std::holds_alternative<Remove<Body>>(each);
  });
}

double to_two_figures(double value) {
  const double scale = std::pow(10.0, 1.0 - std::floor(std::log10(value)));
  return std::round(value * scale) / scale;
}

}  // namespace

bool Session::needs_pause(const SceneEdits& edits) {
  if (runs().at_start()) return false;
  if (!runs().plays()) return runs().replayed().has_value();
  return runs().in_past() || need_new_start(*runs().shown_scene(), edits);
}

void Session::pause_for(const SceneEdits& edits, const QString& text,
                        const std::function<void(const SceneEdits&)>& then) {
  const auto moment = runs().plays() ? runs().shown_scene() : nullptr;
  const bool plays_on = runs().in_past() && moment != nullptr && !need_new_start(*moment, edits);
  runs().when_still(text, [=, this] {
    const auto now = runs().scene();
    then(moment == nullptr || now == nullptr ? edits : moved_to(now->bodies, edits, *moment));
    if (plays_on) runs().set_playing(true);
  });
}

void Session::edit(const SceneEdits& asked, const QString& text, int drag) {
  if (needs_pause(asked))
    return pause_for(asked, text, [=, this](const SceneEdits& there) { edit(there, text, drag); });
  if (!history_.may_edit_moment()) return;
  const bool begins = runs().at_start();
  const auto scene = runs().shown_scene();
  if (!begins && scene == nullptr) return history_.refuse(tr("Restart the run first."));
  const double time = runs().frame() == nullptr ? 0.0 : runs().frame()->time;
  const Document& before = history_.document();
  const Scene now = begins ? before.preset.scene : *scene;
  SceneEdits edits = asked;
  number_new_parts(before.preset.scene, edits);
  const bool from_here = !begins && need_new_start(now, edits);
  Document changed = before;
  try {
    DocumentChange change = begins      ? change_of_start(before, edits)
                            : from_here ? change_to_moment(before, now, time, edits)
                                        : change_of_start(before, at_the_start(before.preset, edits));
    apply_change(changed, change);
    // What changes nothing is no step.
    if (!from_here && fingerprint_of_start(changed.preset) == fingerprint_of_start(before.preset)) return;
    validate(changed.preset);
    DocumentEdit::What what{.text = text, .begins = begins || from_here};
    if (drag > 0) what.drag = drag;
    what.said = said_of_methods(before, change, changed.preset.scene);
    if (from_here || (begins && goes_on_with_new_start(drag))) name_new_start(time, edits, text, change, what);
    runs().forget_wait();
    if (!what.begins) {
      if (runs().in_past()) change.emplace_back(SetLateBodies{history_.edits_left()});
      history_.cut_at_shown(what);
      what.runs = edit_runs(with_followers(now, edits), change, drag, what.runs);
    } else if (from_here || runs().in_past()) {
      what.left = runs().keep();
    }
    history_.push(what, change);
    if (what.begins) runs().begin();
  } catch (const std::exception& error) {
    history_.refuse(refusal_text(error.what(), changed.preset.scene));
  }
}

// Whether an edit of this drag has made the start.
bool Session::goes_on_with_new_start(int drag) const {
  const DocumentEdit* last = history_.last_edit_of(drag);
  return drag > 0 && history_.document().start.from && last != nullptr && last->what().leaves != nullptr;
}

// `time` (s): the moment of the edit, unless an earlier edit of the same drag has made the start.
void Session::name_new_start(double time, const SceneEdits& edits, const QString& by, DocumentChange& change,
                             DocumentEdit::What& what) {
  const bool goes_on = what.drag && goes_on_with_new_start(*what.drag);
  const double from = goes_on ? *history_.document().start.from : time;
  if (!goes_on) what.leaves = std::make_shared<const Start>(start_of(history_.document()));
  what.asked = edits;
  what.text = tr("New start from %1 s: %2").arg(from, 0, 'f', 3).arg(by);
  change.emplace_back(SetOrigin{{.from = from, .by = by}});
}

void Session::go_on_from_here() {
  if (!runs().in_past() || !history_.may_edit_moment()) return;
  DocumentEdit::What what{.text = tr("Go on from %1 s").arg(runs().shown_time(), 0, 'f', 3), .is_work = false};
  const DocumentChange change = {SetLateBodies{history_.edits_left()}};
  history_.cut_at_shown(what);
  history_.push(what, change);
}

// The edits in the runs as they go on, with the methods that the change sets: one edit of the runs for a whole
// drag.
Worker::EditId Session::edit_runs(const SceneEdits& edits, const DocumentChange& change, int drag,
                                  Worker::EditId part_of) {
  const DocumentEdit* last = drag > 0 ? history_.last_edit_of(drag) : nullptr;
  const Worker::EditId id = part_of == 0 && last != nullptr ? last->what().runs : part_of;
  return runs().edit(methods_changed(history_.document(), change), edits, id);
}

void Session::cancel(int drag) {
  const DocumentEdit* last = history_.last_edit();
  if (last == nullptr || last->what().drag != drag) return;
  auto* edit = const_cast<QUndoCommand*>(edits().command(edits().index() - 1));
  edit->undo();
  edit->setObsolete(true);  // the stack drops it instead of keeping it for redo
  edits().undo();
}

std::string Session::add_body(double x, double y, std::optional<double> radius) {
  const Preset& preset = document();
  // A disc like the existing ones, between half and one and a half times their radius; in a scene without any,
  // a twentieth of the view.
  const Body* model = model_disc(history_.bodies());
  const double usual = model != nullptr ? std::get<Disc>(model->shape).radius
                       : preset.view    ? preset.view->width / 20.0
                                        : 0.1;
  const Disc disc{radius ? *radius : to_two_figures(usual * (0.5 + sizes_.generateDouble()))};
  Body body = new_body(history_.bodies(), disc, {x, y});
  body.id.number = preset.scene.ids_given + 1;
  const SceneEdits edits = {Add<Body>{body}};
  if (runs().at_start()) {
    edit(edits, tr("Add disc %1").arg(QString::fromStdString(body.name)));
    return body.name;
  }
  if (!history_.may_edit_moment()) return {};
  // The time is the displayed one until the runs tell when they had it.
  const double now = runs().frame()->time;
  Preset with = preset;
  with.edits = history_.edits_left();
  add_edit(with.edits, {now, 0, edits});
  validate(with);
  history_.count_id();
  std::vector<RunEdit> late = history_.edits_left();
  DocumentEdit::What what{.text = tr("Drop disc at %1 s").arg(QString::number(std::round(1e3 * now) / 1e3))};
  history_.cut_at_shown(what);
  what.runs = runs().worker().edit_scene(edits, what.runs);
  add_edit(late, {now, what.runs, edits});
  history_.push(what, change_of_late_bodies(history_.document(), std::move(late)));
  return body.name;
}

// The choice of named plots of a built-in experiment is not work that could be lost.
void Session::change_plots(const std::vector<Plot>& plots) {
  const std::vector<Plot>& before = document().plots;
  if (plots == before) return;
  const bool notes = without_notes(plots) == without_notes(before);
  DocumentEdit::What what{.text = notes                          ? tr("Notes of a plot")
                                  : plots.size() > before.size() ? tr("Add plot")
                                  : plots.size() < before.size() ? tr("Remove plot")
                                                                 : tr("Change plot")};
  what.is_work = !file_.isEmpty() || own_plots(plots) != own_plots(before);
  history_.push(what, {SetPlots{plots}});
}

void Session::change_stops(const std::vector<Stop>& stops, const QString& text) {
  if (stops != document().stops) push_valid({.text = text}, {SetStops{stops}});
}

void Session::change_duration(double duration, const QString& text, int drag) {
  if (duration == document().duration) return;
  DocumentEdit::What what{.text = text};
  if (drag > 0) what.drag = drag;
  push_valid(what, {SetDuration{duration}});
}

// A change that leaves the scene alone.
void Session::push_valid(const DocumentEdit::What& what, const DocumentChange& change) {
  Document changed = history_.document();
  try {
    apply_change(changed, change);
    validate(changed.preset);
    history_.push(what, change);
  } catch (const SceneError& error) {
    history_.refuse(refusal_text(error.what(), changed.preset.scene));
  }
}

}  // namespace carom
