#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <type_traits>

#include "physics/dynamics/trajectories.h"

// What trajectories, forces and joints keep from step to step. Each list below names every member of its class
// in a structured binding, so that one that is new doesn't compile until it is either kept or known to be made
// anew. Keeping and putting back take the same list: each(own, kept) copies one way or the other.
namespace carom {

namespace {

// s: no trajectory is that long.
constexpr double kFarthest = 1e7;

template <class Values>
void make_room(Values& values, std::size_t size) {
  if constexpr (!std::is_const_v<Values>) values.resize(size);
}

}  // namespace

template <class Self, class Kept, class Each>
void ForceField::each_kept(Self& field, Kept& kept, const Each& each) {
  auto& [model, terms, add_external, engaged, phase, in_contact, contact] = field;
  each(engaged, kept.engaged);
  each(phase, kept.phase);
  if constexpr (std::is_const_v<Self>) {
    if (in_contact) kept.contact = contact;
  } else if (kept.contact.size() > 0) {
    in_contact = true;
    contact = kept.contact;
  }
}

template <class Self, class Kept, class Each>
void JointConstraints::each_kept(Self& joints, Kept& kept, const Each& each) {
  // What the groups hold is made anew before it is read.
  auto& [model, joint_terms, first_row, taut, groups, restoring_work] = joints;
  each(taut, kept.taut);
}

template <class Self, class Kept, class Ahead, class Each>
void Trajectories::each_kept(Self& trajectories, Kept& kept, Ahead* ahead, const Each& each) {
  auto& [model, field, joints, islands, members, groups, island_of, at_start, at_end, constant, curvature_bound,
         turn_bound, integrator, adaptive, parabolic, general, evaluations_a_flight, tolerance, epoch,
         evaluations, flight_work, switches, margins, margins_at_first, leaving, step_start, rejected_steps,
         tolerance_missed_since, joints_missed_since, switches_missed_since, lost_to_joints, released_at] =
      trajectories;
  ForceField::each_kept(field, kept, each);
  JointConstraints::each_kept(joints, kept, each);
  each(epoch, kept.epoch);
  make_room(kept.start, islands.size());
  make_room(kept.end, islands.size());
  make_room(kept.next_step, islands.size());
  make_room(kept.switching, islands.size());
  for (std::size_t k = 0; k < islands.size(); ++k) {
    auto& [start, end, next_step, first, count, group, a_switch, kinematic] = islands[k];
    each(start, kept.start[k]);
    each(end, kept.end[k]);
    each(next_step, kept.next_step[k]);
    each(a_switch, kept.switching[k]);
  }
  each(at_start, kept.at_start);
  if (field.in_contact()) each(constant, kept.constant);
  each(released_at, kept.released_at);
  each(evaluations, kept.evaluations);
  each(rejected_steps, kept.rejected_steps);
  each(tolerance_missed_since, kept.tolerance_missed_since);
  each(joints_missed_since, kept.joints_missed_since);
  each(switches_missed_since, kept.switches_missed_since);
  each(lost_to_joints, kept.lost_to_joints);
  if (ahead == nullptr) return;
  each(at_end, ahead->at_end);
  make_room(ahead->curvature_bound, model->bodies().size());
  make_room(ahead->turn_bound, model->bodies().size());
  for (std::size_t i = 0; i < model->bodies().size(); ++i) {
    each(curvature_bound[static_cast<Eigen::Index>(i)], ahead->curvature_bound[i]);
    each(turn_bound[static_cast<Eigen::Index>(i)], ahead->turn_bound[i]);
  }
  make_room(ahead->cached, islands.size());
  for (std::size_t k = 0; k < islands.size(); ++k) {
    if (islands[k].group < 0) {
      if constexpr (std::is_const_v<Self>) ahead->cached[k] = -kForever;
      continue;
    }
    // All but the time follows from it.
    auto& [cached, from, now, change, missed, rates_known, start_rates, stages] =
        groups[static_cast<std::size_t>(islands[k].group)];
    if constexpr (std::is_const_v<Self>) {
      each(cached, ahead->cached[k]);
    } else if (ahead->cached[k] != -kForever) {
      (void)trajectories.fly_group(islands[k], ahead->cached[k]);
    }
  }
  // Which costs nothing that was not counted then.
  each(evaluations, kept.evaluations);
}

void Trajectories::keep(TrajectoryState& to, TrajectoriesAhead* ahead) const {
  each_kept(*this, to, ahead, [](const auto& own, auto& kept) { kept = own; });
}

void Trajectories::put_back(const TrajectoryState& from, const TrajectoriesAhead* ahead) {
  for (const Island& island : islands_) forget(island);
  each_kept(*this, from, ahead, [](auto& own, const auto& kept) { own = kept; });
}

std::optional<std::string> Trajectories::fault_of(const TrajectoryState& state,
                                                  const TrajectoriesAhead* ahead) const {
  for (std::size_t k = 0; k < islands_.size(); ++k) {
    const Island& island = islands_[k];
    const auto at = [k](const char* key) { return fmt::format("tracks/{}/{}", key, k); };
    if (!(state.start[k] <= state.end[k]))
      return fmt::format("{}: {} is before the start, {}", at("end"), state.end[k], state.start[k]);
    if (!(state.next_step[k] >= 0.0))
      return fmt::format("{}: {} is below 0", at("next_step"), state.next_step[k]);
    const int a_switch = state.switching[k];
    bool known = a_switch == -1;
    if (a_switch >= 0 && a_switch < field_.springs()) {
      const auto members = members_of(island);
      known = !island.kinematic && std::any_of(members.begin(), members.end(), [&](int i) {
        const std::span<const int> own = field_.switching_springs(i);
        return std::find(own.begin(), own.end(), a_switch) != own.end();
      });
    } else if (a_switch >= field_.springs() && island.group >= 0) {
      const std::vector<int>& own = joints_.strings(island.group);
      known = std::find(own.begin(), own.end(), a_switch - field_.springs()) != own.end();
    }
    if (!known) return fmt::format("{}: {} is no spring or string of these bodies", at("switching"), a_switch);
    if (ahead == nullptr || ahead->cached[k] == -kForever) continue;
    if (!(std::abs(ahead->cached[k]) <= kFarthest))
      return fmt::format("ahead/cached/{}: {} is on no track", k, ahead->cached[k]);
  }
  return std::nullopt;
}

}  // namespace carom
