#include "widgets/scene/text_places.h"

#include <QFontMetricsF>
#include <QPolygonF>
#include <QTransform>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "widgets/scene/body_path.h"
#include "widgets/scene/scale_row.h"

namespace carom {
namespace {

constexpr double kTextGap = 6.0;      // px, of a text at an impact from its anchor
constexpr double kInset = 4.0;        // px, from the view's edges
constexpr double kLower = 4.0;        // px, a step down to a free place
constexpr double kLowest = 60.0;      // px
constexpr double kBetween = 2.0;      // px, of two texts at an impact
constexpr double kBelowCentre = 3.0;  // px, of a name within its body

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

// The bodies that can move, by their index.
using Silhouettes = std::map<int, Obstacles>;

Silhouettes silhouettes_of(const Drawing& drawing, const Camera& camera) {
  Silhouettes all;
  for (const Drawing::DiscItem& disc : drawing.discs) {
    if (disc.body != Drawing::kNoBody)
      all[disc.body].discs.push_back({camera.to_screen(disc.center), disc.radius * camera.scale});
  }
  for (const Drawing::BoxItem& box : drawing.boxes) {
    if (box.body != Drawing::kNoBody) all[box.body].areas.push_back(path_of(box, camera));
  }
  for (const Drawing::PolygonItem& polygon : drawing.polygons) {
    if (polygon.body != Drawing::kNoBody)
      all[polygon.body].areas.push_back(polygon_path(drawing.corners(polygon), polygon.rounding, camera));
  }
  return all;
}

// Whether one of its shapes does.
bool contains(const Obstacles& body, const QRectF& rect) {
  const auto in_disc = [&rect](const Obstacles::Disc& disc) {
    const QPointF from = rect.topLeft() - disc.centre;
    const QPointF to = rect.bottomRight() - disc.centre;
    return std::hypot(std::max(std::abs(from.x()), std::abs(to.x())),
                      std::max(std::abs(from.y()), std::abs(to.y()))) < disc.radius;
  };
  return std::any_of(body.discs.begin(), body.discs.end(), in_disc) ||
         std::any_of(body.areas.begin(), body.areas.end(),
                     [&rect](const QPainterPath& area) { return area.contains(rect); });
}

// Where names stand.
class Names {
 public:
  Names(const Drawing& drawing, const Camera& camera, const QFont& font, const Obstacles& obstacles)
      : camera_(camera),
        obstacles_(obstacles),
        scales_(scale_row(drawing, camera, font)),
        bodies_(silhouettes_of(drawing, camera)) {
    for (const Drawing::ArrowItem& arrow : drawing.arrows)
      arrows_.lines.emplace_back(camera.to_screen(arrow.from), camera.to_screen(arrow.to));
  }

  // Below, in its body, above or beside it: the first place that is not on another body.
  [[nodiscard]] std::optional<QRectF> place(const Drawing::LabelItem& label, const QSizeF& size) const {
    const QPointF at = camera_.to_screen(label.anchor) - QPointF(0.5 * size.width(), 0.0);
    const QRectF above(at - QPointF(0.0, label.rise * camera_.scale + label.drop + size.height()), size);
    const QRectF below = clear_below({at + QPointF(0.0, label.drop), size}, obstacles_);
    const auto is_clear = [this](const QRectF& rect) {
      return is_readable(rect) && obstacles_.covered_by(rect) == 0;
    };
    const bool lifted = !is_readable(below) && is_clear(above);
    if (!label.named) return lifted ? above : below;
    const Drawing::LabelItem::Named& named = *label.named;
    if (lifted && is_apart(above, named.body)) return above;
    if (is_readable(below) && is_apart(below, named.body)) return below;
    if (const auto inside = place_inside(named, size)) return inside;
    const QPointF middle = camera_.to_screen(named.centre) - QPointF(0.0, 0.5 * size.height());
    const QPointF aside(named.half_width * camera_.scale + label.drop, 0.0);
    for (const QRectF& rect :
         {above, QRectF(middle + aside, size), QRectF(middle - aside - QPointF(size.width(), 0.0), size)}) {
      if (is_clear(rect) && is_apart(rect, named.body)) return rect;
    }
    return is_apart(below, named.body) ? std::optional(below) : std::nullopt;
  }

 private:
  [[nodiscard]] bool is_readable(const QRectF& rect) const {
    return rect.top() >= 0.0 && rect.bottom() <= camera_.viewport.height() &&
           std::none_of(scales_.begin(), scales_.end(),
                        [&](const ScaleMark& m) { return m.rect.intersects(rect); });
  }
  // From all bodies but its own.
  [[nodiscard]] bool is_apart(const QRectF& rect, int own) const {
    const QRectF letters = rect.adjusted(kNameGap, 0.0, -kNameGap, 0.0);
    return std::none_of(bodies_.begin(), bodies_.end(), [&](const Silhouettes::value_type& each) {
      return each.first != own && each.second.covered_by(letters) > 0;
    });
  }
  // Below the centre, where no arrow and no mark of its angle begins, else about it, or towards a side:
  // the first of those under the fewest arrows.
  [[nodiscard]] std::optional<QRectF> place_inside(const Drawing::LabelItem::Named& named,
                                                   const QSizeF& size) const {
    const auto body = bodies_.find(named.body);
    if (body == bodies_.end()) return std::nullopt;
    const QPointF centre = camera_.to_screen(named.centre);
    const double room = named.half_width * camera_.scale - 0.5 * size.width() - kBelowCentre;
    std::optional<QRectF> best;
    int least = 0;
    for (const double side : {0.0, -0.5, 0.5, -1.0, 1.0}) {
      for (const double top : {kBelowCentre, -0.5 * size.height()}) {
        const QRectF rect(centre + QPointF(side * room - 0.5 * size.width(), top), size);
        const int covered = arrows_.covered_by(rect);
        if (best && covered >= least) continue;
        if (!is_readable(rect) || obstacles_.covered_by(rect) > 0 || !contains(body->second, rect)) continue;
        best = rect;
        least = covered;
      }
    }
    return best;
  }

  const Camera& camera_;
  const Obstacles& obstacles_;
  std::vector<ScaleMark> scales_;
  Silhouettes bodies_;
  Obstacles arrows_;
};

}  // namespace

QFont sized_font(QFont font, double pixels, QFont::Weight weight) {
  font.setPixelSize(std::max(1, static_cast<int>(std::lround(pixels))));
  font.setWeight(weight);
  return font;
}

std::vector<NamePlace> name_places(const Drawing& drawing, const Camera& camera, const QFont& font,
                                   const Obstacles& obstacles) {
  const QFontMetricsF metrics(sized_font(font, drawing.text_size, QFont::DemiBold));
  const Names names(drawing, camera, font, obstacles);
  std::vector<NamePlace> places;
  for (std::size_t k = 0; k < drawing.labels.size(); ++k) {
    const Drawing::LabelItem& label = drawing.labels[k];
    const double width = metrics.horizontalAdvance(label.text) + 2 * kNameGap;
    const std::optional<QRectF> rect = names.place(label, {width, metrics.ascent()});
    const auto meets = [&rect](const NamePlace& p) { return p.rect.intersects(*rect); };
    if (!rect || std::any_of(places.begin(), places.end(), meets)) continue;
    places.push_back({k, *rect});
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
