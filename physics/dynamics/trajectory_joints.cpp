#include <tuple>

#include "physics/dynamics/trajectories.h"

// What joints do to settled motions at once: at the start, after a push out of a penetration, at an impact, and
// when a string becomes taut.
namespace carom {

void Trajectories::restore_joints(int k) {
  const Island& island = islands_[k];
  if (island.group < 0 || !joints_.has_joints(island.group)) return;
  gather(island);
  joints_.restore(island.group, epoch_ + island.start, groups_[island.group].from);
  spread(island);
}

void Trajectories::spread(const Island& island) {
  const Motions& from = groups_[island.group].from;
  for (int j = 0; j < island.count; ++j) at_start_.col(members_[island.first + j]) = from.col(j);
  forget(island);
}

// The group's motions and what the impact would change in them were all bodies free; -1: no group.
int Trajectories::set_change(int body, const Eigen::Vector3d& by) {
  const int k = island_of_[body];
  if (k < 0 || islands_[k].group < 0) return -1;
  const Island& island = islands_[k];
  gather(island);
  groups_[island.group].change.setZero();
  groups_[island.group].change.col(column_of(island, body)) = by;
  return island.group;
}

void Trajectories::answer(int a, int b, Eigen::Vector3d& a_by, Eigen::Vector3d& b_by) {
  const auto project = [&](int body, int group) {
    const Island& island = islands_[island_of_[body]];
    joints_.project(group, epoch_ + island.start, groups_[group].from, groups_[group].change);
    return Eigen::Vector3d(groups_[group].change.col(column_of(island, body)));
  };
  const int group_a = set_change(a, a_by);
  if (group_a >= 0 && island_of_[a] == island_of_[b]) {
    const Island& island = islands_[island_of_[a]];
    groups_[group_a].change.col(column_of(island, b)) = b_by;
    a_by = project(a, group_a);
    b_by = groups_[group_a].change.col(column_of(island, b));
    return;
  }
  if (group_a >= 0) a_by = project(a, group_a);
  const int group_b = set_change(b, b_by);
  if (group_b >= 0) b_by = project(b, group_b);
}

bool Trajectories::push(int a, int b, const Eigen::Vector3d& a_by, const Eigen::Vector3d& b_by) {
  const auto share = [&](int body, int group) {
    const Island& island = islands_[island_of_[body]];
    if (joints_.share(group, epoch_ + island.start, groups_[group].change, groups_[group].from)) return true;
    forget(island);
    return false;
  };
  const int group_a = set_change(a, a_by);
  if (group_a >= 0 && island_of_[a] == island_of_[b]) {
    const Island& island = islands_[island_of_[a]];
    groups_[group_a].change.col(column_of(island, b)) = b_by;
    if (!share(a, group_a)) return false;
    spread(island);
    return true;
  }
  if (group_a >= 0 && !share(a, group_a)) return false;
  const int group_b = set_change(b, b_by);
  if (group_b >= 0 && !share(b, group_b)) return false;
  for (const auto& [body, group, by] : {std::tuple(a, group_a, a_by), std::tuple(b, group_b, b_by)}) {
    if (group >= 0) {
      spread(islands_[island_of_[body]]);
    } else if (island_of_[body] >= 0 && !islands_[island_of_[body]].kinematic) {
      at_start_.col(body).segment<3>(3) += by;
      forget(islands_[island_of_[body]]);
    }
  }
  return true;
}

// A string has become taut, or a joint is new: the plastic impact that makes it hold. Strings that would have
// to push let go.
double Trajectories::apply_taut_impulse(const Island& island) {
  gather(island);
  const double taken =
      joints_.apply_taut_impulse(island.group, epoch_ + island.start, groups_[island.group].from);
  spread(island);
  return taken;
}

Trajectories::Engagement Trajectories::engage(int joint, int body) {
  const Island& island = islands_[island_of_[body]];
  const double taken = apply_taut_impulse(island);
  return {taken, joints_.impulse(island.group, joint, body)};
}

}  // namespace carom
