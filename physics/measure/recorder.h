#pragma once

#include <vector>

#include "physics/world/frame.h"

namespace carom {

// How large a run's quantities are: against these a plot tells a value from rounding.
struct Scales {
  double energy = 0.0;    // J: the most of kinetic energy and size of the potential one
  double momentum = 0.0;  // N s: √(2 M K), which the sum of all sizes m|v| never exceeds
  double impulse = 0.0;   // N s: the strongest impact
};

// What plots and tables show of a run, bounded in memory by physics/world/thinning.h; `complete()` says that
// something went.
class Recorder {
 public:
  void clear();
  // Takes what happened since the frame before; a frame of another run starts anew.
  void add(const Frame& frame);

  [[nodiscard]] const std::vector<Sample>& samples() const { return samples_; }
  [[nodiscard]] const std::vector<ImpactRecord>& impacts() const { return impacts_; }
  [[nodiscard]] const Scales& scales() const { return scales_; }
  [[nodiscard]] bool complete() const { return complete_; }

 private:
  std::uint64_t run_ = 0;
  std::vector<Sample> samples_;
  std::vector<ImpactRecord> impacts_;
  Scales scales_;
  std::shared_ptr<const std::vector<Body>> bodies_;
  double mass_ = 0.0;  // kg, of all that moves freely
  bool complete_ = true;
};

}  // namespace carom
