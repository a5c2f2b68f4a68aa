#include "widgets/compare/study_panel.h"

#include <QFile>
#include <QHelpEvent>
#include <QLabel>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QToolTip>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>

#include "physics/preset/preset.h"
#include "physics/scene/validate.h"
#include "tests/support/run_fixture.h"
#include "tests/support/wait_events.h"
#include "widgets/compare/error_plot.h"
#include "widgets/compare/order_table.h"

namespace carom {
namespace {

// Discs that fly through a drag, so that every method has an error.
Preset drag_scene() {
  Preset preset = head_on_scene();
  preset.scene.forces.gravity = {0.0, -9.81};
  preset.scene.forces.linear_drag = 0.4;
  preset.duration = 0.5;
  return preset;
}

StudyOptions quick() {
  StudyOptions o;
  o.integrators = {IntegratorId::kExplicitEuler, IntegratorId::kRk4, IntegratorId::kAdaptiveDormandPrince};
  o.steps = {0.05, 0.025, 0.0125};
  o.tolerances = {1e-3, 1e-6};
  o.repeats = 1;
  return o;
}

class StudyPanelTest : public testing::Test {
 protected:
  void SetUp() override {
    QObject::connect(&panel_, &StudyPanel::methodChosen, [this](const Method& m) { chosen_.push_back(m); });
    panel_.resize(600, 150);
    panel_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel_));
    panel_.set_scene(drag_scene(), "drag");
  }
  void run_to_its_end(const StudyOptions& options = quick()) {
    panel_.start(options);
    EXPECT_TRUE(panel_.running());
    ASSERT_TRUE(test::wait_in_event_loop([this] { return !panel_.running(); }));
    ASSERT_EQ(panel_.so_far().phase, StudySoFar::Phase::kDone) << panel_.so_far().refusal;
  }
  [[nodiscard]] const QLabel* label(const QString& text) const {
    for (const QLabel* each : panel_.findChildren<QLabel*>()) {
      if (each->text() == text) return each;
    }
    return nullptr;
  }
  QToolButton* button(const QString& text) {
    for (QToolButton* b : panel_.findChildren<QToolButton*>()) {
      if (b->text() == text) return b;
    }
    throw std::runtime_error("no button " + text.toStdString());
  }
  // The row of one method at one step.
  [[nodiscard]] const StudyRow& row(IntegratorId integrator, ImpactsId impacts, double step) const {
    for (const StudyRow& r : panel_.so_far().table.rows) {
      if (r.method.integrator == integrator && r.method.impacts == impacts && r.method.step == step) return r;
    }
    throw std::runtime_error("no such row");
  }
  void click(const StudyRow& r) {
    const auto pixel = panel_.plot().pixel_of(r);
    ASSERT_TRUE(pixel.has_value());
    QTest::mouseClick(panel_.plot().canvas(), Qt::LeftButton, {}, pixel->toPoint());
  }

  StudyPanel panel_{light_theme()};
  std::vector<Method> chosen_;
};

TEST_F(StudyPanelTest, ComputesWhatTheCommandDoes) {
  EXPECT_FALSE(button("Export...")->isEnabled());
  run_to_its_end();
  StudyTable mine = panel_.so_far().table;
  StudyTable whole = run_study(drag_scene(), "drag", quick());
  for (StudyTable* table : {&mine, &whole}) {
    for (StudyRow& r : table->rows) r.wall_time = r.wall_least = r.wall_most = 0.0;
  }
  EXPECT_EQ(study_csv(mine), study_csv(whole));
  EXPECT_TRUE(button("Export...")->isEnabled());
  EXPECT_TRUE(panel_.words().startsWith("compared at t = ")) << panel_.words().toStdString();
  const QLabel* words = label(panel_.words());
  ASSERT_NE(words, nullptr) << "the whole sentence";
  EXPECT_TRUE(test::wait_in_event_loop([&] {
    return words->height() >= words->heightForWidth(words->width());
  })) << words->height();
  EXPECT_GT(panel_.plot().height(), 80);
}

TEST_F(StudyPanelTest, AClickOnAPointChoosesItsMethod) {
  StudyOptions options = quick();
  options.impacts = {ImpactsId::kLocated};  // so that no two points coincide
  run_to_its_end(options);
  for (const IntegratorId id : {IntegratorId::kExplicitEuler, IntegratorId::kRk4}) {
    for (const double step : quick().steps) {
      chosen_.clear();
      click(row(id, ImpactsId::kLocated, step));
      ASSERT_EQ(chosen_.size(), 1U);
      EXPECT_EQ(chosen_[0].integrator, id);
      EXPECT_EQ(chosen_[0].impacts, ImpactsId::kLocated);
      EXPECT_EQ(chosen_[0].step, step);
    }
  }
  chosen_.clear();
  QTest::mouseClick(panel_.plot().canvas(), Qt::LeftButton, {}, {2, 2});  // empty space
  EXPECT_TRUE(chosen_.empty());
}

