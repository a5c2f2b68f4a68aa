#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "physics/world/simulation.h"

namespace carom {

// The scene's sums at one moment, for plots.
struct Sample {
  double time = 0.0;  // s
  Totals totals;
};

// A moment of a run, whole, as the simulation's thread publishes it: what is now, and what happened since the
// frame before. Nothing in it changes after it was published.
struct Frame {
  std::uint64_t run = 0;  // counts loads and restarts: samples of different runs don't belong together
  double time = 0.0;
  std::int64_t steps = 0;
  std::int64_t impact_count = 0;
  State state;
  std::shared_ptr<const std::vector<Body>> bodies;
  Totals totals;
  Ledger ledger;
  std::string status = "ok";
  bool playing = false;
  double realised_speed = 0.0;  // simulated seconds per second, while playing
  std::vector<Sample> samples;  // since the frame before: each step's end, and before and after each impact
  std::vector<ImpactRecord> impacts;  // since the frame before
};

// Appends what the last step of a simulation has to show on a plot: jumps at its watched impacts, then its end.
void append_samples(const Simulation& simulation, std::vector<Sample>& samples);

}  // namespace carom
