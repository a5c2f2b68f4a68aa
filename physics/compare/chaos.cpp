#include "physics/compare/chaos.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "physics/math/cancelled.h"
#include "physics/math/least_squares.h"
#include "physics/math/parallel.h"
#include "physics/run/run_setup.h"
#include "physics/step/run_clock.h"

namespace carom {
namespace {

constexpr std::array kDisplacements = {1e-7, 1e-9, 1e-11, 1e-13};  // of the length
constexpr int kLooks = 400;                                        // comparisons with the neighbours, about
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
// Exponential growth adds as much to ln growth in the second half of the time as in the first; a power law
// adds only a small part of it.
constexpr double kLeastSecondHalf = 0.3;
constexpr double kLeastGrowth = 100.0;

// A unit vector for each body, the same on every machine.
std::vector<Vec2> directions(std::size_t count) {
  std::mt19937_64 random(1);
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < count; ++i) {
    const double turn = static_cast<double>(random() >> 11) * 0x1p-53;
    out.emplace_back(std::cos(2.0 * std::numbers::pi * turn), std::sin(2.0 * std::numbers::pi * turn));
  }
  return out;
}

// m: the largest distance of a body from itself in another run, at its centre or, by its turn, at its rim.
double largest_distance(const State& a, const State& b, const std::vector<MovingBody>& moving) {
  double largest = 0.0;
  for (const auto& [i, radius] : moving) {
    largest = std::fmax(largest, (a.position(i) - b.position(i)).norm());
    largest = std::fmax(largest, radius * std::abs(a.q.col(i)[2] - b.q.col(i)[2]));
  }
  return largest;
}

// Slope of ln growth over time, without its first tenth.
double slope(const Chaos& c) {
  const double last = std::log(c.growth.back());
  std::vector<Vec2> points;
  for (std::size_t k = 0; k < c.time.size(); ++k) {
    const double y = std::log(c.growth[k]);
    if (y >= 0.1 * last) points.emplace_back(c.time[k], y);
  }
  return points.size() < 2 ? 0.0 : fit_line(points).slope;
}

}  // namespace

double reach(const State& state, const std::vector<Body>& bodies, const std::vector<MovingBody>& moving) {
  double length = 0.0;
  for (const MovingBody& m : moving) {
    const double radius = bounding_radius(bodies[static_cast<std::size_t>(m.index)].shape);
    length = std::max(length, state.position(m.index).lpNorm<Eigen::Infinity>() + radius);
  }
  return length;
}

double smallest(const std::vector<Body>& bodies, const std::vector<MovingBody>& moving, double most) {
  for (const MovingBody& m : moving)
    most = std::min(most, bounding_radius(bodies[static_cast<std::size_t>(m.index)].shape));
  return most;
}

RunSetup displaced(const RunSetup& setup, double distance) {
  RunSetup beside = setup;
  beside.scene.bodies = all_bodies(setup.scene);
  beside.scene.generators.clear();
  const std::vector<Vec2> where = directions(beside.scene.bodies.size());
  for (const MovingBody& m : moving_bodies(beside.scene.bodies)) {
    const auto body = static_cast<std::size_t>(m.index);
    beside.scene.bodies[body].position += distance * where[body];
  }
  return beside;
}

double Chaos::growth_at(double t) const {
  if (time.empty() || t <= time.front()) return 1.0;
  if (t >= time.back()) return growth.back() * std::exp(exponent * (t - time.back()));
  const auto next = std::upper_bound(time.begin(), time.end(), t) - time.begin();
  const auto k = static_cast<std::size_t>(next);
  const double share = (t - time[k - 1]) / (time[k] - time[k - 1]);
  return std::exp(std::lerp(std::log(growth[k - 1]), std::log(growth[k]), share));
}

Chaos follow_neighbours(const RunSetup& setup, const Method& method, double until, int threads,
                        const std::stop_token& stop) {
  RunSetup plain = setup;
  plain.method = method;
  plain.scene.bodies = all_bodies(setup.scene);
  plain.scene.generators.clear();
  const std::vector<MovingBody> moving = moving_bodies(plain.scene.bodies);

  Chaos c;
  c.time = {0.0};
  c.growth = {1.0};
  std::vector<Simulation> runs;
  runs.emplace_back(plain);
  c.largest_kinetic = runs.front().totals().kinetic();
  c.length = reach(runs.front().state(), plain.scene.bodies, moving);
  c.size = smallest(plain.scene.bodies, moving, c.length);
  const double first_length = c.length;
  for (const double displacement : kDisplacements) {
    runs.emplace_back(displaced(plain, displacement * first_length));
  }

  // Whole steps between two comparisons.
  const double steps = std::max(1.0, std::round(until / kLooks / method.step));
  const double interval = std::min(until, steps * method.step);
  std::array<double, kDisplacements.size()> parted{};  // m
  std::array<bool, kDisplacements.size()> near{};
  near.fill(true);
  bool visible = moving.empty();
  for (int look = 1; !visible && step_towards(until, c.followed, method.step) > 0.0; ++look) {
    const double time = std::min(until, look * interval);
    parallel_for(static_cast<int>(runs.size()), threads, [&](int k) {
      if (k > 0 && !near[static_cast<std::size_t>(k - 1)]) return;
      Simulation& s = runs[static_cast<std::size_t>(k)];
      s.advance_to(time, [&] {
        throw_if_cancelled(stop);
        if (k > 0) return;
        for (const ImpactRecord& i : s.last_impacts()) c.impacts.push_back({i.time, i.a, i.b});
        c.largest_kinetic = std::fmax(c.largest_kinetic, s.totals().kinetic());
      });
    });
    const State& base = runs.front().state();
    if (runs.front().lost()) {
      c.followed = runs.front().time();
      break;
    }
    c.followed = time;
    c.length = std::max(c.length, reach(base, plain.scene.bodies, moving));
    for (const auto& [i, radius] : moving) {
      c.largest_speed = std::fmax(c.largest_speed, base.velocity(i).norm());
      c.largest_rim_speed = std::fmax(c.largest_rim_speed, radius * std::abs(base.v.col(i)[2]));
      c.arc = std::fmax(c.arc, radius * std::abs(base.q.col(i)[2]));
    }

    const double linear = kVisible * c.size;  // m: up to here neighbouring bodies move linearly
    double growth = 0.0;
    for (std::size_t k = 0; k < kDisplacements.size(); ++k) {
      if (!near[k]) continue;
      parted[k] = largest_distance(runs[k + 1].state(), base, moving);
      near[k] = parted[k] < linear;
      if (near[k] && growth == 0.0) growth = parted[k] / (kDisplacements[k] * first_length);
    }
    if (!near.back()) break;
    c.time.push_back(time);
    c.growth.push_back(std::max(c.growth.back(), growth));
    visible = c.growth.back() * kEpsilon * c.length > linear;
    if (visible) c.horizon = time;
  }
  c.resting_since = runs.front().notices().resting_since;

  const double most = c.growth.back();
  const double half = c.growth_at(0.5 * c.time.back());
  if (most > kLeastGrowth && std::log(most / half) > kLeastSecondHalf * std::log(most)) c.exponent = slope(c);
  const double needed = kVisible * c.size / (kEpsilon * c.length);
  if (!std::isfinite(c.horizon) && c.exponent > 0.0) {
    c.horizon = c.time.back() + std::log(needed / most) / c.exponent;
  } else if (!std::isfinite(c.horizon) && !near.back()) {
    c.horizon = c.time.back();  // the nearest neighbour separated at once, as where impacts change their order
  }
  return c;
}

}  // namespace carom
