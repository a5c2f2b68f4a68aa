#include "widgets/scene/body_path.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <variant>

namespace carom {

QPainterPath body_path(const Body& body, const Camera& camera) {
  const Eigen::Rotation2Dd turned(body.angle);
  const QPointF centre = camera.to_screen(body.position);
  QPainterPath path;
  if (const auto* disc = std::get_if<Disc>(&body.shape)) {
    path.addEllipse(centre, disc->radius * camera.scale, disc->radius * camera.scale);
    return path;
  }
  if (const auto* compound = std::get_if<Compound>(&body.shape)) {
    for (const Body& part : bodies_of(*compound, body)) {
      if (area(part.shape) > 0.0) path = path.united(body_path(part, camera));
    }
    for (const Body& part : bodies_of(*compound, body)) {
      if (area(part.shape) == 0.0) path.addPath(body_path(part, camera));
    }
    return path;
  }
  Outline outline = outline_of(body.shape);
  if (outline.half_plane) {
    const Vec2 along = turned * Vec2::UnitX();
    const double middle = along.dot(camera.center - body.position);
    const double reach = (camera.visible().upper - camera.visible().lower).norm();
    path.moveTo(camera.to_screen(body.position + (middle - reach) * along));
    path.lineTo(camera.to_screen(body.position + (middle + reach) * along));
    return path;
  }
  for (Vec2& v : outline.vertices) v = body.position + turned * v;
  return polygon_path(outline.vertices, outline.rounding, camera);
}

QPainterPath polygon_path(std::span<const Vec2> vertices, double rounding, const Camera& camera) {
  const double radius = rounding * camera.scale;
  const auto count = vertices.size();
  QPainterPath path;
  for (std::size_t k = 0; k < count; ++k) {
    const Vec2 in = vertices[k] - vertices[(k + count - 1) % count];
    const Vec2 out = vertices[(k + 1) % count] - vertices[k];
    const QPointF at = camera.to_screen(vertices[k]);
    // Outward normals of the two edges, as angles in degrees.
    const double from = std::atan2(-in.x(), in.y()) * 180.0 / std::numbers::pi;
    double turn = std::atan2(-out.x(), out.y()) * 180.0 / std::numbers::pi - from;
    if (turn < 0.0) turn += 360.0;
    if (radius > 0.0) {
      const QRectF circle(at.x() - radius, at.y() - radius, 2 * radius, 2 * radius);
      if (k == 0) path.arcMoveTo(circle, from);
      path.arcTo(circle, from, turn);
    } else if (k == 0) {
      path.moveTo(at);
    } else {
      path.lineTo(at);
    }
  }
  path.closeSubpath();
  return path;
}

}  // namespace carom
