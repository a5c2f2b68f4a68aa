#pragma once

#include <optional>

#include "physics/dynamics/state.h"
#include "physics/dynamics/trajectory_state.h"
#include "physics/scene/method.h"
#include "physics/scene/scene.h"
#include "physics/world/event_driven_impacts.h"
#include "physics/world/resting_contacts.h"
#include "physics/world/run_clock.h"
#include "physics/world/run_sums.h"
#include "physics/world/step_work.h"

namespace carom {

// All that a step changes of a simulation, as plain values: between two steps nothing else is remembered. Put
// back into a simulation of the same scene (see SavedRun), the run goes on for the same bytes.
struct RunState {
  Method method;
  RunClock clock;
  RunSums sums;
  int at_once = 0;  // impacts before the last one at the same time
  StepWork::Kept work;
  State motions;  // at clock.time
  TrajectoryState trajectories;
  ContactMemory contacts;
  std::optional<RunAhead> ahead;  // none: the next step begins anew
};

// Throws SceneError, with the place under /state, where a state is none that a run of this scene can have. All
// sizes must be those of the scene already, but for lists whose length is free.
void check_state(const Scene& scene, double start_time, const RunState& state);

}  // namespace carom
