#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

#include "physics/record/sampler.h"
#include "physics/world/edit.h"
#include "physics/world/run_setup.h"
#include "physics/world/run_state.h"
#include "physics/world/simulation.h"

namespace carom {

// All that a run is made of: where it started, and what was done to it, in order. Whole steps from there give
// the same bytes again.
struct RunLog {
  RunSetup start;
  std::vector<Edit> edits;
};

// A run at the end of one of its steps, with all that is needed to go on from there.
struct KeyFrame {
  std::shared_ptr<const Model> model;
  RunState state;
  Sampler sampler;
  std::size_t edits = 0;  // of its log, carried out so far
};

// Moments of a run from which its past can be gone through again: evenly spaced over the whole of it, kMost at
// most, so that of a long run only a piece has to be.
class KeyFrames {
 public:
  static constexpr std::size_t kMost = 32;
  static constexpr std::int64_t kFirstInterval = 512;  // steps; doubled each time that there are too many

  // After each step.
  void take(const Simulation& simulation, const Sampler& sampler, std::size_t edits);
  [[nodiscard]] const std::vector<std::shared_ptr<const KeyFrame>>& all() const { return frames_; }

 private:
  std::int64_t interval_ = kFirstInterval;
  std::vector<std::shared_ptr<const KeyFrame>> frames_;  // in the order of time
};

// The latest moment before `time` from which these curves can be read; nullptr: only from the start.
[[nodiscard]] std::shared_ptr<const KeyFrame> latest_before(
    std::span<const std::shared_ptr<const KeyFrame>> frames, double time, const std::vector<Curve>& curves);

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
