#include "physics/scene/shape.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace carom {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(PlateMoments, ClosedForms) {
  const std::vector<Vec2> rectangle = {{1, 2}, {4, 2}, {4, 4}, {1, 4}};
  const PlateMoments plain = moments_of(rectangle, 0.0);
  EXPECT_NEAR(plain.area, 6.0, 1e-14);
  EXPECT_NEAR((plain.centroid - Vec2(2.5, 3.0)).norm(), 0.0, 1e-15);
  EXPECT_NEAR(plain.second_moment, 6.0 * (9.0 + 4.0) / 12.0, 1e-13);

  // A capsule of length l and radius r: a rectangle and two half discs, whose centroids lie 4r/3π from the cut.
  const double l = 3.0;
  const double r = 0.5;
  const PlateMoments capsule = moments_of(std::vector<Vec2>{{1, 1}, {1, 1 + l}}, r);
  const double disc = kPi * r * r;
  EXPECT_NEAR(capsule.area, 2 * r * l + disc, 1e-14);
  EXPECT_NEAR((capsule.centroid - Vec2(1.0, 2.5)).norm(), 0.0, 1e-15);
  const double off = 4.0 * r / (3.0 * kPi);
  const double ends = disc * (0.5 * r * r - off * off + (0.5 * l + off) * (0.5 * l + off));
  EXPECT_NEAR(capsule.second_moment, 2 * r * l * (l * l + 4 * r * r) / 12.0 + ends, 1e-13);

  // A regular polygon of circumradius c: area n c² sin(2π/n)/2, polar moment area c² (2 + cos(2π/n))/6.
  for (int n = 3; n <= 12; ++n) {
    std::vector<Vec2> v;
    for (int k = 0; k < n; ++k)
      v.emplace_back(7.0 + 2.0 * std::cos(2 * kPi * k / n), 2.0 * std::sin(2 * kPi * k / n));
    const PlateMoments m = moments_of(v, 0.0);
    const double area = 0.5 * n * 4.0 * std::sin(2 * kPi / n);
    EXPECT_NEAR(m.area, area, 1e-13) << n;
    EXPECT_NEAR(m.second_moment, area * 4.0 * (2.0 + std::cos(2 * kPi / n)) / 6.0, 1e-12) << n;
  }
}

// Against a sum over a fine lattice of the points within the outline.
TEST(PlateMoments, OfARoundedTriangle) {
  const Polygon polygon{{{0.0, 0.0}, {1.0, 0.1}, {0.2, 0.7}}, 0.25};
  const PlateMoments m = moments_of(polygon.vertices, polygon.rounding);
  const Outline outline{polygon.vertices, polygon.rounding, false};
  const double cell = 0.004;
  double area = 0.0;
  Vec2 first = Vec2::Zero();
  double second = 0.0;
  for (double x = -0.5; x < 1.5; x += cell) {
    for (double y = -0.5; y < 1.2; y += cell) {
      if (signed_distance(outline, {x, y}) > 0.0) continue;
      area += cell * cell;
      first += cell * cell * Vec2(x, y);
      second += cell * cell * (Vec2(x, y) - m.centroid).squaredNorm();
    }
  }
  EXPECT_NEAR(m.area, area, 1e-3);
  EXPECT_NEAR((m.centroid - first / area).norm(), 0.0, 1e-3);
  EXPECT_NEAR(m.second_moment, second, 1e-3);
  EXPECT_NEAR(inertia_per_mass(polygon), m.second_moment / m.area, 1e-15);
  // The outline is centred, wherever the vertices stood.
  Polygon moved = polygon;
  for (Vec2& v : moved.vertices) v += Vec2(5.0, -3.0);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR((outline_of(moved).vertices[k] - (polygon.vertices[k] - m.centroid)).norm(), 0.0, 1e-14);
  }
}

