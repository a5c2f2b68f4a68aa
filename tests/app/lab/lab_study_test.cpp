#include <QApplication>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <gtest/gtest.h>
#include <set>
#include <stdexcept>

#include "app/lab/drawer.h"
#include "app/lab/lab_window.h"
#include "physics/preset/preset.h"
#include "physics/scene/validate.h"
#include "tests/support/wait_events.h"
#include "widgets/compare/error_plot.h"
#include "widgets/compare/study_panel.h"
#include "widgets/compare/study_steps.h"

namespace carom {
namespace {

StudyOptions quick() {
  StudyOptions o;
  o.integrators = {IntegratorId::kExplicitEuler, IntegratorId::kRk4};
  o.impacts = {ImpactsId::kLocated};
  o.steps = {0.02, 0.01, 0.005};
  o.repeats = 1;
  return o;
}

class LabStudyTest : public testing::Test {
 protected:
  void SetUp() override {
    window_ = std::make_unique<LabWindow>(light_theme());
    window_->resize(1000, 700);
    window_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
    ASSERT_TRUE(window_->open("drag-projectile"));
    panel_ = window_->findChild<StudyPanel*>();
    ASSERT_NE(panel_, nullptr);
    window_->findChild<Drawer*>()->choose(panel_);
    ASSERT_TRUE(test::wait_in_event_loop([this] { return panel_->isVisible(); }));
  }
  std::unique_ptr<LabWindow> window_;
  StudyPanel* panel_ = nullptr;
};

// Through the dialog, like a user.
TEST_F(LabStudyTest, TheStepsAreChosen) {
  const auto button = [this](const QString& text) {
    for (auto* each : panel_->findChildren<QToolButton*>()) {
      if (each->text() == text) return each;
    }
    throw std::runtime_error("no button " + text.toStdString());
  };
  const auto answer = [](const QString& steps, const QString& expected_fault) {
    auto* dialog = qobject_cast<StudyStepsDialog*>(QApplication::activeModalWidget());
    ASSERT_NE(dialog, nullptr);
    auto* list = dialog->findChild<QLineEdit*>();
    list->selectAll();
    QTest::keyClicks(list, steps);
    EXPECT_EQ(dialog->findChild<QLabel*>("fault")->text(), expected_fault);
    QPushButton* accept = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
    EXPECT_EQ(accept->isEnabled(), expected_fault.isEmpty());
    if (expected_fault.isEmpty()) {
      accept->click();
    } else {
      dialog->reject();
    }
  };
  button("usual steps...")->click();
  answer("20; zero", "zero is not allowed; allowed: a step from 1e−6 to 1000 ms");
  button("usual steps...")->click();
  answer("10 ms; 20 5,5ms", {});
  StudyOptions options = quick();
  options.steps.clear();
  button("3 steps...");
  panel_->start(options);
  ASSERT_TRUE(test::wait_in_event_loop([this] { return !panel_->running(); }));
  std::set<double> steps;
  for (const StudyRow& row : panel_->so_far().table.rows) steps.insert(row.method.step);
  EXPECT_EQ(steps, (std::set<double>{0.0055, 0.01, 0.02}));
  ASSERT_TRUE(window_->open("bouncing-ball"));
  EXPECT_NO_THROW(button("usual steps...")) << "those of another scene";
}

TEST_F(LabStudyTest, AClickOnAPointTakesItsMethodIntoTheComparison) {
  panel_->start(quick());
  ASSERT_TRUE(test::wait_in_event_loop([this] { return !panel_->running(); }));
  ASSERT_EQ(panel_->so_far().phase, StudySoFar::Phase::kDone);
  EXPECT_EQ(panel_->so_far().table.facts.preset, "drag-projectile");
  EXPECT_FALSE(window_->isWindowModified());
  for (const StudyRow& row : std::vector<StudyRow>(panel_->so_far().table.rows)) {
    const auto pixel = panel_->plot().pixel_of(row);
    ASSERT_TRUE(pixel.has_value());
    for (int i = 0; i < 2; ++i) {  // the second time the method is present already
      QTest::mouseClick(panel_->plot().canvas(), Qt::LeftButton, {}, pixel->toPoint());
      const Preset preset = window_->preset();
      std::vector<Method> methods = preset.compare;
      methods.push_back(preset.method);
      EXPECT_EQ(std::count(methods.begin(), methods.end(), row.method), 1) << row.index;
    }
    EXPECT_TRUE(panel_->of_the_scene_shown());
  }
  EXPECT_EQ(window_->preset().compare.size(), kMostCompared);
  EXPECT_TRUE(window_->isWindowModified());
}

TEST_F(LabStudyTest, TheLastStudyStaysWhenAnotherSceneIsShown) {
  panel_->start(quick());
  ASSERT_TRUE(test::wait_in_event_loop([this] { return !panel_->running(); }));
  ASSERT_TRUE(window_->open("head-on"));
  EXPECT_FALSE(panel_->of_the_scene_shown());
  EXPECT_TRUE(panel_->words().contains("Projectile with drag")) << panel_->words().toStdString();
  ASSERT_TRUE(window_->open("drag-projectile"));
  EXPECT_TRUE(panel_->of_the_scene_shown());
}

TEST_F(LabStudyTest, TheWindowClosesWhileAStudyRuns) {
  StudyOptions endless = quick();
  endless.steps = {kLeastStep};
  panel_->start(endless);
  ASSERT_TRUE(test::wait_in_event_loop([this] { return panel_->so_far().stage == "accuracy"; }));
  window_.reset();
}

TEST_F(LabStudyTest, TheTabNeedsNoLargerWindow) { EXPECT_EQ(window_->size(), QSize(1000, 700)); }

}  // namespace
}  // namespace carom
