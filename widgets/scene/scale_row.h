#pragma once

#include <QFont>
#include <QPointF>
#include <QRectF>
#include <QString>
#include <optional>
#include <vector>

#include "widgets/scene/drawing.h"

class QPainter;

namespace carom {

// A scale at the lower left of the scene: a bar of a round length, or an arrow of a round velocity or force.
enum class ScaleKind { kLength, kVelocity, kForce };

struct ScaleMark {
  ScaleKind kind = ScaleKind::kLength;
  QPointF from;         // px, its left end
  double length = 0.0;  // px
  QString text;
  QRectF rect;  // px, of both
};

// From left to right, each with its text in the drawing's size of this font. In a narrow view arrows are left
// out, the last one first; the bar stays.
[[nodiscard]] std::vector<ScaleMark> scale_row(const Drawing& drawing, const Camera& camera, const QFont& font);
// Returns its right end, in px.
double paint_scale_row(QPainter& painter, const Drawing& drawing, const Camera& camera, const Theme& theme);

// The arrow at this place; nothing for the bar, whose length is that of the view.
[[nodiscard]] std::optional<ScaleKind> arrow_scale_at(const std::vector<ScaleMark>& row, const QPointF& at);
// What its tooltip says.
[[nodiscard]] QString scale_tip(ScaleKind kind);

// The arrow for a round `amount`, near `longest` px, of what has `per_unit` px of arrow.
[[nodiscard]] Drawing::ArrowKey arrow_key(double longest, double per_unit, double width, const QColor& color);

// Background under text at the edges, readable on a wall.
void paint_text_ground(QPainter& painter, const Theme& theme, const QRectF& text);

}  // namespace carom
