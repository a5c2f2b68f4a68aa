#include <QAction>
#include <QInputDialog>
#include <QMenu>
#include <QTest>
#include <QToolButton>
#include <gtest/gtest.h>

#include "tests/app/lab/lab_fixture.h"
#include "tests/support/wait_events.h"

namespace carom {
namespace {

class LabToolBarTest : public LabWindowTest {};

TEST_F(LabToolBarTest, TheToolBarIsWholeInANarrowWindow) {
  action("Dormand-Prince 5(4), adaptive")->trigger();
  const QToolButton* impacts = button("When impacts are resolved");
  EXPECT_LE(window_.minimumWidth(), 880);
  for (const int width : {1280, 1100, 950, 880}) {
    window_.resize(width, 640);
    QApplication::processEvents();
    ASSERT_EQ(window_.width(), width);
    const QToolButton* last = button("Dark colours");
    EXPECT_TRUE(last->isVisible()) << width;
    EXPECT_GT(button("How free motion is advanced")->text().size(), 4) << width;
    EXPECT_LE(last->mapTo(&window_, QPoint(last->width(), 0)).x(), width);
  }
  EXPECT_EQ(impacts->text(), "located ▾");
  window_.resize(1500, 640);
  EXPECT_TRUE(wait_for([&] { return impacts->text() == "impacts at their own time ▾"; }));
}

TEST_F(LabToolBarTest, TheToolBarNamesTheExperimentAndKeepsTheSwitchesInAMenu) {
  ASSERT_TRUE(window_.open("head-on"));
  const QToolButton* experiments = button("Head-on");
  EXPECT_TRUE(experiments->text().startsWith("Head-on")) << experiments->text().toStdString();
  const auto* more = button("More buttons");
  EXPECT_FALSE(more->isVisible());
  window_.resize(1100, 700);
  EXPECT_TRUE(wait_for([&] { return more->isVisible(); }));
  EXPECT_TRUE(more->menu()->actions().contains(action("Grid")));
  window_.resize(1280, 700);
  EXPECT_TRUE(wait_for([&] { return !more->isVisible(); }));
}

// At any width and with any method.
TEST_F(LabToolBarTest, NoButtonIsLost) {
  for (const char* experiment : {"head-on", "ball-in-a-box"}) {
    ASSERT_TRUE(window_.open(experiment));
    for (const int width : {1400, 1280, 1240, 1200, 1199, 1100, 1024, 1000, 950, 900, 880}) {
      window_.resize(width, 700);
      QTest::qWait(30);
      const QString where = QString("%1 at %2").arg(experiment).arg(width);
      for (const char* tip :
           {"Dark colours", "Help", "Which plots", "How free motion", "When impacts", "How lasting"}) {
        const QToolButton* shown = button(tip);
        EXPECT_TRUE(shown->isVisible()) << tip << ", " << where.toStdString();
        EXPECT_LE(shown->mapTo(&window_, QPoint(shown->width(), 0)).x(), width) << tip << where.toStdString();
      }
      const QString method = button("How free motion")->text();
      EXPECT_TRUE(method.startsWith(QString(experiment) == "head-on" ? "RK4" : "E")) << method.toStdString();
    }
  }
}

TEST_F(LabToolBarTest, TheStepButtonGoesByTheIntegrator) {
  EXPECT_EQ(button("Length of a step")->text(), "h = 5 ms ▾");
  action("Dormand-Prince 5(4), adaptive")->trigger();
  EXPECT_EQ(button("Largest error of a step")->text(), "tolerance 1e−9 ▾");
  action("tolerance 1e−6")->trigger();
  EXPECT_EQ(window_.preset().method.tolerance, 1e-6);
  EXPECT_EQ(button("Largest error of a step")->text(), "tolerance 1e−6 ▾");
  action("Exact flight")->trigger();
  EXPECT_EQ(button("Exact flight needs no step")->text(), "results every 5 ms ▾");
  window_.run_until(1.0);
  EXPECT_NEAR(window_.frame()->totals.momentum.x(), -0.5, 1e-12);
}

TEST_F(LabToolBarTest, AnotherStepIsAskedForWithItsBounds) {
  for (QAction* each : button("Length of a step")->menu()->actions()) {
    if (each->text() == "Another...") each->trigger();
  }
  auto* dialog = window_.findChild<QInputDialog*>();
  ASSERT_NE(dialog, nullptr);
  EXPECT_EQ(dialog->labelText(), "h in ms, from 0.000001 to 1000:");
  dialog->setDoubleValue(2.5);
  dialog->accept();
  EXPECT_DOUBLE_EQ(window_.preset().method.step, 0.0025);
}

TEST_F(LabToolBarTest, AStepOutOfItsBoundsIsRefusedWithASentence) {
  const double before = window_.preset().method.step;
  for (QAction* each : button("Length of a step")->menu()->actions()) {
    if (each->text() == "Another...") each->trigger();
  }
  auto* dialog = window_.findChild<QInputDialog*>();
  ASSERT_NE(dialog, nullptr);
  auto* line = dialog->findChild<QLineEdit*>();
  ASSERT_NE(line, nullptr);
  line->selectAll();
  QTest::keyClicks(line, "-3");
  dialog->accept();
  ASSERT_TRUE(wait_for_boxes(1));
  EXPECT_TRUE(boxes_[0].startsWith("h lies between 0.000001 and 1000 ms; it is still 5 ms."))
      << boxes_[0].toStdString();
  EXPECT_EQ(window_.preset().method.step, before);
}

TEST_F(LabToolBarTest, TheStepsAndTolerancesHaveATickToo) {
  const auto ticked = [this](const QString& tip) {
    QMenu* menu = button(tip)->menu();
    emit menu->aboutToShow();
    QStringList texts;
    for (const QAction* each : menu->actions()) {
      if (each->isChecked()) texts << each->text();
    }
    return texts.join(", ");
  };
  EXPECT_EQ(ticked("Length of a step"), "h = 5 ms");
  action("h = 20 ms")->trigger();
  EXPECT_EQ(ticked("Length of a step"), "h = 20 ms");
  for (QAction* each : button("Length of a step")->menu()->actions()) {
    if (each->text() == "Another...") each->trigger();
  }
  auto* dialog = window_.findChild<QInputDialog*>();
  ASSERT_NE(dialog, nullptr);
  dialog->setDoubleValue(3.3);
  dialog->accept();
  EXPECT_EQ(ticked("Length of a step"), "Another...");
  action("Dormand-Prince 5(4), adaptive")->trigger();
  EXPECT_EQ(ticked("Largest error of a step"), "tolerance 1e−9");
}

TEST_F(LabToolBarTest, WhatASceneForbidsIsGreyAndSaysWhy) {
  EXPECT_TRUE(action("Exact flight")->isEnabled());
  ASSERT_TRUE(window_.open("drag-projectile"));
  EXPECT_FALSE(action("Exact flight")->isEnabled());
  EXPECT_TRUE(action("Exact flight")->toolTip().contains("not possible with drag"));
  EXPECT_TRUE(action("RK4")->isEnabled());
  ASSERT_TRUE(window_.open("head-on"));
  EXPECT_TRUE(action("Exact flight")->isEnabled());
}

}  // namespace
}  // namespace carom
