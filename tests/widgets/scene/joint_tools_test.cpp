#include <QApplication>
#include <numbers>

#include "tests/widgets/scene/scene_tools_fixture.h"

// The tools that draw joints, springs and forces, and the choice of one. Disc A (radius 0.5 m) stands at (1,
// 1), which is (200, 200) px, disc B (0.25 m) at (3, 1), which is (400, 200) px; both at rest. 1 px is 1 cm.
namespace carom {
namespace {

class JointToolsTest : public SceneToolsTest {
 protected:
  void SetUp() override {
    SceneToolsTest::SetUp();
    body("A").velocity.setZero();
    show(true);
  }
  [[nodiscard]] Body& body(const std::string& name) {
    return *std::find_if(scene_.bodies.begin(), scene_.bodies.end(),
                         [&](const Body& each) { return each.name == name; });
  }
  template <class Part>
  [[nodiscard]] const Part& added() {
    return std::get<Add<Part>>(told_.at(told_.size() - 1).edits.at(0)).part;
  }
  void key(Qt::Key k) { QTest::keyClick(&view_, k); }
  void hover(const QPoint& at) {
    QMouseEvent event(QEvent::MouseMove, at, view_.mapToGlobal(QPointF(at)), Qt::NoButton, Qt::NoButton, {});
    QGuiApplication::sendEvent(&view_, &event);
  }
  // The scene with a part, shown.
  template <class Part>
  void put(const Part& part) {
    apply_edit(scene_, Add<Part>{part});
    show(true);
  }
  void put_rod() {
    Joint rod;
    rod.name = "Rod 1";
    rod.body = "A";
    rod.to = "B";
    put(rod);
  }
  static bool near(const Vec2& a, const Vec2& b) { return (a - b).norm() < 1e-9; }

  const QPoint a_centre_{203, 204};
  const QPoint b_centre_{396, 202};
};

TEST_F(JointToolsTest, ADragDrawsARodBetweenCentres) {
  view_.set_tool(SceneTool::kRod);
  EXPECT_EQ(view_.cursor().shape(), Qt::CrossCursor);
  drag(a_centre_, b_centre_);
  ASSERT_EQ(told_.size(), 1U);
  EXPECT_EQ(told_[0].name, "Add rod from A to B");
  const Joint& rod = added<Joint>();
  EXPECT_EQ(rod.kind, JointKind::kRod);
  EXPECT_EQ(rod.name, "Rod 1");
  EXPECT_EQ(rod.body, "A");
  EXPECT_EQ(rod.to, "B");
  EXPECT_EQ(rod.point, Vec2(0.0, 0.0));
  EXPECT_EQ(rod.anchor, Vec2(0.0, 0.0));
  EXPECT_FALSE(rod.length);
  EXPECT_EQ(view_.tool(), SceneTool::kSelect);
}

// It is not chosen: the next drag takes the body, not its end.
TEST_F(JointToolsTest, TheValueOfWhatIsDrawnIsTyped) {
  answers_ = true;
  view_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&view_));
  view_.setFocus();
  const auto type = [](const QString& text) {
    for (const QChar c : text) QTest::keyClicks(QApplication::focusWidget(), c);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
  };
  view_.set_tool(SceneTool::kString);
  drag(a_centre_, QPoint(300, 60));
  EXPECT_FALSE(view_.part());
  type("2.5");
  EXPECT_EQ(scene_.joints.front().length, 2.5);

  // During the drag, which the digit ends.
  view_.set_tool(SceneTool::kString);
  press(b_centre_);
  move(QPoint(450, 120));
  move(QPoint(480, 60));
  type("3.25");
  release(QPoint(480, 60));
  ASSERT_EQ(scene_.joints.size(), 2U);
  EXPECT_EQ(scene_.joints.back().body, "B");
  EXPECT_EQ(scene_.joints.back().length, 3.25);

