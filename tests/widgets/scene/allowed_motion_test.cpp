#include "widgets/scene/allowed_motion.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "physics/math/vectors.h"

namespace carom {
namespace {

// A bob on a rod of 1 m, 30° to the right of the vertical through its support.
class AllowedMotionTest : public testing::Test {
 protected:
  AllowedMotionTest() {
    const double angle = std::numbers::pi / 6.0;
    Body bob;
    bob.name = "bob";
    bob.mass = 1.0;
    bob.position = Vec2(std::sin(angle), -std::cos(angle));
    Joint rod;
    rod.body = "bob";
    scene_.bodies = {bob};
    scene_.joints = {rod};
    give_ids(scene_);
  }
  [[nodiscard]] AllowedMotion typed(const Vec2& velocity, double spin = 0.0) const {
    Body body = scene_.bodies[0];
    body.velocity = velocity;
    body.spin = spin;
    return allowed_motion(scene_, {Replace<Body>{body}});
  }
  static const Body& body_of(const SceneEdit& edit) { return std::get<Replace<Body>>(edit).part; }
  Scene scene_;
};

// v - (v·r) r with r = (1/2, -√3/2).
TEST_F(AllowedMotionTest, ARodTakesWhatIsAlongIt) {
  const AllowedMotion made = typed(Vec2(1.0, 0.0));
  ASSERT_EQ(made.edits.size(), 1U);
  EXPECT_NEAR(body_of(made.edits[0]).velocity.x(), 0.75, 1e-12);
  EXPECT_NEAR(body_of(made.edits[0]).velocity.y(), std::sqrt(3.0) / 4.0, 1e-12);
  EXPECT_EQ(made.sentence, "Rod 1 allows no other direction: 0.87 m/s at 30°");
  EXPECT_EQ(made.name, "Speed of bob 0.00 → 0.87 m/s");
}

TEST_F(AllowedMotionTest, WhatIsAllowedStaysAsTyped) {
  const Vec2 across = 2.0 * Vec2(std::cos(std::numbers::pi / 6.0), 0.5);
  const AllowedMotion made = typed(across);
  EXPECT_EQ(body_of(made.edits[0]).velocity, across);
  EXPECT_TRUE(made.sentence.isEmpty());
}

TEST_F(AllowedMotionTest, WhereNothingIsLeftTheEditIsAsAsked) {
  const Vec2 along = scene_.bodies[0].position;
  const AllowedMotion made = typed(along);
  EXPECT_EQ(body_of(made.edits[0]).velocity, along);
  EXPECT_TRUE(made.sentence.isEmpty());
}

// A spin about a pin beside the centre: the centre goes round it.
TEST_F(AllowedMotionTest, ASpinMovesTheCentreAboutAPin) {
  Joint& pin = scene_.joints[0];
  pin.kind = JointKind::kPin;
  pin.point = Vec2(0.1, 0.0);
  pin.anchor = scene_.bodies[0].position + pin.point;
  const AllowedMotion made = typed(Vec2::Zero(), 2.0);
  EXPECT_EQ(body_of(made.edits[0]).spin, 2.0);
  EXPECT_NEAR(body_of(made.edits[0]).velocity.x(), 0.0, 1e-12);
  EXPECT_NEAR(body_of(made.edits[0]).velocity.y(), -0.2, 1e-12);
}

// Two bobs joined by a level rod of 1 m.
class TwoChangedTest : public AllowedMotionTest {
 protected:
  TwoChangedTest() {
    Body other = scene_.bodies[0];
    other.name = "other";
    other.id = {};
    other.mass = 3.0;
    other.position += Vec2(1.0, 0.0);
    scene_.bodies.push_back(other);
    scene_.joints[0].to = "other";
    give_ids(scene_);
  }
  [[nodiscard]] AllowedMotion pasted(const Vec2& first, const Vec2& second) const {
    Body one = scene_.bodies[0];
    Body two = scene_.bodies[1];
    one.velocity = first;
    two.velocity = second;
    return allowed_motion(scene_, {Replace<Body>{one}, Replace<Body>{two}});
  }
};

TEST_F(TwoChangedTest, WhatTheirJointAllowsStaysAsPasted) {
  const AllowedMotion made = pasted(Vec2(3.0, 1.0), Vec2(3.0, -2.0));
  ASSERT_EQ(made.edits.size(), 2U);
  EXPECT_EQ(body_of(made.edits[0]).velocity, Vec2(3.0, 1.0));
  EXPECT_EQ(body_of(made.edits[1]).velocity, Vec2(3.0, -2.0));
  EXPECT_TRUE(made.sentence.isEmpty());
}

// Along the rod both get (1 · 4 + 3 · 0) / (1 + 3), and the momentum stays.
TEST_F(TwoChangedTest, TheirRodTakesFromBothByTheirMasses) {
  const AllowedMotion made = pasted(Vec2(4.0, 1.0), Vec2(0.0, -2.0));
  ASSERT_EQ(made.edits.size(), 2U);
  EXPECT_NEAR((body_of(made.edits[0]).velocity - Vec2(1.0, 1.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((body_of(made.edits[1]).velocity - Vec2(1.0, -2.0)).norm(), 0.0, 1e-12);
  EXPECT_EQ(made.sentence, "Rod 1 allows no others: velocities change by up to 3.00 m/s");
  EXPECT_EQ(made.name, "Speed of 2 bodies");
}

// A weld takes their spins too: both turn about the common centre with L / I of the whole.
TEST_F(TwoChangedTest, TheirWeldMakesThemOneBody) {
  scene_.joints[0].kind = JointKind::kWeld;
  scene_.joints[0].point = Vec2(0.5, 0.0);
  scene_.joints[0].anchor = Vec2(-0.5, 0.0);
  const AllowedMotion made = pasted(Vec2(0.0, 4.0), Vec2(0.0, 0.0));
  const Body& one = body_of(made.edits[0]);
  const Body& two = body_of(made.edits[1]);
  const double inertia = inertia_of(one) + inertia_of(two) + 1.0 * 0.75 * 0.75 + 3.0 * 0.25 * 0.25;
  const double spin = -0.75 * 4.0 / inertia;
  EXPECT_NEAR(one.spin, spin, 1e-12);
  EXPECT_NEAR(two.spin, spin, 1e-12);
  EXPECT_NEAR((one.velocity - Vec2(0.0, 1.0 - 0.75 * spin)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((two.velocity - Vec2(0.0, 1.0 + 0.25 * spin)).norm(), 0.0, 1e-12);
}

TEST_F(TwoChangedTest, WhereNothingIsLeftTheyAreAsAsked) {
  const AllowedMotion made = pasted(Vec2(3.0, 0.0), Vec2(-1.0, 0.0));
  EXPECT_EQ(body_of(made.edits[0]).velocity, Vec2(3.0, 0.0));
  EXPECT_EQ(body_of(made.edits[1]).velocity, Vec2(-1.0, 0.0));
}

}  // namespace
}  // namespace carom
