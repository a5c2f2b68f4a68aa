#pragma once

#include <cmath>

#include "physics/motion/state.h"

namespace carom {

// A vector turned by an angle in rad, and by +90°: ω crossed(r) is the velocity that a spin ω gives the point
// r.
[[nodiscard]] inline Vec2 turned_by(double angle, const Vec2& v) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}
[[nodiscard]] inline Vec2 crossed(const Vec2& v) { return {-v.y(), v.x()}; }

}  // namespace carom
