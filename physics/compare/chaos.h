#pragma once

#include <algorithm>
#include <limits>
#include <stop_token>
#include <vector>

#include "physics/compare/comparison.h"
#include "physics/run/run_setup.h"

namespace carom {

// Separation of runs that start side by side, and what it means for a comparison: rounding is such a
// neighbour.
//
// A scene is run together with neighbours whose bodies are displaced at the start, all in the same directions
// but by 1e-7, 1e-9, ... 1e-13 of the scene's length. growth(t) is the largest distance of a body from its
// neighbour, or of their angles times its turning_radius(), over the initial displacement. It is read from the
// most displaced neighbour that is still close enough for linear motion; when that one gets too far away, the
// next takes over, which has the same effect as renormalising one neighbour. Positions are continuous through
// impacts, so this is valid across them (Benettin et al., Meccanica 15 (1980) 9, with several neighbours
// instead of rescaled ones).
struct Chaos {
  std::vector<double> time;    // s
  std::vector<double> growth;  // dimensionless, >= 1: the running maximum
  double length =
      0.0;  // m: the largest coordinate that a moving body reaches, plus its size: the scale of rounding
  double size = 0.0;  // m: radius of the smallest moving body
  double arc = 0.0;   // m: the largest angle that a moving body reaches times its turning_radius()
  // 1/s, the largest Lyapunov exponent: slope of ln growth over time if the growth is exponential, otherwise
  // 0.
  double exponent = 0.0;
  // s: when rounding (2.2e-16 of the length) has grown to kVisible of the size; infinite if neighbours don't
  // separate exponentially and the run ends before. Extrapolated beyond the followed time.
  double horizon = std::numeric_limits<double>::infinity();

  // On the run itself, for planning a comparison:
  std::vector<TimedImpact> impacts;
  double followed = 0.0;           // s: the end of `time` and of `impacts`
  double resting_since = -1.0;     // s, < 0: never
  double largest_kinetic = 0.0;    // J
  double largest_speed = 0.0;      // m/s
  double largest_rim_speed = 0.0;  // m/s: of a spin times the turning_radius()

  // m: the scale of rounding in angles.
  [[nodiscard]] double largest_arc() const { return std::max(length, arc); }
  // Linear in ln growth between the times; extrapolated with `exponent` beyond the last.
  [[nodiscard]] double growth_at(double t) const;
};

// Fraction of a body's radius at which a difference becomes visible.
inline constexpr double kVisible = 1e-3;

// Runs the scene and its neighbours under `method` up to `until`, or until rounding would be visible. Throws
// Cancelled at the next step once `stop` is requested, as do make_reference() and run_and_summarize().
[[nodiscard]] Chaos follow_neighbours(const RunSetup& setup, const Method& method, double until, int threads,
                                      const std::stop_token& stop = {});

// m: the largest coordinate of a body of `moving`, plus its size.
[[nodiscard]] double reach(const State& state, const std::vector<Body>& bodies,
                           const std::vector<MovingBody>& moving);

// m: radius of the smallest body of `moving`, up to `most`.
[[nodiscard]] double smallest(const std::vector<Body>& bodies, const std::vector<MovingBody>& moving,
                              double most);

// The scene with its moving bodies displaced by `distance` (m), each in its own direction, which is the same
// on every machine. Generated bodies become listed ones.
[[nodiscard]] RunSetup displaced(const RunSetup& setup, double distance);

}  // namespace carom
