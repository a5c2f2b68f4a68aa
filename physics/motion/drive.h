#pragma once

#include <cmath>

#include "physics/scene/scene.h"

namespace carom {

// Where a driven body is at time t (s), how fast it moves and how its velocity changes: the closed form and its
// exact derivatives. `home` is the position that the scene gives the body.
[[nodiscard]] inline Vec2 drive_position(const Drive& d, const Vec2& home, double t) {
  return home + t * d.velocity + std::sin(d.angular_frequency * t + d.phase) * d.amplitude;
}
[[nodiscard]] inline Vec2 drive_velocity(const Drive& d, double t) {
  return d.velocity + d.angular_frequency * std::cos(d.angular_frequency * t + d.phase) * d.amplitude;
}
[[nodiscard]] inline Vec2 drive_acceleration(const Drive& d, double t) {
  return -d.angular_frequency * d.angular_frequency * std::sin(d.angular_frequency * t + d.phase) * d.amplitude;
}

}  // namespace carom
