#include "tests/widgets/scene/scene_tools_fixture.h"
#include "widgets/edit/driven.h"
#include "widgets/scene/value_bubble.h"

// The velocity of a body that is driven straight on is pulled, typed and changed by keys as that of others.
namespace carom {
namespace {

class DrivenVelocityTest : public SceneToolsTest {
 protected:
  void SetUp() override {
    SceneToolsTest::SetUp();
    // As the window does with what it is told of bodies as they are seen.
    QObject::connect(&view_, &SceneView::edited, [this](const SceneEdits& edits) {
      stated_ = as_stated(edits, scene_, 0.0, true);
      apply_edits(scene_, stated_);
      show(true);
    });
    drive({.velocity = Vec2(1.0, 0.0)});
  }
  void drive(const Drive& drive) {
    scene_.bodies[1] = driven(scene_.bodies[1], drive);
    ++run_;
    show(true);
    view_.scene_edited();
    view_.select({"A"});
    told_.clear();
  }
  [[nodiscard]] QPoint tip() const {
    return view_.camera().to_screen(view_.drawing().arrows.at(0).to).toPoint();
  }
  [[nodiscard]] const Body& stated() const { return replaced(stated_.at(0)); }

  SceneEdits stated_;
};

TEST_F(DrivenVelocityTest, ItsArrowIsPulled) {
  drag(tip(), tip() + QPoint(40, -20));
  ASSERT_FALSE(told_.empty());
  EXPECT_TRUE(told_.back().name.contains("A")) << told_.back().name.toStdString();
  const Body& body = stated();
  ASSERT_TRUE(body.drive);
  EXPECT_GT(body.drive->velocity.x(), 1.0);
  EXPECT_GT(body.drive->velocity.y(), 0.0);
  EXPECT_TRUE(body.velocity.isZero(0.0)) << "as a scene states it";
  EXPECT_TRUE(body.position.isApprox(Vec2(1.0, 1.0)));
}

TEST_F(DrivenVelocityTest, KeysChangeIt) {
  QTest::keyClick(&view_, Qt::Key_Right, Qt::ControlModifier);
  ASSERT_EQ(told_.size(), 1U);
  EXPECT_NEAR(stated().drive.value().velocity.x(), 1.1, 1e-12);
  QTest::keyClick(&view_, Qt::Key_X);
  EXPECT_NEAR(stated().drive.value().velocity.x(), -1.1, 1e-12);
  QTest::keyClick(&view_, Qt::Key_0);
  EXPECT_TRUE(stated().drive.value().velocity.isZero(0.0));
  EXPECT_EQ(stated().spin, 0.0);
}

TEST_F(DrivenVelocityTest, ItIsTyped) {
  drag(tip(), tip() + QPoint(40, 0));
  QTest::keyClick(&view_, Qt::Key_3);  // into the bubble
  auto* field = view_.findChild<ValueField*>();
  ASSERT_TRUE(field->isVisible());
  EXPECT_EQ(field->text(), "3");
  QTest::keyClick(field, Qt::Key_Return);
  EXPECT_TRUE(stated().drive.value().velocity.isApprox(Vec2(3.0, 0.0)));
}

TEST_F(DrivenVelocityTest, AMoveKeepsItsDrive) {
  for (const Drive& each :
       {Drive{.velocity = Vec2(1.0, 0.0)},
        Drive{.velocity = Vec2::Zero(), .amplitude = Vec2(0.2, 0.0), .angular_frequency = 3.0}}) {
    drive(each);
    QTest::keyClick(&view_, Qt::Key_Up);
    ASSERT_EQ(told_.size(), 1U);
    EXPECT_EQ(stated().drive.value(), each);
    EXPECT_TRUE(stated().velocity.isZero(0.0));
  }
}

// Where there is none to change, that is said.
TEST_F(DrivenVelocityTest, WhatOscillatesAndWhatIsFixedSayWhyNot) {
  drive({.velocity = Vec2::Zero(), .amplitude = Vec2(0.2, 0.0), .angular_frequency = 3.0});
  QTest::keyClick(&view_, Qt::Key_Right, Qt::ControlModifier);
  EXPECT_TRUE(told_.empty());
  EXPECT_EQ(view_.bubble().value, "A goes to and fro");
  view_.select({"floor"});
  QTest::keyClick(&view_, Qt::Key_Right, Qt::ControlModifier);
  EXPECT_TRUE(told_.empty());
  EXPECT_EQ(view_.bubble().value, "floor is fixed");
}

}  // namespace
}  // namespace carom
