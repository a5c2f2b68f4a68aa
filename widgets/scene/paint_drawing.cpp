#include "widgets/scene/paint_drawing.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "widgets/scene/body_path.h"
#include "widgets/scene/paint_jump.h"
#include "widgets/scene/scale_row.h"
#include "widgets/scene/text_places.h"

namespace carom {
namespace {

// Arrow heads, in widths of the shaft, and never longer than this share of the arrow.
constexpr double kHeadLength = 5.5;
constexpr double kHeadHalfWidth = 2.3;
constexpr double kHeadShare = 0.7;

constexpr double kEdge = 6.0;  // px, from the muted text to the edges

void paint_grid(QPainter& painter, const Drawing& drawing, const Camera& camera, const Theme& theme) {
  const double ratio = painter.device()->devicePixelRatioF();
  painter.setRenderHint(QPainter::Antialiasing, false);
  for (const Grid::Line& line : drawing.grid.lines) {
    painter.fillRect(line_rect(line, camera, grid_line_width(drawing), ratio),
                     line.strong ? theme.strong_grid : theme.grid);
  }
  painter.setRenderHint(QPainter::Antialiasing, true);
}

void paint_boxes(QPainter& painter, const Drawing& drawing, const Camera& camera) {
  for (const Drawing::BoxItem& box : drawing.boxes) {
    const Vec2 half = box.half * camera.scale;
    const double corner = std::min(kCornerRadius, half.minCoeff());
    painter.save();
    painter.translate(camera.to_screen(box.center));
    painter.rotate(-box.angle * 180.0 / std::numbers::pi);
    painter.setPen(QPen(box.line, drawing.outline));
    painter.setBrush(box.fill);
    painter.drawRoundedRect(QRectF(-half.x(), -half.y(), 2 * half.x(), 2 * half.y()), corner, corner);
    painter.restore();
  }
}

void paint_polygons(QPainter& painter, const Drawing& drawing, const Camera& camera) {
  for (const Drawing::PolygonItem& polygon : drawing.polygons) {
    painter.setPen(QPen(polygon.line, drawing.outline, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
    painter.setBrush(polygon.fill);
    painter.drawPath(polygon_path(drawing.corners(polygon), polygon.rounding, camera));
  }
}

void paint_discs(QPainter& painter, const Drawing& drawing, const Camera& camera) {
  for (const Drawing::DiscItem& disc : drawing.discs) {
    const QPointF center = camera.to_screen(disc.center);
    const double radius = disc.radius * camera.scale;
    painter.setPen(QPen(disc.line, drawing.outline, Qt::SolidLine, Qt::RoundCap));
    painter.setBrush(disc.fill);
    painter.drawEllipse(center, radius, radius);
    if (disc.oriented) {
      painter.drawLine(center, center + radius * QPointF(std::cos(disc.angle), -std::sin(disc.angle)));
    }
  }
}

void paint_segments(QPainter& painter, const std::vector<Drawing::SegmentItem>& segments,
                    const Camera& camera) {
  for (const Drawing::SegmentItem& segment : segments) {
    const QPointF from = camera.to_screen(segment.from);
    const QPointF to = camera.to_screen(segment.to);
    if (from == to) {
      painter.setPen(Qt::NoPen);
      painter.setBrush(segment.color);
      painter.drawEllipse(from, segment.width / 2, segment.width / 2);
    } else {
      painter.setPen(QPen(segment.color, segment.width, Qt::SolidLine, Qt::RoundCap));
      painter.drawLine(from, to);
    }
  }
}

bool meets(const std::vector<QRectF>& written, const QRectF& place) {
  return std::any_of(written.begin(), written.end(), [&](const QRectF& r) { return r.intersects(place); });
}

// Coordinates of the strong lines, along the lower and left edges, except under the scale bar and names.
void paint_numbers(QPainter& painter, const Drawing& drawing, const Camera& camera, const Theme& theme,
                   double bars_end, const std::vector<QRectF>& names) {
  const QFontMetricsF metrics(painter.font());
  const double bottom = camera.viewport.height() - kEdge;
  for (const Grid::Line& line : drawing.grid.lines) {
    if (!line.strong) continue;
    const QPointF at = camera.to_screen(Vec2::Constant(line.at));
    const QString text = number_text(line.at);
    const double width = metrics.horizontalAdvance(text);
    QPointF place(kEdge, at.y() + metrics.capHeight() / 2);
    if (line.vertical) {
      place = QPointF(at.x() - width / 2, bottom);
      if (place.x() < bars_end + 12.0 || place.x() + width > camera.viewport.width() - kEdge) continue;
    } else if (at.y() < 2 * metrics.height() || at.y() > bottom - 3 * metrics.height()) {
      continue;
    }
    const QRectF ground(place.x(), place.y() - metrics.ascent(), width, metrics.height());
    if (meets(names, ground)) continue;
    paint_text_ground(painter, theme, ground);
    painter.setPen(theme.muted);
    painter.drawText(place, text);
  }
}

}  // namespace

void paint_arrow(QPainter& painter, const ArrowOnScreen& a, double width, const QColor& color) {
  const QPointF along = (a.tip - a.from) / QLineF(a.from, a.tip).length();
  const QPointF across(-along.y(), along.x());
  const QPointF base = a.tip - along * a.head_length;
  painter.setPen(QPen(color, width, Qt::SolidLine, Qt::FlatCap));
  painter.drawLine(a.from, a.shaft_end);
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  const QPointF head[] = {a.tip, base + across * a.head_half_width, base - across * a.head_half_width};
  painter.drawConvexPolygon(head, 3);
}

ArrowOnScreen arrow_between(const QPointF& from, const QPointF& tip, double width) {
  ArrowOnScreen a;
  a.from = from;
  a.tip = tip;
  const double length = QLineF(from, tip).length();
  a.head_length = std::min(kHeadLength * width, kHeadShare * length);
  a.head_half_width = a.head_length * kHeadHalfWidth / kHeadLength;
  a.shaft_end = tip - (tip - from) * (0.9 * a.head_length / length);
  return a;
}

ArrowOnScreen arrow_on_screen(const Drawing::ArrowItem& arrow, const Camera& camera) {
  return arrow_between(camera.to_screen(arrow.from), camera.to_screen(arrow.to), arrow.width);
}

double grid_line_width(const Drawing& drawing) { return drawing.outline / 1.5; }

void paint_drawing(QPainter& painter, const Drawing& drawing, const Camera& camera, const Theme& theme) {
  paint_shapes(painter, drawing, camera, theme);
  paint_text(painter, drawing, camera, theme, {});
}

void paint_shapes(QPainter& painter, const Drawing& drawing, const Camera& camera, const Theme& theme) {
  painter.fillRect(QRectF(QPointF(), camera.viewport), theme.scene_ground);
  painter.setRenderHint(QPainter::Antialiasing);
  if (drawing.has_grid) paint_grid(painter, drawing, camera, theme);
  paint_boxes(painter, drawing, camera);
  paint_polygons(painter, drawing, camera);
  paint_segments(painter, drawing.lines, camera);
  paint_discs(painter, drawing, camera);
  paint_segments(painter, drawing.segments, camera);
  for (const Drawing::ArrowItem& arrow : drawing.arrows) {
    paint_arrow(painter, arrow_on_screen(arrow, camera), arrow.width, arrow.color);
  }
}

void paint_text(QPainter& painter, const Drawing& drawing, const Camera& camera, const Theme& theme,
                const Obstacles& obstacles) {
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  const double left = paint_scale_row(painter, drawing, camera, theme);
  const QFont bold = sized_font(painter.font(), drawing.text_size, QFont::DemiBold);
  painter.setFont(bold);
  const double ascent = QFontMetricsF(bold).ascent();
  Obstacles taken = obstacles;
  std::vector<QRectF> names;
  for (const NamePlace& name : name_places(drawing, camera, bold, obstacles)) {
    painter.setPen(drawing.labels[name.label].color);
    painter.drawText(name.rect.topLeft() + QPointF(kNameGap, ascent), drawing.labels[name.label].text);
    taken.rects.push_back(name.rect);
    names.push_back(name.rect);
  }
  if (drawing.has_grid) {
    painter.setFont(sized_font(bold, drawing.text_size - 1.0, QFont::Normal));
    paint_numbers(painter, drawing, camera, theme, left, names);
    painter.setFont(bold);
  }
  paint_jump(painter, drawing, camera, theme, taken);
}

}  // namespace carom
