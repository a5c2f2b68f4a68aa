#pragma once

#include <Eigen/Core>

namespace carom {

// Why a run can't go on.
enum class LossReason {
  kTooLarge,     // a motion grew beyond kLostBeyond, or is no number any more
  kTooManySteps  // the adaptive integrator would need more steps than Trajectories::kMostFlightWork allows
};

// Beyond this a motion is lost, in m, m/s, rad and rad/s: doubles there lie 0.1 apart, so that nothing of it is
// left.
inline constexpr double kLostBeyond = 1e15;

// Thrown within a step where a motion is lost. Simulation::step() takes it: it never leaves the library.
struct LostMotion {
  LossReason reason = LossReason::kTooLarge;
  int body = 0;
  double time = 0.0;  // s, absolute
};

// False for a motion whose squares could overflow, or that is no number.
template <class Y>
[[nodiscard]] bool has_finite_squares(const Y& y) {
  constexpr double kMost = 1e100;
  return (y.template head<6>().array().abs() < kMost).all();
}

}  // namespace carom
