#pragma once

#include <cstddef>
#include <stop_token>

#include "physics/record/key_frames.h"
#include "physics/record/run_log.h"
#include "physics/world/simulation.h"

namespace carom {

// A run gone through once more, step by step.
class Replay {
 public:
  explicit Replay(const RunSetup& start, const std::stop_token& interrupt = {}) : simulation_(start) {
    simulation_.watch_impacts(true);
    simulation_.interrupt_on(interrupt);
  }
  // From a later moment on.
  explicit Replay(const KeyFrame& moment) : simulation_(moment.model, moment.state), next_(moment.edits) {
    simulation_.watch_impacts(true);
  }

  // Carries out the next edit that is due after the steps so far, and tells which; nullptr if there is none.
  const Edit* edit(const RunLog& log);
  void step() { simulation_.step(); }
  [[nodiscard]] const Simulation& simulation() const { return simulation_; }

 private:
  Simulation simulation_;
  std::size_t next_ = 0;  // edit
};

}  // namespace carom
