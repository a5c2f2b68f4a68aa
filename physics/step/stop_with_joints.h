#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <span>

#include "physics/contact/contact_solver.h"
#include "physics/step/world.h"

namespace carom {

// Rounds that alternate between the impulses of contacts and of joints.
inline constexpr int kMostStopRounds = 200;

// Stops contacts of these bodies, in rising order, some of which are jointed, and gives the trajectories the
// velocities after it: `after`, as `before` and `free` 3×N in m/s, m/s and rad/s. A body gives way to a contact
// less than it would without its joints, so that the rounds converge: solve(free) finds the contacts' impulses
// without joints, and with them `after`, from `free`, which takes what joints changed in the round before. The
// rounds end where velocities change by at most `tolerance` (m/s).
template <class Solve>
ContactSolverReport stop_with_joints(World& world, std::span<const BodyIndex> bodies,
                                     const Eigen::Matrix3Xd& before, double tolerance, const Solve& solve,
                                     Eigen::Matrix3Xd& free, Eigen::Matrix3Xd& after) {
  Eigen::Matrix3Xd own(3, static_cast<Eigen::Index>(bodies.size()));  // changes by contacts alone
  Eigen::Matrix3Xd all = own;
  ContactSolverReport report;
  do {  // again where a string would have to push, and is slack from now on
    free = before;
    for (int round = 0; round < kMostStopRounds; ++round) {
      report = solve(free);
      for (std::size_t k = 0; k < bodies.size(); ++k)
        own.col(static_cast<Eigen::Index>(k)) = after.col(bodies[k]) - free.col(bodies[k]);
      all = own;
      world.trajectories.project_changes(bodies, all);
      double off = 0.0;
      for (std::size_t k = 0; k < bodies.size(); ++k) {
        const BodyIndex i = bodies[k];
        const Eigen::Vector3d by = before.col(i) + all.col(static_cast<Eigen::Index>(k)) - after.col(i);
        off = std::max(off, by.head<2>().norm() + std::abs(by[2]) * world.shapes().size[i]);
        free.col(i) += by;
      }
      if (off <= tolerance) break;
    }
  } while (!world.trajectories.apply_changes(bodies, own));
  for (BodyIndex i{0}; i < world.bodies(); ++i) after.col(i) = world.trajectories.at_start(i).segment<3>(3);
  return report;
}

}  // namespace carom
