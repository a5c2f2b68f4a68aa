#include <QPushButton>

#include "tests/app/lab/lab_fixture.h"
#include "tests/app/lab/two_discs.h"

namespace carom {
namespace {

// Two discs that fly away to the right, side by side, out of a view 4 m wide.
class LabFollowTest : public LabWindowTest {
 protected:
  void SetUp() override {
    ASSERT_NO_FATAL_FAILURE(LabWindowTest::SetUp());
    Preset preset = two_discs();
    preset.view = View{Vec2::Zero(), 4.0};
    preset.duration = 1000.0;
    preset.scene.bodies[0].velocity = preset.scene.bodies[1].velocity = Vec2(10.0, 1.0);
    window_.show_scene(preset, {}, {});
    ASSERT_TRUE(wait_for([this] { return window_.frame()->scene != nullptr; }));
    home_ = view().camera().center;
  }
  SceneView& view() { return window_.scene_view(); }
  QPushButton* offer() {
    for (auto* button : window_.findChildren<QPushButton*>("chip")) {
      if (button->text() == "Follow (F)") return button;
    }
    throw std::runtime_error("no offer to follow");
  }
  [[nodiscard]] bool all_seen() {
    const WorldRect seen = view().camera().visible();
    for (int i = 0; i < window_.frame()->state.size(); ++i) {
      if (!seen.meets(window_.frame()->state.position(i), 0.0)) return false;
    }
    return true;
  }
  Vec2 home_ = Vec2::Zero();
};

TEST_F(LabFollowTest, IsOfferedASecondAfterAllHaveLeftTheView) {
  QTest::keyClick(&view(), Qt::Key_F);
  EXPECT_FALSE(view().follows());
  QTest::keyClick(&view(), Qt::Key_F);
  EXPECT_EQ(view().camera().center, home_) << "the scene's view and all bodies, in turn";
  QTest::keyClick(&view(), Qt::Key_Space);
  QElapsedTimer since_left;
  ASSERT_TRUE(wait_for([&] {
    if (!all_seen() && !since_left.isValid()) since_left.start();
    return offer()->isVisible();
  }));
  EXPECT_GE(since_left.elapsed(), 900);
  const double scale = view().camera().scale;
  QTest::keyClick(&view(), Qt::Key_F);
  EXPECT_TRUE(view().follows());
  EXPECT_FALSE(offer()->isVisible());
  const double left_at = time();
  ASSERT_TRUE(wait_for([&] { return time() > left_at + 1.0; }));
  EXPECT_TRUE(all_seen());
  EXPECT_EQ(view().camera().scale, scale) << "they stay together";
  QTest::keyClick(&view(), Qt::Key_Left);
  EXPECT_FALSE(view().follows()) << "the user moved the camera";
  ASSERT_TRUE(wait_for([&] { return offer()->isVisible(); }));
  QTest::mouseClick(offer(), Qt::LeftButton);
  EXPECT_TRUE(view().follows());
  EXPECT_TRUE(all_seen());
  QTest::keyClick(&view(), Qt::Key_F);
  EXPECT_FALSE(view().follows());
  EXPECT_EQ(view().camera().center, home_);
}

TEST_F(LabFollowTest, ShowsMoreWhereTheySpread) {
  Preset preset = window_.preset();
  preset.scene.bodies[0].velocity = Vec2(10.0, 0.0);
  preset.scene.bodies[1].velocity = Vec2(14.0, 0.0);
  preset.scene.bodies[1].position = preset.scene.bodies[0].position + Vec2(1.0, 0.0);
  window_.show_scene(preset, {}, {});
  QTest::keyClick(&view(), Qt::Key_Space);
  ASSERT_TRUE(wait_for([&] { return offer()->isVisible(); }));
  const double scale = view().camera().scale;
  view().follow();
  const double now = time();
  ASSERT_TRUE(wait_for([&] { return time() > now + 1.0; }));
  EXPECT_TRUE(all_seen());
  EXPECT_LT(view().camera().scale, scale);
}

}  // namespace
}  // namespace carom