  view_.set_tool(SceneTool::kForce);
  drag(a_, QPoint(296, 203));
  type("4");
  EXPECT_NEAR(scene_.forces.applied.front().force.norm(), 4.0, 1e-12);
}

// The frame that shows the joint may come a while after it was made.
TEST_F(JointToolsTest, DigitsWaitForTheJointThatIsAwaited) {
  view_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&view_));
  view_.setFocus();
  view_.set_tool(SceneTool::kString);
  press(a_centre_);
  move(QPoint(250, 120));
  move(QPoint(300, 60));
  for (const auto key : {Qt::Key_2, Qt::Key_Period, Qt::Key_5}) QTest::keyClick(&view_, key);
  release(QPoint(300, 60));
  ASSERT_EQ(told_.size(), 1U);
  apply_edits(scene_, told_.back().edits);
  answers_ = true;
  show(true);
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
  EXPECT_EQ(scene_.joints.front().length, 2.5);
}

// A digit after a pin, which has no value, is none of the keys that change bodies.
TEST_F(JointToolsTest, DigitsAfterAPinChangeNothing) {
  answers_ = true;
  view_.set_tool(SceneTool::kPin);
  click(a_centre_);
  ASSERT_EQ(scene_.joints.size(), 1U);
  const std::size_t told = told_.size();
  QTest::keyClick(&view_, Qt::Key_5);
  view_.select({"A", "B"});
  view_.set_tool(SceneTool::kWeld);
  QTest::keyClick(&view_, Qt::Key_Return);
  const std::size_t welded = told_.size();
  EXPECT_EQ(welded, told + 1);
  QTest::keyClick(&view_, Qt::Key_5);
  EXPECT_EQ(told_.size(), welded);
  EXPECT_EQ(scene_.bodies.size(), 3U);
}

TEST_F(JointToolsTest, AnEndSnapsToACentreWithin12Pixels) {
  body("B").shape = Disc{0.02};
  show(true);
  view_.set_tool(SceneTool::kRod, true);
  drag({210, 205}, {410, 205});
  EXPECT_EQ(added<Joint>().point, Vec2(0.0, 0.0));
  EXPECT_EQ(added<Joint>().to, "B");
  EXPECT_EQ(added<Joint>().anchor, Vec2(0.0, 0.0));
  drag({213, 205}, {413, 205});
  EXPECT_TRUE(near(added<Joint>().point, {0.13, -0.05}));
  EXPECT_EQ(added<Joint>().to, "") << "beside it";
}

// A has a rim of 50 px.
TEST_F(JointToolsTest, AnEndSnapsToTheRim) {
  view_.set_tool(SceneTool::kRod, true);
  drag({200, 157}, b_centre_);
  EXPECT_TRUE(near(added<Joint>().point, {0.0, 0.5}));
  drag({200, 161}, b_centre_);
  EXPECT_TRUE(near(added<Joint>().point, {0.0, 0.39}));
  drag({200, 157}, b_centre_, Qt::ControlModifier);
  EXPECT_TRUE(near(added<Joint>().point, {0.0, 0.43}));
}

// Three discs in a row, of which a rod joins two: all three share what the new one does not allow.
TEST_F(JointToolsTest, AJointLeavesTheOthersAsTheyHold) {
  put_rod();
  Body c = body("B");
  c.id = {};
  c.name = "C";
  c.position = Vec2(4.0, 1.0);
  c.velocity = Vec2(-0.6, 0.0);
  put(c);
  answers_ = true;
  view_.set_tool(SceneTool::kRod);
  drag(b_centre_, QPoint(500, 200));
  ASSERT_EQ(told_.size(), 1U);
  const double all = mass_of(body("A")) + mass_of(body("B")) + mass_of(body("C"));
  const double together = -0.6 * mass_of(body("C")) / all;
  for (const char* name : {"A", "B", "C"}) EXPECT_NEAR(body(name).velocity.x(), together, 1e-12) << name;
}

