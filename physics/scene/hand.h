#pragma once

#include <numbers>

#include "physics/math/vectors.h"
#include "physics/scene/scene.h"

namespace carom {

// A hand on a body, as it stands now, that takes hold at this place (m) and has not moved yet. A free body
// would swing about it twice a second, with 0.7 of the critical damping.
[[nodiscard]] inline Hand hand_on(const Body& body, const Vec2& place) {
  constexpr double kOmega = 2.0 * std::numbers::pi * 2.0;  // rad/s
  constexpr double kDampingRatio = 0.7;
  const double mass = mass_of(body);
  return {.body = body.name,
          .grip = turned_by(-body.angle, place - body.position),
          .place = place,
          .stiffness = mass * kOmega * kOmega,
          .damping = 2.0 * kDampingRatio * mass * kOmega};
}

}  // namespace carom
