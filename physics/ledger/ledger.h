#pragma once

#include "physics/dynamics/state.h"
#include "physics/scene/scene.h"

namespace carom {

// Energy balance of a run since its start, in J (physics/ledger/ledger_entries.h describes each entry):
//   E(t) = initial - lost_to_restitution - lost_to_friction - lost_to_drag - lost_to_dampers
//          - lost_to_rolling - lost_to_sticking - lost_to_joints + penetration_correction + put_in_by_drives
//          + put_in_by_user + numerical drift,
// so the drift is what the method itself gained (+) or lost (-). The same for momentum, in N s, and for angular
// momentum about the origin, in kg m²/s:
//   P(t) = initial_momentum + momentum_from_gravity + momentum_from_forces + momentum_from_user
//          - momentum_to_walls + numerical drift.
// A push out of a penetration changes angular momentum: that is in the drift, except in islands of free bodies
// without joints under contacts that last (physics/step/island_spin.h). A point-like body doesn't turn: what
// would turn it counts as given to walls.
struct Ledger {
  double initial = 0.0;
  double lost_to_restitution = 0.0;
  double lost_to_friction = 0.0;
  double lost_to_rolling = 0.0;   // to rolling resistance
  double lost_to_sticking = 0.0;  // by impacts after which bodies stay joined
  double lost_to_drag = 0.0;
  double lost_to_dampers = 0.0;         // of springs
  double lost_to_joints = 0.0;          // by taut impulses of strings
  double penetration_correction = 0.0;  // change of potential energy by the pseudo-spring's pushes
  double put_in_by_drives = 0.0;        // by kinematic bodies and by applied forces and torques
  double put_in_by_user = 0.0;          // by the hand, and by edits of the run
  Vec2 initial_momentum = Vec2::Zero();
  Vec2 momentum_from_gravity = Vec2::Zero();
  Vec2 momentum_from_forces =
      Vec2::Zero();  // drag, springs and joints to static or kinematic bodies, applied forces, the hand
  Vec2 momentum_from_user = Vec2::Zero();
  Vec2 momentum_to_walls = Vec2::Zero();  // given by impacts to static and kinematic bodies
  double initial_angular_momentum = 0.0;
  double angular_momentum_from_gravity = 0.0;
  double angular_momentum_from_forces = 0.0;
  double angular_momentum_from_user = 0.0;
  double angular_momentum_to_walls = 0.0;

  // J: the sum of the entries' absolute values; a figure far below it may be rounding.
  [[nodiscard]] double turnover() const;
  // Adds `share` times each entry of another ledger.
  void add(double share, const Ledger& other);
  [[nodiscard]] double expected() const;
  [[nodiscard]] double numerical_drift(double total_energy) const { return total_energy - expected(); }
  [[nodiscard]] Vec2 expected_momentum() const;
  [[nodiscard]] Vec2 momentum_drift(const Vec2& momentum) const { return momentum - expected_momentum(); }
  [[nodiscard]] double expected_angular_momentum() const;
  [[nodiscard]] double angular_momentum_drift(double angular_momentum) const {
    return angular_momentum - expected_angular_momentum();
  }
};

// The entries that are quadratures of the bodies' motion.
[[nodiscard]] Ledger ledger_of_quadratures(const State& state);

}  // namespace carom
