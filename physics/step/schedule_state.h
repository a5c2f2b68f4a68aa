#pragma once

#include <vector>

#include "physics/collision/cell_grid.h"
#include "physics/dynamics/trajectory_state.h"
#include "physics/model/index.h"

namespace carom {

// Pending events of trajectories that continue across the ends of steps: scheduled impacts, and pairs that
// wait for the next step's end. Times in s after the epoch.
struct ScheduleState {
  // As in Event: bodies a < b collide, or (b < 0) the trajectory of a's island ends.
  struct Scheduled {
    double time = 0.0;
    BodyIndex a;
    BodyIndex b;
  };
  TrajectoriesAhead trajectories;
  CellGrid::Order grid;
  std::vector<Scheduled> events;  // in the order of (time, a, b)
  double reach = 1.0;             // m
  double stretch = 1.0;           // of trajectories, if too many ended
  double epoch_length = 1.0;      // s, a power of two
  double last_impact = -1.0;
};

}  // namespace carom
