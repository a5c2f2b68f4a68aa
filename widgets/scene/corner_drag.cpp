#include "widgets/scene/corner_drag.h"

#include <cmath>
#include <utility>
#include <variant>

#include "physics/math/vectors.h"
#include "physics/scene/polygon.h"
#include "widgets/scene/edit_names.h"

namespace carom {
namespace {

QString fault_text(const Polygon& polygon) {
  const std::vector<Vec2> corners = tidied(polygon.vertices);
  const bool many =
      corners.size() > std::size_t{kMostVertices} && convex_hull(corners).size() == corners.size();
  if (many) return QStringLiteral("at most %1 corners without a dent").arg(kMostVertices);
  return polygon.rounding > 0.0 ? QStringLiteral("rounded bodies are convex") : QStringLiteral("edges cross");
}

Attached attached_at(const DragStart& start) {
  return {start.joints, start.forces.springs, start.forces.applied};
}

// What has its ends on the body, as it was.
SceneEdits attached_before(const DragStart& start) {
  return kept_ends(attached_at(start), start.bodies[0].name, Vec2::Zero());
}

// As they were.
void refuse_corner(const DragStart& start, const Polygon& polygon, const Vec2& at, Dragged& out) {
  const std::size_t count = polygon.vertices.size();
  const Body& body = start.bodies[0];
  out.bodies = {body};
  out.attached = attached_before(start);
  for (const std::size_t beside : {start.corner + count - 1, start.corner + 1})
    out.refused.emplace_back(corner_at(body, beside % count), at);
  out.value = fault_text(polygon);
  out.detail = QStringLiteral("Let go: the corner goes back.");
  out.fault = true;
}

}  // namespace

Vec2 corner_at(const Body& body, std::size_t corner) {
  const auto& polygon = std::get<Polygon>(body.shape);
  return body.position + turned_by(body.angle, polygon.vertices[corner] - centre_of(polygon));
}

Dragged with_corner(const DragStart& start, const Vec2& at, double scale) {
  const Body& body = start.bodies[0];
  Polygon polygon = std::get<Polygon>(body.shape);
  polygon.vertices[start.corner] = centre_of(polygon) + turned_by(-body.angle, at - body.position);
  Dragged out;
  out.name = "Resize " + name_of_bodies(start.bodies);
  if (fault_of(polygon.vertices, polygon.rounding)) {
    refuse_corner(start, polygon, at, out);
    return out;
  }
  SceneEdits edits = reshaping(attached_at(start), body, resized(body, polygon, start.keeps));
  out.bodies = {std::get<Replace<Body>>(edits.front()).part};
  edits.erase(edits.begin());
  out.attached = edits.empty() ? attached_before(start) : std::move(edits);
  out.value = place_text(at, scale);
  if (!has_infinite_mass(body)) out.detail = QStringLiteral("m = %1 kg").arg(mass_of(out.bodies[0]), 0, 'g', 3);
  return out;
}

Dragged drag_corner(const DragStart& start, const DragPoint& point) {
  const Vec2 before = corner_at(start.bodies[0], start.corner);
  const Vec2 way = point.at - start.press;
  Vec2 at = drawn_place(before + way, point, start.grid);
  if (point.keys.testFlag(Qt::ShiftModifier)) {
    const int across = std::abs(way.x()) >= std::abs(way.y()) ? 1 : 0;
    at[across] = before[across];
  }
  Dragged out = with_corner(start, at, point.scale);
  if (!out.fault) out.detail = with_former(out.detail, place_text(before, point.scale));
  return out;
}

}  // namespace carom
