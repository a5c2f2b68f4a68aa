#pragma once

#include <limits>
#include <utility>
#include <vector>

#include "physics/collision/broad_phase.h"
#include "physics/step/world.h"

namespace carom {

// The broad phase of a step without an event queue.
class NearPairs {
 public:
  // Pairs whose rectangles touch, to rounding, in rising order. Each rectangle bounds a body at the start of
  // its trajectory, widened by margin(body) in m. At most BroadPhase::most_pairs() pairs are listed; a notice
  // reports that there were more.
  template <class Margin>
  const std::vector<BodyPair>& find(World& world, const Margin& margin) {
    const int n = world.bodies();
    bounds_.resize(n);
    for (BodyIndex i{0}; i < n; ++i) {
      const Eigen::Array2d x = world.trajectories.at_start(i).template head<2>().array();
      const Eigen::Array2d extent = world.shapes().extent.col(i).array();
      const Eigen::Array2d reach = extent + margin(i) + kRounding * (x.abs() + extent);
      bounds_[i] = {x - reach, x + reach};
    }
    const auto& pairs = broad_phase_.pairs(bounds_, world.shapes().fixed);
    if (broad_phase_.cut()) world.note(&Notices::pairs_cut_since, world.clock.time);
    return pairs;
  }

 private:
  static constexpr double kRounding = 16.0 * std::numeric_limits<double>::epsilon();

  BroadPhase broad_phase_;
  std::vector<Bounds> bounds_;
};

}  // namespace carom
