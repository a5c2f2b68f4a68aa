#include "widgets/scene/key_edits.h"

#include <gtest/gtest.h>
#include <numbers>

namespace carom {
namespace {

class KeyEditsTest : public testing::Test {
 protected:
  KeyEditsTest() {
    body_.name = "light";
    body_.position = Vec2(0.3, 0.1);
    body_.velocity = Vec2(1.0, -0.5);
    body_.spin = 2.0;
  }
  [[nodiscard]] Body after(int key, Qt::KeyboardModifiers keys = {}) const {
    return edited_by_key(std::vector<Body>{body_}, key, keys, 0.1)[0];
  }
  Body body_;
};

TEST_F(KeyEditsTest, ArrowsMoveByTheGrid) {
  EXPECT_EQ(after(Qt::Key_Right).position, Vec2(0.4, 0.1));
  EXPECT_EQ(after(Qt::Key_Down, Qt::ShiftModifier).position, Vec2(0.3, -0.9));
}

TEST_F(KeyEditsTest, ControlAndArrowsChangeTheVelocity) {
  EXPECT_EQ(after(Qt::Key_Up, Qt::ControlModifier).velocity, Vec2(1.0, -0.4));
  EXPECT_EQ(after(Qt::Key_Left, Qt::ControlModifier | Qt::ShiftModifier).velocity, Vec2(0.0, -0.5));
}

TEST_F(KeyEditsTest, BracketsTurn) {
  EXPECT_NEAR(after(Qt::Key_BracketLeft).angle, 5.0 * std::numbers::pi / 180.0, 1e-15);
  EXPECT_NEAR(after(Qt::Key_BracketRight).angle, -5.0 * std::numbers::pi / 180.0, 1e-15);
  EXPECT_NEAR(after(Qt::Key_BraceLeft, Qt::ShiftModifier).angle, 45.0 * std::numbers::pi / 180.0, 1e-15);
}

// Which of the two is typed with Shift depends on the keyboard.
TEST_F(KeyEditsTest, LessAndGreaterTurn) {
  for (const auto keys : {Qt::NoModifier, Qt::ShiftModifier}) {
    EXPECT_NEAR(after(Qt::Key_Less, keys).angle, 5.0 * std::numbers::pi / 180.0, 1e-15);
    EXPECT_NEAR(after(Qt::Key_Greater, keys).angle, -5.0 * std::numbers::pi / 180.0, 1e-15);
  }
  EXPECT_FALSE(key_edit(Qt::Key_Greater, Qt::ControlModifier | Qt::ShiftModifier));
}

TEST_F(KeyEditsTest, RestAndReverse) {
  EXPECT_EQ(after(Qt::Key_0).velocity, Vec2(0.0, 0.0));
  EXPECT_EQ(after(Qt::Key_0).spin, 0.0);
  EXPECT_EQ(after(Qt::Key_X).velocity, Vec2(-1.0, 0.5));
  EXPECT_EQ(after(Qt::Key_X).spin, -2.0);
  EXPECT_FALSE(key_edit(Qt::Key_X, Qt::ControlModifier));  // cuts
}

TEST_F(KeyEditsTest, SaysTheNewValue) {
  EXPECT_EQ(value_of(KeyEdit::kMove, after(Qt::Key_Left), 100.0), "x 0.20 m, y 0.10 m");
  EXPECT_EQ(value_of(KeyEdit::kTurn, after(Qt::Key_BracketRight), 100.0), QString(QChar(0x2212)) + "5°");
  EXPECT_EQ(value_of(KeyEdit::kVelocity, after(Qt::Key_0), 100.0), "0.00 m/s");
}

TEST(DeletionTest, TakesLinksAlong) {
  Scene scene;
  for (const char* name : {"light", "heavy"}) {
    Body body;
    body.name = name;
    scene.bodies.push_back(body);
  }
  Joint rod;
  rod.body = "heavy";
  rod.to = "light";
  scene.joints = {rod};
  AppliedForce force;
  force.body = "light";
  scene.forces.applied = {force};
  give_ids(scene);
  const Deletion light = deletion(scene, std::vector<std::string>{"light"});
  EXPECT_EQ(light.name, "Delete light and 1 rod");
  apply_edits(scene, light.edits);
  EXPECT_EQ(scene.bodies.size(), 1U);
  EXPECT_TRUE(scene.joints.empty());
  EXPECT_TRUE(scene.forces.applied.empty());
  EXPECT_EQ(deletion(scene, std::vector<std::string>{"heavy"}).name, "Delete heavy");
}

}  // namespace
}  // namespace carom
