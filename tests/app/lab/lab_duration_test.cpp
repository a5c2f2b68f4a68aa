#include "tests/app/lab/hands_fixture.h"
#include "widgets/run/stop_editor.h"
#include "widgets/run/timeline.h"

// The duration and the stops of runs in the inspector of the scene. Head-on lasts one second.
namespace carom {
namespace {

class LabDurationTest : public LabHandsTest {
 protected:
  [[nodiscard]] double duration() const { return window_.preset().duration; }
  [[nodiscard]] bool stands_at(double time) {
    const auto there = [&] {
      return !window_.frame()->playing && std::abs(window_.frame()->time - time) < 1e-9;
    };
    return wait_for(there);
  }
};

TEST_F(LabDurationTest, IsTypedTakenBackAndEndsTheRun) {
  type("Duration, s", "0.6");
  EXPECT_EQ(duration(), 0.6);
  EXPECT_EQ(window_.session().edits().undoText(), "Duration 1.00 → 0.600 s");
  EXPECT_EQ(window_.findChild<Timeline*>()->end(), 0.6);
  EXPECT_TRUE(window_.isWindowModified());
  choose_speed(4.0);
  key(Qt::Key_Space);
  EXPECT_TRUE(stands_at(0.6));
  undo();  // the run
  undo();
  EXPECT_EQ(duration(), 1.0);
  EXPECT_EQ(window_.findChild<Timeline*>()->end(), 1.0);
  key(Qt::Key_Space);
  EXPECT_TRUE(stands_at(1.0));
}

TEST_F(LabDurationTest, EndsARunThatPlays) {
  choose_speed(0.25);
  key(Qt::Key_Space);
  ASSERT_TRUE(wait_for([this] { return window_.frame()->playing; }));
  type("Duration, s", "0.4");
  EXPECT_TRUE(window_.frame()->playing);
  EXPECT_TRUE(stands_at(0.4));
}

TEST_F(LabDurationTest, TheButtonOpensTheEditorOfTheStops) {
  for (QAbstractButton* each : window_.findChild<Inspector*>()->findChildren<QAbstractButton*>()) {
    if (each->accessibleName() == "Edit the stops") QTest::mouseClick(each, Qt::LeftButton);
  }
  EXPECT_TRUE(window_.findChild<StopEditor*>()->isVisible());
}

}  // namespace
}  // namespace carom
