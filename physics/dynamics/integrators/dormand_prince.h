#pragma once

#include <algorithm>
#include <cmath>

#include "physics/dynamics/integrators/stages.h"

namespace carom {

// Dormand and Prince's 5(4) pair, order 5. J. R. Dormand, P. J. Prince, Journal of Computational and Applied
// Mathematics 6 (1980) 19; the coefficients also in Hairer, Nørsett, Wanner, Solving Ordinary Differential
// Equations I, table II.5.2. The seventh stage is used only for the error estimate; it is not kept for the
// next step, because an impact may come between.
template <class System, class Y>
void dormand_prince_step(const System& f, double t, const Y& y, double h, Stages<Y>& s, Y& out) {
  auto& k = s.k;
  f(t, y, k[0]);
  s.y = y + h * (1.0 / 5.0) * k[0];
  f(t + h / 5.0, s.y, k[1]);
  s.y = y + h * (3.0 / 40.0 * k[0] + 9.0 / 40.0 * k[1]);
  f(t + 0.3 * h, s.y, k[2]);
  s.y = y + h * (44.0 / 45.0 * k[0] - 56.0 / 15.0 * k[1] + 32.0 / 9.0 * k[2]);
  f(t + 0.8 * h, s.y, k[3]);
  s.y = y + h * (19372.0 / 6561.0 * k[0] - 25360.0 / 2187.0 * k[1] + 64448.0 / 6561.0 * k[2] -
                 212.0 / 729.0 * k[3]);
  f(t + 8.0 / 9.0 * h, s.y, k[4]);
  s.y = y + h * (9017.0 / 3168.0 * k[0] - 355.0 / 33.0 * k[1] + 46732.0 / 5247.0 * k[2] + 49.0 / 176.0 * k[3] -
                 5103.0 / 18656.0 * k[4]);
  f(t + h, s.y, k[5]);
  out = y + h * (35.0 / 384.0 * k[0] + 500.0 / 1113.0 * k[2] + 125.0 / 192.0 * k[3] - 2187.0 / 6784.0 * k[4] +
                 11.0 / 84.0 * k[5]);
}

// The largest difference of the fifth- and the fourth-order result over positions and angles (m, rad) and
// velocities and spins (m/s, rad/s), of the step that ended in `out`. Quadratures are ignored.
template <class System, class Y>
[[nodiscard]] double dormand_prince_error(const System& f, double t, double h, Stages<Y>& s, const Y& out) {
  auto& k = s.k;
  f(t + h, out, k[6]);
  s.y = h * (71.0 / 57600.0 * k[0] - 71.0 / 16695.0 * k[2] + 71.0 / 1920.0 * k[3] - 17253.0 / 339200.0 * k[4] +
             22.0 / 525.0 * k[5] - 1.0 / 40.0 * k[6]);
  return s.y.template topRows<6>().cwiseAbs().maxCoeff();
}

// The step to try after one of length h with this error, at most five times longer or shorter. Hairer,
// Nørsett, Wanner, section II.4, (4.13), with the exponent for the fifth order of the estimate's local error.
[[nodiscard]] inline double next_adaptive_step(double h, double error, double tolerance) {
  constexpr double kSafety = 0.9;
  constexpr double kMost = 5.0;
  const double factor = error > 0.0 ? kSafety * std::pow(tolerance / error, 0.2) : kMost;
  return h * std::clamp(factor, 1.0 / kMost, kMost);
}

}  // namespace carom
