#include "app/lab/session_starts.h"

#include <algorithm>
#include <utility>

#include "app/lab/refusal_text.h"
#include "physics/preset/preset_file.h"
#include "physics/scene/fingerprint.h"

namespace carom {
namespace {

QString name_of(const Start& start) {
  const StartOrigin& origin = start.origin;
  if (origin.from) return SessionStarts::tr("from %1 s: %2").arg(*origin.from, 0, 'f', 3).arg(origin.by);
  const QString name = origin.saved ? SessionStarts::tr("as saved") : SessionStarts::tr("as opened");
  return fingerprint(start.scene, start_time(start.saved)) == origin.scene
             ? name
             : SessionStarts::tr("%1, edited").arg(name);
}

// A start that was left again since stands once, as it was left.
void add_known(std::vector<SessionStarts::Known>& known, const SessionStarts::Known& start) {
  const auto same = std::find_if(known.begin(), known.end(),
                                 [&](const SessionStarts::Known& each) { return each.name == start.name; });
  if (same == known.end()) {
    known.push_back(start);
  } else {
    same->start = start.start;
  }
}

}  // namespace

SessionStarts::SessionStarts(EditHistory& history) : history_(history), runs_(history.runs()) {}

void SessionStarts::set_playing(bool playing) {
  if (playing && !runs_.replayed()) {
    if (!runs_.in_past() && runs_.at_end() && !runs_.at_start()) restart();
    enter_run();
  }
  runs_.set_playing(playing);
}

void SessionStarts::play_on() {
  enter_run();
  runs_.play_on();
}

void SessionStarts::step_by(int steps) {
  if (steps > 0 && !runs_.in_past() && !runs_.replayed()) enter_run();
  runs_.step_by(steps);
}

void SessionStarts::enter_run() {
  const DocumentEdit* last = history_.last_edit();
  if (last != nullptr && last->what().run != nullptr) return;
  const auto run = runs_.enter();
  history_.push({.text = tr("Run from %1 s").arg(run->time, 0, 'f', 3), .is_work = false, .run = run}, {});
}

void SessionStarts::restart() {
  if (!runs_.have_begun()) return runs_.restart();
  DocumentEdit::What what{.text = tr("Restart"), .begins = true, .is_work = false};
  what.left = runs_.keep();
  history_.push(what, {});
  runs_.begin();
}

std::vector<SessionStarts::Known> SessionStarts::known() const {
  std::vector<Known> known = {{name_of(*first_), first_}};
  for (int i = 0; i < history_.stack().index(); ++i) {
    if (const auto& left = history_.edit_at(i).what().leaves) add_known(known, {name_of(*left), left});
  }
  const Start now = start_of(history_.document());
  if (begin_alike(now, *first_)) {
    known.front().start = nullptr;
  } else {
    add_known(known, {name_of(now), nullptr});
  }
  return known;
}

void SessionStarts::leave(const QString& text, const Start& start) {
  DocumentEdit::What what{.text = text, .begins = true};
  what.leaves = std::make_shared<const Start>(start_of(history_.document()));
  if (runs_.have_begun()) what.left = runs_.keep();
  history_.push(what, change_to_start(history_.document(), start));
  runs_.begin();
}

void SessionStarts::go_to(const Known& known) {
  if (known.start == nullptr) return restart();
  leave(tr("Start %1").arg(known.name), *known.start);
}

void SessionStarts::go_to_first() {
  if (begin_alike(start_of(history_.document()), *first_)) return restart();
  leave(tr("First start"), *first_);
}

// The place in the undo stack of the edit that made the present start of a moment; -1 if it came by another
// way.
int SessionStarts::newest_start_edit() const {
  int place = history_.stack().index() - 1;
  while (place >= 0 && history_.edit_at(place).what().leaves == nullptr) --place;
  return place >= 0 && !history_.edit_at(place).what().asked.empty() ? place : -1;
}

// What the document was before this edit and all later ones.
Document SessionStarts::before_edit(int place) const {
  Document before = history_.document();
  for (int i = history_.stack().index() - 1; i >= place; --i) apply_change(before, history_.edit_at(i).next());
  return before;
}

void SessionStarts::put_into_start_before() {
  const int place = newest_start_edit();
  if (place < 0) return history_.refuse(tr("This start was not made by an edit of the start before."));
  for (int i = place + 1; i < history_.stack().index(); ++i) {
    if (!history_.edit_at(i).what().is_work) continue;
    return history_.refuse(tr("More was changed since: take that back first."));
  }
  const DocumentEdit::What& made = history_.edit_at(place).what();
  const Document before = before_edit(place);
  Document changed = before;
  try {
    const SceneEdits edits = at_the_start(before.preset, made.asked, *runs_.scene_left(made.left));
    const DocumentChange change = change_of_start(before, edits);
    apply_change(changed, change);
    validate(changed.preset);
    const QString by = history_.document().start.by;
    history_.stack().setIndex(place);
    DocumentEdit::What what{.text = by, .begins = true};
    what.left = runs_.keep();
    history_.push(what, change);
    runs_.begin();
  } catch (const std::exception& error) {
    history_.refuse(tr("Not in the start before: %1").arg(refusal_text(error.what(), changed.preset.scene)));
  }
}

}  // namespace carom