// A step chosen by a click does not change the steps of later studies; a scene with another method, or told in
// other words, is the same scene.
TEST_F(StudyPanelTest, AChosenMethodIsNoOtherScene) {
  run_to_its_end();
  Preset with_method = drag_scene();
  with_method.method.integrator = IntegratorId::kExplicitEuler;
  with_method.method.step = 0.001;
  with_method.about += ", told in other words";
  panel_.edit_scene(with_method);
  EXPECT_TRUE(panel_.of_the_scene_shown());
  StudyOptions of_the_scene = quick();
  of_the_scene.steps.clear();
  of_the_scene.integrators = {IntegratorId::kRk4};
  panel_.start(of_the_scene);
  ASSERT_TRUE(test::wait_in_event_loop([this] { return !panel_.running(); }));
  EXPECT_EQ(panel_.so_far().table.rows.front().method.step,
            std::min(16.0 * drag_scene().method.step, 0.5 / 8.0));
}

TEST_F(StudyPanelTest, AnotherTimeOfADiscThatComesLaterIsAnotherScene) {
  Preset with = drag_scene();
  with.edits = {{0.2, 0, SceneEdits{Add<Body>{disc("C", {1.0, 1.0}, {0.0, 0.0}, 1.0)}}}};
  panel_.set_scene(with, "drag");
  run_to_its_end();
  panel_.edit_scene(with);
  EXPECT_TRUE(panel_.of_the_scene_shown());
  with.edits[0].time = 0.3;
  panel_.edit_scene(with);
  EXPECT_FALSE(panel_.of_the_scene_shown());
}

TEST_F(StudyPanelTest, AStudyOfAnotherSceneIsMarkedAndNotClickable) {
  run_to_its_end();
  Preset edited = drag_scene();
  edited.scene.bodies.push_back(disc("C", {1.0, 1.0}, {0.0, 0.0}, 1.0));
  panel_.edit_scene(edited);
  EXPECT_FALSE(panel_.of_the_scene_shown());
  EXPECT_TRUE(panel_.words().startsWith("Before this scene was edited")) << panel_.words().toStdString();
  Preset other = edited;
  other.title = "Another";
  panel_.set_scene(other, "another");
  EXPECT_TRUE(panel_.words().startsWith("Not for the scene shown, but for Head-on"))
      << panel_.words().toStdString();
  const auto* above =
      label("Not for the scene shown, but for " + QString::fromStdString(drag_scene().title) + ".");
  ASSERT_NE(above, nullptr) << "in full";
  QApplication::processEvents();
  EXPECT_TRUE(above->isVisible());
  EXPECT_LE(above->heightForWidth(above->width()), above->height()) << "not cut";
  EXPECT_LE(above->geometry().bottom(), panel_.plot().geometry().top());
  click(row(IntegratorId::kRk4, ImpactsId::kLocated, 0.05));
  EXPECT_TRUE(chosen_.empty());
  panel_.set_scene(drag_scene(), "drag");
  EXPECT_FALSE(above->isVisible());
  click(row(IntegratorId::kRk4, ImpactsId::kLocated, 0.05));
  EXPECT_EQ(chosen_.size(), 1U);
}

// Runs of days: only a stop within a run can end them.
StudyOptions endless() {
  StudyOptions o = quick();
  o.steps = {0.05, kLeastStep};
  return o;
}

TEST_F(StudyPanelTest, CancelStopsAndKeepsWhatIsThere) {
  panel_.start(endless());
  ASSERT_TRUE(test::wait_in_event_loop([this] { return panel_.so_far().stage == "accuracy"; }));
  QTest::mouseClick(button("Cancel"), Qt::LeftButton);
  ASSERT_TRUE(test::wait_in_event_loop([this] { return !panel_.running(); }));
  EXPECT_EQ(panel_.so_far().phase, StudySoFar::Phase::kCancelled);
  EXPECT_NO_THROW((void)button("Run the study"));
  run_to_its_end();
}

TEST(StudyPanel, GoesWhileAStudyRuns) {
  for (const bool started : {false, true}) {
    auto panel = std::make_unique<StudyPanel>(dark_theme());
    panel->show();
    panel->set_scene(drag_scene(), "drag");
    panel->start(endless());
    if (started) {
      ASSERT_TRUE(test::wait_in_event_loop([&] { return panel->so_far().stage == "accuracy"; }));
    }
    panel.reset();
  }
}

TEST_F(StudyPanelTest, AStudyThatCannotBeSaysWhy) {
  StudyOptions o = quick();
  o.integrators = {IntegratorId::kExactFlight};
  panel_.start(o);
  ASSERT_TRUE(test::wait_in_event_loop([this] { return !panel_.running(); }));
  bool said = false;
  for (const QLabel* label : panel_.findChildren<QLabel*>()) {
    said = said || (label->isVisible() && label->text().contains("xact flight"));
  }
  EXPECT_TRUE(said);
}

