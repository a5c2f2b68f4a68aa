#pragma once

#include <cmath>

#include "physics/scene/scene.h"

namespace carom {

// Where a kinematic body is at time t (s), how fast it moves and how its velocity changes: the closed form and
// its exact derivatives. `home` is the position that the scene gives the body.
[[nodiscard]] inline Vec2 drive_position(const Drive& d, const Vec2& home, double t) {
  return home + t * d.velocity + std::sin(d.angular_frequency * t + d.phase) * d.amplitude;
}
[[nodiscard]] inline Vec2 drive_velocity(const Drive& d, double t) {
  return d.velocity + d.angular_frequency * std::cos(d.angular_frequency * t + d.phase) * d.amplitude;
}
[[nodiscard]] inline Vec2 drive_acceleration(const Drive& d, double t) {
  return -d.angular_frequency * d.angular_frequency * std::sin(d.angular_frequency * t + d.phase) * d.amplitude;
}

// The body as it is at time t (s): a kinematic one where its drive has moved it, with the drive's velocity; any
// other as the scene has it at the start.
[[nodiscard]] inline Body moved_by_drive(Body body, double t) {
  if (!body.drive) return body;
  body.velocity = drive_velocity(*body.drive, t);
  body.position = drive_position(*body.drive, body.position, t);
  return body;
}

}  // namespace carom
