#pragma once

#include "physics/model/index.h"
#include "physics/scene/scene.h"

namespace carom {

// Where two bodies touch or come nearest.
struct Contact {
  double gap = 0.0;             // m; if negative, minus the penetration depth
  Vec2 normal = Vec2::UnitX();  // from A to B
  Vec2 point = Vec2::Zero();    // m, half-way between the surfaces
  ShapePair parts = {};         // that touch, where one body has several
};

}  // namespace carom
