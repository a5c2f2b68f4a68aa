#include <QApplication>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/widgets/scene/scene_tools_fixture.h"

namespace carom {
namespace {

TEST_F(SceneToolsTest, ClicksSelect) {
  click(a_);
  EXPECT_EQ(selected_, Names{"A"});
  click(b_, Qt::ShiftModifier);
  EXPECT_EQ(selected_, (Names{"A", "B"}));
  click(a_, Qt::ShiftModifier);
  EXPECT_EQ(selected_, Names{"B"});
  click(empty_);
  EXPECT_EQ(selected_, Names{});
  EXPECT_TRUE(told_.empty());
  EXPECT_TRUE(spawned_.empty());
}

// B under A: a second click on the same spot takes it, a third one A again; then a drag moves what is selected.
TEST_F(SceneToolsTest, AnotherClickOnTheSpotSelectsTheBodyBelow) {
  answers_ = true;
  const auto body = [this](const char* name) -> Body& {
    return *std::find_if(scene_.bodies.begin(), scene_.bodies.end(),
                         [&](const Body& b) { return b.name == name; });
  };
  body("B").position = body("A").position;
  show(true);
  const std::string top = "B";
  const std::string below = "A";
  const QPoint spot(196, 206);
  click(spot);
  EXPECT_EQ(selected_, Names{top});
  QTest::qWait(QApplication::doubleClickInterval() + 50);
  click(spot);
  EXPECT_EQ(selected_, Names{below});
  QTest::qWait(QApplication::doubleClickInterval() + 50);
  drag(spot, spot + QPoint(0, 140), Qt::ControlModifier);
  EXPECT_EQ(selected_, Names{below});
  EXPECT_NEAR(body(below.c_str()).position.y(), body(top.c_str()).position.y() - 1.4, 1e-9);
  click(QPoint(450, 60));
  click(spot);
  EXPECT_EQ(selected_, Names{top});
}

TEST_F(SceneToolsTest, ARightClickOnAHandleKeepsTheSelection) {
  click(a_);
  ASSERT_FALSE(view_.drawing().arrows.empty());
  const QPoint tip = view_.camera().to_screen(view_.drawing().arrows[0].to.cast<double>()).toPoint();
  QTest::mouseClick(&view_, Qt::RightButton, {}, tip);
  EXPECT_EQ(selected_, Names{"A"});
}

TEST_F(SceneToolsTest, ABandSelectsWhatItTouches) {
  drag(QPoint(260, 120), QPoint(380, 200));
  EXPECT_EQ(selected_, Names{"B"});
  drag(QPoint(260, 120), QPoint(230, 200), Qt::ShiftModifier);
  EXPECT_EQ(selected_, (Names{"B", "A"}));
  drag(QPoint(260, 120), QPoint(380, 200), Qt::ControlModifier);
  EXPECT_EQ(selected_, Names{"A"});
  drag(QPoint(260, 60), QPoint(300, 80));
  EXPECT_EQ(selected_, Names{});
  EXPECT_TRUE(told_.empty());
}

TEST_F(SceneToolsTest, NamesCanBeSelectedFromOutsideAndDropOut) {
  view_.select({"B", "nobody", "A"});
  EXPECT_EQ(selected_, (Names{"B", "A"}));
  scene_.bodies.pop_back();
  show(true);
  EXPECT_EQ(view_.selection(), Names{"A"});
  EXPECT_EQ(selected_, Names{"A"});
  view_.clear();
  EXPECT_EQ(selected_, Names{});
}

TEST_F(SceneToolsTest, APressOnABodyThatIsGoneDoesNothing) {
  for (const bool moves : {false, true}) {
    press(b_);
    const Body gone = scene_.bodies.back();
    scene_.bodies.pop_back();
    show(true);
    if (moves) move(b_ + QPoint(40, 0));
    release(b_ + QPoint(moves ? 40 : 0, 0));
    EXPECT_EQ(selected_, Names{});
    EXPECT_TRUE(told_.empty());
    scene_.bodies.push_back(gone);
    show(true);
  }
}

TEST_F(SceneToolsTest, ADragTellsThePlaceUnderOneNumber) {
  answers_ = true;
  press(b_);
  move(b_ + QPoint(2, 2));
  EXPECT_TRUE(told_.empty());  // less than 4 px
  move(b_ + QPoint(33, -47), Qt::ControlModifier);
  move(b_ + QPoint(50, -55), Qt::ControlModifier);
  release(b_ + QPoint(50, -55));
  ASSERT_EQ(told_.size(), 2U);
  ASSERT_EQ(told_[0].edits.size(), 1U);
  EXPECT_TRUE(replaced(told_[0].edits[0]).position.isApprox(Vec2(3.33, 1.47), 1e-12));
  EXPECT_TRUE(replaced(told_[1].edits[0]).position.isApprox(Vec2(3.5, 1.55), 1e-12));
  EXPECT_EQ(told_[1].name, "Move B");
  EXPECT_GT(told_[0].drag, 0);
  EXPECT_EQ(told_[1].drag, told_[0].drag);
  EXPECT_EQ(selected_, Names{"B"});
  // From where it is now, under another number, to the drawn grid of 0.2 m.
  drag(QPoint(450, 145), QPoint(463, 137));
  ASSERT_GE(told_.size(), 3U);
  EXPECT_TRUE(replaced(told_.back().edits[0]).position.isApprox(Vec2(3.6, 1.6), 1e-12));
  EXPECT_NE(told_.back().drag, told_[0].drag);
}

TEST_F(SceneToolsTest, TheGripOfASpinIsDraggedAlongTheRim) {
  answers_ = true;
  view_.select({"A"});
  // The arc is 58 px from the centre and begins at 240°.
  const auto on_arc = [](double degrees) {
    const double angle = degrees * std::numbers::pi / 180.0;
    return QPoint(200 + qRound(58.0 * std::cos(angle)), 200 - qRound(58.0 * std::sin(angle)));
  };
  press(on_arc(240.0));
  for (int degrees = 250; degrees <= 660; degrees += 10) move(on_arc(degrees));  // more than once around
  release(on_arc(660.0));
  ASSERT_FALSE(told_.empty());
  EXPECT_NEAR(replaced(told_.back().edits[0]).spin, 28.0, 1e-12);
  EXPECT_EQ(told_.back().name, "Spin of A 0.00 → 28.00 rad/s");
  EXPECT_EQ(told_.back().drag, told_.front().drag);
}

TEST_F(SceneToolsTest, ASelectionMovesTogether) {
  view_.select({"A", "B"});
  drag(b_, b_ + QPoint(0, -30), Qt::ShiftModifier | Qt::ControlModifier);
  ASSERT_FALSE(told_.empty());
  ASSERT_EQ(told_.back().edits.size(), 2U);
  EXPECT_EQ(told_.back().name, "Move 2 bodies");
  EXPECT_EQ(replaced(told_.back().edits[0]).name, "B");
  EXPECT_TRUE(replaced(told_.back().edits[1]).position.isApprox(Vec2(1.0, 1.3), 1e-12));
}

TEST_F(SceneToolsTest, EscapeTakesADragBack) {
  answers_ = true;
  press(b_);
  move(b_ + QPoint(40, 0));
  ASSERT_EQ(told_.size(), 1U);
  QTest::keyClick(&view_, Qt::Key_Escape);
  EXPECT_EQ(cancelled_, std::vector<int>{told_[0].drag});
  move(b_ + QPoint(60, 0));
  release(b_ + QPoint(60, 0));
  EXPECT_EQ(told_.size(), 1U);
  EXPECT_EQ(selected_, Names{"B"});
  QTest::keyClick(&view_, Qt::Key_Escape);
  EXPECT_EQ(selected_, Names{});
}

TEST_F(SceneToolsTest, TheTipOfAnArrowSetsTheVelocity) {
  answers_ = true;
  click(a_);
  ASSERT_FALSE(view_.drawing().arrows.empty());
  const Vec2 tip = view_.drawing().arrows[0].to;
  const double seconds = (tip.y() - 1.0) / 2.0;  // m of arrow per m/s
  const QPoint from = view_.camera().to_screen(tip).toPoint();
  press(from);
  // The scale holds, though the peak rises.
  const int rise = static_cast<int>(std::lround(seconds * 100.0));
  move(from + QPoint(0, -rise));
  const Body& body = replaced(told_.back().edits[0]);
  EXPECT_NEAR(body.velocity.y(), 3.0, 1e-12);
  EXPECT_EQ(body.velocity.x(), 0.0);
  EXPECT_EQ(told_.back().name, "Speed of A 2.00 → 3.00 m/s");
  EXPECT_NEAR(view_.drawing().arrows[0].to.y(), 1.0 + 3.0 * seconds, 1e-9);
  // Back into the body.
  move(QPoint(200, 205));
  EXPECT_EQ(replaced(told_.back().edits[0]).velocity, Vec2(0.0, 0.0));
  release(QPoint(200, 205));
}

TEST_F(SceneToolsTest, ControlCountsWhileTheMouseStandsStill) {
  press(b_);
  move(b_ + QPoint(37, 0));
  const Vec2 on_grid = replaced(told_.back().edits[0]).position;
  QTest::keyPress(&view_, Qt::Key_Control, Qt::NoModifier);
  EXPECT_NE(replaced(told_.back().edits[0]).position, on_grid);
  EXPECT_NEAR(replaced(told_.back().edits[0]).position.x(), 3.37, 1e-12);
  QTest::keyRelease(&view_, Qt::Key_Control, Qt::ControlModifier);
  EXPECT_EQ(replaced(told_.back().edits[0]).position, on_grid);
  release(b_ + QPoint(37, 0));
}

TEST_F(SceneToolsTest, AnEditMovesNeitherCameraNorScale) {
  view_.fit();
  answers_ = true;
  const double scale = view_.camera().scale;
  const double length = view_.drawing().arrows[0].to.y() - view_.drawing().arrows[0].from.y();
  view_.select({"A"});
  QTest::keyClick(&view_, Qt::Key_Up, Qt::ShiftModifier | Qt::ControlModifier);
  const auto& arrow = view_.drawing().arrows[0];
  EXPECT_NEAR((arrow.to - arrow.from).norm(), 1.5 * length, 1e-9);
  ++run_;
  QTest::keyClick(&view_, Qt::Key_Up, Qt::ShiftModifier);  // out of the view
  EXPECT_EQ(view_.camera().scale, scale);
}

TEST_F(SceneToolsTest, WhilePlayingThereAreNoHandles) {
  show(false);
  click(b_);
  EXPECT_EQ(selected_, Names{"B"});
  drag(b_, b_ + QPoint(40, 0));
  drag(QPoint(455, 200), QPoint(500, 200));  // the grip of a body at rest
  QTest::keyClick(&view_, Qt::Key_Delete);
  EXPECT_TRUE(told_.empty());
}

TEST_F(SceneToolsTest, PlayingEndsADrag) {
  press(b_);
  move(b_ + QPoint(40, 0));
  show(false);
  move(b_ + QPoint(60, 0));
  EXPECT_EQ(told_.size(), 1U);
  release(b_ + QPoint(60, 0));
  EXPECT_TRUE(cancelled_.empty());
}

TEST_F(SceneToolsTest, SavedPicturesShowNoSelection) {
  const QImage before = view_.picture();
  const QImage seen = view_.grab().toImage();
  view_.select({"A"});
  EXPECT_EQ(view_.picture(), before);
  EXPECT_NE(view_.grab().toImage(), seen);
}

TEST_F(SceneToolsTest, KeysOfARowShareANumber) {
  view_.select({"B"});
  QTest::keyClick(&view_, Qt::Key_Right);
  QTest::keyClick(&view_, Qt::Key_Right);  // before a frame shows the first
  ASSERT_EQ(told_.size(), 2U);
  EXPECT_TRUE(replaced(told_[1].edits[0]).position.isApprox(Vec2(3.4, 1.0), 1e-12));
  EXPECT_EQ(told_[1].drag, told_[0].drag);
  QTest::keyClick(&view_, Qt::Key_Up, Qt::ControlModifier);
  EXPECT_NE(told_[2].drag, told_[0].drag);
  EXPECT_EQ(told_[2].name, "Speed of B 0.00 → 0.10 m/s");
  QTest::qWait(1050);
  QTest::keyClick(&view_, Qt::Key_Up, Qt::ControlModifier);
  EXPECT_NE(told_[3].drag, told_[2].drag);
}

// As by undo: what it made of the bodies is not overwritten.
TEST_F(SceneToolsTest, ARowOfKeysEndsWhenTheSceneIsEditedByOtherMeans) {
  answers_ = true;
  view_.select({"A"});
  const Scene before = scene_;
  QTest::keyClick(&view_, Qt::Key_Right);
  const double once = scene_.bodies[1].position.x();
  scene_ = before;
  view_.scene_edited();
  show(true);
  QTest::keyClick(&view_, Qt::Key_Right);
  EXPECT_EQ(scene_.bodies[1].position.x(), once);
  ASSERT_EQ(told_.size(), 2U);
  EXPECT_NE(told_[0].drag, told_[1].drag) << "another step of undo";
}

TEST_F(SceneToolsTest, ArrowsPanWithoutASelection) {
  const double before = view_.camera().center.x();
  QTest::keyClick(&view_, Qt::Key_Right);
  EXPECT_GT(view_.camera().center.x(), before);
  EXPECT_TRUE(told_.empty());
}

TEST_F(SceneToolsTest, DeleteTellsARemoval) {
  view_.select({"A"});
  QTest::keyClick(&view_, Qt::Key_Delete);
  ASSERT_EQ(told_.size(), 1U);
  EXPECT_EQ(std::get<Remove<Body>>(told_[0].edits[0]).id, scene_.bodies[1].id);
  EXPECT_EQ(told_[0].name, "Delete A");
}

TEST_F(SceneToolsTest, KeysSelect) {
  QTest::keyClick(&view_, Qt::Key_A, Qt::ControlModifier);
  EXPECT_EQ(selected_, (Names{"A", "B"}));
  view_.select({});
  view_.setFocus();
  for (const char* name : {"floor", "A", "B"}) {
    QTest::keyClick(&view_, Qt::Key_Tab);
    EXPECT_EQ(selected_, Names{name});
  }
  QTest::keyClick(&view_, Qt::Key_Backtab, Qt::ShiftModifier);
  EXPECT_EQ(selected_, Names{"A"});
}

// Two bodies that are no neighbours.
TEST_F(SceneToolsTest, KeysSelectSeveral) {
  view_.setFocus();
  QTest::keyClick(&view_, Qt::Key_Tab);
  QTest::keyClick(&view_, Qt::Key_Space, Qt::ControlModifier);
  EXPECT_EQ(selected_, Names{"floor"});
  QTest::keyClick(&view_, Qt::Key_Tab);
  EXPECT_EQ(selected_, (Names{"floor", "A"}));
  QTest::keyClick(&view_, Qt::Key_Tab);
  EXPECT_EQ(selected_, (Names{"floor", "B"}));
  QTest::keyClick(&view_, Qt::Key_Space, Qt::ControlModifier);
  QTest::keyClick(&view_, Qt::Key_Backtab, Qt::ShiftModifier);
  EXPECT_EQ(selected_, (Names{"floor", "B", "A"}));
  QTest::keyClick(&view_, Qt::Key_Backtab, Qt::ShiftModifier);
  EXPECT_EQ(selected_, (Names{"B", "floor"}));
  QTest::keyClick(&view_, Qt::Key_Space, Qt::ControlModifier);
  QTest::keyClick(&view_, Qt::Key_Tab);
  EXPECT_EQ(selected_, (Names{"B", "A"})) << "floor does not stay";
  view_.select({"floor"});
  view_.select({"B"});
  QTest::keyClick(&view_, Qt::Key_Backtab, Qt::ShiftModifier);
  EXPECT_EQ(selected_, Names{"A"}) << "another selection was made since";
  // What stays selected is deleted.
  QTest::keyClick(&view_, Qt::Key_Space, Qt::ControlModifier);
  QTest::keyClick(&view_, Qt::Key_Delete);
  apply_edits(scene_, told_.back().edits);
  show(true);
  QTest::keyClick(&view_, Qt::Key_Tab);
  EXPECT_EQ(selected_, Names{"floor"});
}

TEST_F(SceneToolsTest, TheDiscToolAsksForADiscOnce) {
  std::vector<SceneTool> tools;
  QObject::connect(&view_, &SceneView::toolChanged, [&](SceneTool tool) { tools.push_back(tool); });
  view_.set_tool(SceneTool::kDisc);
  EXPECT_EQ(view_.cursor().shape(), Qt::CrossCursor);
  click(QPoint(350, 100));
  ASSERT_EQ(spawned_.size(), 1U);
  EXPECT_TRUE(spawned_[0].isApprox(Vec2(2.5, 2.0), 1e-12));
  click(QPoint(350, 100));
  EXPECT_EQ(spawned_.size(), 1U);
  view_.set_tool(SceneTool::kDisc);
  click(QPoint(357, 96));
  EXPECT_TRUE(spawned_.back().isApprox(Vec2(2.6, 2.0), 1e-12)) << "on the grid";
  view_.set_tool(SceneTool::kDisc);
  click(QPoint(357, 96), Qt::ControlModifier);
  EXPECT_TRUE(spawned_.back().isApprox(Vec2(2.57, 2.04), 1e-12)) << "free";
  tools.resize(2);
  spawned_.resize(1);
  EXPECT_EQ(tools, (std::vector<SceneTool>{SceneTool::kDisc, SceneTool::kSelect}));
  // Kept, also while playing; the second click of a double click makes none.
  view_.set_tool(SceneTool::kDisc, true);
  show(false);
  click(QPoint(350, 100));
  QTest::mouseDClick(&view_, Qt::LeftButton, {}, QPoint(350, 100));
  release(QPoint(350, 100));
  EXPECT_EQ(spawned_.size(), 2U);
  QTest::keyClick(&view_, Qt::Key_Escape);
  EXPECT_EQ(view_.tool(), SceneTool::kSelect);
}

TEST_F(SceneToolsTest, TheDiscToolDrawsADisc) {
  view_.set_tool(SceneTool::kDisc);
  drag(QPoint(300, 100), QPoint(330, 100));
  ASSERT_EQ(told_.size(), 1U);
  const Body& disc = std::get<Add<Body>>(told_[0].edits[0]).part;
  EXPECT_NEAR(std::get<Disc>(disc.shape).radius, 0.3, 1e-12);
  EXPECT_TRUE(disc.position.isApprox(Vec2(2.0, 2.0), 1e-12));
  EXPECT_EQ(told_[0].name, "Add disc C");
  EXPECT_EQ(view_.tool(), SceneTool::kSelect);
}

TEST_F(SceneToolsTest, AToolInHandGoesBeforeHandles) {
  view_.select({"B"});
  const QPoint grip(400 + 25 + 30, 200);  // of its velocity, beside its rim
  view_.set_tool(SceneTool::kDisc);
  EXPECT_TRUE(view_.findChild<SceneTools*>()->overlay().handles.empty());
  drag(grip, grip + QPoint(20, 0));
  ASSERT_EQ(told_.size(), 1U);
  EXPECT_EQ(told_[0].name, "Add disc C");
  drag(grip, grip + QPoint(20, 0));  // with no tool in hand
  ASSERT_GE(told_.size(), 2U);
  EXPECT_TRUE(told_.back().name.startsWith("Speed of B")) << told_.back().name.toStdString();
}

TEST_F(SceneToolsTest, TheEndOfAWallIsDraggedInOneStep) {
  answers_ = true;
  Body wall;
  wall.name = "W";
  wall.shape = Wall{1.0};
  wall.fixed = true;
  wall.position = Vec2(3.0, 2.0);
  scene_.bodies.push_back(wall);
  give_ids(scene_);
  show(true);
  view_.select({"W"});
  const QPoint end(400 + 50 + 8, 100);
  drag(end, end + QPoint(40, 0));
  ASSERT_FALSE(told_.empty());
  EXPECT_EQ(told_.front().drag, told_.back().drag);
  EXPECT_EQ(told_.back().name, "Resize W");
  const Body& longer = replaced(told_.back().edits[0]);
  EXPECT_NEAR(*std::get<Wall>(longer.shape).length, 1.4, 1e-9);
  EXPECT_NEAR(longer.position.x(), 3.2, 1e-9);
}

TEST_F(SceneToolsTest, ABodyThatIsLetGoInAnotherMovesOut) {
  answers_ = true;
  press(b_);
  move(b_ + QPoint(-60, 0), Qt::ControlModifier);
  move(b_ + QPoint(-150, 0), Qt::ControlModifier);
  EXPECT_EQ(told_.size(), 2U);
  release(b_ + QPoint(-150, 0));
  ASSERT_EQ(told_.size(), 3U);
  EXPECT_EQ(told_[2].drag, told_[0].drag);
  const Body& b = replaced(told_[2].edits[0]);
  EXPECT_EQ(b.name, "B");
  EXPECT_NEAR((b.position - Vec2(1.0, 1.0)).norm(), 0.75, 1e-9);
}

TEST_F(SceneToolsTest, WithControlAnOverlapStays) {
  answers_ = true;
  drag(b_, b_ + QPoint(-150, 0), Qt::ControlModifier);
  EXPECT_TRUE(replaced(told_.back().edits[0]).position.isApprox(Vec2(1.5, 1.0), 1e-12));
}

TEST_F(SceneToolsTest, WithoutRoomABodyGoesBack) {
  scene_.bodies[0].shape = Box{40.0, 40.0};
  scene_.bodies[0].position = Vec2(2.0, -19.0);  // A and B stand half in it
  scene_.bodies[1].position = scene_.bodies[2].position = Vec2(3.0, 1.3);
  scene_.bodies[1].position.x() = 1.0;
  scene_.bodies[1].position.y() = 1.6;
  answers_ = true;
  show(true);
  press(QPoint(400, 170));
  move(QPoint(400, 250), Qt::ControlModifier);
  move(QPoint(400, 390), Qt::ControlModifier);
  release(QPoint(400, 390));
  ASSERT_EQ(cancelled_.size(), 1U);
  EXPECT_EQ(cancelled_[0], told_[0].drag);
}

TEST_F(SceneToolsTest, KeysResizeAndPutInTouch) {
  answers_ = true;
  view_.select({"B"});
  QTest::keyClick(&view_, Qt::Key_Plus);
  QTest::keyClick(&view_, Qt::Key_Plus);
  ASSERT_EQ(told_.size(), 2U);
  EXPECT_EQ(told_[1].name, "Resize B");
  EXPECT_EQ(told_[1].drag, told_[0].drag);
  EXPECT_NEAR(std::get<Disc>(replaced(told_[1].edits[0]).shape).radius, 0.25 * 1.05 * 1.05, 1e-12);
  QTest::keyClick(&view_, Qt::Key_K);
  EXPECT_EQ(told_.size(), 2U);
  EXPECT_EQ(view_.bubble().value, "select two bodies") << "to put them in touch";
  view_.select({"B", "A"});
  QTest::keyClick(&view_, Qt::Key_K);
  ASSERT_EQ(told_.size(), 3U);
  EXPECT_EQ(told_[2].name, "Put B in touch with A");
  EXPECT_NEAR(replaced(told_[2].edits[0]).position.x(), 1.5 + 0.25 * 1.05 * 1.05, 1e-9);
}

TEST_F(SceneToolsTest, AKeyThatWouldOverlapOnlyTouches) {
  answers_ = true;
  scene_.bodies[2].position = Vec2(1.8, 1.0);
  show(true);
  view_.select({"B"});
  QTest::keyClick(&view_, Qt::Key_Left);
  EXPECT_NEAR((replaced(told_.back().edits[0]).position - Vec2(1.0, 1.0)).norm(), 0.75, 1e-9);
}

}  // namespace
}  // namespace carom
