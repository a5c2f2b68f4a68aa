#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>

namespace carom {

using Vec2 = Eigen::Vector2d;

// The unit vector at an angle in rad from +x: (cos, sin). Along an axis exactly if the angle is a multiple of
// π/2 as well as doubles know it, so that a wall at π/2 has no component of 6e-17 along itself.
[[nodiscard]] inline Vec2 direction_at(double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const double unknown = 0.5 * std::numeric_limits<double>::epsilon() * std::abs(angle);
  if (std::abs(c) <= unknown) return {0.0, std::copysign(1.0, s)};
  if (std::abs(s) <= unknown) return {std::copysign(1.0, c), 0.0};
  return {c, s};
}
// A vector turned by an angle in rad.
[[nodiscard]] inline Vec2 turned_by(double angle, const Vec2& v) {
  const Vec2 along = direction_at(angle);
  return {along.x() * v.x() - along.y() * v.y(), along.y() * v.x() + along.x() * v.y()};
}
// A vector turned by +90°. A spin ω gives the point r the velocity ω crossed(r).
[[nodiscard]] inline Vec2 crossed(const Vec2& v) { return {-v.y(), v.x()}; }

// The third component of u × v.
[[nodiscard]] inline double cross(const Vec2& u, const Vec2& v) { return u.x() * v.y() - u.y() * v.x(); }

}  // namespace carom
