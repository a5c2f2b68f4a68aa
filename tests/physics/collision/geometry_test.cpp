#include "physics/model/geometry.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

#include "physics/collision/broad_phase.h"
#include "physics/collision/contact.h"
#include "physics/collision/pair_contact.h"
#include "tests/support/body_literal.h"
#include "tests/support/scenes.h"

namespace carom {
namespace {

using namespace test::literals;

using test::disc;
using test::wall;

double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
}

// The signed distance of a point to a turned rectangle by brute force: the least distance to its four edges,
// each as a segment between two corners of the plane, and the sign by a half-plane test of each edge.
double signed_distance(const Vec2& p, const Vec2& center, const Box& box, double angle) {
  const Vec2 x(std::cos(angle), std::sin(angle));
  const Vec2 y(-x.y(), x.x());
  const double sx[] = {-1, 1, 1, -1};
  const double sy[] = {-1, -1, 1, 1};
  double least = std::numeric_limits<double>::infinity();
  bool inside = true;
  for (int i = 0; i < 4; ++i) {
    const int k = (i + 1) % 4;
    const Vec2 a = center + 0.5 * (sx[i] * box.width * x + sy[i] * box.height * y);
    const Vec2 b = center + 0.5 * (sx[k] * box.width * x + sy[k] * box.height * y);
    const Vec2 d = b - a;
    const double t = std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (p - a - t * d).norm());
    inside = inside && d.x() * (p - a).y() - d.y() * (p - a).x() >= 0.0;
  }
  return inside ? -least : least;
}

TEST(Geometry, DiscAgainstBoxAtAnyAngle) {
  std::mt19937_64 random(7);
  int inside = 0;
  for (int n = 0; n < 20000; ++n) {
    const double angle = uniform(random, -10.0, 10.0);
    const Box box{uniform(random, 0.1, 3.0), uniform(random, 0.1, 3.0)};
    const Vec2 center(uniform(random, -2.0, 2.0), uniform(random, -2.0, 2.0));
    const Vec2 p = center + Vec2(uniform(random, -3.0, 3.0), uniform(random, -3.0, 3.0));
    const double radius = uniform(random, 0.01, 1.0);
    const bool box_first = n % 2 == 0;
    std::vector<Body> bodies = {wall("box", center, box.width, box.height, angle),
                                disc("disc", p, {0, 0}, radius)};
    if (!box_first) std::swap(bodies[0], bodies[1]);
    const Geometry g = geometry(bodies);
    const Eigen::Vector3d q0 = initial_motion(bodies[0]).head<3>();
    const Eigen::Vector3d q1 = initial_motion(bodies[1]).head<3>();
    const Contact c = contact_between(g, 0_b, q0, 1_b, q1);

    const double distance = signed_distance(p, center, box, angle);
    if (distance < 0.0) ++inside;
    ASSERT_NEAR(c.gap, distance - radius, 1e-13);
    ASSERT_NEAR(c.normal.norm(), 1.0, 1e-14);
    // Moving the disc out along the normal by the overlap makes the two touch, moving it away opens the gap.
    const Vec2 out = box_first ? c.normal : Vec2(-c.normal);
    ASSERT_NEAR(signed_distance(p + (radius - distance) * out, center, box, angle), radius, 1e-12);
    // The contact point is half-way between the surfaces, on the normal through the disc's centre.
    ASSERT_NEAR((c.point - (p - (radius + 0.5 * c.gap) * out)).norm(), 0.0, 1e-13);
    if (c.gap > 0.0) {
      ASSERT_NEAR(signed_distance(c.point, center, box, angle), 0.5 * c.gap, 1e-12);
    }
    // The axis-aligned rectangle holds the body.
    const int b = box_first ? 0 : 1;
    const double most = std::abs(std::cos(angle)) * box.width / 2 + std::abs(std::sin(angle)) * box.height / 2;
    ASSERT_NEAR(g.extent(0, b), most, 1e-14);
  }
  EXPECT_GT(inside, 1000);
}

