#include "physics/collision/pair_contact.h"

#include <functional>
#include <gtest/gtest.h>

#include "physics/model/geometry.h"
#include "tests/support/body_literal.h"
#include "tests/support/convex_reference.h"
#include "tests/support/scenes.h"

namespace carom {
namespace {

using namespace test::literals;

using test::kFirst;
using test::kSecond;
using test::kShapeKinds;
using test::kShapeNames;
using test::Outline;
using test::outline;
using test::ShapeKind;
using test::uniform;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
// Of the reference's scale; the error of the world's coordinates comes on top.
constexpr double kGapRounding = 16.0 * kEpsilon;

struct Pair {
  ConvexShape shape[2];
  Eigen::Vector3d q[2];

  [[nodiscard]] ConvexShapes shapes() const { return convex_shapes({shape[0], shape[1]}); }
};

Pose pose(const ConvexShapes& s, const Pair& p, int i) { return pose_of(s, ShapeIndex{i}, p.q[i]); }

Pair random_pair(std::mt19937_64& random, ShapeKind a, ShapeKind b) {
  Pair p{{test::random_shape(random, a), test::random_shape(random, b)}, {}};
  for (Eigen::Vector3d& q : p.q) {
    q = {uniform(random, -1.5, 1.5), uniform(random, -1.5, 1.5), uniform(random, -7.0, 7.0)};
    // Parallel faces within rounding.
    if (random() % 4 == 0) q[2] = 0.5 * std::numbers::pi * static_cast<double>(random() % 4);
  }
  if (random() % 16 == 0) p.q[1].head<2>() = p.q[0].head<2>();
  if (random() % 4 == 0) {
    // Next to touching, from either side.
    const ConvexShapes s = p.shapes();
    const Gap g = gap_between(s, kFirst, pose(s, p, 0), kSecond, pose(s, p, 1));
    const double off[] = {0.0, 1e-15, -1e-15, 1e-9, -1e-9, 1e-3, -1e-3};
    p.q[1].head<2>() -= (g.gap + off[random() % 7]) * g.normal;
  }
  return p;
}

void each_pair_of_kinds(int pairs, const std::function<void(const Pair&, const std::string&)>& look) {
  const int each = pairs / (kShapeKinds * kShapeKinds - 1) + 1;
  for (int a = 0; a < kShapeKinds; ++a) {
    for (int b = 0; b < kShapeKinds; ++b) {
      if (a == kShapeKinds - 1 && b == kShapeKinds - 1) continue;
      std::mt19937_64 random(static_cast<std::uint64_t>(100 * a + b));
      for (int n = 0; n < each; ++n) {
        look(random_pair(random, ShapeKind{a}, ShapeKind{b}),
             std::string(kShapeNames[a]) + " and " + kShapeNames[b] + ", case " + std::to_string(n));
        if (testing::Test::HasFailure()) return;
      }
    }
  }
}

// Gap, normal and point of 10⁵ random pairs against the definitions in extended precision.
TEST(PairContact, AgainstBruteForce) {
  int apart = 0;
  int overlap = 0;
  each_pair_of_kinds(100'000, [&](const Pair& p, const std::string& name) {
    const ConvexShapes s = p.shapes();
    Outline a = outline(p.shape[0], p.q[0]);
    Outline b = outline(p.shape[1], p.q[1]);
    test::grow_thin(a, b);
    const double tolerance = kGapRounding * test::scale_of(a, b);
    const double in_world =
        2.0 * tolerance + 8.0 * kEpsilon * (p.q[0].head<2>().norm() + p.q[1].head<2>().norm());
    const Contact c = contact_between(s, kFirst, pose(s, p, 0), kSecond, pose(s, p, 1));
    const auto expected = static_cast<double>(test::reference_gap(a, b));
    (expected > 0.0 ? apart : overlap) += 1;
    ASSERT_NEAR(c.gap, expected, tolerance) << name;
    ASSERT_NEAR(c.normal.norm(), 1.0, 4.0 * kEpsilon) << name;
    // The bodies are as far apart along the normal as the gap says. (The direction from vertex to vertex is
    // rounded too: by the share that their distance is.)
    const test::Point n{c.normal.x(), c.normal.y()};
    ASSERT_NEAR(static_cast<double>(test::separation_along(a, b, n)), expected, 2.0 * tolerance) << name;
    // The point is half-way between the surfaces there.
    test::Real reach = -std::numeric_limits<test::Real>::infinity();
    for (const test::Point& v : a.vertices) reach = std::max(reach, n.x * v.x + n.y * v.y);
    ASSERT_NEAR(c.normal.dot(c.point), static_cast<double>(reach + a.rounding) + 0.5 * expected, in_world)
        << name;
    const Gap gap = gap_between(s, kFirst, pose(s, p, 0), kSecond, pose(s, p, 1));
    ASSERT_EQ(gap.gap, c.gap) << name;
    ASSERT_EQ(gap.normal, c.normal) << name;
    if (expected > 0.0) {
      // In the middle of faces that are parallel to 1e-9 the gap is as much wider.
      const double flat = in_world + 1e-9 * test::scale_of(a, b);
      for (const Outline* o : {&a, &b}) {
        const Outline point{{{c.point.x(), c.point.y()}}, {}};
        ASSERT_NEAR(static_cast<double>(test::reference_gap(*o, point)), 0.5 * expected, flat) << name;
      }
    }
    // No direction at all parts them more.
    if (!a.half_plane && !b.half_plane) {
      for (int k = 0; k < 16; ++k) {
        const double angle = 0.4 * k;
        ASSERT_LE(
            separation(s, kFirst, pose(s, p, 0), kSecond, pose(s, p, 1), {std::cos(angle), std::sin(angle)}),
            c.gap + tolerance)
            << name;
      }
    }
    ASSERT_NEAR(separation(s, kFirst, pose(s, p, 0), kSecond, pose(s, p, 1), c.normal), c.gap, tolerance)
        << name;
  });
  EXPECT_GT(apart, 20'000);
  EXPECT_GT(overlap, 20'000);
}

TEST(PairContact, SameFromBothSidesAndAnywhere) {
  std::mt19937_64 random(5);
  each_pair_of_kinds(20'000, [&](const Pair& p, const std::string& name) {
    const ConvexShapes s = p.shapes();
    const Contact c = contact_between(s, kFirst, pose(s, p, 0), kSecond, pose(s, p, 1));
    const Contact back = contact_between(s, kSecond, pose(s, p, 1), kFirst, pose(s, p, 0));
    const double scale = test::scale_of(outline(p.shape[0], p.q[0]), outline(p.shape[1], p.q[1]));
    ASSERT_NEAR(back.gap, c.gap, kGapRounding * scale) << name;
    ASSERT_NEAR(separation(s, kFirst, pose(s, p, 0), kSecond, pose(s, p, 1), -back.normal), c.gap,
                2.0 * kGapRounding * scale)
        << name;

    const double turn = uniform(random, -3.0, 3.0);
    const Vec2 shift(uniform(random, -9.0, 9.0), uniform(random, -9.0, 9.0));
    const Pose motion{shift, std::cos(turn), std::sin(turn)};
    Pair moved = p;
    for (Eigen::Vector3d& q : moved.q) {
      q.head<2>() = shift + motion.turned(q.head<2>());
      q[2] += turn;
    }
    const Contact there = contact_between(s, kFirst, pose(s, moved, 0), kSecond, pose(s, moved, 1));
    const double rounding = kGapRounding * (scale + 20.0);
    ASSERT_NEAR(there.gap, c.gap, rounding) << name;
    ASSERT_NEAR(separation(s, kFirst, pose(s, moved, 0), kSecond, pose(s, moved, 1), motion.turned(c.normal)),
                there.gap, 2.0 * rounding)
        << name;
  });
}

// Discs and boxes as they have always been, to the last bit.
TEST(PairContact, DiscsAndBoxesToTheLastBit) {
  std::mt19937_64 random(3);
  for (int n = 0; n < 20'000; ++n) {
    std::vector<Body> bodies = {test::disc("a", {0, 0}, {0, 0}, uniform(random, 0.01, 1.0)),
                                test::disc("b", {0, 0}, {0, 0}, uniform(random, 0.01, 1.0))};
    std::vector<ConvexShape> list = {disc_shape(std::get<Disc>(bodies[0].shape).radius),
                                     disc_shape(std::get<Disc>(bodies[1].shape).radius)};
    const std::size_t boxed = random() % 3;
    if (boxed < 2) {
      bodies[boxed].shape = Box{uniform(random, 0.1, 3.0), uniform(random, 0.1, 3.0)};
      list[boxed] =
          box_shape(std::get<Box>(bodies[boxed].shape).width, std::get<Box>(bodies[boxed].shape).height);
    }
    const Geometry g = geometry(bodies);
    const ConvexShapes s = convex_shapes(list);
    Eigen::Vector3d q[2];
    for (Eigen::Vector3d& x : q) {
      x = {uniform(random, -2.0, 2.0), uniform(random, -2.0, 2.0), uniform(random, -9.0, 9.0)};
    }
    const Contact before = contact_between(g, 0_b, q[0], 1_b, q[1]);
    const Contact now =
        contact_between(s, kFirst, pose_of(s, kFirst, q[0]), kSecond, pose_of(s, kSecond, q[1]));
    ASSERT_EQ(now.gap, before.gap) << n;
    ASSERT_EQ(now.normal, before.normal) << n;
    ASSERT_EQ(now.point, before.point) << n;
  }
}

TEST(PairContact, FarFromTheOriginOnlyTheCoordinatesRound) {
  // Both positions are exact there, so the gap is as good as at the origin.
  const ConvexShapes s =
      convex_shapes({box_shape(1.0, 1.0), polygon_shape({{-0.5, -0.5}, {0.5, 0.0}, {-0.5, 0.5}})});
  const Vec2 far(0x1p40, -0x1p39);
  for (const double angle : {0.0, 0.3, 2.0}) {
    const Gap near = gap_between(s, kFirst, pose_of(s, kFirst, {0, 0, angle}), kSecond,
                                 pose_of(s, kSecond, {1.5, 0.25, 1.0}));
    const Gap there = gap_between(s, kFirst, pose_of(s, kFirst, {far.x(), far.y(), angle}), kSecond,
                                  pose_of(s, kSecond, {far.x() + 1.5, far.y() + 0.25, 1.0}));
    EXPECT_EQ(near.gap, there.gap);
    EXPECT_EQ(near.normal, there.normal);
  }
}

TEST(PairContact, KnownCases) {
  const auto contact = [](const ConvexShape& a, const Eigen::Vector3d& qa, const ConvexShape& b,
                          const Eigen::Vector3d& qb) {
    const ConvexShapes s = convex_shapes({a, b});
    return contact_between(s, kFirst, pose_of(s, kFirst, qa), kSecond, pose_of(s, kSecond, qb));
  };
  // Faces that touch: the middle of what they share.
  Contact c = contact(box_shape(4.0, 1.0), {0, 0, 0}, box_shape(1.0, 1.0), {2.0, 1.0, 0});
  EXPECT_EQ(c.gap, 0.0);
  EXPECT_EQ(c.normal, Vec2(0, 1));
  EXPECT_EQ(c.point, Vec2(1.75, 0.5));
  c = contact(half_plane_shape({0, 1}, 0.0), {0, 0, 0}, box_shape(2.0, 1.0), {3.0, 0.5, 0});
  EXPECT_EQ(c.gap, 0.0);
  EXPECT_EQ(c.point, Vec2(3.0, 0.0));
  // Corner to corner.
  c = contact(box_shape(1.0, 1.0), {0, 0, 0}, box_shape(1.0, 1.0), {4.0, 5.0, 0});
  EXPECT_NEAR(c.gap, 5.0, 1e-15);
  EXPECT_NEAR((c.normal - Vec2(0.6, 0.8)).norm(), 0.0, 1e-15);
  EXPECT_NEAR((c.point - Vec2(2.0, 2.5)).norm(), 0.0, 1e-15);
  // Capsules that cross, and thin walls end to end on one line.
  c = contact(segment_shape({-1, 0}, {1, 0}, 0.1), {0, 0, 0}, segment_shape({-1, 0}, {1, 0}, 0.2),
              {0, 0.25, 1.5});
  EXPECT_LT(c.gap, -0.3);
  c = contact(segment_shape({-1, 0}, {1, 0}), {0, 0, 0.7}, segment_shape({-2, 0}, {2, 0}),
              {4.0 * std::cos(0.7), 4.0 * std::sin(0.7), 0.7});
  EXPECT_NEAR(c.gap, 1.0 - 2.0 * ConvexShapes::kThinWalls, 1e-15);
  EXPECT_NEAR((c.normal - Vec2(std::cos(0.7), std::sin(0.7))).norm(), 0.0, 1e-15);
  // Centres that coincide.
  EXPECT_EQ(contact(disc_shape(0.5), {1, 2, 0}, disc_shape(0.25), {1, 2, 0}).normal, Vec2(1, 0));
  EXPECT_EQ(contact(box_shape(1.0, 2.0), {1, 2, 0}, box_shape(1.0, 2.0), {1, 2, 0}).gap, -1.0);
  c = contact(segment_shape({-1, 0}, {1, 0}, 0.1), {0, 0, 0}, segment_shape({-1, 0}, {1, 0}, 0.2), {0, 0, 0});
  EXPECT_NEAR(c.gap, -0.3, 1e-15);
  EXPECT_EQ(std::abs(c.normal.y()), 1.0);
}

TEST(ApartUntil, NoOverlapBefore) {
  std::mt19937_64 random(8);
  int finite = 0;
  for (int n = 0; n < 20'000; ++n) {
    const Pair p = [&] {
      Pair touching = random_pair(random, ShapeKind{static_cast<int>(random() % 6)},
                                  ShapeKind{static_cast<int>(random() % kShapeKinds)});
      const ConvexShapes s = touching.shapes();
      const Gap g = gap_between(s, kFirst, pose(s, touching, 0), kSecond, pose(s, touching, 1));
      touching.q[1].head<2>() -= g.gap * g.normal;
      return touching;
    }();
    const ConvexShapes s = p.shapes();
    const Gap g = gap_between(s, kFirst, pose(s, p, 0), kSecond, pose(s, p, 1));
    if (std::abs(g.gap) > 1e-13) continue;  // overlapping corners: another feature is next
    Twist twist[2];
    for (int i = 0; i < 2; ++i) {
      twist[i].velocity = {uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0)};
      if (s.core[ShapeIndex{i}] != Core::kHalfPlane) twist[i].spin = uniform(random, -3.0, 3.0);
    }
    double curvature = 0.0;
    for (int i = 0; i < 2; ++i) {
      if (twist[i].spin != 0.0)
        curvature += turning_curvature(s.core_radius[ShapeIndex{i}], twist[i].spin, 0.0);
    }
    const double until =
        apart_until(s, kFirst, pose(s, p, 0), twist[0], kSecond, pose(s, p, 1), twist[1], g.normal, curvature);
    ASSERT_GE(until, 0.0);
    if (until > 0.0 && until < 10.0) ++finite;
    for (int k = 1; k <= 20; ++k) {
      const double t = std::min(until, 10.0) * k / 20.0;
      const auto at = [&](int i) {
        Eigen::Vector3d q = p.q[i];
        q.head<2>() += t * twist[i].velocity;
        q[2] += t * twist[i].spin;
        return pose_of(s, ShapeIndex{i}, q);
      };
      ASSERT_GE(gap_between(s, kFirst, at(0), kSecond, at(1)).gap, -1e-12) << n << ", " << t << " of " << until;
    }
  }
  EXPECT_GT(finite, 5000);
  // Two discs that part at u under an acceleration K are back after 2u/K.
  const ConvexShapes s = convex_shapes({disc_shape(1.0), disc_shape(2.0)});
  EXPECT_NEAR(apart_until(s, kFirst, {}, {}, kSecond, {{3.0, 0.0}, 1.0, 0.0}, {{0.5, 7.0}, 100.0}, {1, 0}, 4.0),
              0.25, 1e-15);
}

}  // namespace
}  // namespace carom
