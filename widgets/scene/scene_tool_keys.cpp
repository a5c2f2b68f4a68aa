#include <algorithm>

#include "widgets/scene/grid.h"
#include "widgets/scene/scene_tools.h"

// The keys of the scene's tools.
namespace carom {
namespace {

constexpr qint64 kSameRow = 1000;  // ms between two keys

bool is_enter(int key, Qt::KeyboardModifiers keys) {
  return (key == Qt::Key_Return || key == Qt::Key_Enter) && keys == Qt::NoModifier;
}

}  // namespace

bool SceneTools::takes(int key, Qt::KeyboardModifiers keys) const {
  if (key == Qt::Key_Escape) {
    return state_ != State::kNone || tool_ != SceneTool::kSelect || !selection_.empty();
  }
  if (key == Qt::Key_A && keys == Qt::ControlModifier) return bodies_ != nullptr;
  if (is_enter(key, keys)) return shape_tool(tool_) != nullptr;
  if (key == Qt::Key_Backspace && !draft_.empty()) return true;
  const std::shared_ptr<const Frame> frame = sight_().frame;
  if (selection_.empty() || !frame || !frame->scene) return false;
  return key == Qt::Key_Delete || key == Qt::Key_Backspace || key_edit(key, keys).has_value();
}

bool SceneTools::press_key(int key, Qt::KeyboardModifiers keys) {
  if (!takes(key, keys)) return false;
  if (key == Qt::Key_Escape) return escape();
  if (state_ != State::kNone) return true;  // the mouse has the bodies
  if (is_enter(key, keys)) {
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
  } else if (const auto kind = key_edit(key, keys)) {
    edit_by_key(*kind, key, keys);
  } else {
    remove_selected();
  }
  return true;
}

bool SceneTools::escape() {
  if (state_ == State::kDrag && emitted_) emit dragCancelled(drags_);
  if (state_ != State::kNone || !draft_.empty()) {
    if (state_ != State::kNone) state_ = State::kMute;
    drop_corners();
  } else if (tool_ != SceneTool::kSelect) {
    set_tool(SceneTool::kSelect, false);
  } else {
    set_selection({});
  }
  return true;
}

// What a click draws, at the mouse or else in the middle of the view.
void SceneTools::enter() {
  if (!draft_.empty()) return close_polygon();
  const QSizeF view = sight_().camera.viewport;
  if (!over_) mouse_ = {0.5 * view.width(), 0.5 * view.height()};
  press_ = mouse_;
  keys_ = {};
  add_usual();
}

void SceneTools::remove_selected() {
  row_ = {};
  end_note();
  const Deletion removed = deletion(*sight_().frame->scene, selection_.names());
  if (!removed.edits.empty()) emit edited(removed.edits, removed.name, ++drags_);
}

void SceneTools::edit_by_key(KeyEdit kind, int key, Qt::KeyboardModifiers keys) {
  const bool repeats = kind == KeyEdit::kMove || kind == KeyEdit::kVelocity || kind == KeyEdit::kTurn;
  const bool same_row = repeats && row_.drag != 0 && row_.kind == kind && row_.names == selection_.names() &&
                        row_.since.elapsed() < kSameRow;
  if (!same_row) {
    const bool of_motion = kind != KeyEdit::kMove && kind != KeyEdit::kTurn;
    row_.before = editable({}, of_motion);
    row_.now = row_.before;
    row_.kind = kind;
    row_.names = selection_.names();
    row_.drag = row_.before.empty() ? 0 : ++drags_;
  }
  if (row_.drag == 0) return;
  row_.now = edited_by_key(row_.now, key, keys, grid_spacing(sight_().camera));
  row_.since.start();
  emit_bodies(row_.now, name_of(kind, row_.before, row_.now), row_.drag);
  // At the upper right of the body.
  const Body& body = row_.now.front();
  const Camera camera = sight_().camera;
  const Vec2 half = half_extent(body.shape, body.angle);
  const QPointF centre = camera.to_screen(body.position);
  const QPointF corner = half.allFinite() ? camera.to_screen(body.position + half) : centre;
  note({value_of(kind, body, camera.scale), {}, corner, centre});
}

}  // namespace carom
