#pragma once

#include "physics/scene/scene.h"

namespace carom {

// Where two bodies touch or come nearest.
struct Contact {
  double gap = 0.0;             // m, negative for a penetration: the least distance that would part them
  Vec2 normal = Vec2::UnitX();  // from A to B
  Vec2 point = Vec2::Zero();    // m, half-way between the surfaces
};

}  // namespace carom
