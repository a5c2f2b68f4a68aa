#include <QAction>
#include <QTest>
#include <algorithm>
#include <gtest/gtest.h>
#include <qwt_plot.h>
#include <qwt_plot_curve.h>
#include <qwt_text.h>

#include "app/lab/drawer.h"
#include "app/lab/lab_window.h"
#include "physics/preset/preset.h"
#include "tests/app/lab/lab_fixture.h"
#include "tests/support/wait_events.h"
#include "widgets/compare/compare_panel.h"
#include "widgets/compare/compare_table.h"
#include "widgets/plot/legend_button.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/plot/run_plot.h"

namespace carom {
namespace {

class LabCompareTest : public LabTest {
 protected:
  void SetUp() override {
    ASSERT_NO_FATAL_FAILURE(show("bouncing-ball"));
    window_.run_until(0.0);
  }
  QAction* usual() {
    for (QAction* a : window_.findChildren<QAction*>()) {
      if (a->shortcut() == QKeySequence(Qt::Key_C)) return a;
    }
    return nullptr;
  }
  [[nodiscard]] double cell(int row, const QString& header) const {
    const auto* table = window_.findChild<CompareTable*>();
    int column = 0;
    while (table->model()->headerData(column, Qt::Horizontal).toString() != header) ++column;
    const QString tip = table->model()->index(row, column).data(Qt::ToolTipRole).toString();
    return tip.section('\n', 0, 0).replace(QChar(0x2212), '-').toDouble();
  }
  [[nodiscard]] int rows() const { return window_.findChild<CompareTable*>()->model()->rowCount(); }
};

// One key starts the comparison, and the same key ends it.
TEST_F(LabCompareTest, OneKeyMakesEulerRk4AndTheExactRun) {
  const Method own = window_.preset().method;
  usual()->trigger();
  window_.run_until(1.0);
  ASSERT_TRUE(test::wait_in_event_loop([&] { return rows() == 3 && cell(2, "CPU, s/s") > 0.0; }));
  const Preset compared = window_.preset();
  EXPECT_EQ(compared.method.integrator, IntegratorId::kExactFlight);
  ASSERT_EQ(compared.compare.size(), 2U);
  EXPECT_EQ(compared.compare[0].integrator, IntegratorId::kExplicitEuler);
  EXPECT_EQ(compared.compare[1].integrator, IntegratorId::kRk4);
  EXPECT_EQ(compared.plots.back().id, "error");
  // Under gravity Euler is off by g h t/2 in flight; RK4 and exact flight only by rounding.
  EXPECT_GT(cell(1, "largest / m"), 1e-3);
  EXPECT_LT(cell(2, "largest / m"), 1e-12);
  EXPECT_EQ(window_.findChild<CompareTable*>()->model()->index(0, 1).data().toString(), "reference");
  usual()->trigger();
  EXPECT_EQ(window_.preset().method, own);
  EXPECT_TRUE(window_.preset().compare.empty());
}

// In the plots: each curve of each run has a line of its own, as plain as the main one.
TEST_F(LabCompareTest, NoTwoCurvesLookAlike) {
  usual()->trigger();
  window_.run_until(0.5);
  auto* plots = window_.findChild<PlotPanel*>();
  ASSERT_EQ(plots->runs().size(), 3U);
  RunPlot* energy = plots->plots().front();
  ASSERT_EQ(energy->content().plot.id, "energy");
  std::vector<QPen> pens;
  for (const QwtPlotItem* item : energy->plot()->itemList(QwtPlotItem::Rtti_PlotCurve)) {
    const auto* curve = static_cast<const QwtPlotCurve*>(item);
    const bool has_points = curve->isVisible() && curve->dataSize() > 0;
    const QString title = curve->title().text();
    if (has_points && (title == "kinetic" || title == "potential" || title == "total"))
      pens.push_back(curve->pen());
  }
  ASSERT_EQ(pens.size(), 9U);
  for (std::size_t i = 0; i < pens.size(); ++i) {
    const auto& series = light_theme().series;
    EXPECT_NE(std::find(series.begin(), series.end(), pens[i].color()), series.end()) << "not faded";
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_NE(pens[i], pens[k]);
      EXPECT_NE(pens[i].dashPattern(), pens[k].dashPattern()) << "colour is not the only cue";
    }
  }
  const auto legend = energy->legend();
  const auto pen = [&legend](const QString& name) {
    return std::find_if(legend.begin(), legend.end(), [&](const auto& each) { return each.first == name; })
        ->second;
  };
  EXPECT_NE(pen("kinetic").dashPattern(), pen("potential").dashPattern());
}

TEST_F(LabCompareTest, APresetOpensWithItsComparison) {
  ASSERT_TRUE(window_.open("drag-projectile"));
  EXPECT_TRUE(window_.findChild<Drawer*>()->shows(window_.findChild<ComparePanel*>()));
  window_.run_until(1.0);
  ASSERT_TRUE(test::wait_in_event_loop([&] { return rows() == 3 && cell(2, "largest / m") > 0.0; }));
  EXPECT_LT(cell(0, "largest / m"), 1e-8) << "RK4";
  EXPECT_GT(cell(1, "largest / m"), 1e-3) << "explicit Euler";
  EXPECT_GT(cell(2, "largest / m"), 1e-3) << "impacts at the step's end";
  ASSERT_TRUE(window_.open("head-on"));
  EXPECT_FALSE(window_.findChild<Drawer*>()->shows(window_.findChild<ComparePanel*>()));
  window_.findChild<Drawer*>()->choose(window_.findChild<ComparePanel*>());
  window_.run_until(0.1);
  EXPECT_TRUE(window_.preset().compare.empty());
  ASSERT_TRUE(test::wait_in_event_loop([&] { return rows() == 1; }));
}

// And back to the preset's own comparison.
TEST_F(LabCompareTest, TheSameKeyGoesBackToThePresetsOwnComparison) {
  ASSERT_TRUE(window_.open("drag-projectile"));
  const Preset own = window_.preset();
  usual()->trigger();
  EXPECT_NE(window_.preset().method, own.method);
  usual()->trigger();
  EXPECT_EQ(window_.preset().method, own.method);
  EXPECT_EQ(window_.preset().compare, own.compare);
}

// Removing a run keeps the records of the others; the last run stays visible.
TEST_F(LabCompareTest, TheOthersKeepTheirPast) {
  ASSERT_TRUE(window_.open("drag-projectile"));
  window_.run_until(1.0);
  auto* plots = window_.findChild<PlotPanel*>();
  const auto legend = plots->findChildren<LegendButton*>();
  const auto first =
      std::find_if(legend.begin(), legend.end(), [](const auto* b) { return b->text() == "RK4, located"; });
  ASSERT_NE(first, legend.end());
  (*first)->click();
  auto* panel = window_.findChild<ComparePanel*>();
  emit panel->methodRemoved(1);
  window_.run_until(1.2);
  ASSERT_EQ(plots->runs().size(), 2U);
  EXPECT_FALSE(plots->runs()[0].shown);
  const Curve energy{{find_observable("kinetic_energy"), {}}, std::nullopt};
  ASSERT_NE(plots->runs()[1].recorder->series(energy), nullptr);
  EXPECT_LE(plots->runs()[1].recorder->series(energy)->at(0.01)->at, 0.01);
  EXPECT_NE(plots->runs()[1].recorder->series(energy)->at(0.01), nullptr);
  emit panel->methodRemoved(1);
  window_.run_until(1.3);
  ASSERT_EQ(plots->runs().size(), 1U);
  EXPECT_TRUE(plots->runs()[0].shown);
}

TEST_F(LabCompareTest, MethodsComeAndGoWhileItRuns) {
  window_.run_until(0.5);
  auto* panel = window_.findChild<ComparePanel*>();
  window_.findChild<Drawer*>()->choose(panel);
  Method euler = window_.preset().method;
  euler.integrator = IntegratorId::kExplicitEuler;
  emit panel->methodAdded(euler);
  window_.run_until(1.0);
  ASSERT_TRUE(test::wait_in_event_loop([&] { return rows() == 2 && cell(1, "largest / m") > 1e-4; }));
  euler.step *= 0.5;
  emit panel->methodChanged(euler, 1);
  EXPECT_EQ(window_.preset().compare.front().step, euler.step);
  emit panel->methodRemoved(1);
  window_.run_until(1.1);
  ASSERT_TRUE(test::wait_in_event_loop([&] { return rows() == 1; }));
}

}  // namespace
}  // namespace carom
