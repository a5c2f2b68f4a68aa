#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/support/scenes.h"

namespace carom::test {

// Four discs of different velocities fall in a room of 2 m.
inline Preset gas_in_a_room(double restitution, double friction) {
  std::vector<Body> bodies = room(1.0, 0.5);
  for (int i = 0; i < 4; ++i) {
    bodies.push_back(disc("disc " + std::to_string(i), {-0.6 + 0.4 * i, 0.1 * i}, {1.0 - 0.7 * i, 0.3 * i}));
  }
  Preset s = preset_with(std::move(bodies), restitution, friction);
  s.scene.forces.gravity = {0.0, -9.81};
  return s;
}

}  // namespace carom::test
