#include "widgets/compare/compare_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <gtest/gtest.h>
#include <qwt_plot.h>
#include <qwt_plot_curve.h>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/preset/preset.h"
#include "tests/support/run_fixture.h"
#include "tests/support/scene_fixture.h"
#include "widgets/base/method_names.h"
#include "widgets/compare/compare_table.h"
#include "widgets/plot/legend_button.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/scene/drawing.h"

namespace carom {
namespace {

Method method(IntegratorId integrator, ImpactsId impacts = ImpactsId::kLocated, double step = 0.005) {
  Method m;
  m.integrator = integrator;
  m.impacts = impacts;
  m.step = step;
  return m;
}

TEST(MethodNames, NameOnlyTheDifferences) {
  const Method euler = method(IntegratorId::kExplicitEuler);
  const Method rk4 = method(IntegratorId::kRk4);
  EXPECT_EQ(names_of({euler, rk4}), (std::vector<QString>{"Explicit Euler", "RK4"}));
  const Method late = method(IntegratorId::kRk4, ImpactsId::kStepEnd);
  EXPECT_EQ(names_of({rk4, late}), (std::vector<QString>{"RK4, located", "RK4, step-end"}));
  const Method fine = method(IntegratorId::kRk4, ImpactsId::kLocated, 0.0025);
  const Method exact = method(IntegratorId::kExactFlight);
  EXPECT_EQ(names_of({rk4, fine, exact}), (std::vector<QString>{"RK4, 5 ms", "RK4, 2.5 ms", "Exact flight"}));
  EXPECT_TRUE(names_of({}).empty());
}

class ComparePanelTest : public testing::Test {
 protected:
  void SetUp() override {
    preset_ = head_on_scene();
    preset_.method = method(IntegratorId::kRk4);
    preset_.compare = {method(IntegratorId::kExplicitEuler),
                       method(IntegratorId::kRk4, ImpactsId::kStepEnd, 0.3)};
    panel_.set_scene(preset_, ReferenceId::kExactFlight);
    for (std::size_t i = 0; i < 3; ++i) {
      auto frame = std::make_shared<Frame>(run_to(preset_, 1.0));
      frame->method = i == 0 ? preset_.method : preset_.compare[i - 1];
      frame->wall_time = 0.25 * static_cast<double>(i);
      frame->error.emplace();
      frame->error->position = 0.125 * static_cast<double>(i);
      frame->error->largest_position = 0.5;
      frame->error->angle = 0.375;
      frame->error->impact_time = 0.25;
      frame->error->matched = static_cast<int>(i);
      frame->error->unmatched = 7;
      frame->error->uncertainty = 1e-9 * static_cast<double>(i);
      frames_.push_back(frame);
    }
    panel_.resize(640, 200);
    panel_.show();
    show_frames();
  }
  void show_frames() {
    panel_.update_from({frames_.begin(), frames_.end()});
    QApplication::processEvents();
  }
  [[nodiscard]] bool has_label(const QString& text) const {
    const auto labels = panel_.findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(),
                       [&](const QLabel* label) { return label->text() == text; });
  }
  [[nodiscard]] QString cell(int row, int column, int role = Qt::DisplayRole) const {
    return table()->model()->index(row, column).data(role).toString();
  }
  [[nodiscard]] CompareTable* table() const { return panel_.findChild<CompareTable*>(); }
  [[nodiscard]] QComboBox* box(const QString& text) const {
    for (auto* b : panel_.findChildren<QComboBox*>()) {
      if (b->findText(text) >= 0) return b;
    }
    return nullptr;
  }
  void choose(const QString& text) const {
    QComboBox* b = box(text);
    b->setCurrentIndex(b->findText(text));
    emit b->activated(b->currentIndex());
  }

