#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QTableView>

#include "tests/app/lab/hands_fixture.h"
#include "widgets/edit/bodies_model.h"
#include "widgets/edit/bodies_sheet.h"

// Edits of a run that plays: by keys, in the inspector and in the table.
namespace carom {
namespace {

class LabPlayEditTest : public LabHandsTest {
 protected:
  void SetUp() override {
    ASSERT_NO_FATAL_FAILURE(LabHandsTest::SetUp());
    name_ = window_.preset().scene.bodies[0].name;
    window_.scene_view().select({name_});
    choose_speed(0.25);
    window_.session().runs().set_playing(true);
    ASSERT_TRUE(wait_for([this] { return time() > 0.02 && window_.frame()->playing; }));
    window_.scene_view().setFocus();
  }
  // Where the body is while the mouse is pressed on it, however slow the machine is.
  Vec2 place_of_slow_body() {
    choose_speed(0.001);
    const double from = time();
    EXPECT_TRUE(wait_for([&] { return time() > from; }));
    return window_.frame()->state.position(0);
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
  // The inspector's field of this name.
  [[nodiscard]] QLineEdit* field(const QString& name) {
    for (QLineEdit* edit : window_.findChild<Inspector*>()->findChildren<QLineEdit*>()) {
      if (edit->accessibleName() == name && edit->isVisibleTo(&window_)) return edit;
    }
    throw std::runtime_error("no field " + name.toStdString());
  }
  [[nodiscard]] QTableView& table() { return *window_.findChild<BodiesSheet*>()->findChild<QTableView*>(); }
  void click_cell(int row, int column) {
    const QModelIndex index = table().model()->index(row, column);
    table().scrollTo(index);
    QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, table().visualRect(index).center());
  }
  static void type_where_the_focus_is(const QString& text) {
    for (const QChar c : text) QTest::keyClicks(QApplication::focusWidget(), c);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
  }
  // The run has gone on for a while, and plays.
  [[nodiscard]] bool plays_on() {
    const double from = time();
    return wait_for([&] { return window_.frame()->playing && time() > from + 0.02; });
  }
  [[nodiscard]] double mass_in_run() { return mass_of(window_.frame()->bodies->front()); }
  [[nodiscard]] QString undo_text() { return window_.session().edits().undoText(); }

