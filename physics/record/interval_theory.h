#pragma once

#include <Eigen/Core>
#include <vector>

#include "physics/record/run_interval.h"

namespace carom {

// Why no closed law tells a quantity at the end of an interval.
enum class NoIntervalLaw {
  kNone,     // one does
  kEdits,    // the scene was changed meanwhile
  kTouches,  // the body hit or touched another one: a law holds for the sum alone
  kJoints,   // a joint acts: on the body, or from outside
  kForces,   // drag, springs, attraction or applied forces act: on the body, or from outside
  kWalls,    // a fixed or driven body was touched
  kLosses    // impacts with e < 1, friction, or surfaces that stick
};

// The bodies at the end of an interval by closed laws, from the state at its start; found without the code that
// makes the steps. With g the gravity, T the duration, M, P, L, K the sums of mass, momentum, angular momentum
// and kinetic energy of the moving bodies, and Q = Σ m x at the start:
//   a body in free flight             v' = v + g T,  ω' = ω
//   only gravity acts from outside    P' = P + M g T,  L' = L + (Q T + P T²/2) × g
//   and nothing else does work        K' = K + g · (P T + M g T²/2)
// Walls at rest do no work either: without gravity K' = K with elastic ones too.
struct IntervalTheory {
  std::vector<NoIntervalLaw> no_velocity;  // by body
  Eigen::Matrix3Xd v;                      // m/s, rad/s, by body; only if there is a law
  NoIntervalLaw no_momentum = NoIntervalLaw::kNone;
  Vec2 momentum = Vec2::Zero();  // N s
  NoIntervalLaw no_angular = NoIntervalLaw::kNone;
  double angular = 0.0;  // kg m²/s, about the origin
  NoIntervalLaw no_kinetic = NoIntervalLaw::kNone;
  double kinetic = 0.0;  // J
};
[[nodiscard]] IntervalTheory theory_of(const RunInterval& interval);

}  // namespace carom