  Preset preset_;
  std::vector<std::shared_ptr<Frame>> frames_;
  ComparePanel panel_{light_theme()};
};

TEST_F(ComparePanelTest, ShowsErrorsAndCostsOfEachMethod) {
  ASSERT_EQ(table()->model()->rowCount(), 3);
  EXPECT_EQ(cell(2, 0), "RK4, step-end, 300 ms");
  EXPECT_EQ(cell(1, 1), "0.125");
  EXPECT_EQ(cell(1, 2), "0.500");
  EXPECT_EQ(cell(1, 3), "0.375");
  EXPECT_EQ(cell(1, 4), "0.250");
  EXPECT_EQ(cell(0, 4), "") << "no impact has a partner yet";
  EXPECT_EQ(cell(2, 6), "0.50");
  EXPECT_TRUE(cell(1, 4, Qt::ToolTipRole).contains("1 impacts found their partner, 7 did not"));
  EXPECT_TRUE(has_label("± 2e−9 m")) << "the most uncertain of the references";
}

TEST_F(ComparePanelTest, RoundingIsNoFigure) {
  for (const auto& frame : frames_) {
    frame->error->position = 3.6e-15;
    frame->error->largest_position = 0.0;
    frame->error->impact_time = 2e-16;
    frame->error->matched = 1;
    frame->error->uncertainty = 2e-16;
  }
  show_frames();
  EXPECT_EQ(cell(1, 1).left(4), "< 1e");
  EXPECT_EQ(cell(1, 1, Qt::ToolTipRole).section('\n', 0, 0), "3.6e−15");
  EXPECT_EQ(cell(1, 2), "0");
  EXPECT_EQ(cell(1, 4), "< 1e−12");
  EXPECT_TRUE(has_label(cell(1, 1) + " m"));
  frames_[0]->error->uncertainty = 3e-11;
  show_frames();
  EXPECT_TRUE(has_label("± 3e−11 m"));
}

TEST_F(ComparePanelTest, ChangesTheChosenMethod) {
  QSignalSpy changed(&panel_, &ComparePanel::methodChanged);
  table()->selectRow(2);
  EXPECT_EQ(box("RK4")->currentText(), "RK4");
  choose("Velocity Verlet");
  ASSERT_EQ(changed.size(), 1);
  Method expected = preset_.compare[1];
  expected.integrator = IntegratorId::kVelocityVerlet;
  EXPECT_EQ(changed[0][0].value<Method>(), expected);
  EXPECT_EQ(changed[0][1].value<std::size_t>(), 2U);
}

TEST_F(ComparePanelTest, TheSliderSetsTheStepOfOneOrOfAll) {
  using Runs = std::vector<std::size_t>;
  QSignalSpy changed(&panel_, &ComparePanel::stepChanged);
  auto* slider = panel_.findChild<QSlider*>();
  table()->selectRow(1);
  slider->setValue(200);  // two decades above 0.1 ms
  ASSERT_TRUE(changed.wait(2000));
  ASSERT_EQ(changed.size(), 1);
  EXPECT_EQ(changed[0][0].value<double>(), 0.01);
  EXPECT_EQ(changed[0][1].value<Runs>(), Runs{1});
  panel_.findChild<QCheckBox*>()->setChecked(true);
  slider->setValue(230);
  ASSERT_TRUE(changed.wait(2000));
  ASSERT_EQ(changed.size(), 2);
  EXPECT_NEAR(changed[1][0].value<double>(), 0.02, 1e-17);
  EXPECT_EQ(changed[1][1].value<Runs>(), (Runs{0, 1, 2}));
  EXPECT_EQ(changed[0][2], changed[1][2]) << "no drag began";
}

TEST_F(ComparePanelTest, TheFirstMethodStaysAndSixAreEnough) {
  const auto button = [this](const QString& tip) {
    for (auto* b : panel_.findChildren<QToolButton*>()) {
      if (b->toolTip().startsWith(tip)) return b;
    }
    return static_cast<QToolButton*>(nullptr);
  };
  table()->selectRow(0);
  EXPECT_FALSE(button("Removes the chosen")->isEnabled());
  table()->selectRow(1);
  EXPECT_TRUE(button("Removes the chosen")->isEnabled());
  EXPECT_TRUE(button("One more")->isEnabled());
  preset_.compare.resize(kMostCompared);
  panel_.set_scene(preset_, ReferenceId::kNone);
  EXPECT_FALSE(button("One more")->isEnabled());
}

// In every plot a curve of each run, in the run's colour; the legend hides a run in all of them.
TEST(PlotsOfSeveralRuns, HaveACurveOfEach) {
  PlotPanel panel(light_theme());
  Preset preset = head_on_scene();
  std::vector<PlottedRun> runs;
  for (const char* name : {"one", "two"}) {
    auto recorder = std::make_shared<Recorder>();
    recorder->add(run_to(preset, 1.0, panel.curves()));
    runs.push_back({recorder, name});
    preset.scene.bodies[0].velocity.x() = 2.0;
  }
  panel.resize(420, 600);
  panel.show();
  panel.update_from(runs);
  QApplication::processEvents();
  const RunPlot* plot = panel.plots().front();
  const QwtPlotItemList items = plot->plot()->itemList(QwtPlotItem::Rtti_PlotCurve);
  ASSERT_EQ(items.size(), 6) << "kinetic, potential and total of both";
  std::vector<double> widths;  // px, of the second run
  for (const QwtPlotItem* item : items) {
    const auto* curve = static_cast<const QwtPlotCurve*>(item);
    EXPECT_GT(curve->dataSize(), 2U);
    if (curve->pen().color() == light_theme().series[1]) widths.push_back(curve->pen().widthF());
  }
  std::sort(widths.begin(), widths.end());
  ASSERT_EQ(widths.size(), 3U);
  EXPECT_LT(widths[1], widths[2]) << "the total; the others are thinner";
  ASSERT_GE(plot->legend().size(), 2U);
  EXPECT_EQ(plot->legend()[1].first, "two");

  const auto buttons = panel.findChildren<LegendButton*>();
  const auto second =
      std::find_if(buttons.begin(), buttons.end(), [](const auto* b) { return b->text() == "two"; });
  ASSERT_NE(second, buttons.end());
  (*second)->click();
  QApplication::processEvents();
  int visible = 0;
  for (const QwtPlotItem* item : items) visible += item->isVisible() ? 1 : 0;
  EXPECT_EQ(visible, 3);
  EXPECT_EQ(plot->legend()[1].first, "kinetic");
}

TEST(OtherRuns, AreOutlinesWithTheirDistance) {
  const auto frame = frame_of(Simulation(setup_of(two_discs())));
  auto beside = frame_of(Simulation(setup_of(two_discs())));
  beside->state.q(0, 1) += 0.5;
  const OtherRuns others = {beside};
  Camera camera;
  camera.center = Vec2(2.0, 1.0);
  camera.scale = 100.0;
  const DrawingOptions options;
  const auto draw = [&](const OtherRuns& which) {
    return make_drawing({*frame, {}, camera, options, light_theme(), ArrowScale{0.1, 0.5}, which});
  };
  const Drawing alone = draw({});
  const Drawing both = draw(others);
  ASSERT_EQ(both.discs.size(), alone.discs.size() + 2);
  EXPECT_EQ(both.boxes.size(), alone.boxes.size()) << "what never moves is there once";
  const auto& outline = both.discs[alone.discs.size()];
  EXPECT_EQ(outline.fill.alpha(), 0);
  EXPECT_EQ(outline.line, light_theme().series[1]);
  ASSERT_EQ(both.segments.size(), alone.segments.size() + 1);
  ASSERT_EQ(both.labels.size(), alone.labels.size() + 1);
  EXPECT_TRUE(std::any_of(both.labels.begin(), both.labels.end(),
                          [](const auto& l) { return l.text == "0.5 m" || l.text == "0.500 m"; }));
}

}  // namespace
}  // namespace carom
