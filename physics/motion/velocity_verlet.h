#pragma once

#include "physics/motion/state.h"

namespace carom {

// Velocity Verlet, order 2:
//   q₁ = q₀ + h v₀ + ½h² a(q₀, v₀),   v₁ = v₀ + ½h (a(q₀, v₀) + a(q₁, v₀ + h a(q₀, v₀))).
// The second acceleration is taken at a predicted velocity, whose error of h² keeps the order also where forces
// depend on the velocity; where they don't, it is the classical, symplectic method. Swope, Andersen, Berens,
// Wilson, Journal of Chemical Physics 76 (1982) 637, with the predictor as our addition.
template <class RateFunction>
[[nodiscard]] Motion velocity_verlet_step(const RateFunction& rate, const Motion& y, double h) {
  const auto k1 = rate(y);
  const Motion y1{y.q + h * (y.v + 0.5 * h * k1.acceleration), y.v + h * k1.acceleration, 0.0};
  const auto k2 = rate(y1);
  return {y1.q, y.v + 0.5 * h * (k1.acceleration + k2.acceleration),
          y.dissipated + 0.5 * h * (k1.dissipation + k2.dissipation)};
}

}  // namespace carom
