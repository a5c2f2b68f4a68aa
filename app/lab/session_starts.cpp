#include <algorithm>
#include <utility>

#include "app/lab/refusal_text.h"
#include "app/lab/session.h"
#include "physics/preset/preset_file.h"
#include "physics/scene/fingerprint.h"

// The runs of a session as steps of undo, and its starts: back to the present one, to the first, to any since
// the document was opened.
namespace carom {
namespace {

QString name_of(const Start& start) {
  const StartOrigin& origin = start.origin;
  if (origin.from) return Session::tr("from %1 s: %2").arg(*origin.from, 0, 'f', 3).arg(origin.by);
  const QString name = origin.saved ? Session::tr("as saved") : Session::tr("as opened");
  return fingerprint(start.scene, start_time(start.saved)) == origin.scene
             ? name
             : Session::tr("%1, edited").arg(name);
}

// A start that was left again since stands once, as it was left.
void add_known(std::vector<Session::KnownStart>& known, const Session::KnownStart& start) {
  const auto same = std::find_if(known.begin(), known.end(),
                                 [&](const Session::KnownStart& each) { return each.name == start.name; });
  if (same == known.end()) {
    known.push_back(start);
  } else {
    same->start = start.start;
  }
}

}  // namespace

void Session::set_playing(bool playing) {
  if (playing && !runs_.replayed()) {
    if (!runs_.in_past() && runs_.at_end() && !runs_.at_start()) restart();
    enter_run();
  }
  runs_.set_playing(playing);
}

void Session::play_on() {
  enter_run();
  runs_.play_on();
}

void Session::enter_run() {
  const DocumentEdit* last = last_edit();
  if (last != nullptr && last->what().run != nullptr) return;
  const auto run = runs_.enter();
  push({.text = tr("Run from %1 s").arg(run->time, 0, 'f', 3), .is_work = false, .run = run}, {});
}

void Session::restart() {
  if (!runs_.have_begun()) return runs_.restart();
  DocumentEdit::What what{.text = tr("Restart"), .begins = true, .is_work = false};
  what.left = runs_.keep();
  push(what, {});
  runs_.begin();
}

const DocumentEdit& Session::edit_at(int place) const {
  return static_cast<const DocumentEdit&>(*edits_.command(place));
}

std::vector<Session::KnownStart> Session::starts() const {
  std::vector<KnownStart> known = {{name_of(*first_start_), first_start_}};
  for (int i = 0; i < edits_.index(); ++i) {
    if (const auto& left = edit_at(i).what().leaves) add_known(known, {name_of(*left), left});
  }
  const Start now = start_of(document_);
  if (begin_alike(now, *first_start_)) {
    known.front().start = nullptr;
  } else {
    add_known(known, {name_of(now), nullptr});
  }
  return known;
}

void Session::leave_start(const QString& text, const Start& start) {
  DocumentEdit::What what{.text = text, .begins = true};
  what.leaves = std::make_shared<const Start>(start_of(document_));
  if (runs_.have_begun()) what.left = runs_.keep();
  push(what, change_to_start(document_, start));
  runs_.begin();
}

void Session::go_to(const KnownStart& known) {
  if (known.start == nullptr) return restart();
  leave_start(tr("Start %1").arg(known.name), *known.start);
}

void Session::go_to_first_start() {
  if (begin_alike(start_of(document_), *first_start_)) return restart();
  leave_start(tr("First start"), *first_start_);
}

// The place in the undo stack of the edit that made the present start of a moment; -1 if it came by another
// way.
int Session::newest_start_edit() const {
  int place = edits_.index() - 1;
  while (place >= 0 && edit_at(place).what().leaves == nullptr) --place;
  return place >= 0 && !edit_at(place).what().asked.empty() ? place : -1;
}

// What the document was before this edit and all later ones.
Document Session::before_edit(int place) const {
  Document before = document_;
  for (int i = edits_.index() - 1; i >= place; --i) apply_change(before, edit_at(i).next());
  return before;
}

void Session::put_into_start_before() {
  const int place = newest_start_edit();
  if (place < 0) return emit editRefused(tr("This start was not made by an edit of the start before."));
  for (int i = place + 1; i < edits_.index(); ++i) {
    if (!edit_at(i).what().is_work) continue;
    return emit editRefused(tr("More was changed since: take that back first."));
  }
  const DocumentEdit::What& made = edit_at(place).what();
  const Document before = before_edit(place);
  Document changed = before;
  try {
    const SceneEdits edits = at_the_start(before.preset, made.asked, *runs_.scene_left(made.left));
    const DocumentChange change = change_of_start(before, edits);
    apply_change(changed, change);
    validate(changed.preset);
    const QString by = document_.start.by;
    edits_.setIndex(place);
    DocumentEdit::What what{.text = by, .begins = true};
    what.left = runs_.keep();
    push(what, change);
    runs_.begin();
  } catch (const std::exception& error) {
    emit editRefused(tr("Not in the start before: %1").arg(refusal_text(error.what(), changed.preset.scene)));
  }
}

}  // namespace carom
