#pragma once

#include <vector>

#include "physics/world/frame.h"

namespace carom {

// What plots and tables show of a run. Bounded in memory: beyond a limit the older nine tenths are thinned to
// half, again and again, so that a long run is there from its start: of four samples those with the least and
// the largest kinetic energy stay, of two impacts the stronger one. So spikes survive; `complete()` says that
// something went.
class Recorder {
 public:
  static constexpr std::size_t kMostSamples = 400'000;
  static constexpr std::size_t kMostImpacts = 100'000;

  void clear();
  // Takes what happened since the frame before; a frame of another run starts anew.
  void add(const Frame& frame);

  [[nodiscard]] const std::vector<Sample>& samples() const { return samples_; }
  [[nodiscard]] const std::vector<ImpactRecord>& impacts() const { return impacts_; }
  [[nodiscard]] bool complete() const { return complete_; }

 private:
  std::uint64_t run_ = 0;
  std::vector<Sample> samples_;
  std::vector<ImpactRecord> impacts_;
  bool complete_ = true;
};

}  // namespace carom
