#pragma once

#include <Eigen/Core>

#include "physics/model/index.h"

namespace carom {

// Why a run can't go on.
enum class LossReason {
  kTooLarge,     // a motion grew beyond kLostBeyond, or became NaN
  kTooManySteps  // the adaptive integrator would need more steps than Trajectories::kMostFlightWork allows
};

// A motion beyond this is lost; m, m/s, rad and rad/s. Doubles there are 0.1 apart, so no digits are left.
inline constexpr double kLostBeyond = 1e15;

// Thrown within a step when a motion is lost. Simulation::step() catches it; it never leaves the library.
struct LostMotion {
  LossReason reason = LossReason::kTooLarge;
  BodyIndex body;
  double time = 0.0;  // s, absolute
};

// False for a motion whose squares could overflow, or that is NaN.
template <class Y>
[[nodiscard]] bool has_finite_squares(const Y& y) {
  constexpr double kMost = 1e100;
  return (y.template head<6>().array().abs() < kMost).all();
}

}  // namespace carom
