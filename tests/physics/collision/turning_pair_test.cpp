#include "physics/collision/turning_pair.h"

#include <cstdlib>
#include <gtest/gtest.h>

#include "tests/support/convex_reference.h"
#include "tests/support/effort.h"

namespace carom {
namespace {

using test::kFirst;
using test::kSecond;
using test::kShapeKinds;
using test::ShapeKind;
using test::uniform;

// q(t) with constant acceleration and angular acceleration.
struct Path {
  Eigen::Vector3d q;
  Eigen::Vector3d v;
  Eigen::Vector3d acceleration;

  Eigen::Vector3d operator()(double t) const { return q + t * (v + 0.5 * t * acceleration); }
};

struct Flight {
  ConvexShapes shapes;
  Path path[2];
  double until;

  [[nodiscard]] double path_curvature() const {
    return (path[1].acceleration - path[0].acceleration).head<2>().norm();
  }
  [[nodiscard]] double curvature() const {
    double sum = path_curvature();
    for (int i = 0; i < 2; ++i) {
      if (shapes.core[ShapeIndex{i}] != Core::kHalfPlane) {
        sum += turning_curvature(shapes.core_radius[ShapeIndex{i}], fastest_spin(i), path[i].acceleration[2]);
      }
    }
    return sum;
  }
  [[nodiscard]] double fastest_spin(int i) const {
    return std::max(std::abs(path[i].v[2]), std::abs(path[i].v[2] + until * path[i].acceleration[2]));
  }
  [[nodiscard]] double turn(int i) const {
    return fastest_spin(i) * fastest_spin(i) + std::abs(path[i].acceleration[2]);
  }
  [[nodiscard]] TurningPair<Path, Path> sampler() const {
    return {shapes, kFirst, path[0], kSecond, path[1], path_curvature(), turn(0), turn(1)};
  }
};

Flight random_flight(std::mt19937_64& random, ShapeKind a, ShapeKind b) {
  Flight f;
  f.shapes = convex_shapes({test::random_shape(random, a), test::random_shape(random, b)});
  f.until = uniform(random, 0.05, 2.0);
  for (int i = 0; i < 2; ++i) {
    f.path[i].q = {uniform(random, -3.0, 3.0), uniform(random, -3.0, 3.0), uniform(random, -3.0, 3.0)};
    f.path[i].v = {uniform(random, -3.0, 3.0), uniform(random, -3.0, 3.0), uniform(random, -6.0, 6.0)};
    f.path[i].acceleration = {uniform(random, -3.0, 3.0), uniform(random, -9.0, 9.0),
                              uniform(random, -3.0, 3.0)};
    if (random() % 4 == 0) f.path[i].acceleration.setZero();
    if (random() % 4 == 0) f.path[i].v[2] = f.path[i].acceleration[2] = 0.0;
    if (f.shapes.core[ShapeIndex{i}] == Core::kHalfPlane) f.path[i].v[2] = f.path[i].acceleration[2] = 0.0;
  }
  // Body b aims at a's surroundings, from outside its reach.
  const double angle = uniform(random, 0.0, 6.3);
  const double reach = f.shapes.core_radius[kFirst] < 9.0 && f.shapes.core_radius[kSecond] < 9.0
                           ? f.shapes.radius[kFirst] + f.shapes.radius[kSecond]
                           : 2.0;
  const Vec2 from = (reach + uniform(random, 0.0, 2.0)) * Vec2(std::cos(angle), std::sin(angle));
  const Vec2 to = reach * Vec2(uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0));
  const double time = f.until * uniform(random, 0.2, 1.0);
  f.path[1].q.head<2>() = f.path[0].q.head<2>() + from;
  f.path[1].v.head<2>() = f.path[0].v.head<2>() + (to - from) / time -
                          0.5 * time * (f.path[1].acceleration - f.path[0].acceleration).head<2>();
  return f;
}

// The first contact of 10⁵ random flights, of all pairs of kinds (10⁶ in the long tests), against dense
// sampling. The reference looks at the gap at equal steps of time. Where three samples have their least in the
// middle, golden-section search goes down to the bottom between them. A sample or a bottom below -tolerance
// before the time that was found, or without one, is a miss; so is a time at which the gap is not zero.
TEST(TurningPair, RandomFlightsAgainstDenseSampling) {
  const int pairs = test::by_effort(20'000, 100'000, 1'000'000);
  constexpr int kSamples = 64;
  constexpr double kTolerance = 1e-13;
  int searched = 0;
  int hits = 0;
  int brief = 0;
  for (int n = 0; searched < pairs; ++n) {
    const int kind = n % (kShapeKinds * kShapeKinds);
    if (kind == kShapeKinds * kShapeKinds - 1) continue;
    std::mt19937_64 random(static_cast<std::uint64_t>(n));
    const Flight f = random_flight(random, ShapeKind{kind / kShapeKinds}, ShapeKind{kind % kShapeKinds});
    const auto sample = f.sampler();
    const TurningSample first = sample(0.0);
    if (first.gap <= kTolerance) continue;
    const auto found = first_contact(sample, 0.0, first, f.until, sample(f.until), f.curvature(), kTolerance);
    ++searched;
    const double end = found ? *found : f.until;
    const auto gap = [&](double t) { return sample(t).gap; };
    if (found) {
      ++hits;
      ASSERT_GE(gap(end), 0.0) << n;
      ASSERT_LE(gap(end), kTolerance) << n;
      if (gap(end + f.until / kSamples) > 0.0) ++brief;  // the samples alone might not see it
    }
    double before = first.gap;
    double here = gap(end / kSamples);
    for (int k = 1; k < kSamples; ++k) {
      const double after = gap(end * (k + 1) / kSamples);
      ASSERT_GE(here, -kTolerance) << n << ": before " << end << " at " << end * k / kSamples;
      if (here <= before && here <= after) {
        double low = end * (k - 1) / kSamples;
        double high = end * (k + 1) / kSamples;
        for (int i = 0; i < 30; ++i) {
          const double x = high - (high - low) / std::numbers::phi;
          const double y = low + (high - low) / std::numbers::phi;
          (gap(x) < gap(y) ? high : low) = gap(x) < gap(y) ? y : x;
        }
        ASSERT_GE(gap(0.5 * (low + high)), -kTolerance)
            << n << ": before " << end << " at " << 0.5 * (low + high);
      }
      before = here;
      here = after;
    }
  }
  EXPECT_GT(hits, pairs / 2);
  EXPECT_GT(brief, pairs / 1000);
}

// A corner that passes a floor: a bar of half length 1 spins over it, its end at depth `depth` at the lowest.
TEST(TurningPair, GrazingCornerIsNeitherMissedNorInvented) {
  for (const double depth : {1e-6, 1e-9, 1e-12}) {
    for (const double sign : {-1.0, 1.0}) {
      for (const double spin : {0.5, 3.0, 40.0}) {
        Flight f;
        f.until = 3.0 / spin;
        const Vec2 corner(0.6, 0.8);
        f.shapes = convex_shapes(
            {half_plane_shape({0, 1}, 0.0), polygon_shape({-corner, {0.3, -0.4}, corner, {-0.3, 0.4}})});
        const double lowest =
            std::atan2(0.8, 0.6) + 0.5 * std::numbers::pi;  // where -corner points down: half way
        f.path[0] = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
        f.path[1] = {
            {0.0, 1.0 - sign * depth, std::numbers::pi - lowest - 1.5}, {2.0, 0.0, spin}, {0.0, 0.0, 0.0}};
        const auto sample = f.sampler();
        const auto found =
            first_contact(sample, 0.0, sample(0.0), f.until, sample(f.until), f.curvature(), 1e-14);
        ASSERT_EQ(found.has_value(), sign > 0.0) << depth << " " << spin;
        // cos(ω (t - t₀)) = 1 - depth; the angle is conditioned as its square root.
        if (found) {
          const double early = 1.5 - std::acos(1.0 - depth);
          EXPECT_NEAR(*found * spin, early, 1e-15 / std::sqrt(depth) + 1e-14) << depth << " " << spin;
        }
      }
    }
  }
}

// Corner past corner: two squares on their tips pass at a distance, one of them falling.
TEST(TurningPair, CornerPassesCorner) {
  const double tip = std::sqrt(0.5);
  for (const double off : {1e-9, -1e-9}) {
    Flight f;
    f.until = 2.0;
    f.shapes = convex_shapes({box_shape(1.0, 1.0), box_shape(1.0, 1.0)});
    const double turn = 0.25 * std::numbers::pi;
    f.path[0] = {{0.0, 0.0, turn}, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    // Over the other at t = 1, at its lowest then.
    f.path[1] = {{-3.0, 2.0 * tip + off + 2.0, turn}, {3.0, -4.0, 0.0}, {0.0, 4.0, 0.0}};
    const auto sample = f.sampler();
    const auto found = first_contact(sample, 0.0, sample(0.0), f.until, sample(f.until), f.curvature(), 1e-14);
    EXPECT_EQ(found.has_value(), off < 0.0) << off;
  }
}

// How many samples a search takes: fast spin far away costs none.
TEST(TurningPair, FastSpinFarAwayIsNotSearched) {
  Flight f;
  f.until = 10.0;
  f.shapes = convex_shapes({box_shape(1.0, 0.1), box_shape(1.0, 0.1)});
  f.path[0] = {{0.0, 0.0, 0.0}, {0.0, 0.0, 1000.0}, Eigen::Vector3d::Zero()};
  f.path[1] = {{-5.0, 1.2, 0.0}, {1.0, 0.0, -1000.0}, Eigen::Vector3d::Zero()};
  int samples = 0;
  const auto pair = f.sampler();
  struct Counted {
    const TurningPair<Path, Path>& pair;
    int& samples;
    TurningSample operator()(double t) const { return ++samples, pair(t); }
    double separation(const Vec2& n, const TurningSample& at) const { return pair.separation(n, at); }
    bool clear(const TurningSample& a, const TurningSample& b, double width) const {
      return pair.clear(a, b, width);
    }
  };
  const Counted counted{pair, samples};
  const auto found = first_contact(counted, 0.0, pair(0.0), f.until, pair(f.until), f.curvature(), 1e-14);
  EXPECT_FALSE(found.has_value());
  EXPECT_EQ(samples, 0);
}

}  // namespace
}  // namespace carom
