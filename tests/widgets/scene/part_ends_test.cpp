#include <QApplication>

#include "tests/widgets/scene/scene_tools_fixture.h"

namespace carom {
namespace {

// 100 px/m: A at (200, 200), B at (400, 200), both at rest.
class PartEndsTest : public SceneToolsTest {
 protected:
  void SetUp() override {
    ASSERT_NO_FATAL_FAILURE(SceneToolsTest::SetUp());
    answers_ = true;
    for (Body& body : scene_.bodies) body.velocity.setZero();
    show(true);
  }
  // A part from A to the plane at (2.0, 2.5), which is (300, 50).
  const Joint& joint(JointKind kind, std::optional<double> length) {
    Joint joint;
    joint.name = "Link 1";
    joint.kind = kind;
    joint.body = "A";
    joint.anchor = Vec2(2.0, 2.5);
    joint.length = length;
    scene_.joints = {joint};
    give_ids(scene_);
    show(true);
    view_.choose_part(scene_.joints.front().id);
    return scene_.joints.front();
  }
  // A force at the centre of A.
  const AppliedForce& pull_of_a(const Vec2& newtons) {
    AppliedForce force;
    force.body = "A";
    force.force = newtons;
    scene_.forces.applied = {force};
    give_ids(scene_);
    show(true);
    view_.choose_part(scene_.forces.applied.front().id);
    return scene_.forces.applied.front();
  }
  const QPoint a_end_{200, 200};
  const QPoint plane_end_{300, 50};
};

TEST_F(PartEndsTest, AnEndOfARodGoesToAnotherBodyOrAPlace) {
  const Joint& rod = joint(JointKind::kRod, std::nullopt);
  drag(plane_end_, QPoint(403, 197));  // near the centre
  EXPECT_EQ(told_.back().name, "Move the end of Link 1");
  EXPECT_EQ(rod.to, "B");
  EXPECT_TRUE(rod.anchor.isZero(0.0));
  EXPECT_FALSE(rod.length);
  drag(QPoint(400, 200), QPoint(398, 130));
  EXPECT_TRUE(rod.to.empty());
  EXPECT_TRUE(rod.anchor.isApprox(Vec2(3.0, 1.7), 0.02));
  EXPECT_NE(told_.front().drag, told_.back().drag);
  EXPECT_TRUE(view_.part());
}

// Bodies lose what the rod forbids in its new place, as with a new one.
TEST_F(PartEndsTest, AMovingBodyKeepsWhatTheRodAllows) {
  const Joint& rod = joint(JointKind::kRod, std::nullopt);
  for (Body& body : scene_.bodies) {
    if (body.name == "A") body.velocity = Vec2(0.3, -0.2);  // across the rod
  }
  show(true);
  drag(plane_end_, QPoint(200, 60));
  ASSERT_FALSE(told_.empty());
  EXPECT_EQ(told_.back().edits.size(), 2U);
  EXPECT_TRUE(rod.anchor.isApprox(Vec2(1.0, 2.4), 0.02));
  for (const Body& body : scene_.bodies) {
    if (body.name != "A") continue;
    EXPECT_NEAR((body.velocity - Vec2(0.3, 0.0)).norm(), 0.0, 1e-9);
  }
}

TEST_F(PartEndsTest, AStatedLengthFollows) {
  const Joint& rod = joint(JointKind::kRod, std::hypot(1.0, 1.5));
  drag(plane_end_, QPoint(200, 60));
  EXPECT_NEAR(*rod.length, 1.4, 1e-12);
  const Joint& string = joint(JointKind::kString, 1.9);
  drag(plane_end_, QPoint(200, 60));
  EXPECT_EQ(string.length, 1.9) << "it is slack";
  drag(QPoint(200, 60), QPoint(200, 1));
  EXPECT_NEAR(*string.length, 2.0, 0.02);
}

TEST_F(PartEndsTest, ASpringKeepsItsRestLength) {
  Spring spring;
  spring.body = "A";
  spring.anchor = Vec2(2.0, 2.5);
  spring.rest_length = 0.7;
  spring.stiffness = 3.0;
  scene_.forces.springs = {spring};
  give_ids(scene_);
  show(true);
  view_.choose_part(scene_.forces.springs.front().id);
  drag(a_end_, QPoint(410, 190));
  EXPECT_EQ(told_.back().name, "Move the end of a spring");
  EXPECT_EQ(scene_.forces.springs.front().body, "B");
  EXPECT_TRUE(scene_.forces.springs.front().anchor.isApprox(Vec2(2.0, 2.5)));
  EXPECT_EQ(scene_.forces.springs.front().rest_length, 0.7);
  EXPECT_EQ(scene_.forces.springs.front().stiffness, 3.0);
}

TEST_F(PartEndsTest, TheTipOfAForceIsPulled) {
  AppliedForce force;
  force.body = "A";
  force.force = Vec2(2.0, 0.0);
  force.end = 3.0;
  scene_.forces.applied = {force};
  give_ids(scene_);
  show(true);
  const PartId part = scene_.forces.applied.front().id;
  view_.choose_part(part);
  ASSERT_FALSE(view_.drawing().arrows.empty());
  const QPoint tip = view_.camera().to_screen(view_.drawing().arrows.back().to.cast<double>()).toPoint();
  press(tip);
  const QPoint twice = tip + (tip - a_end_);
  move(twice);
  QTest::keyClick(&view_, Qt::Key_Escape);
  release(twice);
  ASSERT_EQ(told_.size(), 1U);
  EXPECT_EQ(cancelled_, std::vector<int>{told_[0].drag});
  scene_.forces.applied.front().force = Vec2(2.0, 0.0);
  show(true);
  drag(tip, twice);
  ASSERT_FALSE(told_.empty());
  EXPECT_TRUE(told_.back().name.startsWith("Force on A 2.00 → 4.")) << told_.back().name.toStdString();
  EXPECT_NEAR(scene_.forces.applied.front().force.x(), 4.0, 0.1);
  EXPECT_EQ(scene_.forces.applied.front().force.y(), 0.0);
  EXPECT_EQ(scene_.forces.applied.front().end, 3.0);
}

// The foot of a force that has been pulled out of A, to a place of A, of B, and of nothing.
TEST_F(PartEndsTest, TheFootOfAForceIsDraggedToWhereItActs) {
  const AppliedForce& force = pull_of_a(Vec2(0.0, 8.0));
  drag(a_end_, QPoint(220, 210));
  EXPECT_EQ(told_.back().name, "Move the foot of a force on A");
  EXPECT_TRUE(force.point.isApprox(Vec2(0.2, -0.1), 1e-9));
  EXPECT_EQ(force.force, Vec2(0.0, 8.0));
  drag(QPoint(220, 210), QPoint(247, 200));  // 3 px from the rim
  EXPECT_TRUE(force.point.isApprox(Vec2(0.5, 0.0), 1e-9));
  drag(QPoint(250, 200), QPoint(402, 197));  // near the centre of B
  EXPECT_EQ(force.body, "B");
  EXPECT_TRUE(force.point.isZero(0.0));
  const std::size_t told = told_.size();
  drag(QPoint(400, 200), QPoint(300, 60));
  EXPECT_EQ(force.body, "B");
  EXPECT_TRUE(force.point.isZero(0.0));
  EXPECT_GE(told_.size(), told);
}

TEST_F(PartEndsTest, TheFootOfAForceTakesATypedPlace) {
  const AppliedForce& force = pull_of_a(Vec2(0.0, 8.0));
  view_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&view_));
  view_.setFocus();
  press(a_end_);
  move(QPoint(220, 210));
  const auto type = [](Qt::Key key) { QTest::keyClick(QApplication::focusWidget(), key); };
  type(Qt::Key_Period);
  type(Qt::Key_3);
  type(Qt::Key_Return);
  release(QPoint(220, 210));
  EXPECT_TRUE(force.point.isApprox(Vec2(0.3, -0.1), 1e-9));
}

