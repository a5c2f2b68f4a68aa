#include "widgets/scene/text_places.h"

#include <QFontMetricsF>
#include <QPolygonF>
#include <QTransform>
#include <algorithm>
#include <cmath>

#include "widgets/scene/body_path.h"
#include "widgets/scene/scale_row.h"

namespace carom {
namespace {

constexpr double kTextGap = 6.0;  // px, of a text at an impact from its anchor
constexpr double kInset = 4.0;    // px, from the view's edges
constexpr double kLower = 4.0;    // px, a step down to a free place
constexpr double kLowest = 60.0;  // px
constexpr double kBetween = 2.0;  // px, of two texts at an impact

QRectF clear_below(const QRectF& rect, const Obstacles& obstacles) {
  for (double down = 0.0; down <= kLowest; down += kLower) {
    const QRectF place = rect.translated(0.0, down);
    if (obstacles.covered_by(place) == 0) return place;
  }
  return rect;
}

QPainterPath path_of(const Drawing::BoxItem& box, const Camera& camera) {
  const Vec2 half = box.half * camera.scale;
  const QPointF centre = camera.to_screen(box.center);
  QTransform placed = QTransform::fromTranslate(centre.x(), centre.y());
  placed.rotateRadians(-box.angle);
  QPainterPath path;
  path.addPolygon(placed.map(QPolygonF(QRectF(-half.x(), -half.y(), 2 * half.x(), 2 * half.y()))));
  return path;
}

// Outlines without a ground are those of the run before and of other methods: texts may stand there.
void add_bodies(const Drawing& drawing, const Camera& camera, Obstacles& out) {
  for (const Drawing::DiscItem& disc : drawing.discs) {
    if (disc.fill.alpha() > 0) out.discs.push_back({camera.to_screen(disc.center), disc.radius * camera.scale});
  }
  for (const Drawing::BoxItem& box : drawing.boxes) {
    if (box.fill.alpha() > 0) out.areas.push_back(path_of(box, camera));
  }
  for (const Drawing::PolygonItem& polygon : drawing.polygons) {
    if (polygon.fill.alpha() > 0)
      out.areas.push_back(polygon_path(drawing.corners(polygon), polygon.rounding, camera));
  }
  for (const Drawing::SegmentItem& wall : drawing.lines)
    out.lines.emplace_back(camera.to_screen(wall.from), camera.to_screen(wall.to));
}

}  // namespace

QFont sized_font(QFont font, double pixels, QFont::Weight weight) {
  font.setPixelSize(std::max(1, static_cast<int>(std::lround(pixels))));
  font.setWeight(weight);
  return font;
}

std::vector<NamePlace> name_places(const Drawing& drawing, const Camera& camera, const QFont& font,
                                   const Obstacles& obstacles) {
  const QFontMetricsF metrics(sized_font(font, drawing.text_size, QFont::DemiBold));
  const std::vector<ScaleMark> scales = scale_row(drawing, camera, font);
  const auto is_readable = [&](const QRectF& rect) {
    return rect.top() >= 0.0 && rect.bottom() <= camera.viewport.height() &&
           std::none_of(scales.begin(), scales.end(),
                        [&](const ScaleMark& m) { return m.rect.intersects(rect); });
  };
  std::vector<NamePlace> places;
  for (std::size_t k = 0; k < drawing.labels.size(); ++k) {
    const Drawing::LabelItem& label = drawing.labels[k];
    const double width = metrics.horizontalAdvance(label.text) + 2 * kNameGap;
    const QPointF at = camera.to_screen(label.anchor) + QPointF(-0.5 * width, 0.0);
    const QSizeF size(width, metrics.ascent());
    const QRectF above(at - QPointF(0.0, label.rise * camera.scale + label.drop + size.height()), size);
    QRectF rect = clear_below({at + QPointF(0.0, label.drop), size}, obstacles);
    if (!is_readable(rect) && is_readable(above) && obstacles.covered_by(above) == 0) rect = above;
    if (std::any_of(places.begin(), places.end(), [&](const NamePlace& p) { return p.rect.intersects(rect); }))
      continue;
    places.push_back({k, rect});
  }
  return places;
}

QFont font_of(const Drawing::JumpText& text, const Drawing& drawing, const QFont& font) {
  return sized_font(font, drawing.text_size, text.strong ? QFont::DemiBold : QFont::Normal);
}

std::vector<QRectF> jump_places(const Drawing& drawing, const Camera& camera, const QFont& font,
                                Obstacles obstacles) {
  if (drawing.jump.texts.empty()) return {};
  add_bodies(drawing, camera, obstacles);
  for (const Drawing::JumpArrow& arrow : drawing.jump.arrows)
    obstacles.lines.emplace_back(camera.to_screen(arrow.from), camera.to_screen(arrow.to));
  for (const auto& [top, end] : drawing.jump.axes)
    obstacles.lines.emplace_back(camera.to_screen(top), camera.to_screen(end));
  for (const ScaleMark& mark : scale_row(drawing, camera, font)) obstacles.rects.push_back(mark.rect);
  const QRectF view = QRectF(QPointF(), camera.viewport).adjusted(kInset, kInset, -kInset, -kInset);
  std::vector<QRectF> places;
  for (const Drawing::JumpText& text : drawing.jump.texts) {
    const QFontMetricsF metrics(font_of(text, drawing, font));
    QRectF rect = metrics.boundingRect(QRectF(), Qt::AlignLeft, text.text);
    const QPointF side(text.side.x(), -text.side.y());
    const double away = std::abs(side.x()) * (0.5 * rect.width() + kTextGap) +
                        std::abs(side.y()) * (0.5 * rect.height() + kTextGap);
    rect.moveCenter(camera.to_screen(text.at) + away * side);
    places.push_back(clear_place(rect, obstacles, view, side));
    obstacles.rects.push_back(places.back().adjusted(-kBetween, 0.0, kBetween, 0.0));
  }
  return places;
}

}  // namespace carom
