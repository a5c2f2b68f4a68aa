#pragma once

#include "physics/dynamics/integrators/stages.h"

namespace carom {

// Semi-implicit (symplectic) Euler, order 1: v₁ = v₀ + h a(q₀, v₀), then q₁ = q₀ + h v₁. This is what the
// founding report calls Euler (its 3.5-3.7). Hairer, Lubich, Wanner, Geometric Numerical Integration, section
// I.1.2.
template <class System, class Y>
void semi_implicit_euler_step(const System& f, double t, const Y& y, double h, Stages<Y>& s, Y& out) {
  f(t, y, s.k[0]);
  out = y + h * s.k[0];
  q_of(out) = q_of(y) + h * v_of(out);
}

}  // namespace carom
