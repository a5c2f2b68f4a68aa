#pragma once

#include <cstddef>
#include <span>

#include "physics/dynamics/force_field.h"
#include "physics/dynamics/joint_constraints.h"

// The right-hand sides f(t, y, k) that integrators evaluate along a trajectory; t in s since the epoch.
namespace carom {

// One body that no force couples to another.
struct BodyRates {
  const ForceField& field;
  BodyIndex body;
  double epoch;
  template <class Y>
  void operator()(double t, const Y& y, Y& k) const {
    field.external_rate(body, epoch + t, y, k);
  }
};

// The coupled bodies of a group, one column each.
struct GroupRates {
  const ForceField& field;
  JointConstraints& joints;
  GroupIndex group;
  std::span<const BodyIndex> members;
  double epoch;
  void operator()(double t, const Motions& y, Motions& k) const {
    for (std::size_t j = 0; j < members.size(); ++j)
      field.external_rate(members[j], epoch + t, y.col(j), k.col(j));
    field.add_couplings(members, y, k);
    joints.add_forces(group, epoch + t, y, k);
  }
};

}  // namespace carom
