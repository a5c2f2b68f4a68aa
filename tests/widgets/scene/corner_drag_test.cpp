#include "widgets/scene/corner_drag.h"

#include <cmath>
#include <gtest/gtest.h>

#include "tests/widgets/scene/scene_tools_fixture.h"
#include "widgets/scene/drag_limits.h"
#include "widgets/scene/value_bubble.h"

namespace carom {
namespace {

Body triangle() {
  Body body;
  body.name = "T";
  body.shape = Polygon{{Vec2(0.0, 0.0), Vec2(0.9, 0.0), Vec2(0.0, 0.9)}};
  body.position = Vec2(3.3, 1.0);  // corners at (3, 0.7), (3.9, 0.7) and (3, 1.6)
  body.mass = 3.0;
  return body;
}

DragStart start_of_corner(std::size_t corner, const Vec2& press) {
  DragStart start;
  start.kind = HandleKind::kCorner;
  start.bodies = {triangle()};
  start.press = press;
  start.corner = corner;
  return start;
}

// 100 px/m.
Dragged drag(const DragStart& start, const Vec2& to, Qt::KeyboardModifiers keys = {}) {
  const DragPoint point{.at = to, .scale = 100.0, .keys = keys};
  return within_joints(start, drag_to(start, point), point);
}

TEST(CornerDragTest, TheOtherCornersAndTheDensityStay) {
  const Dragged moved = drag(start_of_corner(1, Vec2(4.0, 0.7)), Vec2(4.302, 0.698));
  const Body& body = moved.bodies[0];
  EXPECT_TRUE(corner_at(body, 0).isApprox(Vec2(3.0, 0.7), 1e-12));
  EXPECT_TRUE(corner_at(body, 1).isApprox(Vec2(4.2, 0.7), 1e-12));
  EXPECT_TRUE(corner_at(body, 2).isApprox(Vec2(3.0, 1.6), 1e-12));
  EXPECT_TRUE(body.position.isApprox(Vec2(3.4, 1.0), 1e-12));
  EXPECT_NEAR(*body.mass, 4.0, 1e-12);
  EXPECT_EQ(moved.value, "x 4.20 m, y 0.70 m");
  EXPECT_EQ(moved.detail, "m = 4 kg · was x 3.90 m, y 0.70 m");
  EXPECT_FALSE(moved.fault);
}

TEST(CornerDragTest, ShiftKeepsACoordinate) {
  const Dragged moved = drag(start_of_corner(1, Vec2(3.9, 0.7)), Vec2(4.2, 0.8), Qt::ShiftModifier);
  EXPECT_TRUE(corner_at(moved.bodies[0], 1).isApprox(Vec2(4.2, 0.7), 1e-12));
}

TEST(CornerDragTest, TheEndsOfJointsStayInTheScene) {
  DragStart start = start_of_corner(1, Vec2(3.9, 0.7));
  Joint rod;
  rod.id = {7};
  rod.body = "T";
  rod.point = Vec2(-0.1, 0.1);
  start.joints = {rod};
  const Dragged moved = drag(start, Vec2(4.2, 0.7));
  ASSERT_EQ(moved.attached.size(), 1U);
  const Joint& held = std::get<Replace<Joint>>(moved.attached[0]).part;
  EXPECT_TRUE((moved.bodies[0].position + held.point).isApprox(Vec2(3.2, 1.1), 1e-12));
}

// What pulls beside the centre stays at its place of the outline, also when the corner comes back.
TEST(CornerDragTest, SpringsAndForcesStayWhereTheyAre) {
  DragStart start = start_of_corner(1, Vec2(3.9, 0.7));
  Spring spring;
  spring.body = "T";
  spring.point = Vec2(-0.1, 0.1);
  Spring at_centre;
  at_centre.body = "T";
  AppliedForce force;
  force.body = "T";
  force.point = Vec2(0.2, -0.3);
  start.forces.springs = {spring, at_centre};
  start.forces.applied = {force};
  const Dragged moved = drag(start, Vec2(4.2, 0.7));
  ASSERT_EQ(moved.attached.size(), 2U);
  const Vec2 centre = moved.bodies[0].position;
  EXPECT_TRUE(
      (centre + std::get<Replace<Spring>>(moved.attached[0]).part.point).isApprox(Vec2(3.2, 1.1), 1e-12));
  EXPECT_TRUE(
      (centre + std::get<Replace<AppliedForce>>(moved.attached[1]).part.point).isApprox(Vec2(3.5, 0.7), 1e-12));
  const Dragged back = drag(start, Vec2(3.9, 0.7));
  EXPECT_TRUE((std::get<Replace<Spring>>(back.attached.at(0)).part.point - spring.point).norm() < 1e-12);
}

TEST(CornerDragTest, EdgesThatCantBeAreRefused) {
  DragStart start = start_of_corner(1, Vec2(3.9, 0.7));
  start.bodies[0].shape = Polygon{{Vec2(0.0, 0.0), Vec2(0.9, 0.0), Vec2(0.9, 0.9), Vec2(0.0, 0.9)}};
  start.bodies[0].position = Vec2(3.45, 1.15);
  const Dragged crossing = drag(start, Vec2(2.8, 1.2));
  EXPECT_TRUE(crossing.fault);
  EXPECT_EQ(crossing.value, "edges cross");
  EXPECT_EQ(crossing.bodies[0].position, start.bodies[0].position);
  ASSERT_EQ(crossing.refused.size(), 2U);
  EXPECT_TRUE(crossing.refused[0].first.isApprox(Vec2(3.0, 0.7), 1e-12));
  EXPECT_TRUE(crossing.refused[1].first.isApprox(Vec2(3.9, 1.6), 1e-12));
  EXPECT_TRUE(crossing.refused[0].second.isApprox(Vec2(2.8, 1.2), 1e-12));
  EXPECT_FALSE(drag(start, Vec2(3.4, 1.2)).fault);  // a dent
  std::get<Polygon>(start.bodies[0].shape).rounding = 0.05;
  EXPECT_EQ(drag(start, Vec2(3.4, 1.2)).value, "rounded bodies are convex");
}

TEST(CornerDragTest, LetGoInAnotherBodyItGoesBackToTouching) {
  DragStart start = start_of_corner(1, Vec2(3.9, 0.7));
  Body post;
  post.name = "post";
  post.shape = Box{0.2, 2.0};
  post.position = Vec2(4.4, 0.7);  // its left side is x = 4.3
  start.others = {post};
  const DragPoint in{.at = Vec2(4.35, 0.7), .scale = 100.0};
  const Dragged deep = within_joints(start, drag_to(start, in), in);
  EXPECT_EQ(deep.value, "T and post overlap by 5.0 cm");
  const std::optional<Dragged> left = without_overlaps(start, deep, in);
  ASSERT_TRUE(left);
  EXPECT_NEAR(corner_at(left->bodies[0], 1).x(), 4.3, 1e-9);
  EXPECT_TRUE(corner_at(left->bodies[0], 0).isApprox(Vec2(3.0, 0.7), 1e-12));
  EXPECT_EQ(left->detail, "touches post");
}

// The corner of T on the screen is at (490, 230), its handle outside.
class CornerInSceneTest : public SceneToolsTest {
 protected:
  void SetUp() override {
    SceneToolsTest::SetUp();
    answers_ = true;
    scene_.bodies = {triangle()};
    scene_.bodies[0].id = {1};
    show(true);
    view_.select({"T"});
  }
  [[nodiscard]] static QPoint beside(const QPoint& corner) {
    const QPointF out = QPointF(corner) - QPointF(430.0, 200.0);
    return corner + (8.0 / std::hypot(out.x(), out.y()) * out).toPoint();
  }
};

TEST_F(CornerInSceneTest, TheMouseMovesTheCornerThatItHolds) {
  const QPoint handle = beside({490, 230});
  drag(handle, handle + QPoint(30, 0));
  ASSERT_FALSE(told_.empty());
  EXPECT_EQ(told_.back().name, "Resize T");
  EXPECT_TRUE(corner_at(scene_.bodies[0], 1).isApprox(Vec2(4.2, 0.7), 1e-12));
  EXPECT_TRUE(corner_at(scene_.bodies[0], 0).isApprox(Vec2(3.0, 0.7), 1e-12));
}

TEST_F(CornerInSceneTest, ARefusedCornerChangesNothing) {
  const QPoint handle = beside({490, 230});
  press(handle);
  move(handle + QPoint(-20, 0));
  move(handle + QPoint(-90, -90));  // on the line of the others
  EXPECT_EQ(view_.bubble().value, "edges cross");
  EXPECT_TRUE(view_.bubble().fault);
  release(handle + QPoint(-90, -90));
  ASSERT_FALSE(told_.empty());
  EXPECT_EQ(cancelled_, std::vector<int>{told_.front().drag});
}

TEST_F(CornerInSceneTest, ItsPlaceCanBeTyped) {
  const QPoint handle = beside({490, 230});
  press(handle);
  move(handle + QPoint(20, 0));
  release(handle + QPoint(20, 0));
  QTest::mouseDClick(&view_, Qt::LeftButton, {}, beside({510, 230}));
  release(beside({510, 230}));
  auto* field = view_.findChild<ValueField*>();
  ASSERT_TRUE(field->isVisible());
  QTest::keyClicks(field, "4.5 m");
  QTest::keyClick(field, Qt::Key_Return);
  EXPECT_TRUE(corner_at(scene_.bodies[0], 1).isApprox(Vec2(4.5, 0.7), 1e-12));
}

}  // namespace
}  // namespace carom
