#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "physics/collision/geometry.h"
#include "physics/measure/impact_tally.h"
#include "physics/motion/state.h"
#include "physics/world/lasting_contacts.h"
#include "physics/world/ledger.h"
#include "physics/world/totals.h"

namespace carom {

// What an expectation or a plot can be about: a number read off a run at one moment.
struct Reading {
  const State& state;
  const Totals& totals;
  const Ledger& ledger;
  const ImpactTally& tally;
  double time;
  std::int64_t impacts;
  const MassProperties& mass;
  const Geometry& shapes;
  std::span<const ContactForce> contacts;
};

struct Observable {
  std::string_view name;
  std::string_view unit;
  int bodies;  // how many bodies it is about
  double (*value)(const Reading& reading, std::span<const int> bodies);
};

// All observables. Of a body: x, y, angle, velocity_x, velocity_y, speed, direction (of the velocity, -π..π
// from the x axis), spin, body_kinetic_energy. Of two: angle_between their velocities, distance of their
// centres, impacts_between them so far; contact_force and friction_force: the normal and tangential force of
// their contacts that last, over all points, mean over the last step. The normal one pushes them apart; the
// tangential one acts on the body that comes later in the scene, along the normal towards it turned by +90°. Of
// the scene: kinetic_energy, rotational_energy, potential_energy, total_energy, momentum_x, momentum_y,
// momentum (its length), angular_momentum; time; impacts so far, wall_impacts and wall_impulse (with fixed and
// driven bodies; the impulse is the sum of the normal ones), mutual_impacts (of two free bodies); the ledger's
// lost_to_restitution, lost_to_friction, lost_to_rolling, lost_to_sticking, lost_to_drag, lost_to_dampers,
// lost_to_links, put_in_by_drives and numerical_drift. Over all moving bodies: rms_spin, fastest (the largest
// speed), and lowest_y, highest_y, leftmost_x, rightmost_x, the edges of the rectangle that holds them; zero if
// nothing moves.
[[nodiscard]] std::span<const Observable> observables();

// nullptr if there is none of that name.
[[nodiscard]] const Observable* find_observable(std::string_view name);

}  // namespace carom
