#pragma once

#include <Eigen/Core>
#include <cmath>

namespace carom {

using Vec2 = Eigen::Vector2d;

// A vector turned by an angle in rad.
[[nodiscard]] inline Vec2 turned_by(double angle, const Vec2& v) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}
// A vector turned by +90°. A spin ω gives the point r the velocity ω crossed(r).
[[nodiscard]] inline Vec2 crossed(const Vec2& v) { return {-v.y(), v.x()}; }

// The third component of u × v.
[[nodiscard]] inline double cross(const Vec2& u, const Vec2& v) { return u.x() * v.y() - u.y() * v.x(); }

}  // namespace carom
