#pragma once

#include <QString>
#include <Qt>
#include <optional>
#include <utility>
#include <vector>

#include "physics/scene/edit.h"
#include "physics/scene/scene.h"
#include "widgets/edit/reshaping.h"
#include "widgets/scene/handles.h"
#include "widgets/scene/joint_hold.h"

namespace carom {

// What a drag began with. All of its values come from here, however the scene changes meanwhile.
struct DragStart {
  HandleKind kind = HandleKind::kBody;
  std::vector<Body> bodies;       // those that change, the grabbed one first
  std::vector<Body> others;       // that a moved body can come to touch
  Vec2 press = Vec2::Zero();      // m
  double arrow_seconds = 0.1;     // m of arrow per m/s
  double grid = 0.0;              // m, spacing; 0: none to snap to
  std::vector<Body> followers{};  // that joints make one with them, and that are none of the others
  std::vector<Joint> joints{};    // of the scene
  Keeps keeps{};                  // as a body gets another size
  std::size_t corner{};           // of kCorner, among the polygon's vertices
  Forces forces{};                // of the scene
  WorldRect seen{};               // m: what is snapped to is in here
};

// Where the mouse is now.
struct DragPoint {
  Vec2 at = Vec2::Zero();        // m
  double scale = 100.0;          // px/m
  Qt::KeyboardModifiers keys{};  // Shift keeps a direction or the proportions
  double swept{};                // rad, around the centre of the grabbed body since the press
  bool snapping = true;
};

// Ctrl: bodies that overlap are not parted, and joints give way.
[[nodiscard]] inline bool is_forced(const DragPoint& point) { return point.keys.testFlag(Qt::ControlModifier); }
// Ctrl switches snapping off, too.
[[nodiscard]] inline bool snaps(const DragPoint& point) { return point.snapping && !is_forced(point); }

struct Dragged {
  std::vector<Body> bodies;                     // in the order of the start, then its followers
  QString value;                                // with its unit, for the bubble
  QString detail;                               // may be empty
  QString name;                                 // of the edit
  std::vector<std::pair<Vec2, Vec2>> guides{};  // m, from a moved body to what it snapped to
  // See drag_limits.h.
  bool fault = false;                              // what the bubble says can't be
  std::vector<Overlap> overlaps{};                 // the deepest first
  std::optional<std::pair<Vec2, Vec2>> blocked{};  // m, the ends of a joint that allows nothing
  std::vector<std::pair<Vec2, Vec2>> refused{};    // m, edges that the body can't have
  std::vector<Joint> joints{};                     // that hold the bodies
  bool refits = false;                             // some of them are changed
  SceneEdits attached{};                           // of what has its ends on a body that is resized
};

[[nodiscard]] Dragged drag_to(const DragStart& start, const DragPoint& point);

// m: a length that the mouse drew, in round steps if it snaps; never 0.
[[nodiscard]] double drawn_length(double length, const DragPoint& point);
// m: a place that the mouse drew: on the lines of the grid that are near (`grid` as in DragStart), else in
// round steps; as it is if nothing snaps.
[[nodiscard]] Vec2 drawn_place(const Vec2& at, const DragPoint& point, double grid);
// "r 0.12 m", "0.12 m × 0.20 m", "1.20 m": what the bubble says of a size, in the unit of the fields.
[[nodiscard]] QString size_text(const Shape& shape, const DragPoint& point);
// "0.12 m": a length in the decimal places that the mouse can aim at.
[[nodiscard]] QString drawn_text(double length, const DragPoint& point);
// "12 cm": likewise in a sentence, below a metre in centimetres.
[[nodiscard]] QString small_length_text(double length, const DragPoint& point);

}  // namespace carom
