#include "physics/step/contact_arms.h"

namespace carom {

StepArms arms_of(IntegratorId integrator) {
  switch (integrator) {
    case IntegratorId::kExplicitEuler:
      return {1.0, 0.0, 0.0};
    case IntegratorId::kSemiImplicitEuler:
      return {0.0, 1.0, 0.0};
    default:  // the middle of the chord
      return {0.5, 0.5, 0.25};
  }
}

Vec2 arm_start(const World& world, double h, const GuessedFlight& flight, BodyIndex body) {
  Vec2 from = world.trajectories.at_start(body).head<2>();
  if (flight.goes_on[static_cast<std::size_t>(body)] == 0) return from;
  const StepArms arms = arms_of(world.method.integrator);
  const Vec2 straight = h * world.trajectories.at_start(body).segment<2>(3);
  Vec2 start = from + arms.along * straight;
  if (arms.bend > 0.0) {
    const Vec2 to = flight.position.col(body).head<2>();
    start +=
        arms.bend / arms.reach * (to - from - straight - arms.reach * h * h * flight.by.col(body).head<2>());
  }
  return start;
}

}  // namespace carom
