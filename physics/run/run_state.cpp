#include "physics/run/run_state.h"

#include <utility>

#include "physics/run/simulation.h"
#include "physics/run/simulation_parts.h"

// Keeps and restores all of a simulation between two steps.
namespace carom {

RunState Simulation::run_state() const {
  // All members by name: a new member doesn't compile here until it is either saved or known to be set before
  // it is read.
  [[maybe_unused]] const auto& [model, method, apply_impact, immovable, trajectories, state, clock, sums, log,
                                work] = parts_->world;
  RunState kept;
  kept.method = method;
  kept.clock = clock;
  kept.sums = sums;
  kept.work = work.kept();
  kept.motions = state;
  kept.edits_applied = edits_applied_;
  if (const auto* events = std::get_if<EventDrivenImpacts>(&parts_->impacts)) {
    kept.at_once = events->at_once();
    kept.waiting = events->waiting();
    if (!parts_->resting) kept.ahead = events->ahead(parts_->world);
  }
  if (parts_->resting) kept.contacts = parts_->resting->memory();
  trajectories.keep(kept.trajectories, kept.ahead ? &kept.ahead->trajectories : nullptr);
  return kept;
}

Simulation::Simulation(std::shared_ptr<const CompiledScene> compiled, const RunState& state)
    : Simulation(std::move(compiled), state.method) {
  restore(state);
}

void Simulation::restore(const RunState& state) {
  if (!(state.method == parts_->world.method)) {
    parts_->world.method = state.method;
    parts_->world.trajectories.set_method(state.method);
    choose_strategies();
  }
  parts_->world.clock = state.clock;
  parts_->world.clock.step_end = state.clock.time;
  parts_->world.sums = state.sums;
  parts_->world.work.restore(state.work);
  parts_->world.state = state.motions;
  edits_applied_ = state.edits_applied;
  parts_->world.trajectories.restore(state.trajectories, state.ahead ? &state.ahead->trajectories : nullptr);
  if (auto* events = std::get_if<EventDrivenImpacts>(&parts_->impacts))
    events->restore(parts_->world.bodies(), state.at_once, state.waiting, state.ahead);
  if (parts_->resting) parts_->resting->restore(state.contacts);
}

}  // namespace carom
