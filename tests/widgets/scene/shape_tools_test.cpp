#include <QApplication>
#include <numbers>

#include "tests/widgets/scene/scene_tools_fixture.h"
#include "widgets/scene/new_body.h"
#include "widgets/scene/overlap.h"

// The tools that draw bodies. The drawn grid is of 0.2 m, and 1 px is 1 cm.
namespace carom {
namespace {

class ShapeToolsTest : public SceneToolsTest {
 protected:
  void hover(const QPoint& at) {
    QMouseEvent event(QEvent::MouseMove, at, view_.mapToGlobal(QPointF(at)), Qt::NoButton, Qt::NoButton, {});
    QGuiApplication::sendEvent(&view_, &event);
  }
  // The last body that was told.
  [[nodiscard]] const Body& added() {
    EXPECT_FALSE(told_.empty());
    return std::get<Add<Body>>(told_.back().edits.at(0)).part;
  }
  [[nodiscard]] Vec2 size() {
    return {std::get<Box>(added().shape).width, std::get<Box>(added().shape).height};
  }
  // The corners of the last body in the plane.
  [[nodiscard]] std::vector<Vec2> corners() {
    std::vector<Vec2> corners = outline_of(added().shape).vertices;
    for (Vec2& corner : corners) corner += added().position;
    return corners;
  }
  void key(Qt::Key k) { QTest::keyClick(&view_, k); }

