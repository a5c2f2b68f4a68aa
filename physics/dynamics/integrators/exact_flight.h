#pragma once

#include "physics/dynamics/integrators/stages.h"

namespace carom {

// Flight in closed form where the acceleration is constant: q₁ = q₀ + h v₀ + ½h² a, v₁ = v₀ + h a, at any h.
// The power of a constant force is linear in time, so the trapezoid of the quadratures is exact too; its torque
// about the origin is quadratic, so there Simpson's rule is.
template <class System, class Y>
void exact_flight_step(const System& f, double t, const Y& y, double h, Stages<Y>& s, Y& out) {
  f(t, y, s.k[0]);
  out = y + h * s.k[0];
  q_of(out) = q_of(y) + h * (v_of(y) + 0.5 * h * v_of(s.k[0]));
  if constexpr (Y::RowsAtCompileTime > kMotionRows) {
    f(t + h, out, s.k[1]);
    quadratures_of(out) = quadratures_of(y) + 0.5 * h * (quadratures_of(s.k[0]) + quadratures_of(s.k[1]));
    s.y = y + 0.5 * h * s.k[0];
    q_of(s.y) = q_of(y) + 0.5 * h * (v_of(y) + 0.25 * h * v_of(s.k[0]));
    f(t + 0.5 * h, s.y, s.k[2]);
    angular_rows_of(out) =
        angular_rows_of(y) +
        (h / 6.0) * (angular_rows_of(s.k[0]) + 4.0 * angular_rows_of(s.k[2]) + angular_rows_of(s.k[1]));
  }
}

}  // namespace carom