// There it has no length that a digit could change.
TEST_F(PartEndsTest, ADigitOnTheOtherEndLeavesTheDragGoing) {
  const Joint& rod = joint(JointKind::kRod, std::nullopt);
  press(a_end_);
  move(QPoint(230, 170));
  move(plane_end_);
  QTest::keyClick(&view_, Qt::Key_3);
  move(QPoint(403, 197));
  release(QPoint(403, 197));
  EXPECT_EQ(rod.body, "B");
  EXPECT_TRUE(cancelled_.empty());
}

TEST_F(PartEndsTest, AnEndOfASpringHoldsToAPointOfABody) {
  Spring spring;
  spring.body = "A";
  spring.anchor = Vec2(2.0, 2.5);
  scene_.forces.springs = {spring};
  give_ids(scene_);
  show(true);
  view_.choose_part(scene_.forces.springs.front().id);
  drag(a_end_, QPoint(170, 180));
  EXPECT_TRUE(scene_.forces.springs.front().point.isApprox(Vec2(-0.3, 0.2), 1e-9));
  drag(plane_end_, QPoint(424, 201));  // 1 px from the rim of B
  EXPECT_EQ(scene_.forces.springs.front().to, "B");
  EXPECT_NEAR(scene_.forces.springs.front().anchor.norm(), 0.25, 1e-9);
  drag(QPoint(170, 180), QPoint(205, 203));
  EXPECT_TRUE(scene_.forces.springs.front().point.isZero(0.0));
}

