#include "widgets/scene/scale_row.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "widgets/scene/paint_drawing.h"

namespace carom {
namespace {

// px
constexpr double kLeft = 26.0;
constexpr double kBottom = 16.0;
constexpr double kToText = 6.0;
constexpr double kBetween = 18.0;
constexpr double kToEdge = 10.0;  // from the last arrow's text to the right edge of the view

QFont sized(QFont font, const Drawing& drawing) {
  font.setPixelSize(std::max(1, static_cast<int>(std::lround(drawing.text_size))));
  font.setWeight(QFont::Normal);
  return font;
}

}  // namespace

std::vector<ScaleMark> scale_row(const Drawing& drawing, const Camera& camera, const QFont& font) {
  const QFontMetricsF metrics(sized(font, drawing));
  std::vector<ScaleMark> row;
  double left = kLeft;
  const auto add = [&](ScaleKind kind, double length, const QString& text) {
    const QPointF from(left, camera.viewport.height() - kBottom);
    const double end = left + length + kToText + metrics.horizontalAdvance(text);
    if (kind != ScaleKind::kLength && end > camera.viewport.width() - kToEdge) return false;
    const double half = 0.5 * metrics.height();
    row.push_back({kind, from, length, text, {from - QPointF(0.0, half), QPointF(end, from.y() + half)}});
    left = end + kBetween;
    return true;
  };
  if (drawing.has_grid) {
    add(ScaleKind::kLength, drawing.grid.scale_bar * camera.scale, length_text(drawing.grid.scale_bar));
  }
  const Drawing::ArrowKey& velocity = drawing.velocity_key;
  const Drawing::ArrowKey& force = drawing.force_key;
  const bool fits = !(velocity.amount > 0.0) || add(ScaleKind::kVelocity, velocity.length,
                                                    number_text(velocity.amount) + QStringLiteral(" m/s"));
  if (fits && force.amount > 0.0)
    add(ScaleKind::kForce, force.length, number_text(force.amount) + QStringLiteral(" N"));
  return row;
}

double paint_scale_row(QPainter& painter, const Drawing& drawing, const Camera& camera, const Theme& theme) {
  const std::vector<ScaleMark> row = scale_row(drawing, camera, painter.font());
  painter.setFont(sized(painter.font(), drawing));
  const double half_capital = 0.5 * QFontMetricsF(painter.font()).capHeight();
  for (const ScaleMark& mark : row) {
    const QPointF to = mark.from + QPointF(mark.length, 0.0);
    paint_text_ground(painter, theme, mark.rect);
    painter.setPen(theme.muted);
    painter.drawText(to + QPointF(kToText, half_capital), mark.text);
    if (mark.kind == ScaleKind::kLength) {
      painter.setPen(QPen(theme.muted, drawing.outline, Qt::SolidLine, Qt::FlatCap));
      painter.drawLine(mark.from, to);
    } else {
      const Drawing::ArrowKey& key =
          mark.kind == ScaleKind::kVelocity ? drawing.velocity_key : drawing.force_key;
      paint_arrow(painter, arrow_between(mark.from, to, key.width), key.width, key.color);
    }
  }
  return row.empty() ? kLeft : row.back().rect.right();
}

std::optional<ScaleKind> arrow_scale_at(const std::vector<ScaleMark>& row, const QPointF& at) {
  for (const ScaleMark& mark : row) {
    if (mark.kind != ScaleKind::kLength && mark.rect.contains(at)) return mark.kind;
  }
  return std::nullopt;
}

QString scale_tip(ScaleKind kind) {
  return kind == ScaleKind::kVelocity
             ? QStringLiteral("The scale of velocities. A click doubles their arrows, with Shift halves them.")
             : QStringLiteral("The scale of forces. A click doubles their arrows, with Shift halves them.");
}

Drawing::ArrowKey arrow_key(double longest, double per_unit, double width, const QColor& color) {
  const double amount = step_not_above(longest / per_unit);
  return {amount, amount * per_unit, width, color};
}

void paint_text_ground(QPainter& painter, const Theme& theme, const QRectF& text) {
  QColor ground = theme.scene_ground;
  ground.setAlphaF(0.85F);
  painter.setPen(Qt::NoPen);
  painter.setBrush(ground);
  painter.drawRoundedRect(text.adjusted(-4.0, -1.0, 4.0, 1.0), 4.0, 4.0);
}

}  // namespace carom
