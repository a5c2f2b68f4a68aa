#include "widgets/scene/level.h"

#include <gtest/gtest.h>

#include "tests/widgets/scene/scene_tools_fixture.h"
#include "widgets/scene/drag.h"

namespace carom {
namespace {

// 100 px/m, so that 8 px are 8 cm.
class LevelTest : public testing::Test {
 protected:
  LevelTest() {
    Body light;
    light.name = "light";
    light.shape = Disc{0.2};
    Body heavy = light;
    heavy.name = "heavy";
    heavy.position = Vec2(2.0, 1.03);
    Body ramp = light;
    ramp.name = "ramp";
    ramp.shape = Box{0.4, 0.2};
    ramp.position = Vec2(-1.0, -1.0);
    start_ = {.bodies = {light}, .others = {heavy, ramp}};
    start_.grid = 0.2;
  }
  [[nodiscard]] Dragged drag(const Vec2& to, Qt::KeyboardModifiers keys = {}) const {
    return drag_to(start_, {.at = to, .scale = 100.0, .keys = keys});
  }
  DragStart start_;
};

TEST_F(LevelTest, ADraggedCentreSnapsToOtherCentresBeforeTheGrid) {
  const Dragged level = drag(Vec2(0.47, 0.99));
  EXPECT_EQ(level.bodies[0].position, Vec2(0.4, 1.03));  // x to the grid
  EXPECT_EQ(level.detail, "level with heavy");
  ASSERT_EQ(level.guides.size(), 1U);
  EXPECT_EQ(level.guides[0], std::pair(Vec2(0.4, 1.03), Vec2(2.0, 1.03)));
  const Dragged over = drag(Vec2(1.95, 2.7));
  EXPECT_EQ(over.bodies[0].position.x(), 2.0);
  EXPECT_EQ(over.detail, "over heavy");
  EXPECT_EQ(drag(Vec2(1.95, 0.3)).detail, "under heavy");
}

TEST_F(LevelTest, NoFartherThanEightPixelsAndNotWithControl) {
  EXPECT_TRUE(drag(Vec2(0.47, 1.12)).guides.empty());
  EXPECT_FALSE(drag(Vec2(0.47, 1.10)).guides.empty());
  EXPECT_TRUE(drag(Vec2(0.47, 1.0), Qt::ControlModifier).guides.empty());
  EXPECT_EQ(drag(Vec2(0.47, 1.0), Qt::ControlModifier).bodies[0].position, Vec2(0.47, 1.0));
}

TEST_F(LevelTest, ShiftSnapsAlongItsAxisOnly) {
  const Dragged along = drag(Vec2(1.96, 1.0), Qt::ShiftModifier);
  EXPECT_EQ(along.bodies[0].position, Vec2(2.0, 0.0));
  EXPECT_EQ(along.detail, "under heavy");
}

TEST_F(LevelTest, CornersCountToo) {
  const Dragged on = drag(Vec2(-0.77, -0.87));
  EXPECT_TRUE(on.bodies[0].position.isApprox(Vec2(-0.8, -0.9), 1e-12));
  EXPECT_EQ(on.detail, "on a corner of ramp");
  EXPECT_EQ(drag(Vec2(0.47, -1.11)).detail, "level with a corner of ramp");
}

TEST_F(LevelTest, TouchingComesFirst) {
  const Dragged touch = drag(Vec2(1.57, 1.01));
  EXPECT_EQ(touch.detail, "touches heavy");
  EXPECT_TRUE(touch.guides.empty());
}

TEST_F(LevelTest, WhatIsOutOfViewOrInACrowdHoldsNothing) {
  start_.seen.include(Vec2::Zero(), Vec2::Constant(1.5));
  EXPECT_TRUE(drag(Vec2(0.47, 1.0)).guides.empty());
  start_.seen = {};
  for (int k = 0; k < 40; ++k) start_.others.push_back(start_.others[0]);
  EXPECT_TRUE(drag(Vec2(0.47, 1.0)).guides.empty());
}

TEST_F(LevelTest, OfSeveralOnALineTheNearestIsNamed) {
  Body last = start_.others[0];
  last.name = "last";
  last.position.x() = 1.0;
  start_.others.push_back(last);
  EXPECT_EQ(drag(Vec2(0.47, 1.0)).detail, "level with last");
}

using LevelInSceneTest = SceneToolsTest;

// The view is asked for its pixels: the end of a dotted line from A to B in the accent.
TEST_F(LevelInSceneTest, AGuideIsDrawnUntilRelease) {
  answers_ = true;
  scene_.bodies[2].position = Vec2(3.0, 1.13);
  scene_.bodies[1].velocity = Vec2::Zero();
  show(true);
  const auto accents = [&] {
    const QImage image = view_.grab(QRect(383, 180, 15, 14)).toImage();
    int found = 0;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) found += alike(image.pixelColor(x, y), light_theme().accent);
    }
    return found;
  };
  press(a_);
  move(a_ + QPoint(0, -9));
  EXPECT_EQ(view_.bubble().detail, "level with B");
  EXPECT_TRUE(replaced(told_.back().edits[0]).position.isApprox(Vec2(1.0, 1.13), 1e-12));
  EXPECT_GT(accents(), 5);
  release(a_ + QPoint(0, -9));
  EXPECT_EQ(accents(), 0);
}

}  // namespace
}  // namespace carom
