#pragma once

#include "physics/dynamics/integrators/stages.h"

namespace carom {

// Explicit Euler, order 1: y₁ = y₀ + h f(t₀, y₀), with the old velocity in the position. Hairer, Nørsett,
// Wanner, Solving Ordinary Differential Equations I, section I.7.
template <class System, class Y>
void explicit_euler_step(const System& f, double t, const Y& y, double h, Stages<Y>& s, Y& out) {
  f(t, y, s.k[0]);
  out = y + h * s.k[0];
}

}  // namespace carom
