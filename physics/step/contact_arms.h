#pragma once

#include "physics/math/vectors.h"
#include "physics/scene/method.h"
#include "physics/step/contact_turning.h"
#include "physics/step/world.h"

namespace carom {

// A step from x0 with v0 and a constant acceleration a leads to x0 + h v0 + reach h² a. It changes the angular
// momentum by the moment of the force with its arm from x0 + along h v0 + bend h² a.
struct StepArms {
  double along;
  double reach;
  double bend;
};
[[nodiscard]] StepArms arms_of(IntegratorId integrator);

// m: where the arms of contact forces on a body start in a step of h s, under all its other forces; where its
// motion does not go on, at its place at the start. Contact forces have no moment, all together, about where
// they lead to themselves.
[[nodiscard]] Vec2 arm_start(const World& world, double h, const GuessedFlight& flight, BodyIndex body);

}  // namespace carom
