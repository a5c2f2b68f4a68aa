#pragma once

#include "physics/dynamics/integrators/stages.h"

namespace carom {

// Velocity Verlet, order 2:
//   q₁ = q₀ + h v₀ + ½h² a(q₀, v₀),   v₁ = v₀ + ½h (a(q₀, v₀) + a(q₁, v₀ + h a(q₀, v₀))).
// The second acceleration is taken at a predicted velocity, whose error of h² preserves the order also if
// forces depend on the velocity. If they do not, it is the classical, symplectic method. Swope, Andersen,
// Berens, Wilson, Journal of Chemical Physics 76 (1982) 637; the predictor is our addition.
template <class System, class Y>
void velocity_verlet_step(const System& f, double t, const Y& y, double h, Stages<Y>& s, Y& out) {
  f(t, y, s.k[0]);
  s.y = y + h * s.k[0];
  q_of(s.y) = q_of(y) + h * (v_of(y) + 0.5 * h * v_of(s.k[0]));
  f(t + h, s.y, s.k[1]);
  out = y + 0.5 * h * (s.k[0] + s.k[1]);
  q_of(out) = q_of(s.y);
}

}  // namespace carom
