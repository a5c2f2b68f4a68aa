#include "widgets/scene/drawing_shapes.h"

#include "physics/math/vectors.h"

namespace carom {

void add_polygon(const Shape& shape, const Vec2& at, double angle, const QColor& fill, const QColor& line,
                 Drawing& out) {
  const std::vector<ConvexPart> parts = convex_parts(shape);
  const bool convex = parts.size() == 1;
  for (const auto& [outline, position, box, of] : parts) {
    if (!convex && fill.alpha() == 0) break;
    const int first = static_cast<int>(out.vertices.size());
    for (const Vec2& v : outline.vertices) out.vertices.push_back(at + turned_by(angle, position + v));
    out.polygons.push_back(
        {first, static_cast<int>(outline.vertices.size()), outline.rounding, fill, convex ? line : fill});
  }
  if (convex) return;
  const std::vector<Vec2> edge = outline_of(shape).vertices;
  for (std::size_t k = 0; k < edge.size(); ++k) {
    out.lines.push_back({at + turned_by(angle, edge[k]), at + turned_by(angle, edge[(k + 1) % edge.size()]),
                         line, out.outline});
  }
}

void add_outline(const Shape& shape, const Vec2& at, double angle, const QColor& color, Drawing& out) {
  const QColor none(0, 0, 0, 0);
  if (const Disc* disc = std::get_if<Disc>(&shape)) {
    out.discs.push_back({at, disc->radius, angle, none, color, false});
  } else if (const Box* box = std::get_if<Box>(&shape)) {
    out.boxes.push_back({at, Vec2(box->width, box->height) / 2, angle, none, color});
  } else if (const Compound* compound = std::get_if<Compound>(&shape)) {
    const Vec2 centre = centre_of(*compound);
    for (const PlacedShape& placed : compound->shapes) {
      add_outline(shape_of(placed.shape), at + turned_by(angle, placed.position - centre), angle + placed.angle,
                  color, out);
    }
  } else if (!std::holds_alternative<Wall>(shape)) {
    add_polygon(shape, at, angle, none, color, out);
  }
}

}  // namespace carom
