#include "widgets/scene/scale_row.h"

#include <QHelpEvent>
#include <QToolTip>

#include "tests/widgets/scene/scene_tools_fixture.h"

namespace carom {
namespace {

// A moves up at 2 m/s.
class ScaleRowTest : public SceneToolsTest {
 protected:
  [[nodiscard]] std::vector<ScaleMark> row() const {
    return scale_row(view_.drawing(), view_.camera(), view_.font());
  }
  [[nodiscard]] QPoint velocity_scale() const { return row().at(1).rect.center().toPoint(); }
  [[nodiscard]] double metres_per_speed() const {
    const Drawing::ArrowItem& arrow = view_.drawing().arrows.at(0);
    return (arrow.to - arrow.from).norm() / scene_.bodies[1].velocity.norm();
  }
  // A moment of a run that plays, with A at this speed.
  void play(double speed, std::int64_t steps) {
    scene_.bodies[1].velocity = Vec2(0.0, speed);
    Preset preset;
    preset.scene = scene_;
    const Simulation run(setup_of(preset));
    const std::shared_ptr<Frame> frame = frame_of(run);
    frame->run = run_;
    frame->steps = steps;
    frame->playing = true;
    frame->forces = std::make_shared<const Forces>(scene_.forces);
    view_.set_frame(frame);
  }
};

TEST_F(ScaleRowTest, AnArrowOfARoundSpeedStandsBesideTheBar) {
  ASSERT_EQ(row().size(), 2U);
  const ScaleMark velocity = row()[1];
  EXPECT_EQ(velocity.kind, ScaleKind::kVelocity);
  EXPECT_GT(velocity.from.x(), row()[0].rect.right());
  const Drawing::ArrowKey& key = view_.drawing().velocity_key;
  EXPECT_EQ(velocity.text, number_text(key.amount) + " m/s");
  EXPECT_NEAR(key.length, key.amount * metres_per_speed() * 100.0, 1e-9);
  EXPECT_LE(key.length, 80.0);
  EXPECT_EQ(step_not_above(key.amount), key.amount);
}

TEST_F(ScaleRowTest, AClickDoublesTheArrowsAndShiftHalvesThem) {
  const double before = metres_per_speed();
  move(velocity_scale());
  EXPECT_EQ(view_.cursor().shape(), Qt::PointingHandCursor);
  click(velocity_scale());
  EXPECT_DOUBLE_EQ(metres_per_speed(), 2.0 * before);
  click(velocity_scale(), Qt::ShiftModifier);
  EXPECT_DOUBLE_EQ(metres_per_speed(), before);
  EXPECT_TRUE(told_.empty());
}

TEST_F(ScaleRowTest, TheTipIsPulledAtTheLengthThatIsSeen) {
  answers_ = true;
  click(velocity_scale());
  view_.select({"A"});
  const QPoint tip = view_.camera().to_screen(view_.drawing().arrows.at(0).to).toPoint();
  const double doubled = metres_per_speed();
  drag(tip, tip - QPoint(0, qRound(100.0 * doubled)));
  EXPECT_NEAR(scene_.bodies[1].velocity.y(), 3.0, 1e-9);
  EXPECT_DOUBLE_EQ(metres_per_speed(), doubled);
}

TEST_F(ScaleRowTest, ItsTooltipSaysSo) {
  const QPoint at = velocity_scale();
  QHelpEvent help(QEvent::ToolTip, at, view_.mapToGlobal(at));
  QCoreApplication::sendEvent(&view_, &help);
  EXPECT_EQ(QToolTip::text(), "The scale of velocities. A click doubles their arrows, with Shift halves them.");
  QToolTip::hideText();
}

TEST_F(ScaleRowTest, GivesWayInANarrowViewBeforeTheBarDoes) {
  view_.resize(200, 200);
  ASSERT_EQ(row().size(), 1U);
  EXPECT_EQ(row()[0].kind, ScaleKind::kLength);
}

TEST_F(ScaleRowTest, StaysWhileARunLasts) {
  play(2.0, 1);
  play(2.0, 2);
  const double before = metres_per_speed();
  play(50.0, 3);
  EXPECT_DOUBLE_EQ(metres_per_speed(), before);
  ++run_;
  play(50.0, 1);
  play(50.0, 2);
  EXPECT_LT(metres_per_speed(), before);
}

TEST_F(ScaleRowTest, AFallFromRestKeepsOneScale) {
  scene_.forces.gravity = Vec2(0.0, -9.81);
  for (Body& body : scene_.bodies) body.position.y() -= 1.9;  // so that its energy foretells nothing
  ++run_;
  play(0.0, 0);
  play(2.0, 1);
  const double before = metres_per_speed();
  play(8.0, 2);
  EXPECT_DOUBLE_EQ(metres_per_speed(), before);
  EXPECT_LT(8.0 * before, 4.0);  // m: within the view
}

TEST_F(ScaleRowTest, WithADrawingToolInHandItIsNoButton) {
  const double before = metres_per_speed();
  view_.set_tool(SceneTool::kDisc);
  click(velocity_scale());
  EXPECT_DOUBLE_EQ(metres_per_speed(), before);
  EXPECT_EQ(spawned_.size(), 1U);
}

}  // namespace
}  // namespace carom
