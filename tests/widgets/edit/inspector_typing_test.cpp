#include <QAction>
#include <QCursor>

#include "tests/widgets/edit/inspector_fixture.h"

namespace carom {
namespace {

TEST_F(InspectorTest, ATypedMassIsAnEditByItself) {
  select({"light"});
  QLineEdit* mass = field("Mass, kg");
  EXPECT_EQ(mass->text(), "1");
  enter(mass, "2000 g");
  ASSERT_EQ(made_.size(), 1U);
  EXPECT_EQ(made_[0].name, "Mass of light 1.00 → 2.00 kg");
  EXPECT_EQ(made_[0].drag, 0);
  ASSERT_EQ(made_[0].edits.size(), 1U);
  EXPECT_EQ(std::get<Replace<Body>>(made_[0].edits[0]).part.mass, 2.0);
  EXPECT_EQ(mass->text(), "2");
  EXPECT_EQ(field("Mass, kg"), mass) << "the same widget shows it";
  QTest::keyClick(mass, Qt::Key_Return);
  EXPECT_EQ(made_.size(), 1U) << "nothing was typed";
}

TEST_F(InspectorTest, AFormulaKnowsTheBody) {
  select({"light"});
  enter(field("Mass, kg"), "3*m + 0*r + 0*v");
  EXPECT_EQ(light().mass, 3.0);
  enter(field("Position x, m"), "x - 2*r");
  EXPECT_NEAR(light().position.x(), -1.0 - 2.0 * std::get<Disc>(light().shape).radius, 1e-15);
  select({});
  QLineEdit* e = field("e of wood");
  enter(e, "r");
  EXPECT_EQ(sentences(), QStringList{"“r” is not known; formulas know g, pi and e."});
}

// A space plays, but where it belongs to what is typed.
TEST_F(InspectorTest, ASpaceIsTheWindowsAfterEnter) {
  select({"light"});
  QLineEdit* mass = field("Mass, kg");
  const auto is_typed = [mass] {
    QKeyEvent space(QEvent::ShortcutOverride, Qt::Key_Space, Qt::NoModifier, " ");
    space.ignore();
    QApplication::sendEvent(mass, &space);
    return space.isAccepted();
  };
  enter(mass, "2");
  EXPECT_FALSE(is_typed());
  type(mass, "30");
  EXPECT_TRUE(is_typed());
}

TEST_F(InspectorTest, TheSameValueTypedOtherwiseIsNoEdit) {
  select({"light"});
  QLineEdit* x = field("Position x, m");
  EXPECT_EQ(x->text(), "−1");
  enter(x, "-100 cm");
  EXPECT_TRUE(made_.empty());
  EXPECT_EQ(x->text(), "−1");
  enter(x, "-0.8512");
  EXPECT_EQ(x->text(), "−0.8512");
  enter(x, "-0.8512");
  EXPECT_EQ(x->text(), "−0.8512");
}

TEST_F(InspectorTest, LeavingAFieldAcceptsIt) {
  select({"light"});
  type(field("Mass, kg"), "*3");
  EXPECT_TRUE(made_.empty());
  field("Spin, rad/s")->setFocus();
  EXPECT_EQ(light().mass, 3.0);
}

TEST_F(InspectorTest, AWrongValueIsRedAndSaidAndNothingIsEdited) {
  select({});
  QLineEdit* e = field("e of wood");
  EXPECT_EQ(e->text(), "0.6");
  enter(e, "1.2");
  EXPECT_TRUE(e->property("fault").toBool());
  EXPECT_EQ(sentences(), QStringList{"e lies between 0 and 1."});
  EXPECT_TRUE(made_.empty());
  QTest::keyClick(e, Qt::Key_Escape);
  EXPECT_EQ(e->text(), "0.6");
  EXPECT_FALSE(e->property("fault").toBool());
  EXPECT_TRUE(sentences().isEmpty());

  enter(e, "0.8");
  ASSERT_EQ(made_.size(), 1U);
  EXPECT_EQ(made_[0].name, "e of wood 0.600 → 0.800");
  EXPECT_EQ(scene_->materials[0].restitution, 0.8);
}

TEST_F(InspectorTest, WhatMoreDigitsCannotMendIsSaidWhileItIsTyped) {
  select({"light"});
  QLineEdit* e = field("e of wood");
  type(e, "1.2");
  EXPECT_TRUE(e->property("fault").toBool());
  EXPECT_EQ(sentences(), QStringList{"e lies between 0 and 1."});
  QTest::keyClick(e, Qt::Key_Backspace);
  EXPECT_TRUE(sentences().isEmpty());
  QTest::keyClick(e, Qt::Key_Escape);
  QLineEdit* mass = field("Mass, kg");
  type(mass, "0");
  EXPECT_TRUE(sentences().isEmpty()) << "it may become 0.5";
  QTest::keyClicks(mass, ".5");
  QTest::keyClick(mass, Qt::Key_Escape);
  type(mass, "-1");
  EXPECT_EQ(sentences().size(), 1);
  EXPECT_TRUE(made_.empty());
}

TEST_F(InspectorTest, LeavingAWrongValueBringsTheGoodOneBackAndSaysWhy) {
  select({"light"});
  QLineEdit* mass = field("Mass, kg");
  type(mass, "2 m");
  field("Spin, rad/s")->setFocus();
  EXPECT_EQ(mass->text(), "1");
  EXPECT_FALSE(mass->property("fault").toBool());
  EXPECT_EQ(sentences(), QStringList{"“m” is no unit of this; it takes kg, g, t."});
  EXPECT_EQ(label(sentences().front())->parentWidget(), mass->parentWidget()) << "under its field";
  enter(mass, "2");
  EXPECT_TRUE(sentences().isEmpty());
}

TEST_F(InspectorTest, WhatIsSaidOfAFieldEndsWhenAnotherIsTypedIn) {
  select({"light"});
  for (const char* other : {"Spin, rad/s", "Name"}) {
    type(field("Radius, m"), "-1");
    field(other)->setFocus();
    ASSERT_EQ(sentences().size(), 1);
    QTest::keyClicks(field(other), "3");
    EXPECT_TRUE(sentences().isEmpty()) << other;
    QTest::keyClick(field(other), Qt::Key_Escape);
  }
}

// Undo takes back a new body while one of its fields is typed in: nothing of that is meant for what is shown
// then.
TEST_F(InspectorTest, WhatIsTypedGoesWithTheBody) {
  for (const char* name : {"Mass, kg", "Radius, m", "Name"}) {
    SCOPED_TRACE(name);
    select({"light"});
    type(field(name), "5");
    const auto before = scene_;
    Scene without = *scene_;
    without.bodies.erase(without.bodies.begin());
    without.joints.clear();
    scene_ = std::make_shared<const Scene>(without);
    inspector_.show_selection(scene_, names_);
    EXPECT_TRUE(made_.empty());
    scene_ = before;
    select({"light"});
    EXPECT_NE(field(name)->text(), "5");
  }
}

TEST_F(InspectorTest, EnterMarksTheWholeValueForASecondOne) {
  select({"light"});
  enter(field("Mass, kg"), "2.50");
  QLineEdit* mass = field("Mass, kg");
  EXPECT_TRUE(mass->hasFocus());
  EXPECT_EQ(mass->selectedText(), "2.5");
  QTest::keyClicks(mass, "3");
  EXPECT_EQ(mass->text(), "3");
  QTest::keyClick(mass, Qt::Key_Escape);
  EXPECT_EQ(mass->selectedText(), "2.5");
  // As long as the same is selected, and where rows are made anew because a surface has another name.
  select({});
  enter(field("Name of surface rubber"), "ice");
  EXPECT_TRUE(field("Name of surface ice")->hasFocus());
  EXPECT_EQ(field("Name of surface ice")->selectedText(), "ice");
}

TEST_F(InspectorTest, EscapeLeavesOnceNothingIsTyped) {
  int left = 0;
  QObject::connect(&inspector_, &Inspector::left, [&] { ++left; });
  select({"light"});
  QLineEdit* mass = field("Mass, kg");
  type(mass, "7");
  QTest::keyClick(mass, Qt::Key_Escape);
  EXPECT_EQ(left, 0) << "what was typed is over";
  QTest::keyClick(mass, Qt::Key_Escape);
  EXPECT_EQ(left, 1);
}

TEST_F(InspectorTest, TheValueOfAFormulaIsShownWhileItIsTyped) {
  select({"light"});
  QLineEdit* speed = field("Speed, m/s");
  const auto shown = [this] { return texts().filter("= "); };
  type(speed, "sqrt(2*g*0.8");
  EXPECT_TRUE(shown().isEmpty());
  QTest::keyClicks(speed, ")");
  EXPECT_EQ(shown(), QStringList{"= 3.96182 m/s"});
  QTest::keyClick(speed, Qt::Key_Return);
  EXPECT_TRUE(shown().isEmpty());
  type(speed, "*2");
  EXPECT_EQ(shown(), QStringList{"= 7.92364 m/s"});
  QTest::keyClick(speed, Qt::Key_Escape);
  EXPECT_TRUE(shown().isEmpty());
  type(speed, "*3");
  field("Spin, rad/s")->setFocus();
  EXPECT_TRUE(shown().isEmpty());
}

// Refused by who receives the edit, as by a joint.
TEST_F(InspectorTest, ARefusedValueStaysTypedAndIsRed) {
  select({"light"});
  QObject::disconnect(&inspector_, &Inspector::edited, &inspector_, nullptr);
  QObject::connect(&inspector_, &Inspector::edited, [this] { inspector_.say("Rod 1 would be 2 m."); });
  QLineEdit* x = field("Position x, m");
  enter(x, "5");
  EXPECT_EQ(x->text(), "5");
  EXPECT_TRUE(x->property("fault").toBool());
  EXPECT_EQ(sentences(), QStringList{"Rod 1 would be 2 m."});
  QTest::keyClick(x, Qt::Key_Escape);
  EXPECT_EQ(x->text(), "−1");
  EXPECT_TRUE(sentences().isEmpty());
}

TEST_F(InspectorTest, ANewSceneLeavesTheFieldThatIsTypedInAlone) {
  select({"light"});
  QLineEdit* mass = field("Mass, kg");
  type(mass, "4");
  Body moved = light();
  moved.position.x() = -0.5;
  moved.mass = 1.5;
  apply({Replace<Body>{moved}});
  inspector_.show_selection(scene_, names_);
  EXPECT_EQ(mass->text(), "4");
  EXPECT_EQ(field("Position x, m")->text(), "−0.5");
  QTest::keyClick(mass, Qt::Key_Escape);
  EXPECT_EQ(mass->text(), "1.5");

  type(mass, "7");
  select({"heavy"});
  EXPECT_EQ(mass->text(), "2.5") << "what was typed was for another body";
  EXPECT_TRUE(made_.empty());
}

TEST_F(InspectorTest, QuickStepsAreOneEdit) {
  select({"light"});
  QLineEdit* mass = field("Mass, kg");
  mass->setFocus();
  for (int i = 0; i < 3; ++i) QTest::keyClick(mass, Qt::Key_Up);
  ASSERT_EQ(made_.size(), 3U);
  EXPECT_DOUBLE_EQ(light().mass.value(), 1.3);
  EXPECT_GT(made_[0].drag, 0);
  EXPECT_EQ(made_[2].drag, made_[0].drag);
  EXPECT_EQ(made_[2].name, "Mass of light 1.00 → 1.30 kg");
  QLineEdit* spin = field("Spin, rad/s");
  spin->setFocus();
  QTest::keyClick(spin, Qt::Key_Down);
  EXPECT_DOUBLE_EQ(light().spin, -0.01);
  EXPECT_NE(made_[3].drag, made_[0].drag);
}

TEST_F(InspectorTest, ALabelIsPulledLikeASlider) {
  select({"light"});
  QTest::qWait(20);
  QLabel* mass = nullptr;
  for (QLabel* label : inspector_.findChildren<QLabel*>()) {
    if (label->text() == "Mass") mass = label;
  }
  ASSERT_NE(mass, nullptr);
  EXPECT_EQ(mass->cursor().shape(), Qt::SizeHorCursor);
  const QPoint from = mass->rect().center();
  QTest::mousePress(mass, Qt::LeftButton, {}, from);
  QTest::mouseMove(mass, from + QPoint(2, 0));
  EXPECT_TRUE(made_.empty()) << "a press alone moves nothing";
  QTest::mouseMove(mass, from + QPoint(50, 0));
  QTest::mouseMove(mass, from + QPoint(102, 0));
  QTest::mouseRelease(mass, Qt::LeftButton, {}, from + QPoint(102, 0));
  ASSERT_EQ(made_.size(), 2U);
  EXPECT_NEAR(light().mass.value(), 2.0, 0.05);
  EXPECT_GT(made_[0].drag, 0);
  EXPECT_EQ(made_[1].drag, made_[0].drag);
  const int first = made_[0].drag;
  QTest::mousePress(mass, Qt::LeftButton, {}, from);
  QTest::mouseMove(mass, from - QPoint(50, 0));
  QTest::mouseRelease(mass, Qt::LeftButton, {}, from);
  EXPECT_NE(made_.back().drag, first);
}

TEST_F(InspectorTest, EscTakesAPullBack) {
  select({"light"});
  QLabel* x = label("x");
  const QPoint from = x->rect().center();
  QTest::mousePress(x, Qt::LeftButton, {}, from);
  QTest::mouseMove(x, from + QPoint(40, 0));
  EXPECT_EQ(light().position.x(), -0.8);
  QTest::keyClick(x, Qt::Key_Escape);
  EXPECT_EQ(light().position.x(), -1.0);
  QTest::mouseMove(x, from + QPoint(80, 0));
  QTest::mouseRelease(x, Qt::LeftButton, {}, from);
  EXPECT_EQ(light().position.x(), -1.0);
}

TEST_F(InspectorTest, SaysWhyAnEditCouldNotBe) {
  select({"light"});
  inspector_.say("light and heavy overlap by 3.2 cm.");
  EXPECT_EQ(sentences(), QStringList{"light and heavy overlap by 3.2 cm."});
  enter(field("Mass, kg"), "2");
  EXPECT_TRUE(sentences().isEmpty());
}

TEST_F(InspectorTest, UndoIsTheFieldsOnlyWhileItIsTypedIn) {
  int undone = 0;
  auto* undo = new QAction(&inspector_);
  undo->setShortcut(QKeySequence::Undo);
  inspector_.addAction(undo);
  QObject::connect(undo, &QAction::triggered, &inspector_, [&] { ++undone; });
  select({"light"});
  QLineEdit* mass = field("Mass, kg");
  enter(mass, "2");
  QTest::keyClick(mass, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(undone, 1);
  type(mass, "3");
  QTest::keyClick(mass, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(undone, 1);
}

// A disc of radius 0 has no density, so that the rows are other ones.
TEST_F(InspectorTest, TheFieldKeepsTheFocusWhenRowsChange) {
  select({"light"});
  enter(field("Radius, m"), "0");
  EXPECT_FALSE(has_field("Density, kg/m²"));
  EXPECT_TRUE(field("Radius, m")->hasFocus());
}

// Never cut: fewer digits where there is no room, all while the field is edited.
TEST_F(InspectorTest, ANumberHasAsManyDigitsAsFit) {
  Body placed = light();
  placed.position.x() = -0.0264746;
  apply({Replace<Body>{placed}});
  select({"light"});
  QLineEdit* x = field("Position x, m");
  ASSERT_NE(x, nullptr);
  x->clearFocus();
  x->setFixedWidth(x->fontMetrics().horizontalAdvance("0.02647") + 20);
  QApplication::processEvents();
  EXPECT_LT(x->text().size(), 9) << x->text().toStdString();
  EXPECT_TRUE(x->text().startsWith(QString(QChar(0x2212)) + "0.02")) << x->text().toStdString();
  EXPECT_LE(x->fontMetrics().horizontalAdvance(x->text()), x->width() - 8);
  x->setFocus();
  EXPECT_EQ(x->text(), QString(QChar(0x2212)) + "0.0264746");
  QTest::keyClick(x, Qt::Key_Return);
  EXPECT_TRUE(made_.empty()) << "nothing was typed";
  x->clearFocus();
  EXPECT_LT(x->text().size(), 9);
  // The unit first needs the last of many digits, then gives way.
  x->setFixedWidth(x->fontMetrics().horizontalAdvance(QString(QChar(0x2212)) + "0.0265  m") + 18);
  QApplication::processEvents();
  EXPECT_EQ(x->text(), QString(QChar(0x2212)) + "0.0265");
}

}  // namespace
}  // namespace carom
