#pragma once

#include <limits>
#include <stop_token>
#include <vector>

#include "physics/compare/comparison.h"
#include "physics/world/run_setup.h"

namespace carom {

// How fast runs that start beside one another part, and what follows for a comparison: rounding is such a
// neighbour too.
//
// A scene is run together with neighbours whose bodies are displaced at first, all in the same directions but
// by 1e-7, 1e-9, ... 1e-13 of the scene's length. growth(t) is the largest distance of a body from its
// neighbour over the first displacement, read off the most displaced neighbour that is still so near that the
// motion beside it is linear; as one after the other gets too far away, the next takes over, which is what
// renormalising one neighbour would do. Positions are continuous through impacts, so this holds over them
// (Benettin et al., Meccanica 15 (1980) 9, with neighbours at hand instead of rescaled ones).
struct Chaos {
  std::vector<double> time;    // s
  std::vector<double> growth;  // dimensionless, >= 1: the largest up to that time
  double length =
      0.0;  // m: the largest coordinate that a moving body reaches, with its size: what rounding is of
  double size = 0.0;  // m: radius of the smallest moving body
  // 1/s, the largest Lyapunov exponent: slope of ln growth over time where it grows exponentially; else 0.
  double exponent = 0.0;
  // s: when rounding (2.2e-16 of the length) has grown to kVisible of the size; infinite if neighbours don't
  // part exponentially and the run ends before. Beyond the followed time it is extrapolated.
  double horizon = std::numeric_limits<double>::infinity();

  // Meanwhile on the run itself, for whoever plans a comparison:
  std::vector<TimedImpact> impacts;
  double followed = 0.0;         // s: the end of `time` and of `impacts`
  double resting_since = -1.0;   // s, < 0: never
  double largest_kinetic = 0.0;  // J
  double largest_speed = 0.0;    // m/s

  // Linear in ln growth between the times, and beyond the last with `exponent`.
  [[nodiscard]] double growth_at(double t) const;
};

// Part of a body's radius: a difference that begins to show.
inline constexpr double kVisible = 1e-3;

// Runs the scene and its neighbours under `method` up to `until`, or until rounding would be visible. Throws
// Stopped at the next step when `stop` asks for it, as do make_reference() and run_and_summarize().
[[nodiscard]] Chaos follow_neighbours(const RunSetup& setup, const Method& method, double until, int threads,
                                      const std::stop_token& stop = {});

// m: the largest coordinate of a body of `moving`, with its size.
[[nodiscard]] double reach(const State& state, const std::vector<Body>& bodies, const std::vector<int>& moving);

// m: radius of the smallest body of `moving`, up to `most`.
[[nodiscard]] double smallest(const std::vector<Body>& bodies, const std::vector<int>& moving, double most);

// The scene with its moving bodies displaced by `distance` (m), each in a direction of its own that is the same
// on every machine. Its bodies stand in a list.
[[nodiscard]] RunSetup displaced(const RunSetup& setup, double distance);

}  // namespace carom