  std::string name_;
};

TEST_F(LabPlayEditTest, DeletePausesAndDeletes) {
  key(Qt::Key_Delete);
  ASSERT_TRUE(pauses());
  EXPECT_TRUE(wait_for([this] { return window_.frame()->bodies->size() == 1; }));
  EXPECT_TRUE(undo_text().contains(": Delete")) << undo_text().toStdString();
}

// The bodies that are cut are those of the pause, not what was on the clipboard.
TEST_F(LabPlayEditTest, CutPausesCopiesAndDeletes) {
  QApplication::clipboard()->setText("something else");
  key(Qt::Key_X, Qt::ControlModifier);
  ASSERT_TRUE(pauses());
  EXPECT_TRUE(wait_for([this] { return window_.frame()->bodies->size() == 1; }));
  EXPECT_TRUE(QApplication::clipboard()->text().contains(QString::fromStdString(name_)));
}

TEST_F(LabPlayEditTest, CopyGoesOnAndPastePauses) {
  key(Qt::Key_C, Qt::ControlModifier);
  EXPECT_TRUE(QApplication::clipboard()->text().contains(QString::fromStdString(name_)));
  EXPECT_TRUE(window_.frame()->playing);
  key(Qt::Key_V, Qt::ControlModifier);
  ASSERT_TRUE(pauses());
  EXPECT_TRUE(wait_for([this] { return undo_text().contains(": Paste"); })) << undo_text().toStdString();
}

TEST_F(LabPlayEditTest, DuplicatePausesAndDuplicates) {
  key(Qt::Key_D, Qt::ControlModifier);
  ASSERT_TRUE(pauses());
  EXPECT_TRUE(wait_for([this] { return undo_text().contains(": Duplicate"); })) << undo_text().toStdString();
}

// The two are of different densities.
TEST_F(LabPlayEditTest, JoinPausesAndSaysWhatCannotBe) {
  window_.scene_view().select({"light", "heavy"});
  key(Qt::Key_G, Qt::ControlModifier);
  ASSERT_TRUE(pauses());
  EXPECT_TRUE(wait_for([this] { return inspector_says("density"); }));
}

TEST_F(LabPlayEditTest, ALinkIsDrawnIntoARun) {
  key(Qt::Key_O);
  const Vec2 from = place_of_slow_body();
  hold(from, from + Vec2(0.0, 0.4));
  QTest::mouseRelease(&window_.scene_view(), Qt::LeftButton, {}, pixel(from + Vec2(0.0, 0.4)));
  EXPECT_TRUE(wait_for([this] { return undo_text().contains(": Add rod"); })) << undo_text().toStdString();
}

TEST_F(LabPlayEditTest, ADrivePausesAndIsDrawn) {
  key(Qt::Key_M);
  const Vec2 from = place_of_slow_body();
  hold(from, from + Vec2(0.0, 0.4));
  ASSERT_TRUE(pauses());
  QTest::mouseRelease(&window_.scene_view(), Qt::LeftButton, {}, pixel(from + Vec2(0.0, 0.4)));
  EXPECT_TRUE(wait_for([this] { return now(name_).drive.has_value(); })) << undo_text().toStdString();
}

// Where the inspector is hidden, what can't be is said over the scene.
TEST_F(LabPlayEditTest, ARefusalIsSeenWithoutTheInspector) {
  window_.findChild<Inspector*>()->hide();
  QApplication::clipboard()->setText("no preset");
  key(Qt::Key_V, Qt::ControlModifier);
  const QList<QLabel*> chips = window_.findChildren<QLabel*>("chip");
  EXPECT_TRUE(std::any_of(chips.begin(), chips.end(), [](const QLabel* chip) {
    return chip->isVisible() && chip->toolTip().contains("holds no bodies");
  }));
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
  const double radius = std::get<Disc>(window_.preset().scene.bodies[0].shape).radius;
  key(Qt::Key_Plus);
  ASSERT_TRUE(pauses());
  ASSERT_TRUE(wait_for([this] { return undo_text().startsWith("Resize"); })) << undo_text().toStdString();
  EXPECT_TRUE(wait_for([&] { return std::get<Disc>(now(name_).shape).radius > 1.04 * radius; }));
  window_.session().runs().set_playing(true);
  ASSERT_TRUE(wait_for([this] { return window_.frame()->playing; }));
  key(Qt::Key_Right, Qt::ControlModifier);
  ASSERT_TRUE(pauses());
  EXPECT_TRUE(wait_for([this] { return undo_text().contains(": Speed"); })) << undo_text().toStdString();
}

TEST_F(LabPlayEditTest, WhatThingsAreIsTypedLiveInTheInspector) {
  EXPECT_FALSE(inspector_says("Pause to edit"));
  const Vec2 start = window_.preset().scene.bodies[0].position;
  type("Mass, kg", "3");
  EXPECT_TRUE(window_.frame()->playing);
  EXPECT_EQ(field("Mass, kg")->text(), "3");
  ASSERT_TRUE(plays_on());
  EXPECT_EQ(mass_in_run(), 3.0);
  EXPECT_EQ(window_.preset().scene.bodies[0].mass, 3.0) << "in the start too";
  EXPECT_EQ(window_.preset().scene.bodies[0].position, start);
  EXPECT_TRUE(undo_text().startsWith("Mass of light")) << undo_text().toStdString();
  window_.session().runs().set_playing(false);
  ASSERT_TRUE(pauses());
  const double before = time();
  undo();
  ASSERT_TRUE(wait_for([this] { return mass_in_run() == 1.0 && window_.frame()->scene; }));
  EXPECT_EQ(time(), before);
  EXPECT_EQ(window_.preset().scene.bodies[0].mass, 1.0);
}

TEST_F(LabPlayEditTest, GravityIsTypedLive) {
  window_.scene_view().select({});
  type("Gravity, m/s²", "2");
  ASSERT_TRUE(plays_on());
  EXPECT_EQ(window_.frame()->forces->gravity.y(), -2.0);
}

TEST_F(LabPlayEditTest, TheInspectorShowsTheMomentThatPlays) {
  const auto shows_now = [this] {
    const double shown = field("Position x, m")->text().replace(QChar(0x2212), '-').toDouble();
    return std::abs(shown - window_.frame()->state.position(0).x()) < 1e-3;
  };
  ASSERT_TRUE(plays_on());
  EXPECT_TRUE(shows_now());
  // Another body is chosen by a click.
  select(window_.frame()->state.position(1));
  ASSERT_EQ(window_.scene_view().selection(), std::vector<std::string>{"heavy"});
  EXPECT_TRUE(window_.frame()->playing);
  EXPECT_EQ(field("Name")->text(), "heavy");
}

TEST_F(LabPlayEditTest, ATypedVelocityPausesFirst) {
  QLineEdit* speed = field("Velocity y, m/s");
  speed->setFocus();
  speed->selectAll();
  ASSERT_TRUE(plays_on());
  QTest::keyClicks(speed, "1");
  ASSERT_TRUE(pauses());
  EXPECT_EQ(speed->text(), "1") << "it is still typed";
  const Body moment = now(name_);
  QTest::keyClick(speed, Qt::Key_Return);
  ASSERT_TRUE(wait_for([this] { return time() == 0.0; }));
  EXPECT_EQ(window_.preset().scene.bodies[0].position, moment.position);
  EXPECT_EQ(window_.preset().scene.bodies[0].velocity, Vec2(moment.velocity.x(), 1.0));
}

// Entered before the run stands still, it holds for the moment of the pause.
TEST_F(LabPlayEditTest, AVelocityTypedFasterThanThePauseCutsNoMotion) {
  type("Velocity y, m/s", "1");
  ASSERT_TRUE(pauses());
  ASSERT_TRUE(wait_for([this] { return undo_text().contains(": "); })) << undo_text().toStdString();
  const double from = *window_.session().history().document().start.from;
  const Body& light = window_.preset().scene.bodies[0];
  EXPECT_EQ(light.velocity.y(), 1.0);
  undo();
  ASSERT_TRUE(wait_for([&] { return time() == from && window_.frame()->scene; }));
  EXPECT_GT(from, 0.0);
}

TEST_F(LabPlayEditTest, TheTableTakesWhatThingsAreLive) {
  ASSERT_TRUE(plays_on());
  click_cell(0, BodiesModel::kMass);
  type_where_the_focus_is("3");
  ASSERT_TRUE(plays_on());
  EXPECT_EQ(mass_in_run(), 3.0);
  EXPECT_FALSE(window_.findChild<BodiesSheet*>()->findChild<QLabel*>("fault")->isVisible());
  EXPECT_EQ(table().currentIndex().row(), 1) << "Enter goes down";
}

TEST_F(LabPlayEditTest, TheTablePausesForAPlace) {
  ASSERT_TRUE(plays_on());
  click_cell(0, BodiesModel::kY);
  QTest::keyClicks(QApplication::focusWidget(), "0");
  ASSERT_TRUE(pauses());
  type_where_the_focus_is(".1");
  ASSERT_TRUE(wait_for([this] { return time() == 0.0; }));
  EXPECT_EQ(window_.preset().scene.bodies[0].position.y(), 0.1);
  EXPECT_NE(window_.preset().scene.bodies[0].position.x(), -1.0);
}

}  // namespace
}  // namespace carom
