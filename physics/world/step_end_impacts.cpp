#include "physics/world/step_end_impacts.h"

#include "physics/world/penetrations.h"
#include "physics/world/resting_contacts.h"

namespace carom {

void StepEndImpacts::step(World& world, RestingContacts* resting, double h) {
  Trajectories& trajectories = world.trajectories;
  trajectories.begin(world.clock.time);
  for (int k = 0; k < trajectories.islands(); ++k) {
    double end = 0.0;
    do {
      trajectories.rebuild(k, h, 0.0);
      end = trajectories.end(trajectories.members(k).front());
      world.sums.ledger.lost_to_dampers += trajectories.advance_to_end(k);
    } while (end < h);
  }
  if (resting != nullptr) {
    resting->record_forces(world, h, 1.0);
    resting->rebound_at_end(world, resting->near());
    world.publish(h);
    return;
  }
  pairs_.clear();
  for (const auto& [a, b] : near_pairs_.find(world, [](int) { return 0.0; })) {
    if (world.shapes().can_collide(a, b)) pairs_.push_back({a, b, false});
  }
  world.publish(h);
  world.check_motions();
  resolve_penetrations(world, pairs_, h);
  if (!pairs_.empty()) world.publish(h);
}

}  // namespace carom
