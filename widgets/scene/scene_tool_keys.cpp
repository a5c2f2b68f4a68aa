#include <algorithm>
#include <utility>

#include "widgets/edit/driven.h"
#include "widgets/scene/grid.h"
#include "widgets/scene/scene_tools.h"

// The keys of the scene's tools.
namespace carom {
namespace {

constexpr qint64 kSameRow = 1000;  // ms between two keys

bool is_enter(int key, Qt::KeyboardModifiers keys) {
  return (key == Qt::Key_Return || key == Qt::Key_Enter) && keys == Qt::NoModifier;
}

HandleKind changed_by(KeyEdit kind) {
  switch (kind) {
    case KeyEdit::kMove:
      return HandleKind::kBody;
    case KeyEdit::kTurn:
      return HandleKind::kTurn;
    case KeyEdit::kResize:
      return HandleKind::kRadius;
    default:
      return HandleKind::kVelocity;
  }
}

bool is_touch(int key, Qt::KeyboardModifiers keys) { return key == Qt::Key_K && keys == Qt::NoModifier; }

bool is_rename(int key, Qt::KeyboardModifiers keys) { return key == Qt::Key_F2 && keys == Qt::NoModifier; }

bool is_removal(int key) { return key == Qt::Key_Delete || key == Qt::Key_Backspace; }

bool is_stay(int key, Qt::KeyboardModifiers keys) {
  return key == Qt::Key_Space && keys == Qt::ControlModifier;
}

bool is_lock(int key, Qt::KeyboardModifiers keys) { return key == Qt::Key_L && keys == Qt::NoModifier; }

}  // namespace

bool SceneTools::takes(int key, Qt::KeyboardModifiers keys) const {
  if (types_in_drag(key, keys) || types_noted(key, keys)) return true;
  if (key == Qt::Key_Escape) {
    return state_ != State::kNone || tool_ != SceneTool::kSelect || !selection_.empty() || !awaited_.empty() ||
           part_;
  }
  if (key == Qt::Key_A && keys == Qt::ControlModifier) return bodies_ != nullptr;
  if (is_enter(key, keys)) return tool_ != SceneTool::kSelect;
  if (is_stay(key, keys)) return !selection_.empty();
  if (key == Qt::Key_Backspace && !draft_.empty()) return true;
  const std::shared_ptr<const Frame> frame = sight_().frame;
  if (!frame || (!frame->scene && !plays())) return false;
  if (is_removal(key) && part_) return true;
  if (selection_.empty() && awaited_.empty()) return false;
  if (is_rename(key, keys)) return selection_.names().size() == 1;
  return changes(key, keys);
}

// Whether the key does something to what is selected or drawn.
bool SceneTools::changes(int key, Qt::KeyboardModifiers keys) const {
  if (is_removal(key) || is_enter(key, keys) || (key == Qt::Key_A && keys == Qt::ControlModifier)) return true;
  if (selection_.empty() && awaited_.empty()) return false;
  return is_rename(key, keys) || is_touch(key, keys) || is_lock(key, keys) || key_edit(key, keys).has_value();
}

bool SceneTools::press_key(int key, Qt::KeyboardModifiers keys) {
  if (!takes(key, keys)) return false;
  if (key == Qt::Key_Escape) return escape();
  if (types_in_drag(key, keys)) {
    type_in_drag(QChar(key));
    return true;
  }
  if (types_noted(key, keys) && type_noted(QChar(key))) return true;
  if (is_stay(key, keys)) {
    toggle_stay();
    return true;
  }
  if (!changes(key, keys)) return true;                       // a digit that nothing takes
  if (state_ != State::kNone) return true;                    // the mouse has the bodies
  const bool drives = tool_ == SceneTool::kDrive && plays();  // which replaces a body as it stands
  if (is_enter(key, keys) && !drives) {
    enter();
  } else if (key == Qt::Key_Backspace && !draft_.empty()) {
    draft_.take_back();
    emit changed();
  } else if (key == Qt::Key_A && keys == Qt::ControlModifier) {
    std::vector<std::string> moving;
    for (const Body& body : *bodies_) {
      if (!body.fixed) moving.push_back(body.name);
    }
    set_selection(moving);
  } else if (is_lock(key, keys)) {
    toggle_lock();
  } else if (is_touch(key, keys) && awaited_.empty() && !can_touch()) {
    say_two_touch();
  } else if (plays()) {
    waiting_keys_.emplace_back(key, keys);
    emit pauseRequested();
  } else if (!awaited_.empty()) {
    waiting_keys_.emplace_back(key, keys);
  } else {
    edit_by_key(key, keys);
  }
  return true;
}

bool SceneTools::plays() const {
  const std::shared_ptr<const Frame> frame = sight_().frame;
  return frame && frame->playing && !frame->scene;
}

void SceneTools::press_waiting_keys() {
  for (const auto& [key, keys] : std::exchange(waiting_keys_, {})) press_key(key, keys);
}

void SceneTools::edit_by_key(int key, Qt::KeyboardModifiers keys) {
  if (is_enter(key, keys)) {
    enter();
  } else if (is_touch(key, keys)) {
    put_in_touch();
  } else if (is_rename(key, keys)) {
    emit renameRequested();
  } else if (const auto kind = key_edit(key, keys)) {
    edit_by_key(*kind, key, keys);
  } else {
    remove_selected();
  }
}

bool SceneTools::escape() {
  waiting_keys_.clear();
  typed_ahead_.clear();
  if (dragging() && emitted_) emit dragCancelled(drags_);
  if (state_ == State::kHand) end_hand();
  if (state_ != State::kNone || has_draft()) {
    if (state_ != State::kNone) state_ = State::kMute;
    drop_draft();
  } else if (tool_ != SceneTool::kSelect) {
    set_tool(SceneTool::kSelect, false);
  } else {
    set_selection({});
  }
  return true;
}

// What a click draws, or what joins the selected bodies, at the mouse or else in the middle of the view.
void SceneTools::enter() {
  if (!draft_.empty()) return close_polygon();
  keys_ = {};
  const bool joins = joint_tool(tool_) != nullptr;
  if (!over_) mouse_ = joins ? middle_of_view() : free_place();
  press_ = mouse_;
  if (joins) return join_selected();
  add_usual();
}

void SceneTools::remove_selected() {
  row_ = {};
  end_note();
  const Scene& scene = *sight_().frame->scene;
  Selection unlocked = selection_;
  unlocked.keep_if([this](const std::string& name) { return !locked_.contains(name); });
  if (!part_ && unlocked.empty()) return say_locked(selection_.names().front());
  const Deletion removed = part_ ? deletion(scene, *part_) : deletion(scene, unlocked.names());
  if (removed.edits.empty()) return;
  const QString refusal = own_edit(removed.edits, removed.name, ++drags_);
  if (!refusal.isEmpty()) note(refusal_bubble(refusal, mouse_, press_));
}

void SceneTools::say_no_velocity() {
  const std::vector<Body> bodies = selected_now();
  if (bodies.empty() || has_own_velocity(bodies.front())) return;
  const Body& body = bodies.front();
  const QPointF at = sight_().camera.to_screen(body.position);
  const QString name = QString::fromStdString(body.name);
  note(body.fixed ? Bubble{name + " is fixed", "it has no velocity", at, at, true}
                  : Bubble{name + " goes to and fro", "the inspector has its drive", at, at, true});
}

void SceneTools::edit_by_key(KeyEdit kind, int key, Qt::KeyboardModifiers keys) {
  const bool repeats = kind == KeyEdit::kMove || kind == KeyEdit::kVelocity || kind == KeyEdit::kTurn ||
                       kind == KeyEdit::kResize;
  const bool same_row = repeats && row_.drag != 0 && row_.kind == kind && row_.names == selection_.names() &&
                        row_.since.elapsed() < kSameRow;
  if (!same_row) {
    const HandleKind changed = changed_by(kind);
    row_.before = editable({}, changed);
    row_.kind = kind;
    row_.names = selection_.names();
    row_.drag = row_.before.empty() ? 0 : ++drags_;
    if (row_.drag != 0) row_.start = start_of({changed, {}}, row_.before);
  }
  const auto locked = locked_among(row_.drag == 0 ? selected_now() : row_.start.followers);
  if (locked) return say_locked(*locked);
  if (row_.drag == 0) return say_no_velocity();
  const Camera camera = sight_().camera;
  Dragged wanted;
  const double step = snapping_ ? grid_spacing(camera) : step_not_above(1.0 / camera.scale);
  wanted.bodies = edited_by_key(row_.start.bodies, key, keys, step, keeps_);
  wanted.value = value_of(kind, wanted.bodies.front(), camera.scale);
  wanted.name = name_of(kind, row_.before, wanted.bodies);
  row_.since.start();
  change_by_key(std::move(wanted));
}

}  // namespace carom
