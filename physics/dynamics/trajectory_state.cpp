#include <type_traits>

#include "physics/dynamics/trajectories.h"

// Members of trajectories, forces and joints that are saved with a run. Each list below names every member of
// its class in a structured binding, so that a new member doesn't compile until the list either copies it or
// leaves it out. Saving and restoring use the same list: each(own, kept) copies in one direction or the other.
namespace carom {

namespace {

template <class Values>
void make_room(Values& values, std::size_t size) {
  if constexpr (!std::is_const_v<Values>) values.resize(size);
}

}  // namespace

struct KeptMembers {
  template <class Self, class Kept, class Each>
  static void of_field(Self& field, Kept& kept, const Each& each) {
    // Contact forces change during a step only: those of the next are found anew.
    auto& [model, terms, add_external, has_quadratures, constant, engaged, phase, hand_place, in_contact,
           contact_changes, contact_from, contact, contact_rate] = field;
    each(engaged, kept.engaged);
    each(phase, kept.phase);
    each(hand_place, kept.hand_place);
    if constexpr (std::is_const_v<Self>) {
      if (in_contact) kept.contact = contact;
    } else if (kept.contact.size() > 0) {
      in_contact = true;
      contact = kept.contact;
      contact_rate.setZero(3, contact.cols());
    }
  }

  template <class Self, class Kept, class Each>
  static void of_joints(Self& joints, Kept& kept, const Each& each) {
    // The groups' arrays are computed before they are read. The welds have been added.
    auto& [model, joint_terms, welds, welded, first_row, taut, groups, restoring_work] = joints;
    each(taut, kept.taut);
  }

  template <class Self, class Kept, class Each>
  static void of_switches(Self& switches, Kept& kept, const Each& each) {
    auto& [listed, margins, margins_at_first, leaving, missed_since, lost_to_joints, reaches, released_at] =
        switches;
    each(missed_since, kept.switches_missed_since);
    each(lost_to_joints, kept.lost_to_joints);
    each(released_at, kept.released_at);
  }

  template <class Self, class Kept, class Each>
  static void of_flights(Self& flights, Kept& kept, const Each& each) {
    auto& [model, field, joints, islands, members, groups, island_of, at_start, at_end, constant, bent_from,
           integrator, adaptive, parabolic, general, evaluations_a_flight, tolerance, epoch, evaluations,
           flight_work] = flights;
    of_field(field, kept, each);
    of_joints(joints, kept, each);
    each(epoch, kept.epoch);
    make_room(kept.start, islands.size());
    make_room(kept.end, islands.size());
    make_room(kept.next_step, islands.size());
    make_room(kept.switching, islands.size());
    for (const IslandIndex k : islands.indices()) {
      auto& [start, end, next_step, first, count, group, a_switch, kinematic] = islands[k];
      each(start, kept.start[k]);
      each(end, kept.end[k]);
      each(next_step, kept.next_step[k]);
      each(a_switch, kept.switching[k]);
    }
    each(at_start, kept.at_start);
    if (field.in_contact()) each(constant, kept.constant);
    each(evaluations, kept.evaluations);
  }

  // Everything else of a group follows from the time of its last evaluation.
  template <class Self, class Ahead, class Each>
  static void of_flights_ahead(Self& flights, Ahead& ahead, const Each& each) {
    each(flights.at_end, ahead.at_end);
    make_room(ahead.cached, flights.islands.size());
    for (const IslandIndex k : flights.islands.indices()) {
      const Flights::Island& island = flights.islands[k];
      if (!island.coupled()) {
        if constexpr (std::is_const_v<Self>) ahead.cached[k] = -Flights::kForever;
        continue;
      }
      auto& [cached, from, now, change, missed, end_missed, rates_known, start_rates, stages] =
          flights.groups[island.group];
      if constexpr (std::is_const_v<Self>) {
        each(cached, ahead.cached[k]);
      } else if (ahead.cached[k] != -Flights::kForever) {
        // These evaluations were counted before the run was saved.
        const std::int64_t counted = flights.evaluations;
        (void)flights.fly_group(island, ahead.cached[k]);
        flights.evaluations = counted;
      }
    }
  }

  template <class Self, class Kept, class Ahead, class Each>
  static void of_trajectories(Self& trajectories, Kept& kept, Ahead* ahead, const Each& each) {
    auto& [flights, switches, curvature_bound, turn_bound, step_start, rejected_steps, tolerance_missed_since,
           joints_missed_since] = trajectories;
    of_flights(flights, kept, each);
    of_switches(switches, kept, each);
    each(rejected_steps, kept.rejected_steps);
    each(tolerance_missed_since, kept.tolerance_missed_since);
    each(joints_missed_since, kept.joints_missed_since);
    if (ahead == nullptr) return;
    const std::size_t bodies = flights.model->bodies();
    make_room(ahead->curvature_bound, bodies);
    make_room(ahead->turn_bound, bodies);
    for (std::size_t i = 0; i < bodies; ++i) {
      each(curvature_bound[static_cast<Eigen::Index>(i)], ahead->curvature_bound[i]);
      each(turn_bound[static_cast<Eigen::Index>(i)], ahead->turn_bound[i]);
    }
    of_flights_ahead(flights, *ahead, each);
  }
};

void Trajectories::keep(TrajectoryState& to, TrajectoriesAhead* ahead) const {
  to.welds = welds();
  KeptMembers::of_trajectories(*this, to, ahead, [](const auto& own, auto& kept) { kept = own; });
}

void Trajectories::restore(const TrajectoryState& from, const TrajectoriesAhead* ahead) {
  for (std::size_t i = welds().size(); i < from.welds.size(); ++i) {
    flights_.add_weld(from.welds[i]);
    switches_.add_joint();
  }
  for (const Flights::Island& island : flights_.islands) flights_.forget(island);
  KeptMembers::of_trajectories(*this, from, ahead, [](auto& own, const auto& kept) { own = kept; });
}

}  // namespace carom
