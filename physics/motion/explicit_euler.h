#pragma once

#include "physics/motion/state.h"

namespace carom {

// Explicit Euler, order 1: q₁ = q₀ + h v₀, v₁ = v₀ + h a(q₀, v₀).
// `rate` maps a Motion to a Rate. Hairer, Nørsett, Wanner, Solving Ordinary Differential Equations I, section
// I.7.
template <class RateFunction>
[[nodiscard]] Motion explicit_euler_step(const RateFunction& rate, const Motion& y, double h) {
  const auto k = rate(y);
  return {y.q + h * y.v, y.v + h * k.acceleration, y.dissipated + h * k.dissipation};
}

}  // namespace carom
