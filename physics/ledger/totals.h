#pragma once

#include "physics/dynamics/force_field.h"
#include "physics/dynamics/state.h"
#include "physics/model/mass.h"

namespace carom {

// Sums over the moving bodies. Energies in J, momentum in N s, angular momentum about the origin in kg m²/s.
struct Totals {
  double translational = 0.0;  // Σ ½ m v²
  double rotational = 0.0;     // Σ ½ I ω²
  double potential = 0.0;      // gravity (zero at the origin), springs, attraction
  Vec2 momentum = Vec2::Zero();
  double angular_momentum = 0.0;

  [[nodiscard]] double kinetic() const { return translational + rotational; }
  [[nodiscard]] double energy() const { return kinetic() + potential; }
};

[[nodiscard]] Totals totals(const State& state, const MassProperties& mass, const ForceField& field);
[[nodiscard]] double kinetic_energy(const State& state, const MassProperties& mass);

}  // namespace carom