TEST_F(JointToolsTest, TwoClicksHangABodyOnAStringFromThePlane) {
  answers_ = true;
  view_.set_tool(SceneTool::kString, true);
  click(QPoint(303, 57));  // near a crossing of the grid
  EXPECT_TRUE(told_.empty());
  click(a_centre_);
  ASSERT_EQ(told_.size(), 1U);
  EXPECT_EQ(told_[0].name, "Add string from A to the plane");
  EXPECT_EQ(added<Joint>().kind, JointKind::kString);
  EXPECT_EQ(added<Joint>().body, "A");
  EXPECT_TRUE(added<Joint>().to.empty());
  EXPECT_TRUE(near(added<Joint>().anchor, {2.0, 2.4}));
  click(a_centre_);
  click(QPoint(100, 60));
  EXPECT_EQ(added<Joint>().name, "String 2");
  EXPECT_EQ(view_.tool(), SceneTool::kString);
}

TEST_F(JointToolsTest, AnEndHoldsAnyPointOfABodyAlongItsAxes) {
  body("A").angle = 0.5 * std::numbers::pi;
  show(true);
  view_.set_tool(SceneTool::kRod, true);
  drag(a_, b_centre_);  // 0.2 m below the centre
  EXPECT_TRUE(near(added<Joint>().point, {-0.2, 0.0}));
  drag(a_centre_, QPoint(303, 57), Qt::ControlModifier);
  EXPECT_TRUE(near(added<Joint>().point, {-0.04, -0.03}));
  EXPECT_TRUE(near(added<Joint>().anchor, {2.03, 2.43}));
  // The floor doesn't move: it is the other end.
  drag(QPoint(300, 310), b_centre_);
  EXPECT_EQ(added<Joint>().body, "B");
  EXPECT_EQ(added<Joint>().to, "floor");
  EXPECT_TRUE(near(added<Joint>().anchor, {0.0, 0.0}));
}

TEST_F(JointToolsTest, ASpringJoinsPointsOfBodiesAndIsRelaxed) {
  body("A").mass = 2.0;
  body("B").mass = 1.0;
  show(true);
  view_.set_tool(SceneTool::kSpring, true);
  drag(QPoint(205, 205), QPoint(410, 195));  // near the centres
  EXPECT_EQ(told_.back().name, "Add spring from A to B");
  EXPECT_TRUE(added<Spring>().point.isZero(0.0));
  EXPECT_TRUE(added<Spring>().anchor.isZero(0.0));
  EXPECT_EQ(added<Spring>().name, "Spring 1");
  EXPECT_EQ(added<Spring>().stiffness, 40.0);  // (2π)² of 1 kg
  EXPECT_EQ(added<Spring>().damping, 0.0);
  EXPECT_EQ(added<Spring>().rest_length, 2.0);
  drag(QPoint(200, 80), a_);
  EXPECT_EQ(told_.back().name, "Add spring from A to the plane");
  EXPECT_EQ(added<Spring>().stiffness, 80.0);
  EXPECT_TRUE(near(added<Spring>().point, {0.0, -0.2}));
  EXPECT_TRUE(near(added<Spring>().anchor, {1.0, 2.2}));
  EXPECT_NEAR(added<Spring>().rest_length, 1.4, 1e-12);
}

TEST_F(JointToolsTest, AClickPinsTwoBodiesOrOneToThePlane) {
  body("B").position = Vec2(1.6, 1.0);
  show(true);
  view_.set_tool(SceneTool::kPin, true);
  click(QPoint(242, 200));
  EXPECT_EQ(told_.back().name, "Add pin");
  EXPECT_EQ(added<Joint>().kind, JointKind::kPin);
  EXPECT_EQ(added<Joint>().body, "B");
  EXPECT_EQ(added<Joint>().to, "A");
  EXPECT_TRUE(near(added<Joint>().point, {-0.18, 0.0}));
  EXPECT_TRUE(near(added<Joint>().anchor, {0.42, 0.0}));
  click(a_centre_);
  EXPECT_TRUE(added<Joint>().to.empty());
  EXPECT_TRUE(near(added<Joint>().point, {0.0, 0.0}));
  EXPECT_TRUE(near(added<Joint>().anchor, {1.0, 1.0}));
  click(empty_);
  click(QPoint(500, 310));  // the floor
  EXPECT_EQ(told_.size(), 2U);
}

