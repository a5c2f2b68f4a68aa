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

// The complete record of a run: its start and the edits in order. Repeating whole steps from there gives the
// same run bit by bit.
struct RunLog {
  RunSetup start;
  std::vector<Edit> edits;
};

// A run at the end of one of its steps, with everything needed to continue from there.
struct KeyFrame {
  std::shared_ptr<const Model> model;
  RunState state;
  Sampler sampler;
  std::size_t edits = 0;  // of its log, applied so far
};

// Moments of a run from which it can be replayed: evenly spaced over the whole run, at most kMost, so that
// only a part of a long run has to be repeated.
class KeyFrames {
 public:
  static constexpr std::size_t kMost = 32;
  static constexpr std::int64_t kFirstInterval = 512;  // steps; doubled whenever there are too many frames

  // Call after each step.
  void take(const Simulation& simulation, const Sampler& sampler, std::size_t edits);
  [[nodiscard]] const std::vector<std::shared_ptr<const KeyFrame>>& all() const { return frames_; }

 private:
  std::int64_t interval_ = kFirstInterval;
  std::vector<std::shared_ptr<const KeyFrame>> frames_;  // in the order of time
};

// The latest key frame before `time` from which these curves can be read; nullptr: only from the start.
[[nodiscard]] std::shared_ptr<const KeyFrame> latest_before(
    std::span<const std::shared_ptr<const KeyFrame>> frames, double time, const std::vector<Curve>& curves);

// Repeats a run step by step.
class Replay {
 public:
  explicit Replay(const RunSetup& start, const std::stop_token& interrupt = {}) : simulation_(start) {
    simulation_.watch_impacts(true);
    simulation_.interrupt_on(interrupt);
  }
  // From a key frame on.
  explicit Replay(const KeyFrame& moment) : simulation_(moment.model, moment.state), next_(moment.edits) {
    simulation_.watch_impacts(true);
  }

  // For each step of the run: applies the edits due at its start and calls on_edit(edit) for each; calls
  // go_on(simulation), which stops the replay by returning false; then steps and calls
  // after_step(simulation).
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
