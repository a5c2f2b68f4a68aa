#pragma once

#include <span>
#include <string_view>

#include "physics/collision/geometry.h"
#include "physics/motion/state.h"
#include "physics/world/totals.h"

namespace carom {

// What an expectation or a plot can be about: a number read off a run at one moment.
struct Reading {
  const State& state;
  const Totals& totals;
  double time;
  int impacts;
  const MassProperties& mass;
  const Geometry& shapes;
};

struct Observable {
  std::string_view name;
  std::string_view unit;
  int bodies;  // how many bodies it is about
  double (*value)(const Reading& reading, std::span<const int> bodies);
};

// All observables: x, y, angle, velocity_x, velocity_y, speed, spin of a body; angle_between the velocities of
// two; kinetic_energy, rotational_energy, potential_energy, total_energy, momentum_x, momentum_y,
// angular_momentum; time and impacts (their number so far). Over all moving bodies: rms_spin, fastest (the
// largest speed), and lowest_y, highest_y, leftmost_x, rightmost_x, the edges of the rectangle that holds them;
// zero if nothing moves.
[[nodiscard]] std::span<const Observable> observables();

// nullptr if there is none of that name.
[[nodiscard]] const Observable* find_observable(std::string_view name);

}  // namespace carom
