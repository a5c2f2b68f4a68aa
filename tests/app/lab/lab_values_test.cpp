#include <QLabel>
#include <cmath>
#include <numbers>

#include "tests/app/lab/hands_fixture.h"

// Values that are typed at the mouse, during a drag, after it, and instead of one.
namespace carom {
namespace {

class LabValuesTest : public LabHandsTest {
 protected:
  void SetUp() override {
    ASSERT_NO_FATAL_FAILURE(LabHandsTest::SetUp());
    ASSERT_NO_FATAL_FAILURE(draw_two_discs());
    select({-1.0, 0.0});
    steps_ = edits().count();
  }
  [[nodiscard]] QUndoStack& edits() { return window_.session().edits(); }
  [[nodiscard]] const Body& body(std::size_t i) { return window_.preset().scene.bodies[i]; }
  // The field over the scene, if there is one.
  [[nodiscard]] QLineEdit* field() {
    for (QLineEdit* edit : window_.scene_view().findChildren<QLineEdit*>()) {
      if (edit->isVisible()) return edit;
    }
    return nullptr;
  }
  [[nodiscard]] QString field_name() { return field() == nullptr ? QString() : field()->accessibleName(); }
  void type_here(const QString& text, int end = Qt::Key_Return, Qt::KeyboardModifiers keys = {}) {
    ASSERT_NE(field(), nullptr);
    QTest::keyClicks(field(), text);
    QTest::keyClick(field(), static_cast<Qt::Key>(end), keys);
  }
  [[nodiscard]] QString fault() {
    const auto* label = window_.scene_view().findChild<QLabel*>("fault");
    return label->isVisible() ? label->text() : QString();
  }
  void press(const QPoint& at) { QTest::mousePress(&window_.scene_view(), Qt::LeftButton, {}, at); }
  void move(const QPoint& at) {
    SceneView* view = &window_.scene_view();
    QMouseEvent move(QEvent::MouseMove, at, view->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(view, &move);
  }
  void release(const QPoint& at) { QTest::mouseRelease(&window_.scene_view(), Qt::LeftButton, {}, at); }
  void double_click(const QPoint& at) {
    QTest::mouseDClick(&window_.scene_view(), Qt::LeftButton, {}, at);
    QTest::mouseRelease(&window_.scene_view(), Qt::LeftButton, {}, at);
  }
  // Of A at rest: the grip at the right of its rim.
  [[nodiscard]] QPoint grip() { return pixel({-0.9, 0.0}) + QPoint(30, 0); }

  int steps_ = 0;
};

TEST_F(LabValuesTest, ADigitDuringADragTypesTheSpeedThenTheDirection) {
  press(grip());
  move(grip() + QPoint(30, 0));
  move(grip() + QPoint(60, 0));
  key(Qt::Key_7);
  ASSERT_EQ(field_name(), "Speed of A, m/s");
  EXPECT_EQ(field()->text(), "7");
  move(grip() + QPoint(90, 40));
  ASSERT_NO_FATAL_FAILURE(type_here(".2 km/h", Qt::Key_Tab));
  EXPECT_EQ(field_name(), "Direction of A, °");
  EXPECT_TRUE(body(0).velocity.isApprox(Vec2(2.0, 0.0), 1e-12)) << body(0).velocity;
  ASSERT_NO_FATAL_FAILURE(type_here("90°"));
  EXPECT_EQ(field(), nullptr);
  release(grip() + QPoint(90, 40));
  EXPECT_TRUE(body(0).velocity.isApprox(Vec2(0.0, 2.0), 1e-12)) << body(0).velocity;
  EXPECT_EQ(edits().count(), steps_ + 1) << "one step of undo, with the drag";
  EXPECT_EQ(edits().undoText(), "Speed of A 0.00 → 2.00 m/s");
  undo();
  EXPECT_TRUE(body(0).velocity.isZero(0.0));
}

TEST_F(LabValuesTest, EscapeWhileTypingTakesTheDragBack) {
  const Vec2 before = body(0).position;
  press(pixel({-1.0, 0.0}));
  move(pixel({-0.8, 0.2}));
  move(pixel({-0.6, 0.4}));
  ASSERT_FALSE(body(0).position.isApprox(before, 1e-3));
  key(Qt::Key_Minus);
  ASSERT_EQ(field_name(), "x of A, m");
  ASSERT_NO_FATAL_FAILURE(type_here("0.3", Qt::Key_Tab));
  EXPECT_EQ(body(0).position.x(), -0.3);
  EXPECT_EQ(field_name(), "y of A, m");
  QTest::keyClick(field(), Qt::Key_Escape);
  release(pixel({-0.6, 0.4}));
  EXPECT_EQ(field(), nullptr);
  EXPECT_EQ(body(0).position, before);
  EXPECT_EQ(edits().count(), steps_);
}

TEST_F(LabValuesTest, AClickOnTheBubbleEditsItsValue) {
  drag({-1.0, 0.0}, {-0.6, 0.0});
  ASSERT_TRUE(shows_start());
  const QPoint at = pixel({-0.6, 0.0}) + QPoint(40, -30);  // in the bubble beside the mouse
  QTest::mouseClick(&window_.scene_view(), Qt::LeftButton, {}, at);
  ASSERT_EQ(field_name(), "x of A, m");
  ASSERT_NO_FATAL_FAILURE(type_here("-50 cm", Qt::Key_Tab));
  ASSERT_NO_FATAL_FAILURE(type_here("sqrt(0.04)"));
  EXPECT_EQ(body(0).position, Vec2(-0.5, 0.2));
  EXPECT_EQ(edits().count(), steps_ + 2);
  EXPECT_EQ(edits().undoText(), "Move A");
}

// The bubble still stands there. After keys a digit or a minus is a key again.
TEST_F(LabValuesTest, ADigitAfterADragEditsItsValueToo) {
  drag({-1.0, 0.0}, {-0.6, 0.0});
  ASSERT_TRUE(shows_start());
  key(Qt::Key_Minus);
  ASSERT_EQ(field_name(), "x of A, m");
  EXPECT_EQ(field()->text(), "-");
  ASSERT_NO_FATAL_FAILURE(type_here("0.7"));
  EXPECT_EQ(body(0).position.x(), -0.7);
  EXPECT_EQ(field(), nullptr);
  key(Qt::Key_Right);
  const double radius = std::get<Disc>(body(0).shape).radius;
  key(Qt::Key_Minus);
  EXPECT_EQ(field(), nullptr);
  EXPECT_LT(std::get<Disc>(body(0).shape).radius, radius);
}

TEST_F(LabValuesTest, ADoubleClickPutsTheCursorIntoTheValue) {
  double_click(pixel({1.0, 0.0}));
  EXPECT_EQ(field_name(), "x of B, m");
  QTest::keyClick(field(), Qt::Key_Escape);
  select({-1.0, 0.0});
  double_click(grip());
  ASSERT_EQ(field_name(), "Speed of A, m/s");
  ASSERT_NO_FATAL_FAILURE(type_here("1.5"));
  ASSERT_TRUE(shows_start());
  EXPECT_EQ(body(0).velocity, Vec2(1.5, 0.0));
  const double corner = 0.1 * window_.scene_view().camera().scale + 8.0;
  double_click(pixel({-1.0, 0.0}) + QPointF(-corner, corner).toPoint());
  ASSERT_EQ(field_name(), "Radius of A, m");
  ASSERT_NO_FATAL_FAILURE(type_here("1.2*r"));
  EXPECT_DOUBLE_EQ(std::get<Disc>(body(0).shape).radius, 0.12);
}

TEST_F(LabValuesTest, TheValueOfAFormulaIsSaidWhileItIsTyped) {
  double_click(pixel({-1.0, 0.0}));
  ASSERT_NE(field(), nullptr);
  const auto says = [this](const QString& text) {
    for (const QLabel* label : window_.scene_view().findChildren<QLabel*>()) {
      if (label->isVisible() && label->text().contains(text)) return true;
    }
    return false;
  };
  field()->selectAll();
  QTest::keyClicks(field(), "-2*0.4");
  EXPECT_TRUE(says(QStringLiteral("= −0.8 m")));
  field()->selectAll();
  QTest::keyClicks(field(), "-0.8");
  EXPECT_FALSE(says(QStringLiteral("= −0.8 m"))) << "a plain number says it itself";
  QTest::keyClick(field(), Qt::Key_Escape);
}

TEST_F(LabValuesTest, ADiscWithAMassMayShrinkToAPoint) {
  type("Mass, kg", "3");
  ASSERT_TRUE(wait_for([this] { return now("A").mass == 3.0; }));
  const double corner = 0.1 * window_.scene_view().camera().scale + 8.0;
  double_click(pixel({-1.0, 0.0}) + QPointF(-corner, corner).toPoint());
  ASSERT_EQ(field_name(), "Radius of A, m");
  ASSERT_NO_FATAL_FAILURE(type_here("0"));
  EXPECT_EQ(fault(), "");
  EXPECT_EQ(std::get<Disc>(body(0).shape).radius, 0.0);
  EXPECT_EQ(body(0).mass, 3.0);
}

TEST_F(LabValuesTest, ATypedFaultIsSaidAndTheLastValueHolds) {
  double_click(grip());
  ASSERT_NO_FATAL_FAILURE(type_here("-1"));
  ASSERT_NE(field(), nullptr);
  EXPECT_TRUE(field()->property("fault").toBool());
  EXPECT_EQ(fault(), "Speed is 0 or more.");
  EXPECT_TRUE(body(0).velocity.isZero(0.0));
  field()->selectAll();
  ASSERT_NO_FATAL_FAILURE(type_here("3 kg"));
  EXPECT_TRUE(fault().contains("kg")) << fault().toStdString();
  // A press elsewhere leaves the field, and nothing is changed.
  select({0.0, 0.6});
  EXPECT_EQ(field(), nullptr);
  EXPECT_EQ(edits().count(), steps_);
}

TEST_F(LabValuesTest, AnOverlapIsSolvedAsAfterADrag) {
  double_click(pixel({-1.0, 0.0}));
  ASSERT_NO_FATAL_FAILURE(type_here("0.9"));
  const double apart = (body(0).position - body(1).position).norm();
  EXPECT_NEAR(apart, std::get<Disc>(body(0).shape).radius + std::get<Disc>(body(1).shape).radius, 1e-6);
}

TEST_F(LabValuesTest, ARodHoldsAgainstATypedDirectionAndHasALengthItself) {
  key(Qt::Key_O);
  drag({-1.0, 0.0}, {-1.0, 0.6});
  ASSERT_TRUE(wait_for([this] { return window_.frame()->joints.size() == 1 && shows_start(); }));
  select({-1.0, 0.0});
  double_click(grip());
  ASSERT_NO_FATAL_FAILURE(type_here("2", Qt::Key_Tab));
  ASSERT_NO_FATAL_FAILURE(type_here("45"));
  EXPECT_NEAR(body(0).velocity.x(), std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(body(0).velocity.y(), 0.0, 1e-9);
  ASSERT_TRUE(shows_start());
  select({-1.0, 0.4});
  double_click(pixel({-1.0, 0.4}));
  ASSERT_TRUE(field_name().startsWith("Length of")) << field_name().toStdString();
  ASSERT_NO_FATAL_FAILURE(type_here("50 cm"));
  EXPECT_NEAR(body(0).position.y(), 0.1, 0.02);
  EXPECT_EQ(*window_.preset().scene.joints[0].length, 0.5);
}

TEST_F(LabValuesTest, ABubbleGoesWithUndoAndWithOtherEdits) {
  const Bubble& bubble = window_.scene_view().bubble();
  drag({-1.0, 0.0}, {-0.6, 0.0});
  ASSERT_TRUE(shows_start());
  EXPECT_TRUE(bubble.value.startsWith("x ")) << "its own edit leaves it";
  undo();
  EXPECT_TRUE(bubble.value.isEmpty()) << bubble.value.toStdString();
  ASSERT_TRUE(shows_start());
  key(Qt::Key_Right);
  ASSERT_TRUE(shows_start());
  EXPECT_FALSE(bubble.value.isEmpty());
  type("Mass, kg", "3");
  EXPECT_TRUE(bubble.value.isEmpty()) << bubble.value.toStdString();
  // A field that is open goes too.
  ASSERT_TRUE(shows_start());
  double_click(pixel(body(0).position));
  ASSERT_NE(field(), nullptr);
  undo();
  EXPECT_EQ(field(), nullptr);
}

TEST_F(LabValuesTest, TheSceneFollowsWhatIsTyped) {
  press(grip());
  move(grip() + QPoint(30, 0));
  move(grip() + QPoint(60, 0));
  const Vec2 dragged = body(0).velocity;
  key(Qt::Key_4);
  EXPECT_TRUE(body(0).velocity.isApprox(Vec2(4.0, 0.0), 1e-12)) << body(0).velocity;
  // The line has a few milliseconds to be computed, or it is left out.
  for (int k = 0; k < 100 && !window_.scene_view().aim(); ++k) {
    QTest::keyClick(field(), Qt::Key_0);
    QTest::keyClick(field(), Qt::Key_Backspace);
  }
  ASSERT_TRUE(window_.scene_view().aim());
  EXPECT_NEAR(window_.scene_view().aim()->time, 1.7 / 4.0, 0.02);
  QTest::keyClick(field(), Qt::Key_0);
  EXPECT_TRUE(body(0).velocity.isApprox(Vec2(40.0, 0.0), 1e-12)) << body(0).velocity;
  // What can't be taken in the end leaves what the drag left.
  QTest::keyClick(field(), Qt::Key_X);
  window_.scene_view().setFocus();
  EXPECT_EQ(field(), nullptr);
  EXPECT_EQ(body(0).velocity, dragged);
  release(grip() + QPoint(60, 0));
  EXPECT_EQ(edits().count(), steps_ + 1) << "one step of undo";
}

// Of the end of a rod, typed in the inspector: the body loses what the rod then forbids.
TEST_F(LabValuesTest, ABodyKeepsWhatATypedEndAllows) {
  type("Speed, m/s", "1");
  ASSERT_TRUE(shows_start());
  key(Qt::Key_O);
  drag({-1.0, 0.0}, {-1.0, 1.0});
  ASSERT_TRUE(wait_for([this] { return window_.frame()->joints.size() == 1 && window_.frame()->scene; }));
  window_.scene_view().choose_part(window_.preset().scene.joints.front().id);
  ASSERT_TRUE(shows_start());
  type("Anchor x, m", "-2");
  ASSERT_TRUE(shows_start());
  const Vec2 anchor = window_.preset().scene.joints.front().anchor;
  EXPECT_EQ(anchor.x(), -2.0);
  const Vec2 along = (anchor - body(0).position).normalized();
  const Vec2 allowed = Vec2(1.0, 0.0) - along.x() * along;
  EXPECT_NEAR((body(0).velocity - allowed).norm(), 0.0, 1e-9) << body(0).velocity.transpose();
  EXPECT_TRUE(edits().undoText().startsWith("Anchor x of Rod 1")) << edits().undoText().toStdString();
}

// Also with a tool in hand that stays there; two quick clicks on empty space are two discs.
TEST_F(LabValuesTest, ADoubleClickTypesWithAKeptTool) {
  window_.scene_view().set_tool(SceneTool::kDisc, true);
  press(pixel({-1.0, 0.0}));
  release(pixel({-1.0, 0.0}));
  double_click(pixel({-1.0, 0.0}));
  ASSERT_NE(field(), nullptr);
  key(Qt::Key_Escape);
}

}  // namespace
}  // namespace carom
