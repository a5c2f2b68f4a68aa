#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "physics/dynamics/state.h"
#include "physics/dynamics/trajectory_state.h"
#include "physics/ledger/run_sums.h"
#include "physics/scene/method.h"
#include "physics/scene/scene.h"
#include "physics/step/contact_force.h"
#include "physics/step/pair_list.h"
#include "physics/step/run_clock.h"
#include "physics/step/schedule_state.h"
#include "physics/step/step_work.h"

namespace carom {

// Everything in a simulation that a step changes, as plain values. A simulation of the same model that starts
// from it continues the run bit by bit, in the same program: a file holds a Checkpoint instead.
struct RunState {
  Method method;
  RunClock clock;
  RunSums sums;
  int at_once = 0;                   // impacts before the last one at the same time
  std::vector<WaitingPair> waiting;  // for the end of the next step
  StepWork::Kept work;
  State motions;  // at clock.time
  TrajectoryState trajectories;
  ContactMemory contacts;
  std::optional<ScheduleState> ahead;  // none: the next step rebuilds all trajectories
  std::size_t edits_applied = 0;       // of the setup
};

}  // namespace carom
