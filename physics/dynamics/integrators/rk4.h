#pragma once

#include "physics/dynamics/integrators/stages.h"

namespace carom {

// The classical Runge-Kutta method, order 4. Hairer, Nørsett, Wanner, Solving Ordinary Differential Equations
// I, section II.1, table 1.2.
template <class System, class Y>
void rk4_step(const System& f, double t, const Y& y, double h, Stages<Y>& s, Y& out) {
  f(t, y, s.k[0]);
  s.y = y + 0.5 * h * s.k[0];
  f(t + 0.5 * h, s.y, s.k[1]);
  s.y = y + 0.5 * h * s.k[1];
  f(t + 0.5 * h, s.y, s.k[2]);
  s.y = y + h * s.k[2];
  f(t + h, s.y, s.k[3]);
  out = y + (h / 6.0) * (s.k[0] + 2.0 * (s.k[1] + s.k[2]) + s.k[3]);
}

}  // namespace carom
