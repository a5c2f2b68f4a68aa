#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "physics/record/sampler.h"
#include "physics/world/run_state.h"
#include "physics/world/simulation.h"

namespace carom {

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

}  // namespace carom