TEST(Geometry, Discs) {
  const std::vector<Body> bodies = {disc("a", {1, 2}, {0, 0}, 0.5), disc("b", {4, 6}, {0, 0}, 1.5)};
  const Geometry g = geometry(bodies);
  const Contact c = contact_between(g, 0_b, {1, 2, 9}, 1_b, {4, 6, -3});
  EXPECT_NEAR(c.gap, 3.0, 1e-15);
  EXPECT_NEAR((c.normal - Vec2(0.6, 0.8)).norm(), 0.0, 1e-15);
  EXPECT_NEAR((c.point - (Vec2(1, 2) + 2.0 * Vec2(0.6, 0.8))).norm(), 0.0, 1e-15);
  const Contact same = contact_between(g, 0_b, {1, 2, 0}, 1_b, {1, 2, 0});
  EXPECT_EQ(same.gap, -2.0);
  EXPECT_EQ(same.normal, Vec2(1, 0));
  EXPECT_TRUE(same.point.allFinite());
}

TEST(Geometry, DiscCentredInABoxLeavesByTheNearestFace) {
  const std::vector<Body> bodies = {wall("box", {0, 0}, 4.0, 1.0), disc("disc", {0, 0}, {0, 0}, 0.2)};
  const Geometry g = geometry(bodies);
  const Contact c = contact_between(g, 0_b, {0, 0, 0}, 1_b, {0, 0, 0});
  EXPECT_NEAR(c.gap, -0.7, 1e-15);
  EXPECT_EQ(std::abs(c.normal.y()), 1.0);
}

std::vector<BodyPair> all_pairs(const std::vector<Bounds>& bounds, const std::vector<std::uint8_t>& fixed) {
  std::vector<BodyPair> pairs;
  for (std::size_t a = 0; a < bounds.size(); ++a) {
    for (std::size_t b = a + 1; b < bounds.size(); ++b) {
      const Bounds& p = bounds[a];
      const Bounds& q = bounds[b];
      const bool apart =
          p.high.x() < q.low.x() || q.high.x() < p.low.x() || p.high.y() < q.low.y() || q.high.y() < p.low.y();
      if (!apart && !(fixed[a] != 0 && fixed[b] != 0))
        pairs.emplace_back(static_cast<int>(a), static_cast<int>(b));
    }
  }
  return pairs;
}

TEST(BroadPhase, FindsThePairsThatAllPairsFind) {
  std::mt19937_64 random(3);
  BroadPhase kept;  // its order is kept from call to call
  for (int round = 0; round < 300; ++round) {
    const int n = static_cast<int>(random() % 60);
    std::vector<Bounds> bounds(static_cast<std::size_t>(n));
    std::vector<std::uint8_t> fixed(bounds.size());
    for (std::size_t i = 0; i < bounds.size(); ++i) {
      // Whole numbers too, so that bounds often touch or are equal.
      const double unit = round % 2 == 0 ? 1.0 : 0.37;
      bounds[i].low = {unit * static_cast<double>(random() % 20), unit * static_cast<double>(random() % 20)};
      bounds[i].high =
          bounds[i].low + Eigen::Array2d(static_cast<double>(random() % 5), static_cast<double>(random() % 5));
      fixed[i] = random() % 3 == 0 ? 1 : 0;
    }
    ASSERT_EQ(kept.pairs(bounds, fixed), all_pairs(bounds, fixed)) << round;
  }
}

// Bodies that creep and grow stay within their skins for some rounds; then one leaves its.
TEST(BroadPhase, FindsThemWhereBodiesHardlyMove) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> draw(-1.0, 1.0);
  BroadPhase kept;
  std::vector<Bounds> bounds(100);
  std::vector<std::uint8_t> fixed(bounds.size(), 0);
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    bounds[i].low = {static_cast<double>(i % 10), static_cast<double>(i / 10)};
    bounds[i].high = bounds[i].low + 1.0;
    fixed[i] = i % 7 == 0 ? 1 : 0;
  }
  std::size_t most = 0;
  std::size_t least = bounds.size() * bounds.size();
  for (int round = 0; round < 2000; ++round) {
    for (Bounds& b : bounds) {
      const Eigen::Array2d by(0.005 * draw(random), 0.005 * draw(random));
      b.low += by;
      b.high += by + 0.002 * draw(random);
    }
    if (round % 100 == 99) std::swap(fixed[1], fixed[7]);
    ASSERT_EQ(kept.pairs(bounds, fixed), all_pairs(bounds, fixed)) << round;
    most = std::max(most, all_pairs(bounds, fixed).size());
    least = std::min(least, all_pairs(bounds, fixed).size());
  }
  EXPECT_GT(most, least + 30);  // pairs came and went
}

}  // namespace
}  // namespace carom
