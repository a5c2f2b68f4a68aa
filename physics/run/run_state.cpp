#include "physics/run/run_state.h"

#include <utility>

#include "physics/run/simulation.h"

// Keeps and restores all of a simulation between two steps.
namespace carom {

RunState Simulation::run_state() const {
  // All members by name: a new member doesn't compile here until it is either saved or known to be set before
  // it is read.
  [[maybe_unused]] const auto& [model, method, apply_impact, trajectories, state, clock, sums, log, work] =
      world_;
  RunState kept;
  kept.method = method;
  kept.clock = clock;
  kept.sums = sums;
  kept.work = work.kept();
  kept.motions = state;
  kept.edits_applied = edits_applied_;
  if (const auto* events = std::get_if<EventDrivenImpacts>(&impacts_)) {
    kept.at_once = events->at_once();
    kept.waiting = events->waiting();
    if (!resting_) kept.ahead = events->ahead(world_);
  }
  if (resting_) kept.contacts = resting_->memory();
  trajectories.keep(kept.trajectories, kept.ahead ? &kept.ahead->trajectories : nullptr);
  return kept;
}

Simulation::Simulation(std::shared_ptr<const CompiledScene> compiled, const RunState& state)
    : Simulation(std::move(compiled), state.method) {
  restore(state);
}

void Simulation::restore(const RunState& state) {
  if (!(state.method == world_.method)) {
    world_.method = state.method;
    world_.trajectories.set_method(state.method);
    choose_strategies();
  }
  world_.clock = state.clock;
  world_.clock.step_end = state.clock.time;
  world_.sums = state.sums;
  world_.work.restore(state.work);
  world_.state = state.motions;
  edits_applied_ = state.edits_applied;
  world_.trajectories.restore(state.trajectories, state.ahead ? &state.ahead->trajectories : nullptr);
  if (auto* events = std::get_if<EventDrivenImpacts>(&impacts_))
    events->restore(world_.bodies(), state.at_once, state.waiting, state.ahead);
  if (resting_) resting_->restore(state.contacts);
}

}  // namespace carom
