#pragma once

#include <cstddef>

#include "widgets/scene/drag.h"

namespace carom {

// m: where the corner of this body, a polygon, is in the scene.
[[nodiscard]] Vec2 corner_at(const Body& body, std::size_t corner);

// The first body of the start with its corner at this place (m). The other corners stay where they are in the
// scene, and so do the ends of joints; the density stays. Where there can be no corner the body is as it was,
// and the edges that can't be are refused.
[[nodiscard]] Dragged with_corner(const DragStart& start, const Vec2& at, double scale);

// The same with the mouse there. Shift keeps x or y.
[[nodiscard]] Dragged drag_corner(const DragStart& start, const DragPoint& point);

}  // namespace carom
