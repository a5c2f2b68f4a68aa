#include "physics/step/step_end_impacts.h"

#include "physics/step/resting_contacts.h"

namespace carom {

// All bodies fly for h s from this time on.
void StepEndImpacts::fly(World& world, double start, double h) {
  Trajectories& trajectories = world.trajectories;
  trajectories.begin(start);
  for (const IslandIndex k : trajectories.islands()) {
    double end = 0.0;
    do {
      trajectories.rebuild(k, h, 0.0);
      end = trajectories.end(trajectories.members(k).front());
      world.sums.ledger.lost_to_dampers += trajectories.advance_to_end(k);
    } while (end < h);
  }
}

void StepEndImpacts::step_with_contacts(World& world, RestingContacts& resting, double h) {
  int passed = 0;
  while (passed < RestingContacts::kMostParts) {
    const double start = world.clock.time + passed * (h / RestingContacts::kMostParts);
    if (passed > 0) world.trajectories.begin(start);
    const int parts = resting.support_part(world, h, RestingContacts::kMostParts - passed);
    passed += parts;
    const double flight = parts * (h / RestingContacts::kMostParts);
    fly(world, start, flight);
    resting.record_forces(world, flight, 1.0);
    world.publish(flight);
    if (passed < RestingContacts::kMostParts) world.check_motions();
  }
}

void StepEndImpacts::step(World& world, RestingContacts* resting, double h) {
  if (resting != nullptr) {
    step_with_contacts(world, *resting, h);
    return;
  }
  fly(world, world.clock.time, h);
  pairs_.clear();
  for (const auto& [a, b] : near_pairs_.find(world, [](int) { return 0.0; })) {
    if (world.can_collide(a, b)) pairs_.push_back({a, b, false});
  }
  world.publish(h);
  world.check_motions();
  static_cast<void>(resolve_penetrations(world, pairs_, penetrations_, h));
  if (!pairs_.empty()) world.publish(h);
}

}  // namespace carom
