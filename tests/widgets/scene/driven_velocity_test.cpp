#include "tests/widgets/scene/scene_tools_fixture.h"
#include "widgets/edit/driven.h"

// The velocity of a body that is driven straight on is pulled, typed and changed by keys as that of others.
namespace carom {
namespace {

class DrivenVelocityTest : public SceneToolsTest {
 protected:
  void SetUp() override {
    SceneToolsTest::SetUp();
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
  [[nodiscard]] const Drive& told_drive() const { return *replaced(told_.back().edits.at(0)).drive; }
};

TEST_F(DrivenVelocityTest, ItsArrowIsPulled) {
  answers_ = true;
  drag(tip(), tip() + QPoint(40, -20));
  ASSERT_FALSE(told_.empty());
  EXPECT_TRUE(told_.back().name.contains("A")) << told_.back().name.toStdString();
  const Body& body = replaced(told_.back().edits.at(0));
  ASSERT_TRUE(body.drive);
  EXPECT_GT(body.drive->velocity.x(), 1.0);
  EXPECT_GT(body.drive->velocity.y(), 0.0);
  EXPECT_TRUE(body.velocity.isZero(0.0)) << "as a scene states it";
  EXPECT_TRUE(body.position.isApprox(Vec2(1.0, 1.0)));
}

TEST_F(DrivenVelocityTest, KeysChangeIt) {
  answers_ = true;
  QTest::keyClick(&view_, Qt::Key_Right, Qt::ControlModifier);
  ASSERT_EQ(told_.size(), 1U);
  EXPECT_NEAR(told_drive().velocity.x(), 1.1, 1e-12);
  QTest::keyClick(&view_, Qt::Key_X);
  EXPECT_NEAR(told_drive().velocity.x(), -1.1, 1e-12);
  QTest::keyClick(&view_, Qt::Key_0);
  EXPECT_TRUE(told_drive().velocity.isZero(0.0));
  EXPECT_EQ(replaced(told_.back().edits.at(0)).spin, 0.0);
}

TEST_F(DrivenVelocityTest, AMoveKeepsItsDrive) {
  for (const Drive& each :
       {Drive{.velocity = Vec2(1.0, 0.0)},
        Drive{.velocity = Vec2::Zero(), .amplitude = Vec2(0.2, 0.0), .angular_frequency = 3.0}}) {
    drive(each);
    QTest::keyClick(&view_, Qt::Key_Up);
    ASSERT_EQ(told_.size(), 1U);
    EXPECT_EQ(told_drive(), each);
    EXPECT_TRUE(replaced(told_[0].edits.at(0)).velocity.isZero(0.0));
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
