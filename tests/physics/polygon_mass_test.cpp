#include "physics/collision/polygon_mass.h"

#include <gtest/gtest.h>

#include "physics/collision/tidy_polygon.h"
#include "tests/physics/convex_reference.h"

namespace carom {
namespace {

using test::uniform;
constexpr double kPi = std::numbers::pi;

void expect_moments(const std::vector<Vec2>& core, double rounding, double area, const Vec2& centroid,
                    double second) {
  const AreaMoments m = area_moments(core, rounding);
  EXPECT_NEAR(m.area, area, 4e-15 * area);
  EXPECT_NEAR((m.centroid - centroid).norm(), 0.0, 4e-15 * (std::sqrt(area) + centroid.norm()));
  EXPECT_NEAR(m.second, second, 1e-14 * second);
}

TEST(AreaMoments, ClosedForms) {
  // Disc; rectangle; half a regular hexagon's neighbours: regular polygons of n sides and circumradius R have
  // area n R² sin(2π/n)/2 and second moment A R² (2 + cos(2π/n))/6.
  expect_moments({{3.0, 4.0}}, 2.0, 4.0 * kPi, {3.0, 4.0}, 8.0 * kPi);
  expect_moments({{1, 1}, {4, 1}, {4, 3}, {1, 3}}, 0.0, 6.0, {2.5, 2.0}, 6.0 * 13.0 / 12.0);
  expect_moments({{0, 0}, {3, 0}, {0, 6}}, 0.0, 9.0, {1.0, 2.0}, 9.0 * 45.0 / 18.0);
  for (int n = 3; n <= 16; ++n) {
    std::vector<Vec2> v;
    for (int k = 0; k < n; ++k)
      v.emplace_back(2.0 * std::cos(2 * kPi * k / n) + 7.0, 2.0 * std::sin(2 * kPi * k / n));
    const double area = 2.0 * n * std::sin(2 * kPi / n);
    expect_moments(v, 0.0, area, {7.0, 0.0}, area * 4.0 * (2.0 + std::cos(2 * kPi / n)) / 6.0);
  }
  // Capsule: a rectangle L × 2r and two half discs, whose centroids are 4r/(3π) beyond its ends.
  const double length = 3.0;
  const double r = 0.5;
  const double half = 0.5 * kPi * r * r;
  const double out = 4.0 * r / (3.0 * kPi);
  const double capsule = length * 2.0 * r * (length * length + 4.0 * r * r) / 12.0 +
                         2.0 * (half * r * r / 2.0 - half * out * out + half * std::pow(0.5 * length + out, 2));
  expect_moments({{0, -1.5}, {0, 1.5}}, r, 2.0 * r * length + 2.0 * half, {0.0, 0.0}, capsule);
  // A thin wall has no area, nor has a point.
  EXPECT_EQ(area_moments({{0, 0}, {2, 0}}, 0.0).area, 0.0);
  EXPECT_EQ(area_moments({{0, 0}, {2, 0}}, 0.0).centroid, Vec2(1, 0));
  EXPECT_EQ(area_moments({{1, 2}}, 0.0).second, 0.0);
}

// By the distance ρ(φ) from a point inside to the outline: ∫ρ²/2 dφ and so on, ρ by bisection.
TEST(AreaMoments, AgainstRays) {
  std::mt19937_64 random(6);
  for (int n = 0; n < 8; ++n) {
    const std::vector<Vec2> v = test::random_polygon(random);
    const double rounding = n % 4 == 0 ? 0.0 : uniform(random, 0.05, 0.5);
    const test::Outline o = test::outline(polygon_shape(v, rounding), {0.0, 0.0, 0.0});
    Vec2 middle = Vec2::Zero();
    for (const Vec2& x : v) middle += x / static_cast<double>(v.size());
    constexpr int kRays = 2000;
    const double h = 2.0 * kPi / kRays;
    double area = 0.0;
    Vec2 first = Vec2::Zero();
    double second = 0.0;
    for (int k = 0; k < kRays; ++k) {
      const Vec2 u(std::cos(h * k), std::sin(h * k));
      double a = 0.0;
      double b = 3.0;
      for (int i = 0; i < 24; ++i) {
        const Vec2 x = middle + 0.5 * (a + b) * u;
        (test::reference_gap(o, {{{x.x(), x.y()}}, {}}) <= 0.0L ? a : b) = 0.5 * (a + b);
      }
      area += h * a * a / 2.0;
      first += h * a * a * a / 3.0 * u;
      second += h * a * a * a * a / 4.0;
    }
    const Vec2 off = first / area;
    const AreaMoments m = area_moments(v, rounding);
    EXPECT_NEAR(m.area, area, 1e-4 * area) << n;
    EXPECT_NEAR((m.centroid - middle - off).norm(), 0.0, 1e-4) << n;
    EXPECT_NEAR(m.second, second - area * off.squaredNorm(), 2e-4 * second) << n;
  }
}

TEST(AreaMoments, FarFromTheOriginNothingCancels) {
  const Vec2 far(0x1p30, 0x1p30);
  const std::vector<Vec2> v = {{0, 0}, {1, 0}, {1, 1}, {0.25, 1.5}};
  std::vector<Vec2> there;
  for (const Vec2& x : v) there.push_back(x + far);
  const AreaMoments here = area_moments(v, 0.25);
  const AreaMoments moved = area_moments(there, 0.25);
  EXPECT_NEAR(moved.area, here.area, 1e-14);
  EXPECT_NEAR(moved.second, here.second, 1e-13);
}

TEST(TidyPolygon, MendsWhatItCan) {
  const std::vector<Vec2> square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_EQ(tidy_polygon(square).vertices, square);
  // Clockwise; with repeated points; with points on the edges, also within the tolerance of it.
  EXPECT_EQ(tidy_polygon({{0, 0}, {0, 1}, {1, 1}, {1, 0}}).vertices, square);
  EXPECT_EQ(tidy_polygon({{0, 0}, {0, 0}, {1, 0}, {1, 1e-12}, {1, 1}, {0, 1}, {0, 1}, {1e-11, 0}}).vertices,
            square);
  EXPECT_EQ(
      tidy_polygon({{0, 0}, {0.5, 0}, {0.75, -1e-10}, {1, 0}, {1, 1}, {0.5, 1}, {0, 1}, {0, 0.25}}).vertices,
      square);
  for (const double unit : {1e-150, 1e-6, 1e6, 1e150}) {
    std::vector<Vec2> scaled;
    for (const Vec2& x : square) scaled.push_back(unit * x);
    EXPECT_EQ(tidy_polygon(scaled).vertices, scaled) << unit;
  }
  std::mt19937_64 random(1);
  for (int n = 0; n < 1000; ++n) {
    const std::vector<Vec2> v = test::random_polygon(random);
    EXPECT_EQ(tidy_polygon(v).vertices, v) << n << tidy_polygon(v).problem;
    std::vector<Vec2> turned(v.rbegin(), v.rend());
    EXPECT_EQ(tidy_polygon(turned).vertices.size(), v.size());
    EXPECT_TRUE(tidy_polygon(turned).problem.empty());
  }
}

TEST(TidyPolygon, RefusesTheRestInWords) {
  const auto refused = [](const std::vector<Vec2>& v, const std::string& words, int vertex = -1) {
    const TidyPolygon tidy = tidy_polygon(v);
    EXPECT_TRUE(tidy.vertices.empty()) << words;
    EXPECT_NE(tidy.problem.find(words), std::string::npos) << tidy.problem << " | " << words;
    EXPECT_EQ(tidy.problem.find('\n'), std::string::npos);
    EXPECT_EQ(tidy.vertex, vertex) << words << " | " << tidy.problem;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refused({}, "at least 3");
  refused({{0, 0}, {1, 0}}, "at least 3");
  refused({{0, 0}, {1, 0}, {nan, 1}}, "finite", 2);
  refused({{0, 0}, {1, 0}, {0, 0}, {1, 0}}, "fewer than 3");
  refused({{1, 1}, {1, 1}, {1, 1}}, "fewer than 3");
  refused({{0, 0}, {1, 1}, {2, 2}, {3, 3}}, "fewer than 3");
  refused({{0, 0}, {2, 2}, {1, 1}}, "fewer than 3");
  refused({{-1e308, 0}, {1e308, 0}, {0, 1e308}}, "too large");
  // Concave, either way round; a spike; a bow tie; a pentagram; twice round a square.
  refused({{0, 0}, {2, 0}, {1, 0.5}, {2, 2}, {0, 2}}, "bends inwards", 2);
  refused({{0, 2}, {2, 2}, {1, 0.5}, {2, 0}, {0, 0}}, "bends inwards", 2);
  refused({{0, 0}, {1, 0}, {2, 0}, {1, 0}, {1, 1}, {0, 1}}, "crosses itself", 3);
  refused({{0, 0}, {1, 1}, {1, 0}, {0, 1}}, "crosses itself", 2);
  std::vector<Vec2> star;
  for (int k = 0; k < 5; ++k) star.emplace_back(std::cos(0.8 * kPi * k), std::sin(0.8 * kPi * k));
  EXPECT_NE(tidy_polygon(star).problem.find("crosses itself"), std::string::npos);
  refused({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}, {1, 0}, {1, 1}, {0, 1}}, "crosses itself", 3);
  std::vector<Vec2> many;
  for (int k = 0; k < 17; ++k) many.emplace_back(std::cos(2 * kPi * k / 17), std::sin(2 * kPi * k / 17));
  refused(many, "17 vertices; at most 16");
}

}  // namespace
}  // namespace carom
