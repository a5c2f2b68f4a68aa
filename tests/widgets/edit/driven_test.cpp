#include "widgets/edit/driven.h"

#include <gtest/gtest.h>

#include "physics/scene/edit_rules.h"

// What is done to a driven body as it is seen, and what the scene then states.
namespace carom {
namespace {

constexpr double kTime = 2.0;  // s

class DrivenTest : public testing::Test {
 protected:
  DrivenTest() {
    Body body;
    body.name = "piston";
    body.shape = Box{0.2, 0.2};
    body.position = {1.0, 0.0};
    scene_.bodies = {driven(body, {.velocity = Vec2(0.5, 0.0)})};
    give_ids(scene_);
  }
  [[nodiscard]] const Body& piston() const { return scene_.bodies[0]; }
  [[nodiscard]] Body seen() const { return moved_by_drive(piston(), kTime); }
  [[nodiscard]] SceneEdit stated(const Body& body, bool at_start) const {
    return as_stated({Replace<Body>{body}}, scene_, kTime, at_start)[0];
  }
  // A pull of the velocity from where it was pressed.
  [[nodiscard]] static Body pulled(Body body, const Vec2& velocity) {
    body.velocity = velocity;
    return driven_so(body);
  }
  [[nodiscard]] static const Body& part(const SceneEdit& edit) { return std::get<Replace<Body>>(edit).part; }

  Scene scene_;
};

TEST_F(DrivenTest, ItIsSeenWhereItsDriveHasTakenIt) {
  EXPECT_EQ(seen().position, Vec2(2.0, 0.0));
  EXPECT_EQ(seen().velocity, Vec2(0.5, 0.0));
}

// At a start whose clock is late as on the way: where it is seen it stays, however often the mouse has moved.
TEST_F(DrivenTest, APullLeavesItWhereItIsSeen) {
  for (const bool at_start : {true, false}) {
    SCOPED_TRACE(at_start);
    const Scene before = scene_;
    const Body pressed = seen();
    for (const double x : {0.7, 1.1, -0.3, 0.0}) {
      const SceneEdit edit = stated(pulled(pressed, {x, 0.1}), at_start);
      EXPECT_TRUE(is_about_motion(scene_, edit)) << x;
      EXPECT_EQ(part(edit).velocity, Vec2(0.0, 0.0));
      EXPECT_EQ(part(edit).drive->velocity, Vec2(x, 0.1));
      apply_edits(scene_, {edit});
      EXPECT_TRUE(seen().position.isApprox(pressed.position, 1e-14)) << x;
    }
    scene_ = before;
  }
}

TEST_F(DrivenTest, AMoveKeepsItsVelocity) {
  Body body = seen();
  body.position += Vec2(0.25, 0.5);
  const SceneEdit edit = stated(driven_so(body), false);
  EXPECT_TRUE(part(edit).position.isApprox(Vec2(1.25, 0.5)));
  EXPECT_EQ(part(edit).drive, piston().drive);
  EXPECT_EQ(part(edit).velocity, Vec2(0.0, 0.0));
}

// A field of its drive: from now on in the run, which keeps its place, and in the start from its home.
TEST_F(DrivenTest, AFieldOfItsDriveIsNoMotionOnTheWay) {
  Body body = seen();
  body.drive->velocity = {1.5, 0.0};
  EXPECT_EQ(part(stated(body, false)).position, piston().position);
  EXPECT_FALSE(is_about_motion(scene_, stated(body, false)));
  const Body at_start = part(stated(body, true));
  EXPECT_TRUE(moved_by_drive(at_start, kTime).position.isApprox(seen().position))
      << "it goes on from where it is";
}

TEST_F(DrivenTest, WhatIsNoLongerDrivenStaysWhereItIsSeen) {
  Body body = seen();
  body.drive.reset();
  body.density = 1.0;
  EXPECT_EQ(part(stated(body, true)).position, seen().position);
  EXPECT_EQ(part(stated(body, true)).velocity, Vec2(0.5, 0.0));
}

}  // namespace
}  // namespace carom
