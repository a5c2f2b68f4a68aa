#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "physics/dynamics/state.h"

namespace carom {

// All that a step changes of tracks (physics/dynamics/tracks.h), as plain values. Times in s after the epoch,
// where they are not absolute.
struct TrackState {
  double epoch = 0.0;  // s, absolute
  // By island.
  std::vector<double> start, end;
  std::vector<double> next_step;      // s, of the adaptive integrator; 0: not known yet
  std::vector<int> switching;         // the switch that flips at the end, or -1
  Motions settled;                    // by body
  std::vector<std::uint8_t> engaged;  // by spring: it acts
  std::vector<std::uint8_t> taut;     // by link
  std::vector<double> let_go_at;      // s, absolute, by link
  std::vector<int> phase;             // by applied force
  // By body, in m/s², m/s², rad/s²: all constant accelerations, and of those what contacts do; empty where
  // contacts never acted.
  Eigen::Matrix3Xd constant, contact;
  std::int64_t evaluations = 0;
  std::int64_t rejected_steps = 0;
  double tolerance_missed_since = -1.0;  // s, absolute
  double links_missed_since = -1.0;      // s, absolute
  double switches_missed_since = -1.0;   // s, absolute
  double lost_to_links = 0.0;            // J
};

// What is known of the time ahead, where tracks run on across the ends of steps.
struct TracksAhead {
  Motions at_end;              // by body
  std::vector<double> bend;    // m/s², by body
  std::vector<double> turn;    // rad/s², by body
  std::vector<double> cached;  // by island: the time at which a coupled island was last looked at
};

}  // namespace carom
