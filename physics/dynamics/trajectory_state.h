#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "physics/dynamics/state.h"
#include "physics/model/index.h"
#include "physics/model/weld.h"

namespace carom {

// All members of trajectories (physics/dynamics/trajectories.h) that a step changes, as plain values. Times are
// in s after the epoch unless absolute.
struct TrajectoryState {
  double epoch = 0.0;  // s, absolute
  std::vector<Weld> welds;
  // By island.
  ArrayOf<IslandIndex, double> start, end;
  ArrayOf<IslandIndex, double> next_step;                 // s, of the adaptive integrator; 0: not known yet
  ArrayOf<IslandIndex, std::optional<Switch>> switching;  // what flips at the end
  Motions at_start;                                       // by body
  std::vector<std::uint8_t> engaged;                      // by spring: it acts
  std::vector<std::uint8_t> taut;                         // by joint
  std::vector<double> released_at;                        // s, absolute, by joint
  ArrayOf<AppliedForceIndex, int> phase;
  Vec2 hand_place = Vec2::Zero();  // m
  // By body, in m/s², m/s², rad/s²: all constant accelerations, and the part of contacts; empty if contacts
  // never acted.
  Eigen::Matrix3Xd constant, contact;
  std::int64_t evaluations = 0;
  std::int64_t rejected_steps = 0;
  double tolerance_missed_since = -1.0;  // s, absolute
  double joints_missed_since = -1.0;     // s, absolute
  double switches_missed_since = -1.0;   // s, absolute
  double lost_to_joints = 0.0;           // J
};

// What is known of the time ahead, where trajectories extend across the ends of steps.
struct TrajectoriesAhead {
  Motions at_end;                       // by body
  std::vector<double> curvature_bound;  // m/s², by body
  std::vector<double> turn_bound;       // rad/s², by body
  ArrayOf<IslandIndex, double> cached;  // the time of a coupled island's last evaluation
};

}  // namespace carom
