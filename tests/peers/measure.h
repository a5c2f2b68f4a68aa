#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/peers/engine.h"

// Runs of a world, their time, and figures of the bodies' motions.
namespace carom::peers {

inline constexpr double kNone = -std::numeric_limits<double>::infinity();

// Wall time of every step, in ms.
struct StepTimes {
  std::vector<double> ms;

  [[nodiscard]] double total() const { return sum(0); }
  [[nodiscard]] double mean() const { return total() / static_cast<double>(ms.size()); }
  [[nodiscard]] double mean_of_last_third() const {
    const std::size_t from = ms.size() - ms.size() / 3;
    return sum(from) / static_cast<double>(ms.size() - from);
  }
  [[nodiscard]] double median() const {
    std::vector<double> sorted = ms;
    std::sort(sorted.begin(), sorted.end());
    return sorted[sorted.size() / 2];
  }

 private:
  [[nodiscard]] double sum(std::size_t from) const {
    double s = 0.0;
    for (std::size_t i = from; i < ms.size(); ++i) s += ms[i];
    return s;
  }
};

// Steps of h for `seconds`; look(t) after each is not timed.
template <World W, class Look>
StepTimes run(W& world, double h, double seconds, const Look& look) {
  using Clock = std::chrono::steady_clock;
  const long steps = std::lround(seconds / h);
  StepTimes times;
  times.ms.reserve(static_cast<std::size_t>(steps));
  for (long k = 1; k <= steps; ++k) {
    const Clock::time_point from = Clock::now();
    world.step(h);
    times.ms.push_back(std::chrono::duration<double, std::milli>(Clock::now() - from).count());
    look(static_cast<double>(k) * h);
  }
  return times;
}

template <World W>
StepTimes run(W& world, double h, double seconds) {
  return run(world, h, seconds, [](double) {});
}

template <World W>
std::vector<Motion> motions(const W& world, const Scene& scene) {
  std::vector<Motion> list;
  for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i) list.push_back(world.motion(i));
  return list;
}

// The deepest penetration of the engine's contact points (m); kNone without any.
template <World W>
double deepest(const W& world) {
  double most = kNone;
  for (const double overlap : world.overlaps()) most = std::max(most, overlap);
  return most;
}

[[nodiscard]] double speed(const Motion& m);                                                  // m/s
[[nodiscard]] double kinetic_energy(const Scene& scene, const std::vector<Motion>& motions);  // J
// Of the movable bodies, in m/s.
[[nodiscard]] double rms_speed(const Scene& scene, const std::vector<Motion>& motions);

// Walls around discs: planes at these coordinates (m).
struct Container {
  double left = -std::numeric_limits<double>::infinity();
  double right = std::numeric_limits<double>::infinity();
  double floor = -std::numeric_limits<double>::infinity();
};

// From the poses alone, over touching pairs: discs of one radius with each other and with the container.
struct Penetrations {
  double largest = 0.0;  // m
  double mean = 0.0;     // m
};
[[nodiscard]] Penetrations disc_penetrations(const Scene& scene, const std::vector<Motion>& motions,
                                             double radius, const Container& container);

}  // namespace carom::peers