TEST_F(JointToolsTest, AWeldHoldsInTheMiddleBetweenTwoBodies) {
  view_.set_tool(SceneTool::kWeld, true);
  click(a_);
  click(b_);
  EXPECT_EQ(told_.back().name, "Add weld from A to B");
  EXPECT_EQ(added<Joint>().kind, JointKind::kWeld);
  // The rims are at 1.5 and 2.75 m.
  EXPECT_TRUE(near(added<Joint>().point, {1.125, 0.0}));
  EXPECT_TRUE(near(added<Joint>().anchor, {-0.875, 0.0}));
  EXPECT_FALSE(added<Joint>().angle);
  drag(b_, QPoint(300, 310));
  EXPECT_EQ(added<Joint>().body, "B");
  EXPECT_EQ(added<Joint>().to, "floor");
  click(empty_);
  drag(a_, empty_);
  EXPECT_EQ(told_.size(), 2U);
}

TEST_F(JointToolsTest, AForceIsPulledOutOfABody) {
  body("A").mass = 1.0;
  show(true);
  view_.set_tool(SceneTool::kForce, true);
  drag(a_, QPoint(296, 203));  // 100 px are 1 N
  EXPECT_EQ(told_.back().name, "Add force on A");
  EXPECT_EQ(added<AppliedForce>().body, "A");
  EXPECT_TRUE(near(added<AppliedForce>().force, {0.95, 0.0}));
  drag(a_, QPoint(290, 160), Qt::ControlModifier);
  EXPECT_TRUE(near(added<AppliedForce>().force, {0.9, 0.4}));
  drag(a_, QPoint(270, 135), Qt::ShiftModifier);
  EXPECT_EQ(added<AppliedForce>().force.y(), 0.0);
  click(a_);
  click(QPoint(200, 100));
  EXPECT_TRUE(near(added<AppliedForce>().force, {0.0, 1.0}));
  drag(empty_, a_);
  drag(QPoint(300, 310), a_);
  click(a_);
  click(QPoint(200, 200));  // no length
  EXPECT_EQ(told_.size(), 4U);
}

TEST_F(JointToolsTest, ADriveIsPulledOutOfABody) {
  body("A").mass = 1.0;
  show(true);
  const auto driven = [this] { return std::get<Replace<Body>>(told_.back().edits.at(0)).part; };
  view_.set_tool(SceneTool::kDrive, true);
  drag(a_, QPoint(280, 203));
  EXPECT_EQ(told_.back().name, "Drive A");
  ASSERT_TRUE(driven().drive);
  EXPECT_GT(driven().drive->velocity.x(), 0.1);
  EXPECT_EQ(driven().drive->velocity.y(), 0.0);
  EXPECT_EQ(driven().drive->angular_frequency, 0.0);
  EXPECT_FALSE(driven().mass);
  EXPECT_TRUE(driven().velocity.isZero(0.0));
  drag(a_, QPoint(203, 150), Qt::ShiftModifier);
  EXPECT_TRUE(driven().drive->velocity.isZero(0.0));
  EXPECT_TRUE(near(driven().drive->amplitude, {0.0, 0.5}));
  EXPECT_GT(driven().drive->angular_frequency, 6.0);
  EXPECT_EQ(told_.size(), 2U);
  drag(empty_, a_);
  view_.select({"A"});
  key(Qt::Key_L);
  drag(a_, QPoint(280, 203));
  EXPECT_EQ(told_.size(), 2U);
}

