#include "tests/widgets/scene/scene_tools_fixture.h"

namespace carom {
namespace {

class SceneLocksTest : public SceneToolsTest {
 protected:
  void key(Qt::Key k) { QTest::keyClick(&view_, k); }
  void lock(const Names& names) {
    view_.select(names);
    key(Qt::Key_L);
  }
};

TEST_F(SceneLocksTest, ALockedBodyIsChangedNeitherByTheMouseNorByKeys) {
  lock({"A"});
  drag(a_, a_ + QPoint(40, 0));
  for (const Qt::Key k : {Qt::Key_Right, Qt::Key_BracketLeft, Qt::Key_Plus, Qt::Key_0, Qt::Key_Delete}) key(k);
  EXPECT_TRUE(told_.empty());
  lock({"A"});
  drag(a_, a_ + QPoint(40, 0));
  EXPECT_FALSE(told_.empty());
}

TEST_F(SceneLocksTest, OthersGoOnWithoutIt) {
  lock({"A"});
  view_.select({"A", "B"});
  drag(b_, b_ + QPoint(0, -30), Qt::ControlModifier);
  ASSERT_FALSE(told_.empty());
  ASSERT_EQ(told_.back().edits.size(), 1U);
  EXPECT_EQ(replaced(told_.back().edits[0]).name, "B");
  key(Qt::Key_Delete);
  EXPECT_EQ(told_.back().name, "Delete B");
  const std::size_t told = told_.size();
  key(Qt::Key_K);  // would move A
  EXPECT_EQ(told_.size(), told);
  view_.select({"B", "A"});
  key(Qt::Key_K);
  EXPECT_EQ(told_.back().name, "Put B in touch with A");
}

TEST_F(SceneLocksTest, NothingTakesALockedBodyAlong) {
  Joint weld;
  weld.kind = JointKind::kWeld;
  weld.body = "A";
  weld.to = "B";
  weld.point = Vec2(1.0, 0.0);
  weld.anchor = Vec2(-1.0, 0.0);
  for (Body& body : scene_.bodies) body.velocity.setZero();
  scene_.joints = {weld};
  give_ids(scene_);
  show(true);
  lock({"A"});
  drag(b_, b_ + QPoint(0, -30));
  key(Qt::Key_Up);
  EXPECT_TRUE(told_.empty());
}

TEST_F(SceneLocksTest, ALockFollowsANewNameAndEndsWithTheScene) {
  lock({"A"});
  scene_.bodies[1].name = "light";
  show(true);
  drag(a_, a_ + QPoint(40, 0));
  EXPECT_TRUE(told_.empty());
  view_.set_view(View{Vec2(2.0, 1.0), 6.0});
  drag(a_, a_ + QPoint(40, 0));
  EXPECT_FALSE(told_.empty());
}

}  // namespace
}  // namespace carom
