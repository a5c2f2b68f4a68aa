#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

#include "physics/record/sampler.h"
#include "physics/run/run_setup.h"
#include "physics/run/run_state.h"
#include "physics/run/simulation.h"

namespace carom {

// A run at the end of one of its steps, before the edits that are due there, with everything needed to continue
// from there.
struct KeyFrame {
  std::shared_ptr<const CompiledScene> compiled;
  RunState state;
  Sampler sampler;
  double wall_time = 0.0;  // s, spent on the steps so far
  bool at_edit = false;
};

// Moments of a run from which it can be replayed, so that only a part of a long run has to be repeated: at most
// kMost evenly spaced over the whole run, and those of the last kMostAtEdits moments with edits.
class KeyFrames {
 public:
  static constexpr std::size_t kMost = 32;
  static constexpr std::size_t kMostAtEdits = 16;
  static constexpr std::int64_t kFirstInterval = 512;  // steps; doubled whenever there are too many frames

  // Call at the start, after each step, and before an edit is applied.
  void take(const Simulation& simulation, const Sampler& sampler, double wall_time);
  [[nodiscard]] const std::vector<std::shared_ptr<const KeyFrame>>& all() const { return frames_; }
  // The latest before `time` (s) from which a run can go on that has these edits instead, the first `same` of
  // them as before, and from which these curves can be read; nullptr if there is none. The later ones are
  // dropped.
  std::shared_ptr<const KeyFrame> go_back(const std::vector<RunEdit>& edits, std::size_t same,
                                          const std::vector<Curve>& curves,
                                          double time = std::numeric_limits<double>::infinity());

 private:
  void thin();

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
  // From a key frame on, of a run with these edits.
  Replay(const KeyFrame& moment, const std::vector<RunEdit>& edits)
      : simulation_(moment.compiled, moment.state) {
    simulation_.watch_impacts(true);
    simulation_.set_edits(edits);
  }

  // For each step of the run: applies the edits due at its start and calls on_edit(edit) for each; calls
  // go_on(simulation), which stops the replay by returning false; then steps and calls
  // after_step(simulation).
  template <class OnEdit, class GoOn, class AfterStep>
  void go_through(const OnEdit& on_edit, const GoOn& go_on, const AfterStep& after_step) {
    while (true) {
      while (const RunEdit* edit = simulation_.due()) {
        simulation_.apply_due();
        on_edit(*edit);
      }
      if (!go_on(simulation_)) return;
      simulation_.step();
      after_step(simulation_);
    }
  }
  [[nodiscard]] const Simulation& simulation() const { return simulation_; }
  // Other edits of the run; those in its past stay the same.
  void set_edits(const std::vector<RunEdit>& edits) { simulation_.set_edits(edits); }

 private:
  Simulation simulation_;
};

}  // namespace carom
