#pragma once

#include <cmath>

#include "physics/scene/scene.h"

namespace carom {

// Position, velocity and acceleration of a kinematic body at time t (s), in closed form. `home` is the
// position that the scene gives the body.
[[nodiscard]] inline Vec2 drive_position(const Drive& d, const Vec2& home, double t) {
  return home + t * d.velocity + std::sin(d.angular_frequency * t + d.phase) * d.amplitude;
}
[[nodiscard]] inline Vec2 drive_velocity(const Drive& d, double t) {
  return d.velocity + d.angular_frequency * std::cos(d.angular_frequency * t + d.phase) * d.amplitude;
}
[[nodiscard]] inline Vec2 drive_acceleration(const Drive& d, double t) {
  return -d.angular_frequency * d.angular_frequency * std::sin(d.angular_frequency * t + d.phase) * d.amplitude;
}

// The body at time t (s). A kinematic one has the position and velocity of its drive; any other is as the
// scene states it.
[[nodiscard]] inline Body moved_by_drive(Body body, double t) {
  if (!body.drive) return body;
  body.velocity = drive_velocity(*body.drive, t);
  body.position = drive_position(*body.drive, body.position, t);
  return body;
}

}  // namespace carom
