#pragma once

#include <stop_token>
#include <vector>

#include "physics/scene/scene.h"
#include "physics/world/edit.h"
#include "physics/world/simulation.h"

namespace carom {

// All that a run is made of: where it started, and what was done to it, in order. Whole steps from there give
// the same bytes again.
struct RunLog {
  RunSetup start;
  std::vector<Edit> edits;
};

// A run gone through once more, step by step.
class Replay {
 public:
  explicit Replay(const RunSetup& start, const std::stop_token& interrupt = {}) : simulation_(start) {
    simulation_.watch_impacts(true);
    simulation_.interrupt_on(interrupt);
  }
  // From a later moment on, after so many edits.
  Replay(const Simulation& moment, std::size_t edits) : simulation_(moment), next_(edits) {}

  // Carries out the next edit that is due after the steps so far, and tells which; nullptr if there is none.
  const Edit* edit(const RunLog& log);
  void step() { simulation_.step(); }
  [[nodiscard]] const Simulation& simulation() const { return simulation_; }

 private:
  Simulation simulation_;
  std::size_t next_ = 0;  // edit
};

}  // namespace carom
