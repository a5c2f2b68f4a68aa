#pragma once

#include <array>

#include "physics/dynamics/state.h"

namespace carom {

// Storage for the intermediate values of a step, so that a step allocates nothing. Y is a Motion or Motions.
template <class Y>
struct Stages {
  Y y;                 // where a stage is evaluated
  std::array<Y, 7> k;  // rates at the stages

  void resize(int bodies) {
    y.resize(Eigen::NoChange, bodies);
    for (Y& rate : k) rate.resize(Eigen::NoChange, bodies);
  }
};

// The integrators beside this file share one form: step(f, t, y, h, s, out) advances y by h >= 0 from time t
// into `out` (not y itself). f(t, y, k) writes the rate y' = (v, acceleration, quadratures') into k.

}  // namespace carom
