#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>

#include "tests/app/lab/hands_fixture.h"

// Keys that edit the selection of a run that plays.
namespace carom {
namespace {

class LabPlayEditTest : public LabHandsTest {
 protected:
  void SetUp() override {
    ASSERT_NO_FATAL_FAILURE(LabHandsTest::SetUp());
    name_ = window_.preset().scene.bodies[0].name;
    window_.scene_view().select({name_});
    window_.session().runs().set_playing(true);
    ASSERT_TRUE(wait_for([this] { return time() > 0.02 && window_.frame()->playing; }));
    window_.scene_view().setFocus();
  }
  [[nodiscard]] bool pauses() {
    return wait_for([this] { return !window_.frame()->playing && window_.frame()->scene; });
  }
  [[nodiscard]] bool inspector_says(const QString& text) {
    for (const QLabel* label : window_.findChild<Inspector*>()->findChildren<QLabel*>()) {
      if (label->isVisibleTo(&window_) && label->text().contains(text)) return true;
    }
    return false;
  }
  [[nodiscard]] QString undo_text() { return window_.session().edits().undoText(); }

  std::string name_;
};

TEST_F(LabPlayEditTest, DeletePausesAndDeletes) {
  key(Qt::Key_Delete);
  ASSERT_TRUE(pauses());
  EXPECT_TRUE(wait_for([this] { return window_.frame()->bodies->size() == 1; }));
  EXPECT_TRUE(undo_text().contains(": Delete")) << undo_text().toStdString();
}

TEST_F(LabPlayEditTest, ArrowsPauseAndMove) {
  key(Qt::Key_Up);
  key(Qt::Key_Up);
  ASSERT_TRUE(pauses());
  ASSERT_TRUE(wait_for([this] { return undo_text().contains(": Move"); })) << undo_text().toStdString();
  EXPECT_TRUE(wait_for([this] { return time() == 0.0; })) << "a new start";
  EXPECT_EQ(window_.session().edits().count(), 1) << "one row of keys";
}

TEST_F(LabPlayEditTest, ANewStartIsSaidAtOnce) {
  key(Qt::Key_Up);
  ASSERT_TRUE(pauses());
  ASSERT_TRUE(wait_for([this] { return undo_text().contains(": Move"); })) << undo_text().toStdString();
  const QList<QPushButton*> chips = window_.findChildren<QPushButton*>("chip");
  EXPECT_TRUE(std::any_of(chips.begin(), chips.end(), [](const QPushButton* chip) {
    static const QRegularExpression kSaid(R"(^new start, from 0\.\d{3} s)");
    return chip->isVisible() && kSaid.match(chip->text()).hasMatch();
  }));
}

TEST_F(LabPlayEditTest, SizeAndVelocityChangeAndTheInspectorShowsTheMoment) {
  EXPECT_TRUE(inspector_says("Pause to edit"));
  const double radius = std::get<Disc>(window_.preset().scene.bodies[0].shape).radius;
  key(Qt::Key_Plus);
  ASSERT_TRUE(pauses());
  ASSERT_TRUE(wait_for([this] { return undo_text().startsWith("Resize"); })) << undo_text().toStdString();
  EXPECT_TRUE(wait_for([&] { return std::get<Disc>(now(name_).shape).radius > 1.04 * radius; }));
  EXPECT_FALSE(inspector_says("Pause to edit"));
  window_.session().runs().set_playing(true);
  ASSERT_TRUE(wait_for([this] { return window_.frame()->playing; }));
  key(Qt::Key_Right, Qt::ControlModifier);
  ASSERT_TRUE(pauses());
  EXPECT_TRUE(wait_for([this] { return undo_text().contains(": Speed"); })) << undo_text().toStdString();
  EXPECT_FALSE(inspector_says("Pause to edit"));
}

}  // namespace
}  // namespace carom
