#pragma once

#include <algorithm>
#include <numbers>

#include "physics/math/vectors.h"
#include "physics/scene/scene.h"

namespace carom {

// A hand on a body, as it stands now, that takes hold at this place (m) and has not moved yet. A free body
// would swing about it twice a second, with 0.7 of the critical damping; slower where a `step` (s) of a method
// would be too long for it at this grip.
[[nodiscard]] inline Hand hand_on(const Body& body, const Vec2& place, double step = 0.0) {
  constexpr double kOmega = 2.0 * std::numbers::pi * 2.0;  // rad/s
  constexpr double kDampingRatio = 0.7;
  constexpr double kMostDamped = 0.7;  // share of the grip's velocity, in a step
  const double mass = mass_of(body);
  const double inertia = inertia_of(body);
  const Vec2 arm = place - body.position;
  // How much more easily the grip moves than the centre.
  const double ease = 1.0 + (inertia > 0.0 ? mass * arm.squaredNorm() / inertia : 0.0);
  double omega = kOmega;
  if (step > 0.0) omega = std::min(omega, kMostDamped / (2.0 * kDampingRatio * ease * step));
  return {.body = body.name,
          .grip = turned_by(-body.angle, arm),
          .place = place,
          .stiffness = mass * omega * omega,
          .damping = 2.0 * kDampingRatio * mass * omega};
}

}  // namespace carom
