#pragma once

#include <chrono>
#include <optional>
#include <vector>

#include "physics/run/run_setup.h"

namespace carom {

// Where the bodies that move go until the first impact of a run.
struct Aim {
  double time = 0.0;                     // s, of the impact, from the start
  std::vector<std::vector<Vec2>> paths;  // m, of each body that moves, from its start to its place then
  std::vector<Body> meeting;             // the two bodies, where they meet
};

// Computed by the run's own method. Nothing where no impact comes within `ahead` s, or before a step is over,
// where there are more than kMostAimed bodies, or where it takes longer than `budget`.
inline constexpr std::size_t kMostAimed = 100;
[[nodiscard]] std::optional<Aim> aim_of(const RunSetup& start, double ahead,
                                        std::chrono::steady_clock::duration budget);

}  // namespace carom
