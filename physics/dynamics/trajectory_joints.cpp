#include <algorithm>
#include <cstddef>
#include <span>

#include "physics/dynamics/trajectories.h"

// Effect of joints on motions at one moment: at the start, after a push out of a penetration, and at an impact.
namespace carom {
namespace {

// The group of a body's island, if it has one.
GroupIndex group_of(const Flights& f, BodyIndex body) {
  const IslandIndex k = f.island_of[body];
  return k == kNoIsland ? kNoGroup : f.islands[k].group;
}

// Calls visit(island) once for each group among these bodies, with their changes of velocity set in it, without
// its joints. Ends at the first that returns false, and returns false then.
template <class Visit>
bool each_changed(Flights& f, std::span<const BodyIndex> bodies, const Eigen::Ref<const Eigen::Matrix3Xd>& by,
                  const Visit& visit) {
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const GroupIndex group = group_of(f, bodies[k]);
    const auto same = [&](BodyIndex other) { return f.island_of[other] == f.island_of[bodies[k]]; };
    if (group == kNoGroup || std::any_of(bodies.begin(), bodies.begin() + static_cast<std::ptrdiff_t>(k), same))
      continue;
    const Flights::Island& island = f.islands[f.island_of[bodies[k]]];
    f.gather(island);
    f.groups[group].change.setZero();
    for (std::size_t j = k; j < bodies.size(); ++j) {
      if (same(bodies[j]))
        f.groups[group].change.col(f.column_of(island, bodies[j])) = by.col(static_cast<Eigen::Index>(j));
    }
    if (!visit(island)) return false;
  }
  return true;
}

}  // namespace

void Trajectories::restore_joints(IslandIndex k) {
  Flights& f = flights_;
  const Flights::Island& island = f.islands[k];
  if (!island.coupled() || !f.joints.has_joints(island.group)) return;
  f.gather(island);
  f.joints.restore(island.group, f.epoch + island.start, f.groups[island.group].from);
  f.spread(island);
}

void Trajectories::project_changes(std::span<const BodyIndex> bodies, Eigen::Ref<Eigen::Matrix3Xd> by) {
  Flights& f = flights_;
  each_changed(f, bodies, by, [&](const Flights::Island& island) {
    Flights::Group& group = f.groups[island.group];
    f.joints.project(island.group, f.epoch + island.start, group.from, group.change);
    for (std::size_t j = 0; j < bodies.size(); ++j) {
      if (group_of(f, bodies[j]) == island.group)
        by.col(static_cast<Eigen::Index>(j)) = group.change.col(f.column_of(island, bodies[j]));
    }
    return true;
  });
}

bool Trajectories::apply_changes(std::span<const BodyIndex> bodies,
                                 const Eigen::Ref<const Eigen::Matrix3Xd>& by) {
  Flights& f = flights_;
  const bool pulls = each_changed(f, bodies, by, [&](const Flights::Island& island) {
    Flights::Group& group = f.groups[island.group];
    if (f.joints.share(island.group, f.epoch + island.start, group.change, group.from)) return true;
    f.forget(island);
    return false;
  });
  if (!pulls) return false;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const IslandIndex i = f.island_of[bodies[k]];
    if (i == kNoIsland) continue;
    const Flights::Island& island = f.islands[i];
    if (island.coupled()) {
      f.spread(island);
    } else if (!island.kinematic) {
      f.at_start.col(bodies[k]).segment<3>(3) += by.col(static_cast<Eigen::Index>(k));
      f.forget(island);
    }
  }
  return true;
}

Trajectories::WeldImpact Trajectories::add_weld(const Weld& weld, double time) {
  Flights& f = flights_;
  Motions now = f.at_start;
  for (BodyIndex i{0}; i < static_cast<int>(now.cols()); ++i) now.col(i) = f.at(i, time);
  f.at_start = now;
  f.add_weld(weld);
  switches_.add_joint();
  for (Flights::Island& island : f.islands) {
    island.start = island.end = time;
    for (const BodyIndex i : f.members_of(island)) f.field.set_phase(i, f.epoch + time);
  }
  const Flights::Island& island = f.islands[f.island_of[weld.body]];
  const double taken = f.apply_taut_impulse(island);
  return {taken, f.joints.impulse(island.group, f.joints.last(), weld.body)};
}

}  // namespace carom