TEST_F(StudyPanelTest, SavesTableAndPicture) {
  run_to_its_end();
  const QTemporaryDir folder;
  QString error;
  const QString csv = folder.filePath("study.csv");
  ASSERT_TRUE(panel_.save(csv, &error)) << error.toStdString();
  QFile file(csv);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  std::string expected;
  for (const std::string& line : study_csv(panel_.so_far().table)) expected += line + '\n';
  EXPECT_EQ(file.readAll().toStdString(), expected);
  ASSERT_TRUE(panel_.save(folder.filePath("study.svg"), &error)) << error.toStdString();
  EXPECT_GT(QFile(folder.filePath("study.svg")).size(), 10000);
  EXPECT_FALSE(panel_.save(folder.filePath("study.txt"), &error));
  EXPECT_NE(error.indexOf(".txt"), -1);
  EXPECT_FALSE(panel_.save(folder.filePath("no/such/folder/study.csv"), &error));
}

TEST_F(StudyPanelTest, TheMouseOnAPointShowsItsFigures) {
  run_to_its_end();
  QTest::qWait(50);  // the sentence under the plot takes its room
  const StudyRow& r = row(IntegratorId::kRk4, ImpactsId::kLocated, 0.025);
  QTest::mouseMove(panel_.plot().canvas(), panel_.plot().pixel_of(r)->toPoint());
  ASSERT_TRUE(test::wait_in_event_loop([] { return QToolTip::text().contains("RK4"); }));
  EXPECT_TRUE(QToolTip::text().contains("h = 0.025 s")) << QToolTip::text().toStdString();
  EXPECT_TRUE(QToolTip::text().contains("wall time"));

  auto* orders = panel_.findChild<OrderTable*>();
  QHelpEvent help(QEvent::ToolTip, {20, orders->height() / 7 + 3}, orders->mapToGlobal(QPoint(20, 20)));
  QApplication::sendEvent(orders, &help);
  EXPECT_TRUE(QToolTip::text().contains("Explicit Euler")) << QToolTip::text().toStdString();
}

TEST(ErrorPlot, SaysThatNothingMoves) {
  const QTemporaryDir folder;
  const QString file = folder.filePath("empty.png");
  QString error;
  StudyPanel panel(light_theme());
  panel.show();
  panel.set_scene(Preset(), "empty");
  panel.start(quick());
  ASSERT_TRUE(test::wait_in_event_loop([&] { return !panel.running(); }));
  EXPECT_TRUE(panel.save(file, &error)) << error.toStdString();
  EXPECT_EQ(panel.plot().row_at({50.0, 50.0}), nullptr);
}

// Every error against time and step: each row with both values is found where it is drawn.
TEST(ErrorPlot, FindsItsPoints) {
  Preset preset = head_on_scene();
  preset.scene.forces.gravity = {0.0, -1.0};
  preset.duration = 0.5;
  StudyOptions options = quick();
  options.integrators.push_back(IntegratorId::kExactFlight);
  const StudyTable table = run_study(preset, "head-on", options);
  ErrorPlot plot(light_theme(), ErrorPlot::Place::kWindow);
  plot.resize(400, 300);
  plot.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&plot));
  for (const ErrorAgainst against : {ErrorAgainst::kWallTime, ErrorAgainst::kStep}) {
    for (std::size_t error = 0; error < kStudyErrors.size(); ++error) {
      plot.show_study(table.facts, groups_of(table), against, error);
      for (const StudyRow& r : table.rows) {
        const bool drawn =
            !std::isnan(r.*kStudyErrors[error].value) &&
            (against == ErrorAgainst::kWallTime || error_parameter(r.method) == ErrorParameter::kStep);
        const auto pixel = plot.pixel_of(r);
        ASSERT_EQ(pixel.has_value(), drawn) << r.index;
        if (!drawn) continue;
        const StudyRow* found = plot.row_at(*pixel);
        ASSERT_NE(found, nullptr) << r.index;
        const QPointF apart = *plot.pixel_of(*found) - *pixel;
        EXPECT_LT(std::hypot(apart.x(), apart.y()), 1.0) << r.index;
        plot.mark(found);
      }
    }
  }
  // Exact flight has no step: its line is found at every one.
  plot.show_study(table.facts, groups_of(table), ErrorAgainst::kStep, 0);
  const StudyRow* lowest = nullptr;
  for (int y = plot.canvas()->height() - 1; y > 0 && lowest == nullptr; --y) {
    lowest = plot.row_at({plot.canvas()->width() / 2.0 + 11.0, static_cast<double>(y)});
  }
  ASSERT_NE(lowest, nullptr);
  EXPECT_EQ(lowest->method.integrator, IntegratorId::kExactFlight);
}

}  // namespace
}  // namespace carom
