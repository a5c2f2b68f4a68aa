#pragma once

#include "physics/motion/state.h"

namespace carom {

// Semi-implicit (symplectic) Euler, order 1: v₁ = v₀ + h a(q₀, v₀), then q₁ = q₀ + h v₁. This is what the
// founding report calls Euler (its 3.5-3.7). Hairer, Lubich, Wanner, Geometric Numerical Integration, section
// I.1.2.
template <class RateFunction>
[[nodiscard]] Motion semi_implicit_euler_step(const RateFunction& rate, const Motion& y, double h) {
  const auto k = rate(y);
  const Eigen::Vector3d v = y.v + h * k.acceleration;
  return {y.q + h * v, v, y.dissipated + h * k.dissipation};
}

}  // namespace carom
