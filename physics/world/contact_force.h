#pragma once

#include <cstdint>

#include "physics/math/vectors.h"

namespace carom {

// Force of one contact point on two bodies during a step.
struct ContactForce {
  int a = 0;
  int b = 0;                      // a < b
  std::uint32_t id = 0;           // of the manifold point; constant while the same features touch
  Vec2 point = Vec2::Zero();      // m, at the step's start
  Vec2 normal = Vec2::UnitX();    // from a to b
  double normal_force = 0.0;      // N, mean over the step: the force on b along the normal
  double tangential_force = 0.0;  // N, along the normal turned by +90°
  double rolling_moment = 0.0;    // N m
  bool sticks = false;            // did not slip
};

}  // namespace carom
