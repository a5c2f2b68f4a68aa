#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "physics/collision/cell_grid.h"
#include "physics/dynamics/state.h"
#include "physics/dynamics/track_state.h"
#include "physics/scene/scene.h"
#include "physics/world/simulation.h"

namespace carom {

// What contacts that last start from in the next step; see LastingContacts.
struct ContactMemory {
  std::vector<ContactForce> forces;
  std::vector<Eigen::Vector3d> hold;  // N, N and N m, beside forces
  std::vector<std::uint8_t> held;     // by body; empty before the first step
  std::vector<int> pushed;            // bodies
};

// What lies ahead where tracks run on across the ends of steps: impacts that are foreseen, and pairs that wait
// for the next step's end. Times in s after the epoch.
struct RunAhead {
  // As Event has it: bodies a < b meet, or (b < 0) the track of a's island ends.
  struct Foreseen {
    double time = 0.0;
    int a = 0;
    int b = -1;
  };
  struct Waiting {
    int a = 0;
    int b = 0;  // a < b
    bool resting = false;
  };
  TracksAhead tracks;
  CellGrid::Order grid;
  std::vector<Foreseen> events;  // in the order of (time, a, b)
  std::vector<Waiting> waiting;
  double reach = 1.0;         // m
  double stretch = 1.0;       // of tracks, where too many ended
  double epoch_length = 1.0;  // s, a power of two
  double last_impact = -1.0;
};

// All that a step changes of a simulation, as plain values: between two steps nothing else is remembered. Put
// back into a simulation of the same scene (see SavedRun), the run goes on for the same bytes.
struct RunState {
  Method method;
  double time = 0.0;         // s
  double origin = 0.0;       // s: time = origin + steps_since_origin * origin_step
  double origin_step = 0.0;  // s
  std::int64_t steps_since_origin = 0;
  std::int64_t steps = 0;
  std::int64_t impact_count = 0;
  ImpactCounts impact_counts;
  int at_once = 0;  // impacts before the last one at the same time
  StepWork::Kept work;
  State motions;               // at `time`
  Ledger ledger;               // without the work of the smooth forces, which the motions carry
  double gravity_since = 0.0;  // s
  double peak_kinetic = 0.0;   // J
  int energy_doubts = 0;
  Notices notices;
  TrackState tracks;
  ContactMemory contacts;
  std::optional<RunAhead> ahead;  // none: the next step begins anew
};

// Throws SceneError, with the place under /state, where a state is none that a run of this scene can have. All
// sizes must be those of the scene already, but for lists whose length is free.
void check_state(const Scene& scene, double start_time, const RunState& state);

}  // namespace carom
