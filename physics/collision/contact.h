#pragma once

#include "physics/scene/scene.h"

namespace carom {

// Where two bodies touch or come nearest.
struct Contact {
  double gap = 0.0;             // m; if negative, minus the penetration depth
  Vec2 normal = Vec2::UnitX();  // from A to B
  Vec2 point = Vec2::Zero();    // m, half-way between the surfaces
  // The parts that touch, of bodies of several; -1: the only one.
  int part_a = -1;
  int part_b = -1;
};

}  // namespace carom
