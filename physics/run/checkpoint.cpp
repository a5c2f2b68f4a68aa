#include "physics/run/checkpoint.h"

#include <fmt/format.h>
#include <utility>

#include "physics/collision/pair_contact.h"
#include "physics/dynamics/integrators/method_fields.h"
#include "physics/run/run_state.h"
#include "physics/run/simulation.h"
#include "physics/run/simulation_parts.h"
#include "physics/scene/facts.h"
#include "physics/scene/range_check.h"
#include "physics/scene/value_checks.h"

// Keeps a run for a file, continues one from there, and checks what a file holds.
namespace carom {
namespace {

[[noreturn]] void refuse(const std::string& place, const std::string& why) {
  throw SceneError(fmt::format("/state/{}: {}; allowed: what a run of this scene leaves there", place, why));
}

void check_least(const std::string& place, double value, double least) {
  if (!(value >= least)) refuse(place, fmt::format("{} is below {}", value, least));
}

void check_size(const std::string& place, std::size_t size, std::size_t expected) {
  if (size != expected) refuse(place, fmt::format("{} values instead of {}", size, expected));
}

void check_pair(const std::string& place, const std::vector<Body>& bodies, BodyIndex a, BodyIndex b) {
  for (const BodyIndex body : {a, b}) {
    if (body < 0 || body >= static_cast<int>(bodies.size()))
      refuse(place, fmt::format("there is no body {}", body));
  }
  if (a >= b) refuse(place, fmt::format("body {} is not before body {}", a, b));
}

void check_moving_pair(const std::string& place, const std::vector<Body>& bodies, BodyIndex a, BodyIndex b) {
  check_pair(place, bodies, a, b);
  if (has_infinite_mass(bodies[static_cast<std::size_t>(a)]) &&
      has_infinite_mass(bodies[static_cast<std::size_t>(b)]))
    refuse(place, fmt::format("nothing moves bodies {} and {}", a, b));
}

void check_counts(const std::vector<Body>& bodies, std::int64_t impacts, const ImpactCounts& s) {
  check_least("impacts", static_cast<double>(impacts), 0.0);
  check_least("impact_counts/walls", static_cast<double>(s.walls), 0.0);
  check_least("impact_counts/mutual", static_cast<double>(s.mutual), 0.0);
  if (s.counted > impacts || s.counted != s.walls + s.mutual)
    refuse("impact_counts/counted", fmt::format("{} of {} impacts", s.counted, impacts));
  if (s.pairs.size() > ImpactCounts::kMostPairs)
    refuse("impact_counts/pairs", fmt::format("{} are more than {}", s.pairs.size(), ImpactCounts::kMostPairs));
  for (std::size_t i = 0; i < s.pairs.size(); ++i) {
    const std::string at = fmt::format("impact_counts/pairs/{}", i);
    check_pair(at, bodies, s.pairs[i].a, s.pairs[i].b);
    if (s.find(s.pairs[i].a, s.pairs[i].b) != &s.pairs[i]) refuse(at, "a pair for the second time");
  }
}

void check_notices(const std::vector<Body>& bodies, const Notices& s) {
  for (std::size_t i = 0; i < Notices::kKinds; ++i) {
    const NoticeBodies& of = s.bodies[i];
    if (of.a != kNoBody || of.b != kNoBody)
      check_pair(fmt::format("notices/of/{}", notice_entries()[i].key), bodies, of.a, of.b);
  }
}

void check_switches(const Scene& scene, const Checkpoint& s) {
  check_size("engaged", s.engaged.size(), scene.forces.springs.size());
  for (std::size_t i = 0; i < s.engaged.size(); ++i) {
    if (s.engaged[i] > 1 || (s.engaged[i] == 0 && scene.forces.springs[i].acts == SpringActs::kBoth))
      refuse(fmt::format("engaged/{}", i), fmt::format("{} of this spring", s.engaged[i]));
  }
  check_size("taut", s.taut.size(), scene.joints.size());
  check_size("let_go_at", s.released_at.size(), scene.joints.size());
  for (std::size_t i = 0; i < s.taut.size(); ++i) {
    if (s.taut[i] > 1 || (s.taut[i] == 0 && scene.joints[i].kind != JointKind::kString))
      refuse(fmt::format("taut/{}", i), fmt::format("{} of this link", s.taut[i]));
  }
}

void check_contacts(const std::vector<Body>& bodies, const Checkpoint& s) {
  for (std::size_t i = 0; i < s.waiting.size(); ++i)
    check_moving_pair(fmt::format("waiting/{}", i), bodies, s.waiting[i].a, s.waiting[i].b);
  std::vector<std::size_t> parts;
  if (!s.contacts.empty()) {
    for (const Body& body : bodies) parts.push_back(convex_parts(body.shape).size());
  }
  for (std::size_t i = 0; i < s.contacts.size(); ++i) {
    const std::string at = fmt::format("contacts/forces/{}", i);
    const ContactForce& f = s.contacts[i];
    check_moving_pair(at, bodies, f.a, f.b);
    const auto [of_a, of_b] = part_numbers(f.id);
    if (of_a >= parts[static_cast<std::size_t>(f.a)] || of_b >= parts[static_cast<std::size_t>(f.b)])
      refuse(at, "its bodies have no such shapes");
    if (i > 0 && std::pair(f.a, f.b) < std::pair(s.contacts[i - 1].a, s.contacts[i - 1].b))
      refuse(at, "the pairs are not in rising order");
  }
  check_size("contacts/hold", s.support.size(), s.contacts.size());
}

}  // namespace

Checkpoint Simulation::checkpoint() const {
  TrajectoryState trajectories;
  parts_->world.trajectories.keep(trajectories, nullptr);
  Checkpoint kept;
  kept.method = method();
  kept.steps = steps();
  kept.sums = parts_->world.sums;
  kept.sums.ledger = ledger();
  kept.sums.gravity_since = time();
  kept.sums.notices = notices();
  kept.evaluations = evaluations();
  kept.rejected_steps = rejected_steps();
  kept.engaged = std::move(trajectories.engaged);
  kept.taut = std::move(trajectories.taut);
  kept.released_at = std::move(trajectories.released_at);
  for (BodyIndex i{0}; i < parts_->world.bodies(); ++i) {
    const IslandIndex island = parts_->world.trajectories.island_of(i);
    kept.next_step.push_back(island == kNoIsland ? 0.0 : trajectories.next_step[island]);
  }
  if (const auto* events = std::get_if<EventDrivenImpacts>(&parts_->impacts)) kept.waiting = events->waiting();
  if (parts_->resting) {
    kept.contacts = parts_->resting->memory().forces;
    kept.support = parts_->resting->memory().support;
  }
  return kept;
}

void Simulation::go_on_from(const SavedRun& saved) {
  if (saved.fingerprint == 0) return;
  if (saved.checkpoint == nullptr || !state_belongs(compiled_->scene, saved)) {
    parts_->world.note(&Notices::state_left_since, saved.time);
    return;
  }
  go_on_from(*saved.checkpoint);
}

void Simulation::go_on_from(const Checkpoint& from) {
  RunState state = run_state();
  state.clock.steps = from.steps;
  state.sums = from.sums;
  state.work.scarce = from.sums.notices.work_spent_since >= 0.0;
  state.work.impacts_capped = from.sums.notices.impacts_capped_since >= 0.0;
  TrajectoryState& trajectories = state.trajectories;
  trajectories.engaged = from.engaged;
  trajectories.taut = from.taut;
  trajectories.released_at = from.released_at;
  trajectories.evaluations = from.evaluations;
  trajectories.rejected_steps = from.rejected_steps;
  trajectories.tolerance_missed_since = from.sums.notices.tolerance_missed_since;
  trajectories.joints_missed_since = from.sums.notices.joints_missed_since;
  trajectories.switches_missed_since = from.sums.notices.switches_missed_since;
  trajectories.lost_to_joints = from.sums.ledger.lost_to_joints;
  if (from.method == method()) {
    for (const IslandIndex k : parts_->world.trajectories.islands()) {
      const auto first = static_cast<std::size_t>(parts_->world.trajectories.members(k).front());
      trajectories.next_step[k] = from.next_step[first];
    }
    state.waiting = from.waiting;
    state.contacts = {from.contacts, from.support, {}};
  }
  restore(state);
}

void check_checkpoint(const Scene& scene, const Checkpoint& checkpoint) {
  const std::vector<Body> bodies = all_bodies(scene);
  check_fields("/state/method", checkpoint.method);
  check_least("steps", static_cast<double>(checkpoint.steps), 0.0);
  check_least("evaluations", static_cast<double>(checkpoint.evaluations), 0.0);
  check_least("rejected_steps", static_cast<double>(checkpoint.rejected_steps), 0.0);
  check_counts(bodies, checkpoint.sums.impact_count, checkpoint.sums.impact_counts);
  check_notices(bodies, checkpoint.sums.notices);
  check_switches(scene, checkpoint);
  check_size("next_step", checkpoint.next_step.size(), bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i)
    check_least(fmt::format("next_step/{}", i), checkpoint.next_step[i], 0.0);
  check_contacts(bodies, checkpoint);
}

}  // namespace carom
