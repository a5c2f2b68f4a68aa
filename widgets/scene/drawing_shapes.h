#pragma once

#include <QColor>

#include "physics/scene/shape.h"
#include "widgets/scene/drawing.h"

namespace carom {

// Adds a shape of vertices whose centre of mass is at `at`. One that is not convex is filled part by part, and
// its outline is drawn over them; with a transparent `fill`, the outline alone.
void add_polygon(const Shape& shape, const Vec2& at, double angle, const QColor& fill, const QColor& line,
                 Drawing& out);

// Adds the outline of a body's shape whose centre of mass is at `at`, without a fill. None of a wall.
void add_outline(const Shape& shape, const Vec2& at, double angle, const QColor& color, Drawing& out);

}  // namespace carom