TEST_F(JointToolsTest, TheFirstForceKeepsTheLengthItWasDrawnWith) {
  answers_ = true;
  body("A").mass = 1.0;
  show(true);
  view_.set_tool(SceneTool::kForce);
  drag(a_, QPoint(350, 200));
  ASSERT_FALSE(view_.drawing().arrows.empty());
  EXPECT_TRUE(near(view_.drawing().arrows.back().to, {2.5, 1.0}));
}

TEST_F(JointToolsTest, EndsThatCannotBeMakeNothing) {
  for (const SceneTool tool : {SceneTool::kRod, SceneTool::kString, SceneTool::kSpring}) {
    view_.set_tool(tool, true);
    drag(a_, QPoint(200, 170));               // both on A
    drag(empty_, QPoint(400, 60));            // both in the plane
    drag(QPoint(200, 310), QPoint(400, 60));  // the floor and the plane
    drag(QPoint(100, 60), QPoint(300, 310));  // likewise
    EXPECT_TRUE(told_.empty());
    EXPECT_EQ(view_.tool(), tool);
  }
}

// What a joint does not allow goes with the same edit; a string may tighten later.
TEST_F(JointToolsTest, BodiesLoseWhatTheirJointForbids) {
  body("A").velocity = Vec2(-1.0, 0.0);
  show(true);
  const auto edits = [this](SceneTool tool, const QPoint& from, const QPoint& to) {
    told_.clear();
    view_.set_tool(tool, true);
    tool == SceneTool::kPin ? click(from) : drag(from, to);
    EXPECT_EQ(told_.size(), 1U);
    return told_.at(0).edits;
  };
  const SceneEdits pin = edits(SceneTool::kPin, a_, a_);
  ASSERT_EQ(pin.size(), 2U);
  EXPECT_LT(std::get<Replace<Body>>(pin[0]).part.velocity.norm(), 1.0);
  EXPECT_TRUE(std::holds_alternative<Add<Joint>>(pin[1]));
  EXPECT_EQ(edits(SceneTool::kRod, a_centre_, b_centre_).size(), 3U) << "both bodies";
  EXPECT_EQ(edits(SceneTool::kString, a_centre_, b_centre_).size(), 1U);
  EXPECT_EQ(edits(SceneTool::kRod, a_centre_, QPoint(200, 80)).size(), 1U) << "it circles";
}

TEST_F(JointToolsTest, EscapeTakesBackTheFirstEndThenTheTool) {
  view_.set_tool(SceneTool::kRod);
  click(a_);
  key(Qt::Key_Escape);
  EXPECT_EQ(view_.tool(), SceneTool::kRod);
  click(empty_);  // a first end again
  EXPECT_TRUE(told_.empty());
  press(a_);
  move(b_);
  key(Qt::Key_Escape);
  release(b_);
  EXPECT_TRUE(told_.empty());
  key(Qt::Key_Escape);
  EXPECT_EQ(view_.tool(), SceneTool::kSelect);
}

TEST_F(JointToolsTest, EnterJoinsTheSelectedBodies) {
  view_.select({"B", "A"});
  for (const SceneTool tool : {SceneTool::kRod, SceneTool::kSpring, SceneTool::kPin, SceneTool::kWeld}) {
    view_.set_tool(tool);
    key(Qt::Key_Return);
    EXPECT_EQ(view_.tool(), SceneTool::kSelect);
  }
  ASSERT_EQ(told_.size(), 4U);
  EXPECT_EQ(told_[0].name, "Add rod from B to A");
  EXPECT_EQ(told_[1].name, "Add spring from B to A");
  view_.select({"B"});
  view_.set_tool(SceneTool::kRod);
  key(Qt::Key_Return);
  EXPECT_EQ(told_.back().name, "Add rod from B to the plane");
  EXPECT_TRUE(near(added<Joint>().anchor, {2.0, 1.0}));  // the middle of the view
  view_.set_tool(SceneTool::kForce);
  key(Qt::Key_Return);
  EXPECT_EQ(told_.back().name, "Add force on B");
  EXPECT_GT(added<AppliedForce>().force.x(), 0.0);
  EXPECT_EQ(added<AppliedForce>().force.y(), 0.0);
  view_.select({});
  view_.set_tool(SceneTool::kRod);
  key(Qt::Key_Return);
  EXPECT_EQ(told_.size(), 6U);
}