TEST(Polygon, IsTidied) {
  const std::vector<Vec2> clockwise = {{0, 0}, {0, 1}, {0, 1}, {0.5, 1}, {1, 1}, {1, 0}, {0.3, 1e-13}};
  const std::vector<Vec2> v = tidied(clockwise);
  EXPECT_EQ(v, (std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_EQ(tidied(std::vector<Vec2>{{1, 1}, {1, 1}, {2, 1}}).size(), 2U);
}

TEST(Polygon, FaultsAreReported) {
  const auto fault = [](const std::vector<Vec2>& v, double rounding = 0.0) {
    return fault_of(v, rounding).value_or("");
  };
  EXPECT_EQ(fault({{0, 0}, {1, 0}, {0, 1}}), "");
  EXPECT_EQ(fault({{0, 0}, {1, 0}}, 0.1), "");
  EXPECT_NE(fault({}).find("0 points"), std::string::npos);
  EXPECT_NE(fault({{1, 1}}, 1.0).find("1 point "), std::string::npos);
  EXPECT_NE(fault({{0, 0}, {1, 0}, {2, 0}}).find("2 points"), std::string::npos);
  EXPECT_NE(fault({{0, 0}, {2, 0}, {1, 0.1}, {1, 2}}, 0.1).find("reentrant corner at [1, 0.1]"),
            std::string::npos);
  EXPECT_NE(fault({{0, 0}, {1, 1}, {1, 0}, {0, 1}}).find("allowed"), std::string::npos);
  std::vector<Vec2> star;
  for (int k = 0; k < 5; ++k) star.emplace_back(std::cos(0.8 * kPi * k), std::sin(0.8 * kPi * k));
  EXPECT_NE(fault(star).find("cross"), std::string::npos);
  std::vector<Vec2> many;
  for (int k = 0; k < 17; ++k) many.emplace_back(std::cos(2 * kPi * k / 17), std::sin(2 * kPi * k / 17));
  EXPECT_NE(fault(many).find("17 corners"), std::string::npos);
}

TEST(Outline, ChordsEndWhereTheDistanceIsZero) {
  const std::vector<Shape> shapes = {Disc{0.7}, Box{1.0, 0.4}, Polygon{{{0, 0}, {1, 0.1}, {0.2, 0.7}}, 0.25},
                                     Polygon{{{0, 0}, {1, 0}}, 0.3}, Wall{}};
  for (const Shape& shape : shapes) {
    const Outline outline = outline_of(shape);
    int through = 0;
    for (int k = 0; k < 200; ++k) {
      const Vec2 from(std::sin(17.0 * k), std::sin(29.0 * k + 1.0));
      const Vec2 along(std::cos(0.1 * k), std::sin(0.1 * k));
      double least = INFINITY;
      for (int i = -300; i <= 300; ++i)
        least = std::min(least, signed_distance(outline, from + 0.01 * i * along));
      const auto inside = chord(outline, from, along);
      if (least > 1e-3) {
        EXPECT_FALSE(inside && std::abs(inside->first) < 2.9) << k;
      }
      if (least < -1e-3) {
        EXPECT_TRUE(inside.has_value()) << k;
      }
      if (!inside) continue;
      ++through;
      for (const double s : {inside->first, inside->second}) {
        if (!std::isfinite(s)) continue;
        EXPECT_NEAR(signed_distance(outline, from + s * along), 0.0, 1e-12 * (1.0 + std::abs(s)));
      }
    }
    EXPECT_GT(through, 20);
  }
}

TEST(Shape, ExtentsOfATurnedBox) {
  const Vec2 half = half_extent(Box{2.0, 1.0}, kPi / 6.0);
  EXPECT_NEAR(half.x(), std::cos(kPi / 6.0) + 0.5 * std::sin(kPi / 6.0), 1e-15);
  EXPECT_NEAR(half.y(), std::sin(kPi / 6.0) + 0.5 * std::cos(kPi / 6.0), 1e-15);
  EXPECT_EQ(bounding_radius(Wall{}), INFINITY);
  EXPECT_EQ(area(Wall{2.0}), 0.0);
}

// A rod without mass with points at its ends.
TEST(Shape, PointsOfACompoundWeighAlike) {
  const Compound points{{{Disc{0.0}, {1.0, 0.0}, 0.0, ""}, {Disc{0.0}, {2.0, 0.0}, 0.0, ""}}};
  EXPECT_EQ(centre_of(points), Vec2(1.5, 0.0));
  EXPECT_EQ(inertia_per_mass(points), 0.25);
}

}  // namespace
}  // namespace carom