TEST_F(PartEndsTest, WhatCannotBeChangesNothing) {
  const Joint& rod = joint(JointKind::kRod, std::nullopt);
  drag(a_end_, QPoint(450, 60));  // both in the plane
  EXPECT_TRUE(told_.empty());
  drag(plane_end_, QPoint(210, 230));  // both on A
  EXPECT_EQ(cancelled_.size(), 1U);
  const std::size_t told = told_.size();
  drag(QPoint(250, 125), QPoint(450, 60));  // not an end
  EXPECT_EQ(told_.size(), told);
  EXPECT_EQ(rod.body, "A");
  EXPECT_EQ(rod.anchor, Vec2(2.0, 2.5));
}

// One step of undo, in which the scene follows the mouse at every move.
TEST_F(PartEndsTest, TheSceneFollowsTheDrag) {
  const Joint& rod = joint(JointKind::kRod, std::nullopt);
  press(plane_end_);
  for (const int x : {320, 330, 340}) {
    move(QPoint(x, 60));
    EXPECT_TRUE(rod.anchor.isApprox(Vec2(0.01 * x - 1.0, 2.4), 0.02)) << x;
    EXPECT_EQ(told_.back().drag, told_.front().drag);
  }
  EXPECT_EQ(told_.size(), 3U);
  release(QPoint(340, 60));
  EXPECT_EQ(told_.size(), 3U);
  EXPECT_TRUE(cancelled_.empty());
}

// While an end is where it can't be, the part is as it was; let go there, it stays so.
TEST_F(PartEndsTest, AnEndThatCannotBeGoesBack) {
  const Joint& rod = joint(JointKind::kRod, std::nullopt);
  press(plane_end_);
  move(QPoint(320, 60));
  EXPECT_FALSE(rod.anchor.isApprox(Vec2(2.0, 2.5)));
  move(QPoint(210, 230));  // on A, too
  EXPECT_TRUE(rod.anchor.isApprox(Vec2(2.0, 2.5)));
  EXPECT_TRUE(cancelled_.empty());
  move(QPoint(320, 60));
  EXPECT_TRUE(rod.anchor.isApprox(Vec2(2.2, 2.4), 0.02));
  move(QPoint(210, 230));
  release(QPoint(210, 230));
  EXPECT_EQ(cancelled_, std::vector<int>{told_.front().drag});
}

// What the rod forbids in one place of its end, it allows in the next.
TEST_F(PartEndsTest, VelocitiesComeBackWithinADrag) {
  joint(JointKind::kRod, std::nullopt);
  const auto velocity = [this](const char* name) {
    for (const Body& body : scene_.bodies) {
      if (body.name == name) return body.velocity;
    }
    return Vec2(Vec2::Zero());
  };
  for (Body& body : scene_.bodies) {
    if (body.name == "A") body.velocity = Vec2(0.3, -0.2);  // across the rod
  }
  show(true);
  press(plane_end_);
  move(QPoint(400, 200));  // on B
  EXPECT_NEAR(velocity("A").x(), velocity("B").x(), 1e-12);
  EXPECT_GT(velocity("B").norm(), 0.05);
  move(plane_end_);
  EXPECT_TRUE(velocity("A").isApprox(Vec2(0.3, -0.2), 1e-12));
  EXPECT_EQ(velocity("B"), Vec2(0.0, 0.0));
  release(plane_end_);
}

TEST_F(PartEndsTest, TheHintSaysThatALengthCanBeTyped) {
  QString hint;
  QObject::connect(&view_, &SceneView::hintChanged, [&](const QString& text) { hint = text; });
  joint(JointKind::kRod, std::nullopt);
  QTest::mouseMove(&view_, plane_end_);
  EXPECT_EQ(hint, "drag: to another body or place · double click: type the length");
  press(plane_end_);
  move(plane_end_ + QPoint(10, 10));
  EXPECT_EQ(hint, "to a body or a place · Ctrl: no snapping · digits: type the length · Esc: back");
  release(plane_end_ + QPoint(10, 10));
}

TEST_F(PartEndsTest, TheHintOfAForceSaysWhatItsTipDoes) {
  QString hint;
  QObject::connect(&view_, &SceneView::hintChanged, [&](const QString& text) { hint = text; });
  pull_of_a(Vec2(0.0, 10.0));
  const QPoint tip = view_.camera().to_screen(view_.drawing().arrows.back().to.cast<double>()).toPoint();
  QTest::mouseMove(&view_, a_end_);
  EXPECT_EQ(hint, "drag: where the force acts · double click: type the force");
  QTest::mouseMove(&view_, tip);
  EXPECT_EQ(hint, "drag: size and direction · Shift: one axis · double click: type it");
  press(tip);
  move(tip + QPoint(10, 10));
  EXPECT_EQ(hint, "Shift: one axis · Ctrl: no snapping · digits: type the force · Esc: back");
  release(tip + QPoint(10, 10));
}

}  // namespace
}  // namespace carom
