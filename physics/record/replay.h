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

  // Step by step through the run: what was done to it at the end of a step, then on_edit(edit); then
  // go_on(simulation), which ends it with false; then the next step, and after_step(simulation).
  template <class OnEdit, class GoOn, class AfterStep>
  void go_through(const RunLog& log, const OnEdit& on_edit, const GoOn& go_on, const AfterStep& after_step) {
    while (true) {
      for (; next_ < log.edits.size() && log.edits[next_].step <= simulation_.steps(); ++next_) {
        apply(log.edits[next_], simulation_);
        on_edit(log.edits[next_]);
      }
      if (!go_on(simulation_)) return;
      simulation_.step();
      after_step(simulation_);
    }
  }
  [[nodiscard]] const Simulation& simulation() const { return simulation_; }

 private:
  Simulation simulation_;
  std::size_t next_ = 0;  // edit
};

}  // namespace carom
