#include "widgets/scene/joint_hold.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "widgets/scene/drag_limits.h"

namespace carom {
namespace {

Body disc_at(const std::string& name, double x, double y) {
  Body body;
  body.name = name;
  body.shape = Disc{0.1};
  body.position = Vec2(x, y);
  return body;
}

Joint joint_of(JointKind kind, const std::string& body, const std::string& to, const Vec2& anchor) {
  Joint joint;
  joint.kind = kind;
  joint.body = body;
  joint.to = to;
  joint.anchor = anchor;
  joint.id.number = 1;
  return joint;
}

DragStart start_of(const Body& body, const Joint& joint) {
  return {.kind = HandleKind::kBody,
          .bodies = {body},
          .others = {},
          .press = body.position,
          .followers = {},
          .joints = {joint}};
}

Dragged drag(const DragStart& start, const Vec2& to, Qt::KeyboardModifiers keys = {}) {
  const DragPoint point{to, 100.0, keys};
  return within_joints(start, drag_to(start, point), point);
}

TEST(JointHold, ABobSwingsOnItsCircle) {
  const Vec2 pivot(0.2, 1.3);
  const DragStart start = start_of(disc_at("A", 0.5, 0.9), joint_of(JointKind::kRod, "A", "", pivot));
  std::mt19937 random(1);
  std::uniform_real_distribution draw(-2.0, 2.0);
  for (int k = 0; k < 1000; ++k) {
    const Vec2 to(draw(random), draw(random));
    const Dragged dragged = drag(start, to);
    EXPECT_FALSE(dragged.fault);
    const Vec2 arm = dragged.bodies[0].position - pivot;
    EXPECT_NEAR(arm.norm(), 0.5, 1e-12);
    EXPECT_NEAR(cross(arm, to - pivot), 0.0, 0.1 * (to - pivot).norm()) << "towards the mouse";
  }
}

TEST(JointHold, ABobKeepsItsSpeedAlongItsCircle) {
  DragStart start = start_of(disc_at("A", 0.0, -0.5), joint_of(JointKind::kRod, "A", "", {0.0, 0.0}));
  start.bodies[0].velocity = Vec2(2.0, 0.0);
  for (const Vec2& to : {Vec2(0.3, -0.4), Vec2(-0.5, 0.0), Vec2(0.9, 0.2)}) {
    const Body bob = drag(start, to).bodies[0];
    const Vec2 along = crossed(bob.position.normalized());
    EXPECT_NEAR((bob.velocity - 2.0 * along).norm(), 0.0, 1e-12) << to.transpose();
  }
}

// What nothing holds goes where it is dragged, at its own velocity, though another of the bodies is held.
// Bodies that a rod couples move as one.
TEST(JointHold, OfSeveralBodiesOnlyTheHeldOnesAreHeld) {
  for (const std::size_t free : {0U, 1U}) {
    DragStart start = start_of(disc_at("A", 0.0, -0.5), joint_of(JointKind::kRod, "A", "", {0.0, 0.0}));
    start.bodies[0].velocity = Vec2(1.0, 0.0);
    start.bodies.insert(start.bodies.begin() + static_cast<std::ptrdiff_t>(free), disc_at("B", 0.6, 0.0));
    start.press = start.bodies[0].position;
    const std::size_t bob = 1 - free;
    const Dragged dragged = drag(start, start.press + Vec2(0.15, 0.3), Qt::NoModifier);
    const Body& b = dragged.bodies[free];
    EXPECT_LT((b.position - start.bodies[free].position - Vec2(0.15, 0.3)).norm(), 1e-12) << free;
    EXPECT_EQ(b.velocity, Vec2::Zero());
    const Body& a = dragged.bodies[bob];
    EXPECT_NEAR(a.position.norm(), 0.5, 1e-12);
    EXPECT_NEAR(a.position.dot(a.velocity), 0.0, 1e-12);

    start.joints.push_back(joint_of(JointKind::kRod, "B", "A", Vec2::Zero()));
    const Dragged together = drag(start, start.press + Vec2(0.15, 0.3), Qt::NoModifier);
    EXPECT_NEAR((together.bodies[0].position - together.bodies[1].position).norm(),
                (start.bodies[0].position - start.bodies[1].position).norm(), 1e-12);
    EXPECT_NEAR(together.bodies[bob].position.norm(), 0.5, 1e-12);
  }
}

TEST(JointHold, AStringLetsItComeNearer) {
  Joint string = joint_of(JointKind::kString, "A", "", {0.0, 0.0});
  string.length = 0.5;
  const DragStart start = start_of(disc_at("A", 0.0, -0.4), string);
  EXPECT_TRUE(drag(start, Vec2(0.2, -0.1)).bodies[0].position.isApprox(Vec2(0.2, -0.1), 1e-12));
  const Dragged far = drag(start, Vec2(0.0, -0.9));
  EXPECT_NEAR(far.bodies[0].position.norm(), 0.5, 1e-12);
  EXPECT_TRUE(far.detail.contains("String 1")) << far.detail.toStdString();
}

TEST(JointHold, WithControlTheJointGivesWay) {
  Joint rod = joint_of(JointKind::kRod, "A", "", {0.0, 0.0});
  rod.length = 0.5;
  const DragStart start = start_of(disc_at("A", 0.0, -0.5), rod);
  const Dragged dragged = drag(start, Vec2(0.0, -0.7), Qt::ControlModifier);
  EXPECT_EQ(dragged.bodies[0].position, Vec2(0.0, -0.7));
  ASSERT_TRUE(dragged.refits);
  EXPECT_NEAR(*dragged.joints[0].length, 0.7, 1e-12);
  EXPECT_EQ(drag(start, Vec2(0.0, -0.7)).joints[0].length, 0.5);
  // A pin keeps its place on the body.
  Joint pin = joint_of(JointKind::kPin, "A", "", {0.1, -0.5});
  pin.point = Vec2(0.1, 0.0);
  const Dragged pinned = drag(start_of(disc_at("A", 0.0, -0.5), pin), Vec2(1.0, 0.0), Qt::ControlModifier);
  ASSERT_TRUE(pinned.refits);
  EXPECT_TRUE(pinned.joints[0].anchor.isApprox(Vec2(1.1, 0.0), 1e-12));
}

TEST(JointHold, APinnedBodyTurnsAboutItsPin) {
  Body box = disc_at("A", 0.3, 0.0);
  box.shape = Box{0.8, 0.1};
  box.velocity = Vec2(0.0, 0.6);
  box.spin = 2.0;
  Joint pin = joint_of(JointKind::kPin, "A", "", {0.0, 0.0});
  pin.point = Vec2(-0.3, 0.0);
  const Dragged dragged = drag(start_of(box, pin), Vec2(0.0, 1.0));
  const Body& after = dragged.bodies[0];
  EXPECT_TRUE(after.position.isApprox(Vec2(0.0, 0.3), 1e-12));
  EXPECT_NEAR(after.angle, std::acos(0.0), 1e-12);
  EXPECT_TRUE(after.velocity.isApprox(Vec2(-0.6, 0.0), 1e-12));
}

TEST(JointHold, TwoRodsAllowNothingFarFromBoth) {
  DragStart start = start_of(disc_at("A", 0.0, 0.0), joint_of(JointKind::kRod, "A", "", {-0.5, 0.0}));
  start.joints.push_back(joint_of(JointKind::kWeld, "A", "", {0.0, 0.0}));
  const Dragged dragged = drag(start, Vec2(0.4, 0.0));
  EXPECT_EQ(dragged.bodies[0].position, Vec2(0.0, 0.0));
  // Two rods in a corner leave one place.
  start.joints[1] = joint_of(JointKind::kRod, "A", "", {0.0, -0.4});
  const Dragged corner = drag(start, Vec2(0.06, 0.05));
  EXPECT_NEAR(corner.bodies[0].position.norm(), 0.0, 1e-12);
}

TEST(JointHold, AWeldToThePlaneIsDrawnRed) {
  const Joint weld = joint_of(JointKind::kWeld, "A", "", {0.0, 0.0});
  DragStart start = start_of(disc_at("A", 0.0, 0.0), weld);
  start.kind = HandleKind::kTurn;
  start.press = Vec2(0.2, 0.0);
  const Dragged dragged = drag(start, Vec2(0.0, 0.2));
  EXPECT_TRUE(dragged.fault);
  EXPECT_TRUE(dragged.blocked);
  EXPECT_EQ(dragged.value, "Weld 1 holds A");
  EXPECT_EQ(dragged.bodies[0].angle, 0.0);
}

TEST(JointHold, WeldedAndPinnedBodiesComeAlong) {
  const Body a = disc_at("A", 0.0, 0.0);
  Body post = disc_at("post", 0.0, 1.0);
  post.fixed = true;
  Surroundings beside{{disc_at("B", 0.2, 0.0), disc_at("C", 0.4, 0.0), post, disc_at("D", 2.0, 0.0)}, {}};
  beside.joints = {
      joint_of(JointKind::kPin, "C", "B", {0.2, 0.0}), joint_of(JointKind::kWeld, "A", "B", Vec2::Zero()),
      joint_of(JointKind::kPin, "A", "post", Vec2::Zero()), joint_of(JointKind::kRod, "A", "D", Vec2::Zero())};
  std::vector<Body> followers = followers_of(std::array{a}, beside);
  ASSERT_EQ(followers.size(), 2U);
  Body turned = a;
  turned.angle = std::acos(0.0);
  turned.position = Vec2(1.0, 0.0);
  move_along(followers, a, turned);
  for (const Body& body : followers) {
    const double away = body.name == "B" ? 0.2 : 0.4;
    EXPECT_TRUE(body.position.isApprox(Vec2(1.0, away), 1e-12)) << body.name;
    EXPECT_EQ(body.angle, turned.angle);
  }
}

TEST(JointHold, VelocitiesKeepRodsAtTheirLength) {
  Body bob = disc_at("A", 0.0, -0.5);
  bob.velocity = Vec2(1.0, 0.0);
  const DragStart start = start_of(bob, joint_of(JointKind::kRod, "A", "", {0.0, 0.0}));
  const Body after = drag(start, Vec2(0.5, -0.5)).bodies[0];
  EXPECT_NEAR(after.velocity.dot(after.position), 0.0, 1e-12);
}

TEST(JointHold, AFreePairMovesOnlyTogether) {
  DragStart start = start_of(disc_at("A", 0.0, 0.0), joint_of(JointKind::kRod, "A", "B", Vec2::Zero()));
  start.kind = HandleKind::kVelocity;
  start.others = {disc_at("B", 1.0, 0.0)};
  EXPECT_EQ(drag(start, Vec2(0.5, 0.0)).detail, "A moves only with B: select both");
  start.others[0].fixed = true;
  EXPECT_EQ(drag(start, Vec2(0.5, 0.0)).detail, "Rod 1 allows no other direction");
}

TEST(JointHold, OnItsCircleABodyGoesBackToTouching) {
  Joint rod = joint_of(JointKind::kRod, "A", "", {0.0, 1.0});
  rod.length = 1.0;
  DragStart start = start_of(disc_at("A", -0.6, 0.2), rod);
  start.others = {disc_at("B", 0.02, -0.01)};
  const DragPoint point{Vec2(0.01, 0.0), 100.0, {}};
  const Dragged down = within_joints(start, drag_to(start, point), point);
  ASSERT_EQ(down.overlaps.size(), 1U);
  const std::optional<Dragged> left = without_overlaps(start, down, point);
  ASSERT_TRUE(left);
  EXPECT_FALSE(left->fault);
  EXPECT_NEAR((left->bodies[0].position - Vec2(0.0, 1.0)).norm(), 1.0, 1e-12);
  EXPECT_NEAR((left->bodies[0].position - start.others[0].position).norm(), 0.2, 1e-9);
  EXPECT_LT(left->bodies[0].position.x(), 0.0);
}

// The rod keeps A where it is, and B comes down on it.
TEST(JointHold, SelectedBodiesStayClearOfEachOther) {
  Joint rod = joint_of(JointKind::kRod, "A", "", {0.0, 1.0});
  rod.length = 1.0;
  DragStart start = start_of(disc_at("A", 0.0, 0.0), rod);
  start.bodies.push_back(disc_at("B", 0.02, 0.25));
  const DragPoint point{Vec2(0.0, -0.15), 100.0, {}};
  const Dragged down = within_joints(start, drag_to(start, point), point);
  ASSERT_EQ(down.overlaps.size(), 1U);
  EXPECT_TRUE(down.fault);
  const std::optional<Dragged> left = without_overlaps(start, down, point);
  ASSERT_TRUE(left);
  EXPECT_FALSE(left->fault);
  EXPECT_NEAR((left->bodies[1].position - left->bodies[0].position).norm(), 0.2, 1e-9);
  EXPECT_NEAR((left->bodies[0].position - Vec2(0.0, 1.0)).norm(), 1.0, 1e-12);
}

TEST(JointHold, BodiesThatOverlappedBeforeMayStaySo) {
  DragStart start = start_of(disc_at("A", 0.0, 0.0), joint_of(JointKind::kRod, "A", "", {0.0, 1.0}));
  start.bodies.push_back(disc_at("B", 0.1, 0.1));
  const DragPoint point{Vec2(0.3, 0.0), 100.0, {}};
  EXPECT_TRUE(within_joints(start, drag_to(start, point), point).overlaps.empty());
}

}  // namespace
}  // namespace carom
