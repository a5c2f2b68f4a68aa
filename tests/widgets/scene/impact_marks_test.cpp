#include "widgets/scene/impact_marks.h"

#include "tests/support/run_fixture.h"
#include "tests/widgets/scene/scene_view_fixture.h"

// A hits B at 0.2 s at (-0.2, 0).
namespace carom {
namespace {

class ImpactMarks : public SceneViewFixture {
 protected:
  void SetUp() override {
    SceneViewFixture::SetUp();
    QObject::connect(&view_, &SceneView::impactChosen, [this](double time) { chosen_.push_back(time); });
  }
  void show_at(double time, bool playing = false) {
    auto frame = std::make_shared<Frame>(run_to(head_on_scene(), time));
    frame->playing = playing;
    view_.set_frame(frame);
  }
  void click(const QPoint& at, Qt::KeyboardModifiers keys = {}) {
    QTest::mouseClick(&view_, Qt::LeftButton, keys, at);
  }

  const QPoint mark_{280, 200};
  std::vector<double> chosen_;
};

TEST_F(ImpactMarks, AClickGoesToTheMoment) {
  show_at(0.25);
  ASSERT_EQ(view_.drawing().marks.size(), 1U);
  click(mark_ + QPoint(3, -3));
  ASSERT_EQ(chosen_.size(), 1U);
  EXPECT_NEAR(chosen_.front(), 0.2, 1e-12);
  EXPECT_TRUE(view_.selection().empty()) << "the body under it is not selected";
  click(mark_ + QPoint(30, 0));
  EXPECT_EQ(chosen_.size(), 1U) << "farther away is the body";
  EXPECT_EQ(view_.selection(), std::vector<std::string>{"B"});
}

TEST_F(ImpactMarks, AreForTheSelectToolOfAPausedRun) {
  show_at(0.25, true);
  click(mark_);
  EXPECT_TRUE(chosen_.empty()) << "while it plays a click selects";
  show_at(0.26);
  click(mark_, Qt::ShiftModifier);
  EXPECT_TRUE(chosen_.empty()) << "Shift adds to the selection";
  view_.set_tool(SceneTool::kDisc, true);
  click(mark_);
  EXPECT_TRUE(chosen_.empty()) << "a tool does what it does";
}

TEST_F(ImpactMarks, WhatIsNotDrawnIsNotThere) {
  show_at(0.5);
  click(mark_);
  EXPECT_TRUE(chosen_.empty()) << "it has faded";
  show_at(0.25);
  DrawingOptions options = view_.options();
  options.contacts = false;
  view_.set_options(options);
  click(mark_);
  EXPECT_TRUE(chosen_.empty());
}

TEST_F(ImpactMarks, ItsTooltipSaysWhoWhenAndHowHard) {
  Frame frame = run_to(head_on_scene(), 0.25);
  ASSERT_EQ(frame.impacts.size(), 1U);
  // e = 1, so 2 · 2/3 kg · 3 m/s.
  const QString text = impact_text(*frame.bodies, frame.impacts.front());
  EXPECT_TRUE(text.contains("A – B")) << text.toStdString();
  EXPECT_TRUE(text.contains("at 0.200 s")) << text.toStdString();
  EXPECT_TRUE(text.contains("impulse 4.000 N·s")) << text.toStdString();
  EXPECT_TRUE(text.contains("lost 0 J")) << text.toStdString();
}

TEST_F(ImpactMarks, OfSeveralTheClosestOne) {
  std::vector<ImpactRecord> marks(3);
  marks[0].point = Vec2(0.0, 0.0);
  marks[1].point = Vec2(0.06, 0.0);
  marks[2].point = Vec2(0.06, 0.0);
  for (int i = 0; i < 3; ++i) marks[static_cast<std::size_t>(i)].time = i;
  EXPECT_EQ(impact_at(marks, view_.camera(), {301.0, 200.0})->time, 0.0);
  EXPECT_EQ(impact_at(marks, view_.camera(), {305.0, 200.0})->time, 2.0) << "at one place the newest";
  EXPECT_FALSE(impact_at(marks, view_.camera(), {300.0, 210.0}));
}

}  // namespace
}  // namespace carom
