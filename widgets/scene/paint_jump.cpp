#include "widgets/scene/paint_jump.h"

#include <QFontMetricsF>
#include <QLineF>
#include <QPainter>
#include <QPen>
#include <algorithm>
#include <cmath>

#include "widgets/scene/paint_drawing.h"

namespace carom {
namespace {

constexpr double kTextGap = 6.0;  // px, from its anchor
constexpr double kInset = 4.0;    // px, from the view's edges

void paint_arrow(QPainter& painter, const Drawing::JumpArrow& arrow, double line_scale, const Camera& camera,
                 const Theme& theme) {
  const double width = arrow.width * line_scale;
  const ArrowOnScreen a = arrow_on_screen({arrow.from, arrow.to, arrow.color, width}, camera);
  const QPointF along = (a.tip - a.from) / QLineF(a.from, a.tip).length();
  const QPointF across(-along.y(), along.x());
  const QPointF base = a.tip - along * a.head_length;
  painter.setPen(QPen(arrow.color, width, Qt::SolidLine, Qt::FlatCap));
  painter.drawLine(a.from, base);
  painter.setPen(QPen(arrow.color, 0.6 * width, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
  painter.setBrush(arrow.hollow ? theme.scene_ground : arrow.color);
  const QPointF head[] = {a.tip, base + across * a.head_half_width, base - across * a.head_half_width};
  painter.drawConvexPolygon(head, 3);
}

void paint_words(QPainter& painter, const Drawing::JumpText& text, const Camera& camera) {
  QFont font = painter.font();
  font.setWeight(text.strong ? QFont::DemiBold : QFont::Normal);
  painter.setFont(font);
  const QFontMetricsF metrics(font);
  QRectF place = metrics.boundingRect(QRectF(), Qt::AlignLeft, text.text);
  const QPointF side(text.side.x(), -text.side.y());
  const double away = std::abs(side.x()) * (0.5 * place.width() + kTextGap) +
                      std::abs(side.y()) * (0.5 * place.height() + kTextGap);
  place.moveCenter(camera.to_screen(text.at) + away * side);
  const QRectF view = QRectF(QPointF(), camera.viewport).adjusted(kInset, kInset, -kInset, -kInset);
  place.moveLeft(std::clamp(place.left(), view.left(), std::max(view.left(), view.right() - place.width())));
  place.moveTop(std::clamp(place.top(), view.top(), std::max(view.top(), view.bottom() - place.height())));
  painter.setPen(text.color);
  painter.drawText(place, Qt::AlignLeft | Qt::TextDontClip, text.text);
}

}  // namespace

void paint_jump(QPainter& painter, const Drawing& drawing, const Camera& camera, const Theme& theme) {
  const Drawing::Jump& jump = drawing.jump;
  if (jump.axis) {
    QPen dashed(theme.muted, drawing.outline, Qt::CustomDashLine, Qt::FlatCap);
    dashed.setDashPattern({3.0, 2.5});
    painter.setPen(dashed);
    painter.drawLine(camera.to_screen(jump.axis->first), camera.to_screen(jump.axis->second));
  }
  const double line_scale = grid_line_width(drawing);
  for (const Drawing::JumpArrow& arrow : jump.arrows) paint_arrow(painter, arrow, line_scale, camera, theme);
  for (const Drawing::JumpText& text : jump.texts) paint_words(painter, text, camera);
}

}  // namespace carom
