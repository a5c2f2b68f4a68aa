#include "widgets/scene/snap.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace carom {
namespace {

TEST(OnRim, ACornerGoesBeforeTheRim) {
  const Shape box = Box{2.0, 1.0};
  EXPECT_EQ(on_rim(box, {0.95, 0.48}, 0.1), Vec2(1.0, 0.5));
  EXPECT_EQ(on_rim(box, {0.5, 0.48}, 0.1), Vec2(0.5, 0.5));
  EXPECT_EQ(on_rim(box, {0.5, 0.55}, 0.1), Vec2(0.5, 0.5));
  EXPECT_FALSE(on_rim(box, {0.5, 0.3}, 0.1));
  const Shape rod = Wall{.length = 2.0};
  EXPECT_EQ(on_rim(rod, {0.97, 0.02}, 0.1), Vec2(1.0, 0.0));
  EXPECT_NEAR((*on_rim(rod, {0.3, 0.02}, 0.1) - Vec2(0.3, 0.0)).norm(), 0.0, 1e-15);
}

TEST(OnRim, OfDiscsAndTheGround) {
  EXPECT_EQ(on_rim(Disc{0.5}, {0.0, 0.45}, 0.1), Vec2(0.0, 0.5));
  EXPECT_EQ(on_rim(Disc{0.5}, {-0.55, 0.0}, 0.1), Vec2(-0.5, 0.0));
  EXPECT_FALSE(on_rim(Disc{0.5}, Vec2(Vec2::Zero()), 0.1));
  EXPECT_EQ(on_rim(Wall{}, {7.0, -0.05}, 0.1), Vec2(7.0, 0.0));
  EXPECT_FALSE(on_rim(Wall{}, {7.0, -0.2}, 0.1));
}

TEST(OnRim, OfEachShapeOfACompound) {
  const Shape pair = Compound{{{Disc{0.5}, {-1.0, 0.0}, 0.0, ""}, {Disc{0.5}, {1.0, 0.0}, 0.0, ""}}};
  EXPECT_EQ(on_rim(pair, {1.0, 0.45}, 0.1), Vec2(1.0, 0.5));
  EXPECT_EQ(on_rim(pair, {-0.55, 0.0}, 0.1), Vec2(-0.5, 0.0));
}

// By the distance from the shape, which knows nothing of edges.
TEST(OnRim, IsTheNearestPointOfARoundedPolygon) {
  const Shape polygon = Polygon{{{0.0, 0.0}, {1.0, 0.1}, {0.8, 0.9}, {-0.2, 0.7}}, 0.1};
  std::mt19937 random{3};
  std::uniform_real_distribution<> number(-1.0, 1.0);
  int near = 0;
  for (int k = 0; k < 2000; ++k) {
    const Vec2 place(number(random), number(random));
    const double distance = std::abs(signed_distance(polygon, place));
    const std::optional<Vec2> rim = on_rim(polygon, place, 0.15);
    ASSERT_EQ(rim.has_value(), distance <= 0.15) << place.transpose();
    if (!rim) continue;
    ++near;
    EXPECT_NEAR((*rim - place).norm(), distance, 1e-12) << place.transpose();
    EXPECT_NEAR(signed_distance(polygon, *rim), 0.0, 1e-12) << place.transpose();
  }
  EXPECT_GT(near, 300);
}

}  // namespace
}  // namespace carom
