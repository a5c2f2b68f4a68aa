#pragma once

#include "physics/motion/state.h"

namespace carom {

// The classical Runge-Kutta method, order 4, applied to the first-order system (q, v, dissipated).
// Hairer, Nørsett, Wanner, Solving Ordinary Differential Equations I, section II.1, table 1.2.
template <class RateFunction>
[[nodiscard]] Motion rk4_step(const RateFunction& rate, const Motion& y, double h) {
  const auto k1 = rate(y);
  const Motion y2{y.q + 0.5 * h * y.v, y.v + 0.5 * h * k1.acceleration, 0.0};
  const auto k2 = rate(y2);
  const Motion y3{y.q + 0.5 * h * y2.v, y.v + 0.5 * h * k2.acceleration, 0.0};
  const auto k3 = rate(y3);
  const Motion y4{y.q + h * y3.v, y.v + h * k3.acceleration, 0.0};
  const auto k4 = rate(y4);
  return {
      y.q + (h / 6.0) * (y.v + 2.0 * (y2.v + y3.v) + y4.v),
      y.v + (h / 6.0) * (k1.acceleration + 2.0 * (k2.acceleration + k3.acceleration) + k4.acceleration),
      y.dissipated + (h / 6.0) * (k1.dissipation + 2.0 * (k2.dissipation + k3.dissipation) + k4.dissipation)};
}

}  // namespace carom
