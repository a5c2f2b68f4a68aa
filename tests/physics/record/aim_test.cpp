#include "physics/record/aim.h"

#include <gtest/gtest.h>

namespace carom {
namespace {

using std::chrono_literals::operator""s;

RunSetup two_discs(double speed) {
  RunSetup setup;
  for (const double x : {0.0, 1.0}) {
    Body body;
    body.name = x == 0.0 ? "left" : "right";
    body.shape = Disc{0.1};
    body.mass = 1.0;
    body.position = {x, 0.5};
    setup.scene.bodies.push_back(body);
  }
  setup.scene.bodies[0].velocity = {speed, 0.0};
  setup.method.step = 0.01;
  return setup;
}

// Under every method of impacts; the step's end comes up to a step late.
TEST(Aim, EndsWhereTheDiscsMeet) {
  for (const ImpactsId impacts : {ImpactsId::kLocated, ImpactsId::kStepEnd}) {
    RunSetup setup = two_discs(1.3);
    setup.method.impacts = impacts;
    const auto aim = aim_of(setup, 2.0, 10s);
    ASSERT_TRUE(aim);
    const double late = impacts == ImpactsId::kLocated ? 1e-12 : 0.01;
    EXPECT_GE(aim->time, 0.8 / 1.3 - 1e-12);
    EXPECT_LE(aim->time, 0.8 / 1.3 + late);
    ASSERT_EQ(aim->paths.size(), 2U);
    EXPECT_EQ(aim->paths[0].front().x(), 0.0);
    ASSERT_EQ(aim->meeting.size(), 2U);
    if (impacts == ImpactsId::kLocated) {
      EXPECT_NEAR((aim->paths[0].back() - Vec2(0.8, 0.5)).norm(), 0.0, 1e-12);
      EXPECT_NEAR(aim->meeting[0].position.x(), 0.8, 1e-12);
      EXPECT_NEAR(aim->meeting[1].position.x(), 1.0, 1e-12);
    }
  }
}

// From the clock of a saved run on.
TEST(Aim, CountsFromTheStart) {
  RunSetup setup = two_discs(1.0);
  setup.saved = SavedRun{.time = 5.0};
  const auto aim = aim_of(setup, 2.0, 10s);
  ASSERT_TRUE(aim);
  EXPECT_NEAR(aim->time, 0.8, 1e-12);
}

// A billion impacts within a step.
TEST(Aim, EndsWithinAStepThatTakesTooLong) {
  RunSetup setup = two_discs(0.0);
  setup.method.step = 1.0;
  Body wall;
  wall.fixed = true;
  wall.shape = Wall{};
  for (const double sign : {-1.0, 1.0}) {
    wall.name = sign < 0.0 ? "floor" : "ceiling";
    wall.position = {0.0, 0.5 + 0.2 * sign};
    wall.angle = sign < 0.0 ? 0.0 : 3.14159265358979;
    setup.scene.bodies.push_back(wall);
  }
  setup.scene.bodies[0].velocity = {0.0, 1e9};
  EXPECT_FALSE(aim_of(setup, 2.0, std::chrono::milliseconds(20)));
}

TEST(Aim, IsLeftOutWhereThereIsNone) {
  EXPECT_FALSE(aim_of(two_discs(-1.0), 2.0, 10s)) << "they part";
  EXPECT_FALSE(aim_of(two_discs(0.3), 2.0, 10s)) << "later than asked for";
  EXPECT_FALSE(aim_of(two_discs(1.0), 2.0, -1s)) << "no time";
  EXPECT_FALSE(aim_of(two_discs(100.0), 2.0, 10s)) << "within the first step";
  RunSetup many = two_discs(1.0);
  many.scene.bodies.resize(kMostAimed + 1, many.scene.bodies[1]);
  EXPECT_FALSE(aim_of(many, 2.0, 10s));
}

}  // namespace
}  // namespace carom
