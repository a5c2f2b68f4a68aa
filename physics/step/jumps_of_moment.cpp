#include "physics/step/jumps_of_moment.h"

#include <algorithm>

namespace carom {

JumpsOfMoment::JumpsOfMoment(World& world, double within) : within_(within) {
  if (!world.log.wants_jump(world.model->bodies())) return;
  next_.emplace();
  next_->before = world.state_at(within);
  next_->change.add(-1.0, world.sums.ledger);
}

void JumpsOfMoment::add(World& world) {
  if (!next_ || !world.log.wants_jump(world.model->bodies())) return;
  const Ledger& ledger = world.sums.ledger;
  next_->time = std::min(world.trajectories.epoch() + within_, world.clock.step_end);
  next_->after = world.state_at(within_);
  next_->change.add(1.0, ledger);
  world.log.jumps.push_back(*next_);
  next_->before = next_->after;
  next_->change = {};
  next_->change.add(-1.0, ledger);
}

}  // namespace carom
