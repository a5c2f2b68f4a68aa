#pragma once

#include "physics/dynamics/state.h"
#include "physics/math/vectors.h"
#include "physics/world/ledger.h"

namespace carom {

// One impact of a run, as the log keeps it. Bodies are indices into Simulation::bodies(), a < b; the normal
// points from a to b and the impulse acts on b. Times in s, points in m, impulses in N s, energies in J.
struct ImpactRecord {
  double time = 0.0;
  int a = 0;
  int b = 0;
  Vec2 point = Vec2::Zero();
  Vec2 normal = Vec2::UnitX();
  double normal_impulse = 0.0;
  double tangential_impulse = 0.0;
  double closing_speed = 0.0;  // m/s, > 0; of impacts at once also below, where the others drive it together
  double lost_to_restitution = 0.0;
  double lost_to_friction = 0.0;
  double lost_to_sticking = 0.0;
};

// State before and after one recorded impact, so that plots jump where the motion does, and its ledger entry.
struct Jump {
  double time = 0.0;
  State before;
  State after;
  Ledger change;
};

}  // namespace carom
