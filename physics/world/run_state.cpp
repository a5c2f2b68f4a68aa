#include "physics/world/run_state.h"

#include <algorithm>
#include <tuple>
#include <type_traits>
#include <unordered_map>
#include <utility>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/scene/fingerprint.h"
#include "physics/scene/validate.h"
#include "physics/world/simulation.h"

// What a simulation keeps from step to step. The lists name every member of their class in a structured
// binding: one that is new doesn't compile until it is either kept or known to be made anew before it is read.
namespace carom {
namespace {

template <class Contacts, class Kept, class Each>
void each_kept_of_contacts(Contacts& lasting, Kept& kept, const Each& each) {
  auto& [contacts, id, point, forces, hold, guess, sticks, near, landings, holds, held, pushed, acceleration,
         before, after, free, mean, moved, poses, reach, workspace] = lasting;
  each(forces, kept.forces);
  each(hold, kept.hold);
  each(held, kept.held);
  each(pushed, kept.pushed);
}

}  // namespace

template <class Self, class Kept, class Each>
void Simulation::each_kept(Self& simulation, Kept& kept, const Each& each) {
  auto& [model, method, tracks, state, time, step_end, origin, origin_step, steps_since_origin, steps,
         impact_count, impact_counts, impacts_before_step, ledger, gravity_since, peak_kinetic, energy_doubts,
         notices, lost, last_good, work, impacts, jumps,
         watch_impacts,  // the run
         running, reach, epoch_length, last_impact, at_once, grid, queue, stamp, deferred, due, due_islands,
         is_due, near_pairs, track_ends, stretch, touches, cluster,
         cluster_scratch,                                        // impacts at their own time
         lasts, step_length, may_divide, touched_down, lasting,  // contacts that last
         broad_phase, bounds] = simulation;                      // impacts at the step's end
  each(method, kept.method);
  each(time, kept.time);
  each(origin, kept.origin);
  each(origin_step, kept.origin_step);
  each(steps_since_origin, kept.steps_since_origin);
  each(steps, kept.steps);
  each(impact_count, kept.impact_count);
  each(impact_counts, kept.impact_counts);
  each(at_once, kept.at_once);
  each(state, kept.motions);
  each(ledger, kept.ledger);
  each(gravity_since, kept.gravity_since);
  each(peak_kinetic, kept.peak_kinetic);
  each(energy_doubts, kept.energy_doubts);
  each(notices, kept.notices);
  each_kept_of_contacts(lasting, kept.contacts, each);
  if (!kept.ahead) return;
  each(reach, kept.ahead->reach);
  each(stretch, kept.ahead->stretch);
  each(epoch_length, kept.ahead->epoch_length);
  each(last_impact, kept.ahead->last_impact);
}

bool Simulation::runs_on() const {
  const IntegratorChoice& choice = choice_of(kIntegrators, method_.integrator);
  return running_ && method_.impacts == ImpactsId::kLocated && !contacts_last(method_, needs()) &&
         (choice.order == 0 || choice.adaptive);
}

RunState Simulation::run_state() const {
  RunState kept;
  if (runs_on()) {
    RunAhead& ahead = kept.ahead.emplace();
    ahead.grid = grid_.order();
    for (const Event& event : queue_.all()) {
      if (!is_stale(event)) ahead.events.push_back({event.time, event.a, event.b});
    }
    std::sort(ahead.events.begin(), ahead.events.end(), [](const auto& x, const auto& y) {
      return std::tie(x.time, x.a, x.b) < std::tie(y.time, y.a, y.b);
    });
    for (const auto& [a, b, resting] : deferred_.all()) ahead.waiting.push_back({a, b, resting});
  }
  each_kept(*this, kept, [](const auto& own, auto& to) { to = own; });
  kept.work = work_.kept();
  tracks_.keep(kept.tracks, kept.ahead ? &kept.ahead->tracks : nullptr);
  return kept;
}

Simulation::Simulation(std::shared_ptr<const Model> model, const RunState& state)
    : Simulation(std::move(model), state.method) {
  put_back(state);
}

void Simulation::put_back(const RunState& state) {
  if (!(state.method == method_)) tracks_.set_method(state.method);
  each_kept(*this, state, [](auto& own, const auto& from) { own = from; });
  work_.put_back(state.work);
  tracks_.put_back(state.tracks, state.ahead ? &state.ahead->tracks : nullptr);
  step_end_ = time_;
  if (!state.ahead) return;
  (void)grid_.put_back(static_cast<int>(bodies().size()), state.ahead->grid);
  // The stamps of all islands are 0 yet.
  for (const auto& [time, a, b] : state.ahead->events) queue_.push({time, a, b, 0, 0});
  for (const auto& [a, b, resting] : state.ahead->waiting) deferred_.add(a, b, resting);
  running_ = true;
}

void Simulation::go_on_from(const SavedRun& saved) {
  if (saved.fingerprint == 0) return;
  if (saved.state == nullptr || needs().untrimmed ||
      saved.fingerprint != fingerprint(model_->scene, saved.time)) {
    notices_.state_left_since = saved.time;
    return;
  }
  const Method method = method_;
  put_back(*saved.state);
  if (!(method_ == method)) set_method(method);
}

bool state_belongs(const Scene& scene, const std::optional<SavedRun>& saved) {
  return saved && saved->fingerprint != 0 && saved->fingerprint == fingerprint(scene, saved->time);
}

}  // namespace carom
