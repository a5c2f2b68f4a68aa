#include "app/lab/edit_history.h"

#include <algorithm>
#include <utility>

namespace carom {
namespace {

bool is_of_scene(const DocumentChange& change) {
  return std::any_of(change.begin(), change.end(), [](const auto& part) {
    return std::holds_alternative<SceneEdits>(part) || std::holds_alternative<SetScene>(part) ||
           std::holds_alternative<SetLateBodies>(part);
  });
}

}  // namespace

EditHistory::EditHistory(const Document& document) : document_(document), runs_(document_) {
  // Before the window's slot: it shows the document too.
  connect(&runs_, &LabRuns::framesChanged, this, &EditHistory::take_times_of_edits);
}

void EditHistory::load(const Document& document, const std::vector<Curve>& curves) {
  document_ = document;
  bodies_ = all_bodies(document_.preset);
  runs_.load(curves);
  ++revision_;
  stack_.clear();
  stack_.setClean();
}

void EditHistory::push(const DocumentEdit::What& what, const DocumentChange& change) {
  DocumentEdit::What made = what;
  if (is_of_scene(change)) made.selection = selection_;
  const ReferenceId before = document_.reference;
  stack_.push(new DocumentEdit(*this, made, assign(change, what.begins)));
  if (!what.begins && before != document_.reference) runs_.worker().set_reference(document_.reference);
  const QString said = made.drag && made.said.isEmpty() ? last_edit()->what().said : made.said;
  if (!said.isEmpty()) emit editSaid(said);
}

DocumentChange EditHistory::assign(const DocumentChange& change, bool begins) {
  const std::vector<Plot> plots = document_.preset.plots;
  const std::vector<Stop> stops = document_.preset.stops;
  const double duration = document_.preset.duration;
  DocumentChange back = apply_change(document_, change);
  ++revision_;
  if (stops != document_.preset.stops) runs_.watch_stops();
  if (duration != document_.preset.duration) runs_.watch_duration();
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

DocumentChange EditHistory::take_back(const DocumentChange& change, const DocumentEdit::What& what) {
  if (what.run != nullptr) {
    runs_.take_back(*what.run);
    emit runsReturned();
    return {};
  }
  // What was done to the runs that a cut left is in these alone.
  if (what.left != 0 && what.cuts && !what.begins && what.runs != 0) runs_.undo_or_redo(what.runs);
  DocumentChange forth = what.left == 0 ? go_to(change, what) : assign(change, true);
  if (what.left != 0) {
    runs_.return_to(what.left);
    if (!what.cuts && what.runs != 0) runs_.undo_or_redo(what.runs);
    emit runsReturned();
  }
  if (!what.selection.empty()) emit selectionReturned(what.selection);
  return forth;
}

DocumentChange EditHistory::make_again(const DocumentChange& change, const DocumentEdit::What& what) {
  if (what.run != nullptr) {
    runs_.make_again(*what.run);
    emit runsReturned();
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

DocumentChange EditHistory::go_to(const DocumentChange& change, const DocumentEdit::What& what) {
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

const DocumentEdit* EditHistory::last_edit() const {
  return stack_.index() == 0 ? nullptr : static_cast<const DocumentEdit*>(stack_.command(stack_.index() - 1));
}

const DocumentEdit* EditHistory::last_edit_of(int drag) const {
  const DocumentEdit* last = stack_.index() == stack_.cleanIndex() ? nullptr : last_edit();
  return last != nullptr && last->what().drag == drag ? last : nullptr;
}

const DocumentEdit& EditHistory::edit_at(int place) const {
  return static_cast<const DocumentEdit&>(*stack_.command(place));
}

bool EditHistory::may_edit_moment() {
  if (runs_.there()) return true;
  emit editRefused(tr("The shown moment is still being computed."));
  return false;
}

std::vector<RunEdit> EditHistory::edits_left() const {
  std::vector<RunEdit> left = document_.preset.edits;
  if (!runs_.in_past()) return left;
  std::erase_if(left,
                [now = runs_.shown_time()](const RunEdit& edit) { return edit.id != 0 && edit.time > now; });
  return left;
}

void EditHistory::cut_at_shown(DocumentEdit::What& what) {
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

// An edit is timed by the runs. Its time decides the order of bodies, and plots know these by their index.
void EditHistory::take_times_of_edits() {
  const std::vector<RunEdit>& known = runs_.newest().front()->setup->edits;
  const auto time_of = [&known](const RunEdit& edit) {
    const auto found =
        std::find_if(known.begin(), known.end(), [&edit](const RunEdit& k) { return k.id == edit.id; });
    return edit.id == 0 || found == known.end() ? edit.time : found->time;
  };
  const std::vector<RunEdit>& late = document_.preset.edits;
  if (std::all_of(late.begin(), late.end(), [&](const RunEdit& edit) { return edit.time == time_of(edit); }))
    return;
  std::vector<RunEdit> timed = late;
  for (RunEdit& edit : timed) edit.time = time_of(edit);
  std::stable_sort(timed.begin(), timed.end(), is_earlier);
  assign({SetLateBodies{timed}}, false);
}

}  // namespace carom
