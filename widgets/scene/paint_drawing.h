#pragma once

#include <QPointF>

#include "widgets/scene/drawing.h"
#include "widgets/scene/obstacles.h"

class QPainter;

namespace carom {

// Corners of boxes are rounded by this on the screen, in px; by less where the box is thinner.
inline constexpr double kCornerRadius = 2.0;

// An arrow on the screen, in px: its shaft ends inside the head, so that the tip stays sharp.
struct ArrowOnScreen {
  QPointF from;
  QPointF shaft_end;
  QPointF tip;
  double head_length = 0.0;
  double head_half_width = 0.0;
};

[[nodiscard]] ArrowOnScreen arrow_between(const QPointF& from, const QPointF& tip, double width);
void paint_arrow(QPainter& painter, const ArrowOnScreen& a, double width, const QColor& color);
[[nodiscard]] ArrowOnScreen arrow_on_screen(const Drawing::ArrowItem& arrow, const Camera& camera);

// Widths of the grid's lines, in px.
[[nodiscard]] double grid_line_width(const Drawing& drawing);

// Paints everything by QPainter, on screens without OpenGL and in pictures: the two parts below.
void paint_drawing(QPainter& painter, const Drawing& drawing, const Camera& camera, const Theme& theme);

// Background, grid and shapes.
void paint_shapes(QPainter& painter, const Drawing& drawing, const Camera& camera, const Theme& theme);
// Names, the grid's numbers and the scale bar; also over OpenGL. Names, and texts at an impact, stand clear of
// the obstacles.
void paint_text(QPainter& painter, const Drawing& drawing, const Camera& camera, const Theme& theme,
                const Obstacles& obstacles);

}  // namespace carom
