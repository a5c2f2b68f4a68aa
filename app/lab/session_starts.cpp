#include "app/lab/session_starts.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

#include "app/lab/refusal_text.h"
#include "physics/preset/preset_file.h"
#include "physics/preset/start_fingerprint.h"

namespace carom {
namespace {

QString name_of(const Start& start) {
  const StartOrigin& origin = start.origin;
  if (origin.from) return SessionStarts::tr("from %1 s: %2").arg(*origin.from, 0, 'f', 3).arg(origin.by);
  const QString name = origin.saved ? SessionStarts::tr("as saved") : SessionStarts::tr("as opened");
  return fingerprint_of_start(start.scene, start.saved, start.late) == origin.scene
             ? name
             : SessionStarts::tr("%1, edited").arg(name);
}

// Starts in the order in which they were left, each once: one that was left again has its newest name.
class StartList {
 public:
  explicit StartList(const std::shared_ptr<const Start>& first) { add(name_of(*first), first); }

  void add(const QString& name, const std::shared_ptr<const Start>& start) {
    SessionStarts::Known& known = place_of(name, *start);
    if (known.name == name) known.start = start;
  }
  void add_present(const Start& start) { place_of(name_of(start), start).start = nullptr; }

  // Of equal names the later ones have numbers: "(2)".
  [[nodiscard]] std::vector<SessionStarts::Known> numbered() const {
    std::vector<SessionStarts::Known> all = starts_;
    std::map<QString, int> times;
    for (SessionStarts::Known& each : all) {
      const int time = ++times[each.name];
      if (time > 1) each.name = SessionStarts::tr("%1 (%2)").arg(each.name).arg(time);
    }
    return all;
  }

 private:
  // The first one keeps its name.
  SessionStarts::Known& place_of(const QString& name, const Start& start) {
    const std::uint64_t begin = fingerprint_of_start(start.scene, start.saved, start.late);
    const auto same = std::find(begins_.begin(), begins_.end(), begin);
    if (same == begins_.end()) {
      begins_.push_back(begin);
      return starts_.emplace_back(SessionStarts::Known{name, nullptr});
    }
    SessionStarts::Known& known = starts_[static_cast<std::size_t>(same - begins_.begin())];
    if (same != begins_.begin()) known.name = name;
    return known;
  }

  std::vector<SessionStarts::Known> starts_;
  std::vector<std::uint64_t> begins_;  // their fingerprints
};

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
  StartList all(first_);
  for (const Known& each : recovered_) all.add(each.name, each.start);
  for (int i = 0; i < history_.stack().index(); ++i) {
    if (const auto& left = history_.edit_at(i).what().leaves) all.add(name_of(*left), left);
  }
  all.add_present(start_of(history_.document()));
  return all.numbered();
}

KeptStarts SessionStarts::kept() const {
  constexpr std::ptrdiff_t kMost = 20;
  std::vector<Known> all = known();
  if (std::ssize(all) > kMost) all.erase(all.begin() + 1, all.end() - kMost);
  const Document& document = history_.document();
  KeptStarts kept;
  for (const Known& each : all) {
    if (each.start == nullptr) {
      kept.push_back({document.start, std::nullopt, body_ids(document.preset), document.own_theories});
      continue;
    }
    Document there = document;
    apply_change(there, change_to_start(document, *each.start));
    auto ids = body_ids(there.preset);
    kept.push_back({each.start->origin, std::move(there.preset), std::move(ids), {}});
  }
  return kept;
}

void SessionStarts::recover(const KeptStarts& starts) {
  const Preset& document = history_.document().preset;
  std::uint32_t given = document.scene.ids_given;
  std::vector<Start> all = starts_of(starts, document, given);
  history_.count_ids_to(given);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!starts[i].preset) {
      history_.set_origin(all[i].origin);
      history_.set_own_theories(starts[i].theories);
    }
    if (i == 0) {
      if (starts[i].preset) history_.set_first_theories(theories_left_at(all[i], history_.document()));
      set_first(std::move(all[i]));
    } else if (starts[i].preset) {
      const QString name = name_of(all[i]);
      recovered_.push_back({name, std::make_shared<const Start>(std::move(all[i]))});
    }
  }
  emit history_.plotsChanged();
  emit history_.documentChanged();
}

void SessionStarts::leave(const QString& text, const Start& start) {
  DocumentEdit::What what{.text = text, .begins = true};
  what.leaves = std::make_shared<const Start>(start_of(history_.document()));
  if (runs_.have_begun()) what.left = runs_.keep();
  const DocumentChange change = change_to_start(history_.document(), start);
  what.said = said_of_methods(history_.document(), change, start.scene);
  history_.push(what, change);
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

QString SessionStarts::why_not_into_start_before() const {
  const int place = newest_start_edit();
  if (place < 0) return tr("This start was not made by an edit of the start before.");
  for (int i = place + 1; i < history_.stack().index(); ++i) {
    if (history_.edit_at(i).what().is_work) return tr("More was changed since: take that back first.");
  }
  return {};
}

void SessionStarts::put_into_start_before() {
  if (const QString why = why_not_into_start_before(); !why.isEmpty()) return history_.refuse(why);
  const int place = newest_start_edit();
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
    what.said = said_of_methods(before, change, changed.preset.scene);
    history_.push(what, change);
    runs_.begin();
  } catch (const std::exception& error) {
    history_.refuse(tr("Not in the start before: %1").arg(refusal_text(error.what(), changed.preset.scene)));
  }
}

}  // namespace carom
