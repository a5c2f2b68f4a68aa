#include "widgets/scene/hit.h"

#include <Eigen/Geometry>
#include <QPainterPath>
#include <algorithm>

#include "widgets/scene/body_path.h"

namespace carom {
namespace {

// px around a moving body that count as a click on it, and the least radius that the mouse has to meet.
constexpr double kClickSlack = 3.0;
constexpr double kLeastRadius = 12.0;
constexpr double kWallSlack = 6.0;  // px on each side of a thin wall, or of a body that has some

bool is_thin(const Shape& shape) {
  if (const auto* wall = std::get_if<Wall>(&shape)) return wall->length.has_value();
  const auto* compound = std::get_if<Compound>(&shape);
  return compound != nullptr &&
         std::any_of(compound->shapes.begin(), compound->shapes.end(),
                     [](const PlacedShape& placed) { return std::holds_alternative<Wall>(placed.shape); });
}

// px around the body that count as a click on it.
double slack_of(const Body& body, double seen) {
  if (!body.fixed) return std::max(kClickSlack, kLeastRadius - seen);
  return is_thin(body.shape) ? kWallSlack : 0.0;
}

bool covers(const Shape& shape, const Vec2& offset, double angle, double slack) {
  if (offset.norm() > bounding_radius(shape) + slack) return false;
  return signed_distance(shape, Eigen::Rotation2Dd(-angle) * offset) <= slack;
}

}  // namespace

int body_count(const Frame& frame) {
  return frame.bodies ? std::min(frame.state.size(), static_cast<int>(frame.bodies->size())) : 0;
}

Body body_now(const Frame& frame, int index) {
  Body body = (*frame.bodies)[static_cast<std::size_t>(index)];
  body.position = frame.state.position(index);
  body.angle = frame.state.q(2, index);
  body.velocity = frame.state.velocity(index);
  body.spin = frame.state.v(2, index);
  return body;
}

std::vector<int> bodies_at(const Frame& frame, const Camera& camera, const QPointF& at) {
  std::vector<int> found;
  const Vec2 point = camera.to_world(at);
  // Moving bodies come before fixed ones, as they may be small; of two, the later one is painted on top.
  for (const bool fixed : {false, true}) {
    for (int i = body_count(frame) - 1; i >= 0; --i) {
      const Body& body = (*frame.bodies)[static_cast<std::size_t>(i)];
      if (body.fixed != fixed) continue;
      const double seen = bounding_radius(body.shape) * camera.scale;
      const double slack = slack_of(body, seen) / camera.scale;
      if (covers(body.shape, point - frame.state.position(i), frame.state.q(2, i), slack)) found.push_back(i);
    }
  }
  return found;
}

int body_at(const Frame& frame, const Camera& camera, const QPointF& at) {
  const std::vector<int> found = bodies_at(frame, camera, at);
  return found.empty() ? -1 : found.front();
}

std::vector<int> bodies_in(const Frame& frame, const Camera& camera, const QRectF& rect) {
  std::vector<int> found;
  for (int i = 0; i < body_count(frame); ++i) {
    const Body body = body_now(frame, i);
    const bool half_plane = outline_of(body.shape).half_plane;
    const bool touched =
        half_plane ? rect.contains(camera.to_screen(body.position)) : body_path(body, camera).intersects(rect);
    if (touched) found.push_back(i);
  }
  return found;
}

}  // namespace carom
