#include <QComboBox>
#include <QKeyEvent>
#include <QPushButton>
#include <QStyle>
#include <QStyleOptionComboBox>

#include "physics/preset/preset_file.h"
#include "tests/app/lab/lab_fixture.h"
#include "tests/support/scenes.h"
#include "widgets/run/stop_editor.h"
#include "widgets/run/timeline.h"

// Stops act in the window: playing halts at their moments, their flags and their editor change the document.
// The experiment head-on has its one impact at a third of a second and lasts one second.
namespace carom {
namespace {

class LabStopsTest : public LabWindowTest {
 protected:
  void SetUp() override {
    ASSERT_NO_FATAL_FAILURE(LabWindowTest::SetUp());
    choose_speed(4.0);
  }
  LabRuns& runs() { return window_.session().runs(); }
  Timeline* timeline() { return window_.findChild<Timeline*>(); }
  StopEditor* editor() { return window_.findChild<StopEditor*>(); }
  [[nodiscard]] std::vector<std::string> sentences() const {
    std::vector<std::string> all;
    for (const Stop& stop : window_.preset().stops) all.push_back(sentence_of(stop));
    return all;
  }
  template <class Part>
  Part* part(const QString& name) {
    for (Part* each : editor()->findChildren<Part*>()) {
      if (each->accessibleName() == name || each->property("text").toString() == name) return each;
    }
    throw std::runtime_error("no part " + name.toStdString());
  }
  QLineEdit* sentence() { return part<QLineEdit>("Sentence of the stop"); }
  // Without a window manager the window is not active again by itself.
  void close_editor() {
    editor()->hide();
    window_.activateWindow();
    window_.scene_view().setFocus();
  }
  void type_stop(const QString& text) {
    action("Stops...")->trigger();
    ASSERT_TRUE(editor()->isVisible());
    sentence()->clear();
    QTest::keyClicks(sentence(), text);
    QTest::keyClick(sentence(), Qt::Key_Return);
    close_editor();
  }
  void set_stops(const std::vector<std::string>& all) {
    std::vector<Stop> stops;
    for (const std::string& each : all) stops.push_back(stop_of("stop", each));
    window_.session().change_stops(stops, "stops");
  }
  void press(Qt::Key key) { QTest::keyClick(&window_.scene_view(), key); }
  [[nodiscard]] bool wait_stopped(const QString& text) {
    return wait_for([&] {
      return !window_.frame()->playing && runs().there() && chip("Why it stopped")->isVisible() &&
             chip("Why it stopped")->text() == "stopped: " + text;
    });
  }
  QPoint flag_at(double time) { return {qRound(timeline()->x_of(time)) + 2, timeline()->height() / 2 - 10}; }
  void drag_flag(double from, double to, bool escape = false) {
    const int by = qRound(timeline()->x_of(to) - timeline()->x_of(from));
    const QPoint end = flag_at(from) + QPoint(by, 0);
    QTest::mousePress(timeline(), Qt::LeftButton, {}, flag_at(from));
    QMouseEvent move(QEvent::MouseMove, end, timeline()->mapToGlobal(end), Qt::NoButton, Qt::LeftButton,
                     Qt::NoModifier);
    QApplication::sendEvent(timeline(), &move);
    if (escape) QTest::keyClick(timeline(), Qt::Key_Escape);
    QTest::mouseRelease(timeline(), Qt::LeftButton, {}, end);
  }
};

TEST_F(LabStopsTest, AFlagAtTheFirstImpactRestartAndSpace) {
  click_button("Stops");
  ASSERT_TRUE(editor()->isVisible());
  EXPECT_EQ(sentence()->text(), "at the 1st impact") << "what is offered";
  QTest::mouseClick(part<QPushButton>("Add"), Qt::LeftButton);
  close_editor();
  EXPECT_EQ(sentences(), std::vector<std::string>{"at the 1st impact"});
  EXPECT_EQ(window_.session().edits().undoText(), "Stop at the 1st impact");
  press(Qt::Key_R);
  press(Qt::Key_Space);
  ASSERT_TRUE(wait_stopped("1st impact"));
  EXPECT_NEAR(time(), 1.0 / 3.0, 1e-9) << "not rounded to a step";
  EXPECT_EQ(chip("Impact at this moment")->text(), "impact 1 of 1");
  ASSERT_TRUE(runs().picked()) << "for its arrows and its table";
  EXPECT_NEAR(*runs().picked(), 1.0 / 3.0, 1e-9);
  ASSERT_FALSE(window_.frame()->jumps.empty());
  EXPECT_EQ(window_.frame()->jumps.back()->time(), *runs().picked());
  EXPECT_NE(runs().scene(), nullptr) << "for edits";
  press(Qt::Key_Space);
  ASSERT_TRUE(wait_for([this] { return !window_.frame()->playing && time() > 0.98; }))
      << "Space goes on past it";
  Simulation alone(setup_of(window_.preset()));
  while (alone.steps() < steps()) alone.step();
  EXPECT_TRUE(test::same_bytes(window_.frame()->state, alone.state()))
      << "with the digits of a run without stops";
  press(Qt::Key_R);
  press(Qt::Key_Space);
  ASSERT_TRUE(wait_stopped("1st impact")) << "and again";
}

TEST_F(LabStopsTest, AtTheEndTheChipSaysSo) {
  EXPECT_FALSE(chip("Why it stopped")->isVisible());
  press(Qt::Key_Space);
  ASSERT_TRUE(wait_for([this] { return time() > 0.98 && !window_.frame()->playing; }));
  EXPECT_TRUE(chip("Why it stopped")->isVisible());
  EXPECT_EQ(chip("Why it stopped")->text(), "end, 1 s");
  press(Qt::Key_Comma);
  ASSERT_TRUE(wait_for([this] { return runs().in_past() && runs().there(); }));
  EXPECT_FALSE(chip("Why it stopped")->isVisible()) << "a step before it";
  press(Qt::Key_R);
  ASSERT_TRUE(wait_for([this] { return time() == 0.0; }));
  EXPECT_FALSE(chip("Why it stopped")->isVisible());
}

TEST_F(LabStopsTest, TheSpeedHasAChipUnlessItIsReal) {
  EXPECT_TRUE(chip("Speed")->isVisible());
  EXPECT_EQ(chip("Speed")->text(), TransportBar::speed_text(4.0));
  choose_speed(1.0);
  EXPECT_TRUE(wait_for([this] { return !chip("Speed")->isVisible(); }));
  action("Slow near impacts")->trigger();
  EXPECT_TRUE(chip("Speed")->isVisible()) << "it will be slower near impacts";
  action("Slow near impacts")->trigger();
  EXPECT_FALSE(chip("Speed")->isVisible());
}

TEST_F(LabStopsTest, WordsOfTheChoicesAreWhole) {
  action("Stops...")->trigger();
  sentence()->clear();
  QTest::keyClicks(sentence(), "when light passes x = 0.4 m");
  for (const char* name : {"Kind of stop", "Quantity", "Direction"}) {
    auto* box = part<QComboBox>(name);
    ASSERT_TRUE(box->isVisible()) << name;
    for (int i = 0; i < box->count(); ++i) {
      box->setCurrentIndex(i);
      QStyleOptionComboBox option;
      option.initFrom(box);
      const QRect words =
          box->style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, box);
      EXPECT_GE(words.width(), box->fontMetrics().horizontalAdvance(box->currentText()))
          << box->currentText().toStdString();
    }
    sentence()->setText("when light passes x = 0.4 m");
    emit sentence()->textEdited(sentence()->text());
  }
  close_editor();
}

TEST_F(LabStopsTest, ASentenceMayHaveADecimalCommaAndNamesWhatIsMissing) {
  action("Stops...")->trigger();
  const auto type = [this](const QString& text) {
    sentence()->clear();
    QTest::keyClicks(sentence(), text);
  };
  const auto fault = [this] {
    const auto* label = part<QLabel>("What is wrong");
    return label->isVisible() ? label->text() : QString();
  };
  type("when dark passes x = 0,4 m");
  EXPECT_EQ(fault(), "There is no body “dark” here.");
  type("when light passes x = 0,4 m");
  EXPECT_EQ(fault(), "");
  QTest::keyClick(sentence(), Qt::Key_Return);
  close_editor();
  EXPECT_EQ(sentences(), std::vector<std::string>{"when light passes x = 0.4 m"});
}

TEST_F(LabStopsTest, TheRecordMeetsThemAgain) {
  set_stops({"at the 1st impact", "at 0.5 s", "at 0.503 s"});
  window_.run_until(1.0);
  EXPECT_FALSE(runs().stopped());
  press(Qt::Key_Home);
  ASSERT_TRUE(wait_for([this] { return runs().there() && time() == 0.0; }));
  for (const auto& [text, moment] :
       std::vector<std::pair<QString, double>>{{"1st impact", 1.0 / 3.0}, {"0.5 s", 0.5}, {"0.503 s", 0.503}}) {
    press(Qt::Key_Space);
    ASSERT_TRUE(wait_stopped(text));
    EXPECT_NEAR(time(), moment, 1e-9);
  }
  press(Qt::Key_Space);
  ASSERT_TRUE(wait_for([this] { return !window_.frame()->playing && time() > 0.98; }));
}

TEST_F(LabStopsTest, StepsLeadFromAnImpactAndBackToIt) {
  set_stops({"at the 1st impact"});
  press(Qt::Key_Space);
  ASSERT_TRUE(wait_stopped("1st impact"));
  const State was = window_.frame()->state;
  press(Qt::Key_Comma);
  ASSERT_TRUE(wait_for([&] { return runs().there() && time() < 0.33 && !runs().stopped(); }));
  press(Qt::Key_Period);
  ASSERT_TRUE(wait_stopped("1st impact"));
  EXPECT_TRUE(test::same_bytes(window_.frame()->state, was));
}

// Where two bodies touch at the end of a step is the end of that step.
TEST_F(LabStopsTest, AnImpactAtAStepsEndIsPickedToo) {
  Preset preset = window_.preset();
  preset.method.impacts = ImpactsId::kStepEnd;
  preset.stops = {stop_of("stop", "at the 1st impact")};
  const std::string file = folder_.filePath("step-end.json").toStdString();
  save_preset(preset, file);
  ASSERT_TRUE(window_.open(file));
  press(Qt::Key_Space);
  ASSERT_TRUE(wait_stopped("1st impact"));
  EXPECT_EQ(chip("Impact at this moment")->text(), "impact 1 of 1");
  ASSERT_TRUE(runs().picked());
  EXPECT_NEAR(*runs().picked(), time(), 1e-12);
}

TEST_F(LabStopsTest, StepsLeaveAMomentToTheEndsOfItsStep) {
  set_stops({"at 0.503 s"});
  press(Qt::Key_Space);
  ASSERT_TRUE(wait_stopped("0.503 s"));
  const double step = window_.frame()->method.step;
  const double before = std::floor(time() / step) * step;
  press(Qt::Key_Comma);
  ASSERT_TRUE(wait_for([&] { return runs().there() && std::abs(time() - before) < 1e-12; }));
  press(Qt::Key_Period);
  ASSERT_TRUE(wait_for([&] { return !runs().in_past() && std::abs(time() - before - step) < 1e-12; }));
}

// As playing does.
TEST_F(LabStopsTest, ASingleStepHaltsAtTheMoment) {
  set_stops({"at the 1st impact"});
  window_.run_until(0.33);
  const double step = window_.frame()->method.step;
  press(Qt::Key_Period);
  ASSERT_TRUE(wait_stopped("1st impact"));
  EXPECT_NEAR(time(), 1.0 / 3.0, 1e-9);
  press(Qt::Key_Period);
  ASSERT_TRUE(wait_for([&] { return !runs().in_past() && std::abs(time() - 0.33 - step) < 1e-12; }));
}

TEST_F(LabStopsTest, SentencesAreTypedAndRefused) {
  type_stop("when all is at rest");
  EXPECT_EQ(sentences(), std::vector<std::string>{"when all is at rest"});
  action("Stops...")->trigger();
  sentence()->clear();
  QTest::keyClicks(sentence(), "at tea time");
  auto* fault = part<QLabel>("What is wrong");
  EXPECT_TRUE(fault->isVisible());
  EXPECT_TRUE(fault->text().startsWith("stop: \"at tea time\" is not allowed; allowed: \"at 2.5 s\""));
  EXPECT_FALSE(part<QPushButton>("Add")->isEnabled());
  sentence()->clear();
  QTest::keyClicks(sentence(), "at every impact of nobody");
  EXPECT_TRUE(fault->text().contains("nobody"));
  QTest::keyClick(sentence(), Qt::Key_Return);
  EXPECT_EQ(sentences().size(), 1U);
}

TEST_F(LabStopsTest, ChoicesBuildASentence) {
  const QString body = QString::fromStdString(window_.session().history().bodies().front().name);
  action("Stops...")->trigger();
  part<QComboBox>("Kind of stop")->setCurrentIndex(static_cast<int>(StopKind::kPassing));
  part<QComboBox>("Body")->setCurrentIndex(1);
  part<QComboBox>("Quantity")->setCurrentIndex(1);
  part<QComboBox>("Direction")->setCurrentIndex(2);
  auto* value = part<QLineEdit>("Value");
  value->setFocus();
  value->selectAll();
  QTest::keyClicks(value, "40 cm");
  EXPECT_EQ(sentence()->text(), QString("when %1 passes y = 0.4 m downwards").arg(body));
  part<QComboBox>("Kind of stop")->setCurrentIndex(static_cast<int>(StopKind::kEveryImpact));
  part<QComboBox>("Other body")->setCurrentIndex(1);
  EXPECT_EQ(sentence()->text(), QString("at every impact of %1 with a wall").arg(body));
}

TEST_F(LabStopsTest, AFlagIsDraggedInOneStepOfUndo) {
  type_stop("at 0.5 s");
  drag_flag(0.5, 0.75);
  ASSERT_EQ(window_.preset().stops.size(), 1U);
  EXPECT_NEAR(window_.preset().stops[0].time, 0.75, 0.01);
  EXPECT_TRUE(window_.session().edits().undoText().startsWith("Stop at 0.7"));
  action("Undo Stop at " + QString::number(window_.preset().stops[0].time) + " s")->trigger();
  EXPECT_EQ(sentences(), std::vector<std::string>{"at 0.5 s"});
  drag_flag(0.5, 0.75, true);
  EXPECT_EQ(sentences(), std::vector<std::string>{"at 0.5 s"}) << "Escape takes the drag back";
}

TEST_F(LabStopsTest, AFlagOpensItsSentenceAndDeleteRemovesIt) {
  set_stops({"at 0.2 s", "at 0.5 s"});
  QTest::mouseClick(timeline(), Qt::LeftButton, {}, flag_at(0.5));
  ASSERT_TRUE(editor()->isVisible());
  EXPECT_EQ(sentence()->text(), "at 0.5 s");
  QTest::keyClick(part<QListWidget>("Stops"), Qt::Key_Delete);
  close_editor();
  EXPECT_EQ(sentences(), std::vector<std::string>{"at 0.2 s"});
  EXPECT_EQ(window_.session().edits().undoText(), "Remove stop at 0.5 s");
  QTest::mouseClick(timeline(), Qt::LeftButton, {}, flag_at(0.2));
  close_editor();
  QTest::keyClick(timeline(), Qt::Key_Delete);
  EXPECT_TRUE(sentences().empty());
}

TEST_F(LabStopsTest, AnEditAtAStopBeginsThereAndComesBack) {
  set_stops({"at the 1st impact"});
  press(Qt::Key_Space);
  ASSERT_TRUE(wait_stopped("1st impact"));
  const State was = window_.frame()->state;
  Body body = runs().scene()->bodies[0];
  body.position.y() += 0.3;
  window_.session().edit({Replace<Body>{body}}, "Move");
  ASSERT_TRUE(wait_for([this] { return time() == 0.0; }));
  EXPECT_NEAR(window_.frame()->state.v(0, 1), was.v(0, 1), 0.0) << "from the shown moment";
  EXPECT_EQ(sentences(), std::vector<std::string>{"at the 1st impact"});
  window_.session().edits().undo();
  ASSERT_TRUE(wait_stopped("1st impact"));
  EXPECT_TRUE(test::same_bytes(window_.frame()->state, was));
}

TEST_F(LabStopsTest, TheyAreSavedAndLoaded) {
  type_stop("at the 1st impact");
  const std::string file = folder_.filePath("stops.json").toStdString();
  window_.session().save(QString::fromStdString(file));
  ASSERT_TRUE(window_.open("head-on"));
  ASSERT_TRUE(window_.open(file));
  ASSERT_TRUE(wait_for([this] { return window_.preset().stops.size() == 1; }));
  press(Qt::Key_Space);
  ASSERT_TRUE(wait_stopped("1st impact"));
}

TEST_F(LabStopsTest, TheEndIsWhereAStopEndedTheRun) {
  set_stops({"at the 1st impact"});
  press(Qt::Key_Space);
  ASSERT_TRUE(wait_stopped("1st impact"));
  press(Qt::Key_Home);
  ASSERT_TRUE(wait_for([this] { return runs().there() && time() == 0.0; }));
  press(Qt::Key_End);
  ASSERT_TRUE(wait_stopped("1st impact"));
  EXPECT_NEAR(time(), 1.0 / 3.0, 1e-9);
}

TEST_F(LabStopsTest, ASentenceIsReadAgainOnceItsBodyIsThere) {
  action("Stops...")->trigger();
  sentence()->clear();
  QTest::keyClicks(sentence(), "at the 1st impact of ball");
  auto* fault = part<QLabel>("What is wrong");
  ASSERT_TRUE(fault->isVisible());
  std::vector<Body> bodies = window_.session().history().bodies();
  bodies.front().name = "ball";
  editor()->set_document({}, bodies);
  EXPECT_FALSE(fault->isVisible());
  EXPECT_TRUE(part<QPushButton>("Add")->isEnabled());
}

}  // namespace
}  // namespace carom
