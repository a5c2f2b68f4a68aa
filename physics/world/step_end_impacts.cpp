#include "physics/world/step_end_impacts.h"

#include "physics/world/penetrations.h"
#include "physics/world/resting_contacts.h"

namespace carom {

void StepEndImpacts::step(World& world, RestingContacts* resting, double h) {
  Tracks& tracks = world.tracks;
  tracks.begin(world.clock.time);
  for (int k = 0; k < tracks.islands(); ++k) {
    double end = 0.0;
    do {
      tracks.lay(k, h, 0.0);
      end = tracks.end(tracks.members(k).front());
      world.sums.ledger.lost_to_dampers += tracks.settle_at_end(k);
    } while (end < h);
  }
  if (resting != nullptr) {
    resting->book_forces(world, h, 1.0);
    resting->rebound_at_end(world, resting->near());
    world.publish(h);
    return;
  }
  pairs_.clear();
  for (const auto& [a, b] : near_pairs_.find(world, [](int) { return 0.0; })) {
    if (world.shapes().can_meet(a, b)) pairs_.push_back({a, b, false});
  }
  world.publish(h);
  world.check_motions();
  resolve_penetrations(world, pairs_, h);
  if (!pairs_.empty()) world.publish(h);
}

}  // namespace carom
