#include "widgets/scene/paint_jump.h"

#include <QLineF>
#include <QPainter>
#include <QPen>
#include <cstddef>
#include <vector>

#include "widgets/scene/paint_drawing.h"
#include "widgets/scene/text_places.h"

namespace carom {
namespace {

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

}  // namespace

void paint_jump(QPainter& painter, const Drawing& drawing, const Camera& camera, const Theme& theme,
                const Obstacles& obstacles) {
  const Drawing::Jump& jump = drawing.jump;
  QPen dashed(theme.muted, drawing.outline, Qt::CustomDashLine, Qt::FlatCap);
  dashed.setDashPattern({3.0, 2.5});
  painter.setPen(dashed);
  for (const auto& [top, end] : jump.axes) painter.drawLine(camera.to_screen(top), camera.to_screen(end));
  const double line_scale = grid_line_width(drawing);
  for (const Drawing::JumpArrow& arrow : jump.arrows) paint_arrow(painter, arrow, line_scale, camera, theme);
  const QFont font = painter.font();
  const std::vector<QRectF> places = jump_places(drawing, camera, font, obstacles);
  for (std::size_t k = 0; k < places.size(); ++k) {
    painter.setFont(font_of(jump.texts[k], drawing, font));
    painter.setPen(jump.texts[k].color);
    painter.drawText(places[k], Qt::AlignLeft | Qt::TextDontClip, jump.texts[k].text);
  }
}

}  // namespace carom
