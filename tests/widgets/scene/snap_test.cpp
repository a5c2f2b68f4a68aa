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

Body placed(const Shape& shape, const Vec2& position, double angle) {
  Body body;
  body.shape = shape;
  body.position = position;
  body.angle = angle;
  return body;
}

TEST(OnLevelEdges, EachAxisHasItsOwn) {
  const std::vector<Body> bodies = {placed(Wall{}, {0.0, -1.0}, 0.0), placed(Box{1.0, 2.0}, {3.0, 0.0}, 0.0)};
  const Vec2 otherwise(7.0, 8.0);
  EXPECT_EQ(on_level_edges({-5.0, -0.95}, otherwise, bodies, 0.1), Vec2(7.0, -1.0));
  EXPECT_EQ(on_level_edges({-5.0, -1.05}, otherwise, bodies, 0.1), Vec2(7.0, -1.0));
  EXPECT_EQ(on_level_edges({-5.0, -0.85}, otherwise, bodies, 0.1), otherwise);
  EXPECT_EQ(on_level_edges({2.45, 0.3}, otherwise, bodies, 0.1), Vec2(2.5, 8.0));
  EXPECT_EQ(on_level_edges({2.45, -0.95}, otherwise, bodies, 0.1), Vec2(2.5, -1.0)) << "in a nook";
  EXPECT_EQ(on_level_edges({2.45, 1.05}, otherwise, bodies, 0.1), Vec2(2.5, 1.0)) << "at a corner";
  EXPECT_EQ(on_level_edges({2.3, 1.05}, otherwise, bodies, 0.1), otherwise) << "beside the edge";
}

TEST(OnLevelEdges, OfTurnedAndRoundedShapes) {
  const std::vector<Body> upright = {placed(Box{1.0, 2.0}, {0.0, 0.0}, std::acos(0.0))};
  EXPECT_NEAR((on_level_edges({0.95, 0.45}, {7.0, 8.0}, upright, 0.1) - Vec2(1.0, 0.5)).norm(), 0.0, 1e-15);
  const std::vector<Body> tilted = {placed(Box{1.0, 2.0}, {0.0, 0.0}, 0.1), placed(Wall{}, {0.0, 0.0}, 0.1)};
  EXPECT_EQ(on_level_edges({0.0, 1.0}, {7.0, 8.0}, tilted, 0.1), Vec2(7.0, 8.0));
  const Polygon square{{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}, 0.25};
  const std::vector<Body> rounded = {placed(square, {0.0, 0.0}, 0.0)};
  EXPECT_EQ(on_level_edges({0.0, 0.8}, {7.0, 8.0}, rounded, 0.1), Vec2(7.0, 0.75));
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
