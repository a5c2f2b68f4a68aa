#pragma once

#include "physics/scene/scene.h"

namespace carom {

// Where the energy of a run went since it began, in J; and the momentum that fixed bodies took up, in N s.
//   E(t) = initial - lost_to_restitution - lost_to_friction - lost_to_drag + overlap_correction +
//   put_in_by_user
//          + numerical drift,
// so the drift is what the method itself gained (+) or lost (-).
struct Ledger {
  double initial = 0.0;
  double lost_to_restitution = 0.0;
  double lost_to_friction = 0.0;
  double lost_to_drag = 0.0;
  double overlap_correction = 0.0;
  double put_in_by_user = 0.0;
  Vec2 momentum_to_walls = Vec2::Zero();

  [[nodiscard]] double expected() const {
    return initial - lost_to_restitution - lost_to_friction - lost_to_drag + overlap_correction +
           put_in_by_user;
  }
  [[nodiscard]] double numerical_drift(double total_energy) const { return total_energy - expected(); }
};

}  // namespace carom
