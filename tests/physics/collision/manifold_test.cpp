#include <algorithm>
#include <gtest/gtest.h>

#include "physics/collision/pair_contact.h"
#include "tests/support/convex_reference.h"

namespace carom {
namespace {

using test::kFirst;
using test::kSecond;
using test::kThird;
using test::outline;
using test::Outline;
using test::ShapeKind;
using test::uniform;

// The ids of a body b on a body a while b slides and rocks slightly.
std::vector<std::uint32_t> ids_while_rocking(const ConvexShape& a, const ConvexShape& b, const Vec2& at,
                                             double slide) {
  const ConvexShapes s = convex_shapes({a, b});
  std::mt19937_64 random(2);
  std::vector<std::uint32_t> first;
  for (int n = 0; n < 2000; ++n) {
    const double tilt = uniform(random, -1.0, 1.0) * (n % 2 == 0 ? 1e-4 : 1e-15);
    const Eigen::Vector3d q(at.x() + slide * uniform(random, -1.0, 1.0),
                            at.y() + 1e-4 * uniform(random, -1.0, 1.0), tilt);
    const Manifold m =
        manifold(s, kFirst, pose_of(s, kFirst, {0.0, 0.0, 0.0}), kSecond, pose_of(s, kSecond, q), 0.01);
    std::vector<std::uint32_t> ids;
    for (int k = 0; k < m.count; ++k) ids.push_back(m.points[k].id);
    if (n == 0) first = ids;
    if (ids != first) return {};
  }
  return first;
}

TEST(Manifold, IdsStayWhileABodyRocksAndSlides) {
  const auto two = [](const std::vector<std::uint32_t>& ids) { return ids.size() == 2 && ids[0] != ids[1]; };
  const ConvexShape box = box_shape(1.0, 0.5);
  EXPECT_TRUE(two(ids_while_rocking(half_plane_shape({0, 1}, 0.0), box, {0.0, 0.25}, 0.3)));
  EXPECT_TRUE(two(ids_while_rocking(box_shape(9.0, 0.5), box, {0.0, 0.5}, 0.3)));
  // Equal boxes, one on the other: whose corner ends the stretch is a matter of rounding.
  EXPECT_TRUE(two(ids_while_rocking(box, box, {0.0, 0.5}, 1e-15)));
  EXPECT_TRUE(two(ids_while_rocking(box, box, {0.0, 0.5}, 0.3)));
  EXPECT_TRUE(two(ids_while_rocking(box, box, {0.8, 0.5}, 0.1)));
  EXPECT_TRUE(two(ids_while_rocking(box_shape(1.0, 0.5, 0.1), box, {0.5, 0.6}, 0.3)));
  EXPECT_TRUE(two(ids_while_rocking(box, segment_shape({-0.5, 0}, {0.5, 0}, 0.1), {0.2, 0.35}, 0.1)));
  EXPECT_TRUE(two(ids_while_rocking(segment_shape({-0.5, 0}, {0.5, 0}), box, {0.2, 0.25}, 0.1)));
  EXPECT_TRUE(
      two(ids_while_rocking(box, polygon_shape({{-0.5, -0.25}, {0.5, -0.25}, {0.0, 0.5}}), {0.2, 0.5}, 0.1)));
  // A disc has one point, and the same id where it goes round a corner.
  EXPECT_EQ(ids_while_rocking(box, disc_shape(0.25), {0.5, 0.498}, 0.02).size(), 1U);
}

TEST(Manifold, BoxOnABox) {
  const ConvexShapes s = convex_shapes({box_shape(4.0, 1.0), box_shape(2.0, 1.0)});
  const Manifold m =
      manifold(s, kFirst, pose_of(s, kFirst, {0, 0, 0}), kSecond, pose_of(s, kSecond, {1.5, 0.875, 0}), 0.0);
  ASSERT_EQ(m.count, 2);
  EXPECT_EQ(m.normal, Vec2(0, 1));
  // From left to right seen along the normal turned by +90°: from right to left here.
  EXPECT_EQ(m.points[0].point, Vec2(2.0, 0.4375));
  EXPECT_EQ(m.points[1].point, Vec2(0.5, 0.4375));
  EXPECT_EQ(m.points[0].gap, -0.125);
  EXPECT_EQ(m.points[1].gap, -0.125);
  EXPECT_EQ(
      manifold(s, kFirst, pose_of(s, kFirst, {0, 0, 0}), kSecond, pose_of(s, kSecond, {1.5, 1.125, 0}), 0.1)
          .count,
      0);
  EXPECT_EQ(
      manifold(s, kFirst, pose_of(s, kFirst, {0, 0, 0}), kSecond, pose_of(s, kSecond, {1.5, 1.125, 0}), 0.25)
          .count,
      2);
  // Upright thin bodies stand on one point; a tilted box too, if the margin is small.
  const ConvexShapes t =
      convex_shapes({half_plane_shape({0, 1}, 0.0), segment_shape({0, -1}, {0, 1}, 0.1), box_shape(2.0, 1.0)});
  EXPECT_EQ(manifold(t, kFirst, {}, kSecond, pose_of(t, kSecond, {0, 1.1, 0}), 0.5).count, 1);
  EXPECT_EQ(manifold(t, kFirst, {}, kThird, pose_of(t, kThird, {0, 0.5, 0.1}), 0.05).count, 1);
  EXPECT_EQ(manifold(t, kFirst, {}, kThird, pose_of(t, kThird, {0, 0.5, 0.1}), 0.5).count, 2);
}

// Random pairs: the least gap is that of the pair where cores are apart, every point lies between both bodies'
// faces, and the points are those of the bodies seen from the other side.
TEST(Manifold, RandomPairs) {
  std::mt19937_64 random(4);
  int twos = 0;
  for (int n = 0; n < 30'000; ++n) {
    const ConvexShape shape[] = {test::random_shape(random, ShapeKind{static_cast<int>(random() % 6)}),
                                 test::random_shape(random, ShapeKind{static_cast<int>(random() % 7)})};
    const ConvexShapes s = convex_shapes({shape[0], shape[1]});
    Eigen::Vector3d q[2];
    for (Eigen::Vector3d& x : q) {
      x = {uniform(random, -1.5, 1.5), uniform(random, -1.5, 1.5), uniform(random, -7.0, 7.0)};
      if (random() % 4 == 0) x[2] = 0.5 * std::numbers::pi * static_cast<double>(random() % 4);
    }
    const Pose a = pose_of(s, kFirst, q[0]);
    const Pose b = pose_of(s, kSecond, q[1]);
    const double margin = uniform(random, 0.0, 0.5);
    const Manifold m = manifold(s, kFirst, a, kSecond, b, margin);
    const Gap gap = gap_between(s, kFirst, a, kSecond, b);
    ASSERT_EQ(m.count > 0, gap.gap <= margin) << n;
    if (m.count == 0) continue;
    // Another normal only where corners are nearest and a face parts the bodies too.
    const bool same = m.normal == gap.normal;
    if (!same) {
      ASSERT_GT(gap.gap + s.roundings(kFirst, kSecond).sum(), 0.0) << n;
    }
    double least = m.points[0].gap;
    Outline of_a = outline(shape[0], q[0]);
    Outline of_b = outline(shape[1], q[1]);
    test::grow_thin(of_a, of_b);
    for (int k = 0; k < m.count; ++k) {
      const ManifoldPoint& p = m.points[k];
      least = std::min(least, p.gap);
      ASSERT_LE(p.gap, margin) << n;
      ASSERT_GE(p.gap, separation(s, kFirst, a, kSecond, b, m.normal) - 1e-14) << n;
      // Half a gap beyond the faces of both, along the normal, lie their surfaces.
      for (const auto& [body, side] : {std::pair{&of_a, -1.0}, std::pair{&of_b, 1.0}}) {
        const Vec2 at = p.point + side * (0.5 * p.gap + static_cast<double>(body->rounding)) * m.normal;
        const Outline core_point{{{at.x(), at.y()}}, {}};
        Outline core = *body;
        core.rounding = 0.0L;
        if (body->half_plane) {
          ASSERT_NEAR(static_cast<double>(test::reference_gap(core, core_point)), 0.0, 1e-14) << n;
        } else if (body->vertices.size() > 1) {
          // On the core's boundary: in it or at it, and not deeper than its edge's slope says.
          ASSERT_LE(static_cast<double>(test::reference_gap(core, core_point)), 1e-14) << n;
          double on_edge = 1.0;
          for (std::size_t i = 0; i < core.vertices.size(); ++i) {
            on_edge = std::min(on_edge, static_cast<double>(test::distance_to_segment(
                                            core_point.vertices[0], core.vertices[i],
                                            core.vertices[(i + 1) % core.vertices.size()])));
          }
          ASSERT_NEAR(on_edge, 0.0, 1e-14) << n;
        }
      }
    }
    if (same) {
      ASSERT_NEAR(least, gap.gap, 1e-14) << n;
    } else {
      ASSERT_LE(least, gap.gap) << n;
    }
    if (m.count == 2) {
      ++twos;
      ASSERT_NE(m.points[0].id, m.points[1].id) << n;
    }
    const Manifold back = manifold(s, kSecond, b, kFirst, a, margin);
    if ((back.normal + m.normal).norm() > 1e-12) continue;  // another face parts them as well
    ASSERT_EQ(back.count, m.count) << n;
    for (int k = 0; k < m.count; ++k) {
      // The tangent turns with the normal: low is low from both sides by the feature, high and low change.
      double nearest = 1.0;
      for (int l = 0; l < m.count; ++l) {
        nearest = std::min(nearest, (back.points[l].point - m.points[k].point).norm());
      }
      ASSERT_NEAR(nearest, 0.0, 1e-12) << n;
    }
  }
  EXPECT_GT(twos, 5000);
}

}  // namespace
}  // namespace carom
