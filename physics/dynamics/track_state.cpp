#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <type_traits>

#include "physics/dynamics/tracks.h"

// What tracks, forces and links keep from step to step. Each list below names every member of its class in a
// structured binding, so that one that is new doesn't compile until it is either kept or known to be made anew.
// Keeping and putting back take the same list: each(own, kept) copies one way or the other.
namespace carom {

namespace {

// s: no track is that long.
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
void Links::each_kept(Self& links, Kept& kept, const Each& each) {
  // What the groups hold is made anew before it is read.
  auto& [model, joints, first_row, taut, groups, restoring_work] = links;
  each(taut, kept.taut);
}

template <class Self, class Kept, class Ahead, class Each>
void Tracks::each_kept(Self& tracks, Kept& kept, Ahead* ahead, const Each& each) {
  auto& [model, field, links, islands, members, groups, island_of, settled, at_end, constant, bend, turn,
         integrator, adaptive, parabolic, general, evaluations_a_flight, tolerance, epoch, evaluations,
         flight_work, switches, margins, margins_at_first, leaving, step_start, rejected_steps,
         tolerance_missed_since, links_missed_since, switches_missed_since, lost_to_links, let_go_at] = tracks;
  ForceField::each_kept(field, kept, each);
  Links::each_kept(links, kept, each);
  each(epoch, kept.epoch);
  make_room(kept.start, islands.size());
  make_room(kept.end, islands.size());
  make_room(kept.next_step, islands.size());
  make_room(kept.switching, islands.size());
  for (std::size_t k = 0; k < islands.size(); ++k) {
    auto& [start, end, next_step, first, count, group, a_switch, driven] = islands[k];
    each(start, kept.start[k]);
    each(end, kept.end[k]);
    each(next_step, kept.next_step[k]);
    each(a_switch, kept.switching[k]);
  }
  each(settled, kept.settled);
  if (field.in_contact()) each(constant, kept.constant);
  each(let_go_at, kept.let_go_at);
  each(evaluations, kept.evaluations);
  each(rejected_steps, kept.rejected_steps);
  each(tolerance_missed_since, kept.tolerance_missed_since);
  each(links_missed_since, kept.links_missed_since);
  each(switches_missed_since, kept.switches_missed_since);
  each(lost_to_links, kept.lost_to_links);
  if (ahead == nullptr) return;
  each(at_end, ahead->at_end);
  make_room(ahead->bend, model->bodies().size());
  make_room(ahead->turn, model->bodies().size());
  for (std::size_t i = 0; i < model->bodies().size(); ++i) {
    each(bend[static_cast<Eigen::Index>(i)], ahead->bend[i]);
    each(turn[static_cast<Eigen::Index>(i)], ahead->turn[i]);
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
      (void)tracks.fly_group(islands[k], ahead->cached[k]);
    }
  }
  // Which costs nothing that was not counted then.
  each(evaluations, kept.evaluations);
}

void Tracks::keep(TrackState& to, TracksAhead* ahead) const {
  each_kept(*this, to, ahead, [](const auto& own, auto& kept) { kept = own; });
}

void Tracks::put_back(const TrackState& from, const TracksAhead* ahead) {
  for (const Island& island : islands_) forget(island);
  each_kept(*this, from, ahead, [](auto& own, const auto& kept) { own = kept; });
}

std::optional<std::string> Tracks::fault_of(const TrackState& state, const TracksAhead* ahead) const {
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
      known = !island.driven && std::any_of(members.begin(), members.end(), [&](int i) {
        const std::span<const int> own = field_.switching_springs(i);
        return std::find(own.begin(), own.end(), a_switch) != own.end();
      });
    } else if (a_switch >= field_.springs() && island.group >= 0) {
      const std::vector<int>& own = links_.strings(island.group);
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
