#include <tuple>

#include "physics/dynamics/trajectories.h"

// Effect of joints on motions at one moment: at the start, after a push out of a penetration, and at an impact.
namespace carom {
namespace {

// Sets the changes of velocity in a body's group without its joints. Returns the group, or -1 if the body has
// none.
int set_change(Flights& f, int body, const Eigen::Vector3d& by) {
  const int k = f.island_of[body];
  if (k < 0 || f.islands[k].group < 0) return -1;
  const Flights::Island& island = f.islands[k];
  f.gather(island);
  f.groups[island.group].change.setZero();
  f.groups[island.group].change.col(f.column_of(island, body)) = by;
  return island.group;
}

}  // namespace

void Trajectories::restore_joints(int k) {
  Flights& f = flights_;
  const Flights::Island& island = f.islands[k];
  if (island.group < 0 || !f.joints.has_joints(island.group)) return;
  f.gather(island);
  f.joints.restore(island.group, f.epoch + island.start, f.groups[island.group].from);
  f.spread(island);
}

void Trajectories::project_changes(int a, int b, Eigen::Vector3d& a_by, Eigen::Vector3d& b_by) {
  Flights& f = flights_;
  const auto project = [&](int body, int group) {
    const Flights::Island& island = f.islands[f.island_of[body]];
    f.joints.project(group, f.epoch + island.start, f.groups[group].from, f.groups[group].change);
    return Eigen::Vector3d(f.groups[group].change.col(f.column_of(island, body)));
  };
  const int group_a = set_change(f, a, a_by);
  if (group_a >= 0 && f.island_of[a] == f.island_of[b]) {
    const Flights::Island& island = f.islands[f.island_of[a]];
    f.groups[group_a].change.col(f.column_of(island, b)) = b_by;
    a_by = project(a, group_a);
    b_by = f.groups[group_a].change.col(f.column_of(island, b));
    return;
  }
  if (group_a >= 0) a_by = project(a, group_a);
  const int group_b = set_change(f, b, b_by);
  if (group_b >= 0) b_by = project(b, group_b);
}

bool Trajectories::apply_changes(int a, int b, const Eigen::Vector3d& a_by, const Eigen::Vector3d& b_by) {
  Flights& f = flights_;
  const auto share = [&](int body, int group) {
    const Flights::Island& island = f.islands[f.island_of[body]];
    if (f.joints.share(group, f.epoch + island.start, f.groups[group].change, f.groups[group].from))
      return true;
    f.forget(island);
    return false;
  };
  const int group_a = set_change(f, a, a_by);
  if (group_a >= 0 && f.island_of[a] == f.island_of[b]) {
    const Flights::Island& island = f.islands[f.island_of[a]];
    f.groups[group_a].change.col(f.column_of(island, b)) = b_by;
    if (!share(a, group_a)) return false;
    f.spread(island);
    return true;
  }
  if (group_a >= 0 && !share(a, group_a)) return false;
  const int group_b = set_change(f, b, b_by);
  if (group_b >= 0 && !share(b, group_b)) return false;
  for (const auto& [body, group, by] : {std::tuple(a, group_a, a_by), std::tuple(b, group_b, b_by)}) {
    if (group >= 0) {
      f.spread(f.islands[f.island_of[body]]);
    } else if (f.island_of[body] >= 0 && !f.islands[f.island_of[body]].kinematic) {
      f.at_start.col(body).segment<3>(3) += by;
      f.forget(f.islands[f.island_of[body]]);
    }
  }
  return true;
}

Trajectories::Engagement Trajectories::engage(int joint, int body) {
  Flights& f = flights_;
  const Flights::Island& island = f.islands[f.island_of[body]];
  const double taken = f.apply_taut_impulse(island);
  return {taken, f.joints.impulse(island.group, joint, body)};
}

}  // namespace carom