TEST_F(JointToolsTest, TheJointToTheMouseIsShown) {
  view_.set_tool(SceneTool::kRod);
  click(a_);
  hover(QPoint(300, 100));
  const QImage before = view_.grab().toImage();
  hover(QPoint(340, 100));
  EXPECT_NE(view_.grab().toImage(), before);
}

TEST_F(JointToolsTest, AClickChoosesAJointAndDeleteTakesItOut) {
  put_rod();
  const QImage before = view_.grab().toImage();
  click(QPoint(300, 205));
  ASSERT_TRUE(view_.part());
  EXPECT_EQ(std::get<Id<Joint>>(*view_.part()), scene_.joints[0].id);
  EXPECT_NE(view_.grab().toImage(), before);
  answers_ = true;
  key(Qt::Key_Delete);
  ASSERT_EQ(told_.size(), 1U);
  EXPECT_EQ(told_[0].name, "Delete Rod 1");
  EXPECT_TRUE(scene_.joints.empty());
  EXPECT_FALSE(view_.part());
}

TEST_F(JointToolsTest, AJointIsChosenInsteadOfBodies) {
  put_rod();
  click(a_);
  click(QPoint(300, 200));
  EXPECT_TRUE(view_.part());
  EXPECT_TRUE(view_.selection().empty());
  click(a_);
  EXPECT_FALSE(view_.part());
  EXPECT_EQ(view_.selection(), Names{"A"});
  click(QPoint(300, 200));
  click(empty_);
  EXPECT_FALSE(view_.part());
  click(QPoint(300, 200));
  key(Qt::Key_Escape);
  EXPECT_FALSE(view_.part());
  click(QPoint(300, 209));  // too far from it
  EXPECT_FALSE(view_.part());
}

TEST_F(JointToolsTest, SpringsForcesAndPinsAreChosenToo) {
  Spring spring;
  spring.body = "A";
  spring.anchor = Vec2(1.0, 2.4);
  put(spring);
  AppliedForce force;
  force.body = "B";
  force.force = Vec2(1.0, 0.0);
  put(force);
  Joint pin;
  pin.kind = JointKind::kPin;
  pin.body = "B";
  pin.anchor = Vec2(3.0, 1.0);
  put(pin);
  answers_ = true;
  click(QPoint(200, 100));
  key(Qt::Key_Delete);
  EXPECT_EQ(told_.back().name, "Delete a spring");
  click(QPoint(400, 200));
  ASSERT_TRUE(view_.part());
  EXPECT_TRUE(std::holds_alternative<Id<Joint>>(*view_.part()));
  click(QPoint(400, 200));  // then the body under it
  EXPECT_EQ(view_.selection(), Names{"B"});
  click(empty_);  // no handles
  const Vec2 tip = view_.drawing().arrows.back().to;
  click(view_.camera().to_screen(tip - Vec2(0.02, 0.0)).toPoint());
  key(Qt::Key_Delete);
  EXPECT_EQ(told_.back().name, "Delete a force on B");
}

TEST_F(JointToolsTest, NothingIsChosenWhileTheRunPlays) {
  put_rod();
  show(false);
  click(QPoint(300, 200));
  EXPECT_FALSE(view_.part());
  key(Qt::Key_Delete);
  EXPECT_TRUE(told_.empty());
}

}  // namespace
}  // namespace carom
