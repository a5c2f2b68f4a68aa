#pragma once

#include <cstdint>
#include <vector>

#include "physics/ledger/run_sums.h"
#include "physics/scene/method.h"
#include "physics/scene/scene.h"
#include "physics/step/contact_force.h"
#include "physics/step/pair_list.h"

namespace carom {

// What a run has between two steps besides its scene, in which bodies stand where they are, and its clock: with
// these it continues to rounding. Beyond physics these are counts of work, and what the next step starts from:
// next_step, waiting and support. The inside of a step is in RunState alone, which continues to the last bit.
struct Checkpoint {
  Method method;  // in force; under another one next_step, waiting pairs and contacts are found anew
  std::int64_t steps = 0;
  RunSums sums;  // with the work of the smooth forces up to now, and all notices
  std::int64_t evaluations = 0;
  std::int64_t rejected_steps = 0;
  std::vector<std::uint8_t> engaged;  // by spring: it acts
  std::vector<std::uint8_t> taut;     // by joint
  std::vector<double> released_at;    // s, by joint: when a string went slack within a taut impulse, or -1
  std::vector<double> next_step;      // s, by body: of the adaptive integrator; 0: not known yet
  // Pairs that overlap, or that forces press together while impacts follow one another too fast (Zeno).
  std::vector<WaitingPair> waiting;
  // Resting contacts: forces in the order of (a, b), and parallel to them what the solver starts from (N, N and
  // N m).
  std::vector<ContactForce> contacts;
  std::vector<Eigen::Vector3d> support;
};

// Throws SceneError, with the place under /state, if no run of this scene can have this state.
void check_checkpoint(const Scene& scene, const Checkpoint& checkpoint);

}  // namespace carom
