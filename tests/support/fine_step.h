#pragma once

#include <algorithm>
#include <utility>

#include "physics/run/simulation.h"

namespace carom::test {

// m, m/s, rad or rad/s: the largest difference of positions and velocities at this time from those of a step of
// 1/3840 s. setup_of(h) is the setup with a step of h s.
template <class SetupOf>
double off_from_fine_step(const SetupOf& setup_of, double time, double step) {
  const auto end = [&](double h) {
    Simulation run(setup_of(h));
    run.advance_to(time);
    return std::pair(run.state().q, run.state().v);
  };
  const auto [q, v] = end(step);
  const auto [fine_q, fine_v] = end(1.0 / 3840.0);
  return std::max((q - fine_q).cwiseAbs().maxCoeff(), (v - fine_v).cwiseAbs().maxCoeff());
}

}  // namespace carom::test