  static bool near(const Vec2& a, const Vec2& b) { return (a - b).norm() < 1e-9; }
};

TEST_F(ShapeToolsTest, AClickDrawsASquareOf20Cm) {
  view_.set_view(View{Vec2(2.0, 1.0), 3.0});
  view_.set_tool(SceneTool::kBox);
  EXPECT_EQ(view_.cursor().shape(), Qt::CrossCursor);
  click(QPoint(303, 57));  // near a crossing of the grid
  ASSERT_EQ(told_.size(), 1U);
  EXPECT_EQ(told_[0].name, "Add box C");
  EXPECT_TRUE(near(size(), {0.2, 0.2}));
  EXPECT_TRUE(near(added().position, {2.0, 1.7}));
  EXPECT_FALSE(added().fixed);
  EXPECT_EQ(added().material, scene_.bodies[1].material);
  EXPECT_NEAR(mass_of(added()) / area(added().shape), mass_of(scene_.bodies[1]) / area(scene_.bodies[1].shape),
              1e-12);
  EXPECT_EQ(view_.tool(), SceneTool::kSelect);
}

TEST_F(ShapeToolsTest, AClickDrawsWhatCanBeSeen) {
  view_.set_view(View{Vec2(2.0, 1.0), 600.0});
  view_.set_tool(SceneTool::kBox);
  click(empty_);
  EXPECT_TRUE(near(size(), {30.0, 30.0}));  // 24 px are 24 m
  view_.set_view(View{Vec2(2.0, 1.0), 0.06});
  view_.set_tool(SceneTool::kBox);
  click(empty_);
  EXPECT_TRUE(near(size(), {0.02, 0.02}));
}

TEST_F(ShapeToolsTest, AToolThatIsLaidDownInItsDragDrawsNothing) {
  view_.set_tool(SceneTool::kBox);
  press(empty_);
  move(empty_ + QPoint(40, 30));
  view_.set_tool(SceneTool::kSelect);
  release(empty_ + QPoint(40, 30));
  EXPECT_TRUE(told_.empty());
}

TEST_F(ShapeToolsTest, ADragDrawsABoxFromCornerToCorner) {
  view_.set_tool(SceneTool::kBox, true);
  drag(QPoint(302, 62), QPoint(250, 90));  // 10 px from the grid's lines
  EXPECT_TRUE(near(size(), {0.5, 0.3}));
  EXPECT_TRUE(near(added().position, {2.0 - 0.25, 2.4 - 0.15}));
  drag(QPoint(302, 62), QPoint(250, 90), Qt::ShiftModifier);
  EXPECT_TRUE(near(size(), {0.5, 0.5}));
  EXPECT_TRUE(near(added().position, {2.0 - 0.25, 2.4 - 0.25}));
  drag(QPoint(302, 62), QPoint(253, 95), Qt::ControlModifier);
  EXPECT_TRUE(near(size(), {0.49, 0.33}));
  EXPECT_TRUE(near(added().position, {2.02 - 0.245, 2.38 - 0.165}));
  // On a body too.
  drag(b_, b_ + QPoint(20, 20));
  EXPECT_EQ(told_.size(), 4U);
  EXPECT_EQ(told_.back().name, "Add box C");
}

// 2 px are not seen: both corners keep to the grid, and to what is there.
TEST_F(ShapeToolsTest, ABoxStandsOnTheSurfaceThatItIsDrawnTo) {
  view_.set_tool(SceneTool::kBox, true);
  drag(QPoint(302, 98), QPoint(339, 142));
  EXPECT_TRUE(near(size(), {0.4, 0.4}));
  EXPECT_TRUE(near(added().position, {2.2, 1.8}));
  Body floor;
  floor.name = "floor";
  floor.shape = Wall{};
  floor.position = Vec2(0.0, -0.535);
  floor.fixed = true;
  scene_.bodies.push_back(floor);
  Body box = floor;
  box.name = "box";
  box.shape = Box{0.5, 0.75};
  box.position = Vec2(4.0, -0.16);
  scene_.bodies.push_back(box);
  give_ids(scene_);
  show(true);
  const double surface = -0.535;
  for (const int y : {350, 357}) {  // above the surface, and in it
    drag(QPoint(280, 298), QPoint(320, y));
    EXPECT_NEAR(added().position.y() - 0.5 * size().y(), surface, 1e-12) << y;
    drag(QPoint(320, y), QPoint(280, 298));
    EXPECT_NEAR(added().position.y() - 0.5 * size().y(), surface, 1e-12) << "from below, " << y;
  }
  drag(QPoint(420, 320), QPoint(472, 340));  // to the side of the box
  EXPECT_NEAR(added().position.x() + 0.5 * size().x(), 3.75, 1e-12);
  drag(QPoint(280, 298), QPoint(320, 350), Qt::ControlModifier);
  EXPECT_NEAR(added().position.y() - 0.5 * size().y(), -0.5, 1e-12);
}

TEST_F(ShapeToolsTest, AClickDrawsALevelHalfPlane) {
  view_.set_tool(SceneTool::kWall);
  click(QPoint(303, 57));
  ASSERT_EQ(told_.size(), 1U);
  EXPECT_EQ(told_[0].name, "Add wall C");
  EXPECT_FALSE(std::get<Wall>(added().shape).length);
  EXPECT_TRUE(near(added().position, {2.0, 2.4}));
  EXPECT_EQ(added().angle, 0.0);
  EXPECT_TRUE(added().fixed);
  EXPECT_FALSE(added().density || added().mass);
}

TEST_F(ShapeToolsTest, ADragDrawsAThinWall) {
  view_.set_tool(SceneTool::kWall, true);
  drag(QPoint(300, 60), QPoint(383, 62));  // to the grid
  EXPECT_NEAR(*std::get<Wall>(added().shape).length, 0.8, 1e-12);
  EXPECT_EQ(added().angle, 0.0);
  EXPECT_TRUE(near(added().position, {2.4, 2.4}));
  drag(QPoint(300, 60), QPoint(390, 65), Qt::ControlModifier);
  EXPECT_NEAR(*std::get<Wall>(added().shape).length, std::hypot(0.9, 0.05), 1e-12);
  EXPECT_NEAR(added().angle, std::atan2(-0.05, 0.9), 1e-12);
  EXPECT_TRUE(near(added().position, {2.45, 2.375}));
  drag(QPoint(300, 60), QPoint(360, 80), Qt::ShiftModifier);
  EXPECT_NEAR(added().angle, -std::numbers::pi / 12.0, 1e-12);
  EXPECT_TRUE(added().fixed);
}

TEST_F(ShapeToolsTest, ClicksDrawAPolygonWhichItsFirstCornerCloses) {
  view_.set_tool(SceneTool::kPolygon);
  for (const QPoint& at : {QPoint(262, 58), QPoint(341, 63), QPoint(302, 103)}) click(at);
  EXPECT_TRUE(told_.empty());
  click(QPoint(264, 64));
  ASSERT_EQ(told_.size(), 1U);
  EXPECT_EQ(told_[0].name, "Add polygon C");
  // It stands where it was drawn, about its centre of mass.
  EXPECT_TRUE(near(added().position, {2.0, (2.4 + 2.4 + 2.0) / 3.0}));
  const std::vector<Vec2> drawn = corners();
  ASSERT_EQ(drawn.size(), 3U);
  for (const Vec2& corner : {Vec2(1.6, 2.4), Vec2(2.4, 2.4), Vec2(2.0, 2.0)}) {
    EXPECT_TRUE(std::any_of(drawn.begin(), drawn.end(), [&](const Vec2& c) { return near(c, corner); }));
  }
  EXPECT_FALSE(added().fixed);
  EXPECT_EQ(view_.tool(), SceneTool::kSelect);
}

TEST_F(ShapeToolsTest, EnterOrADoubleClickClosesAPolygon) {
  view_.set_tool(SceneTool::kPolygon, true);
  for (const QPoint& at : {QPoint(260, 60), QPoint(340, 60), QPoint(300, 100)}) click(at);
  key(Qt::Key_Return);
  EXPECT_EQ(told_.size(), 1U);
  for (const QPoint& at : {QPoint(260, 60), QPoint(340, 60)}) click(at);
  key(Qt::Key_Return);
  EXPECT_EQ(told_.size(), 1U) << "two corners are no polygon";
  click(QPoint(300, 100));
  QTest::mouseDClick(&view_, Qt::LeftButton, {}, QPoint(300, 100));
  EXPECT_EQ(told_.size(), 2U);
  EXPECT_EQ(corners().size(), 3U);
}

TEST_F(ShapeToolsTest, ADragMovesTheCornerJustSet) {
  view_.set_tool(SceneTool::kPolygon);
  click(QPoint(260, 60));
  drag(QPoint(280, 80), QPoint(340, 60));
  drag(QPoint(200, 80), QPoint(300, 113), Qt::ControlModifier);
  key(Qt::Key_Enter);
  EXPECT_TRUE(near(added().position, {2.0, (2.4 + 2.4 + 1.87) / 3.0}));
}

TEST_F(ShapeToolsTest, BackspaceTakesACornerBackAndEscapeAll) {
  view_.set_tool(SceneTool::kPolygon);
  for (const QPoint& at : {QPoint(260, 60), QPoint(340, 60), QPoint(340, 100), QPoint(260, 100)}) click(at);
  key(Qt::Key_Backspace);
  key(Qt::Key_Return);
  EXPECT_EQ(corners().size(), 3U);
  view_.set_tool(SceneTool::kPolygon);
  for (const QPoint& at : {QPoint(260, 60), QPoint(340, 60), QPoint(340, 100)}) click(at);
  key(Qt::Key_Escape);
  EXPECT_EQ(view_.tool(), SceneTool::kPolygon);
  key(Qt::Key_Escape);
  EXPECT_EQ(view_.tool(), SceneTool::kSelect);
  EXPECT_EQ(told_.size(), 1U);
}

TEST_F(ShapeToolsTest, APolygonMayHaveDents) {
  view_.set_tool(SceneTool::kPolygon);
  // 0.8 m × 0.8 m without the triangle from the upper side to the middle.
  for (const QPoint& at :
       {QPoint(260, 60), QPoint(300, 100), QPoint(340, 60), QPoint(340, 140), QPoint(260, 140)})
    click(at);
  key(Qt::Key_Return);
  EXPECT_EQ(corners().size(), 5U);
  EXPECT_NEAR(area(added().shape), 0.64 - 0.16, 1e-12);
}

TEST_F(ShapeToolsTest, ACornerWhoseEdgeWouldCrossIsNotSet) {
  view_.set_tool(SceneTool::kPolygon, true);
  const std::vector<QPoint> square = {QPoint(260, 60), QPoint(340, 60), QPoint(340, 140)};
  for (const QPoint& at : square) click(at);
  click(QPoint(300, 20));  // across the first edge
  click(QPoint(260, 140));
  key(Qt::Key_Return);
  EXPECT_EQ(corners().size(), 4U);
  EXPECT_NEAR(area(added().shape), 0.64, 1e-12);
  // Enter at once takes the hull with it.
  for (const QPoint& at : square) click(at);
  click(QPoint(300, 20));
  key(Qt::Key_Return);
  EXPECT_EQ(corners().size(), 4U);
  EXPECT_NEAR(area(added().shape), 0.32 + 0.16, 1e-12);
}

TEST_F(ShapeToolsTest, WhereTheLastEdgeWouldCrossTheHullIsTaken) {
  view_.set_tool(SceneTool::kPolygon);
  // A spiral, closed across its own arm.
  for (const QPoint& at : {QPoint(300, 100), QPoint(340, 100), QPoint(340, 140), QPoint(260, 140),
                           QPoint(260, 60), QPoint(380, 60), QPoint(380, 120)})
    click(at);
  ASSERT_TRUE(told_.empty());
  click(QPoint(300, 100));
  ASSERT_EQ(told_.size(), 1U);
  EXPECT_EQ(corners().size(), 5U);
  EXPECT_NEAR(area(added().shape), 0.92, 1e-12);
}

TEST_F(ShapeToolsTest, AConvexPolygonHasAtMost16Corners) {
  view_.set_tool(SceneTool::kPolygon);
  const auto draw = [&](double (*reach)(int)) {
    for (int k = 0; k < 20; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / 20;
      const QPointF at(300.0 + reach(k) * std::cos(angle), 200.0 - reach(k) * std::sin(angle));
      click(at.toPoint(), Qt::ControlModifier);
    }
    key(Qt::Key_Return);
  };
  draw([](int) { return 150.0; });
  EXPECT_TRUE(told_.empty());
  for (int k = 0; k < 4; ++k) key(Qt::Key_Backspace);
  key(Qt::Key_Return);
  ASSERT_EQ(told_.size(), 1U);
  EXPECT_EQ(corners().size(), 16U);
  view_.set_tool(SceneTool::kPolygon);
  draw([](int k) { return k % 2 == 0 ? 150.0 : 70.0; });
  ASSERT_EQ(told_.size(), 2U);
  EXPECT_EQ(corners().size(), 20U) << "a star";
}

TEST_F(ShapeToolsTest, TheEdgeToTheMouseIsShown) {
  view_.set_tool(SceneTool::kPolygon);
  click(QPoint(260, 60));
  const QImage before = view_.grab().toImage();
  hover(QPoint(330, 100));
  EXPECT_NE(view_.grab().toImage(), before);
}

TEST_F(ShapeToolsTest, EscapeTakesAStrokeBack) {
  for (const SceneTool tool : {SceneTool::kDisc, SceneTool::kBox, SceneTool::kPolygon, SceneTool::kWall}) {
    view_.set_tool(tool);
    press(QPoint(300, 60));
    move(QPoint(340, 80));
    key(Qt::Key_Escape);
    release(QPoint(340, 80));
    EXPECT_EQ(view_.tool(), tool);
    key(Qt::Key_Escape);
    EXPECT_EQ(view_.tool(), SceneTool::kSelect);
  }
  EXPECT_TRUE(told_.empty());
  EXPECT_TRUE(spawned_.empty());
}

TEST_F(ShapeToolsTest, EnterDrawsWhereThereIsRoomOrAtTheMouse) {
  const Vec2 middle = Vec2(2.0, 1.0);
  for (const SceneTool tool : {SceneTool::kBox, SceneTool::kPolygon}) {
    view_.set_tool(tool);
    key(Qt::Key_Return);
    EXPECT_TRUE(near(added().position, middle));
    EXPECT_EQ(view_.tool(), SceneTool::kSelect);
  }
  // A half-plane, or the largest disc that chance may give, would overlap bodies there.
  view_.set_tool(SceneTool::kWall);
  key(Qt::Key_Return);
  EXPECT_FALSE(near(added().position, middle));
  EXPECT_TRUE(overlaps_of({&added(), 1}, {scene_.bodies, {}}).empty());
  view_.set_tool(SceneTool::kDisc);
  key(Qt::Key_Return);
  ASSERT_EQ(spawned_.size(), 1U);
  const double radius = 1.5 * std::get<Disc>(model_disc(scene_.bodies)->shape).radius;
  const Body disc = new_body(scene_.bodies, Disc{radius}, spawned_[0]);
  EXPECT_TRUE(overlaps_of({&disc, 1}, {scene_.bodies, {}}).empty()) << spawned_[0].transpose();
  hover(QPoint(260, 60));
  view_.set_tool(SceneTool::kBox);
  key(Qt::Key_Return);
  EXPECT_TRUE(near(added().position, {1.6, 2.4}));
}

TEST_F(ShapeToolsTest, ToolsDrawWhilePlayingToo) {
  show(false);
  view_.set_tool(SceneTool::kBox);
  drag(QPoint(300, 60), QPoint(340, 100));
  view_.set_tool(SceneTool::kWall);
  click(QPoint(300, 60));
  view_.set_tool(SceneTool::kPolygon);
  for (const QPoint& at : {QPoint(260, 60), QPoint(340, 60), QPoint(300, 100)}) click(at);
  key(Qt::Key_Return);
  ASSERT_EQ(told_.size(), 3U);
  EXPECT_EQ(told_[0].name, "Add box C");
  EXPECT_EQ(told_[2].name, "Add polygon C");
}

TEST_F(ShapeToolsTest, AnOverlapIsSaidWhileABodyIsDrawn) {
  const auto overlay = [this] { return view_.findChild<SceneTools*>()->overlay(); };
  view_.set_tool(SceneTool::kDisc);
  press(QPoint(300, 200));
  move(QPoint(330, 200));
  EXPECT_TRUE(overlay().overlaps.empty());
  EXPECT_FALSE(view_.bubble().fault);
  move(QPoint(360, 200));  // 10 cm into A, whose rim is 50 cm away
  ASSERT_EQ(overlay().overlaps.size(), 1U);
  EXPECT_EQ(view_.bubble().value, "C and A overlap by 10.0 cm");
  EXPECT_TRUE(view_.bubble().fault);
  release(QPoint(360, 200));
  EXPECT_EQ(told_.back().name, "Add disc C");
  view_.set_tool(SceneTool::kBox);
  press(QPoint(380, 60));
  move(QPoint(420, 185));
  EXPECT_TRUE(view_.bubble().value.startsWith("C and B overlap by")) << view_.bubble().value.toStdString();
  QTest::keyClick(&view_, Qt::Key_Escape);
  release(QPoint(420, 185));
  view_.set_tool(SceneTool::kPolygon);
  for (const QPoint& corner : {QPoint(300, 200), QPoint(300, 100)}) click(corner);
  press(QPoint(240, 150));
  EXPECT_TRUE(overlay().overlaps.empty());
  move(QPoint(200, 180));  // in A
  EXPECT_TRUE(view_.bubble().value.startsWith("C and A overlap by")) << view_.bubble().value.toStdString();
  release(QPoint(200, 180));
}

TEST_F(ShapeToolsTest, AnotherSceneForgetsTheCorners) {
  view_.set_tool(SceneTool::kPolygon);
  for (const QPoint& at : {QPoint(260, 60), QPoint(340, 60), QPoint(300, 100)}) click(at);
  view_.set_view(View{Vec2(2.0, 1.0), 6.0});
  key(Qt::Key_Backspace);
  key(Qt::Key_Escape);
  EXPECT_EQ(view_.tool(), SceneTool::kSelect);
  EXPECT_TRUE(told_.empty());
}

TEST_F(ShapeToolsTest, DigitsTypeTheSizesOfWhatIsDrawn) {
  view_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&view_));
  view_.setFocus();
  const auto draw = [&](SceneTool tool) {
    view_.set_tool(tool);
    press({300, 350});
    move({320, 330});
    move({340, 310});
  };
  const auto type = [](Qt::Key key) { QTest::keyClick(QApplication::focusWidget(), key); };
  draw(SceneTool::kDisc);
  type(Qt::Key_Period);
  type(Qt::Key_3);
  EXPECT_TRUE(told_.empty());
  type(Qt::Key_Return);
  release({340, 310});
  ASSERT_EQ(told_.size(), 1U);
  EXPECT_EQ(std::get<Disc>(added().shape).radius, 0.3);
  draw(SceneTool::kBox);
  type(Qt::Key_2);
  type(Qt::Key_Tab);
  type(Qt::Key_1);
  type(Qt::Key_Return);
  release({340, 310});
  ASSERT_EQ(told_.size(), 2U);
  EXPECT_EQ(std::get<Box>(added().shape).width, 2.0);
  EXPECT_EQ(std::get<Box>(added().shape).height, 1.0);
  const Vec2 corner = added().position - Vec2(1.0, 0.5);
  EXPECT_LT((corner - Vec2(2.0, -0.5)).norm(), 1e-9) << corner;
  draw(SceneTool::kWall);
  type(Qt::Key_1);
  type(Qt::Key_Return);
  release({340, 310});
  ASSERT_EQ(told_.size(), 3U);
  EXPECT_EQ(std::get<Wall>(added().shape).length, 1.0);
  // Escape makes nothing.
  draw(SceneTool::kDisc);
  type(Qt::Key_1);
  type(Qt::Key_Escape);
  release({340, 310});
  EXPECT_EQ(told_.size(), 3U);
}

}  // namespace
}  // namespace carom
