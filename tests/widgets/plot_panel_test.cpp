#include "widgets/plot_panel.h"

#include <QApplication>
#include <QLabel>
#include <QMenu>
#include <QTest>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <qwt_plot.h>
#include <qwt_plot_curve.h>
#include <qwt_scale_widget.h>

#include "physics/preset/names.h"
#include "tests/widgets/run_fixture.h"
#include "widgets/legend_button.h"
#include "widgets/plot_table.h"
#include "widgets/theme.h"
#include "widgets/time_plot.h"

namespace carom {
namespace {

// Wheel notches towards the user are negative.
void wheel(QWidget* widget, const QPoint& at, int notches, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
  QWheelEvent event(at, widget->mapToGlobal(at), QPoint(), QPoint(0, 120 * notches), Qt::NoButton, modifiers,
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(widget, &event);
  QApplication::processEvents();
}

class PlotPanelTest : public testing::Test {
 protected:
  void show(const Frame& frame) {
    recorder.add(frame);
    panel.resize(400, 560);
    panel.show();
    QApplication::processEvents();
    panel.update_from(recorder);
    QApplication::processEvents();
  }
  [[nodiscard]] QWidget* canvas(int plot) const {
    return panel.plots()[static_cast<std::size_t>(plot)]->plot()->canvas();
  }
  [[nodiscard]] TimePlot* plot(int index) const { return panel.plots()[static_cast<std::size_t>(index)]; }
  [[nodiscard]] bool chip_shown(int index) const {
    const auto labels = plot(index)->findChildren<QLabel*>("chip");
    return std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
      return label->isVisible() && label->text().startsWith("zoomed");
    });
  }

  Recorder recorder;
  PlotPanel panel{light_theme()};
};

TEST_F(PlotPanelTest, StacksThePlotsAskedForOverOneAxis) {
  show(run_to(head_on_scene(), 0.45));
  ASSERT_EQ(panel.plots().size(), 3u);
  for (const TimePlot* each : panel.plots()) {
    EXPECT_EQ(each->time_range(), QwtInterval(0.0, 0.5));
    EXPECT_EQ(each->plot()->canvas()->mapTo(&panel, QPoint()).x(), canvas(0)->mapTo(&panel, QPoint()).x());
    EXPECT_EQ(each->plot()->canvas()->width(), canvas(0)->width());
  }
  EXPECT_EQ(plot(0)->value_range().minValue(), 0.0);
  EXPECT_GE(plot(0)->value_range().maxValue(), 4.5);

  panel.set_plots({"impulse", "energy", "unheard of"});
  ASSERT_EQ(panel.plots().size(), 2u);
  EXPECT_EQ(plot(0)->kind().id, "energy");
  EXPECT_EQ(plot(1)->kind().id, "impulse");
}

TEST_F(PlotPanelTest, TheUserChoosesPlots) {
  show(run_to(head_on_scene(), 0.45));
  const QList<QAction*> actions = panel.menu()->actions();
  ASSERT_EQ(actions.size(), static_cast<qsizetype>(plot_table().size()));
  const auto action = [&](const QString& id) {
    return *std::find_if(actions.begin(), actions.end(), [&](QAction* a) { return a->data() == id; });
  };
  EXPECT_FALSE(action("drift")->isChecked());
  action("drift")->trigger();
  ASSERT_EQ(panel.plots().size(), 4u);
  EXPECT_EQ(plot(3)->kind().id, "drift");
  action("ledger")->trigger();
  EXPECT_EQ(plot(3)->kind().id, "ledger") << "at its place";
  EXPECT_TRUE(action("ledger")->isChecked());
  for (const char* id : {"energy", "ledger", "drift", "momentum"}) action(id)->trigger();
  ASSERT_EQ(panel.plots().size(), 1u);
  EXPECT_TRUE(panel.shows("impulse"));
  EXPECT_FALSE(action("impulse")->isEnabled()) << "the last one stays";
  panel.set_plots({"drift"});
  EXPECT_TRUE(action("drift")->isChecked());
  EXPECT_FALSE(action("impulse")->isChecked());
}

TEST_F(PlotPanelTest, NamesOfPresetFilesAreThePlots) {
  ASSERT_EQ(plot_table().size(), kPlotNames.size());
  for (std::size_t i = 0; i < kPlotNames.size(); ++i) EXPECT_EQ(plot_table()[i].id, kPlotNames[i]);
}

// 1e-6 kg in millimetres: 1e-11 J and 1e-9 N s.
TEST_F(PlotPanelTest, ASmallSceneIsNoNoise) {
  Scene scene = head_on_scene();
  for (Body& body : scene.bodies) {
    body.shape = Disc{0.2e-3};
    body.position *= 1e-3;
    body.velocity *= 1e-3;
    *body.mass *= 1e-6;
  }
  show(run_to(scene, 0.45));
  EXPECT_NEAR(plot(0)->value_range().maxValue(), 5e-12, 1e-12);
  EXPECT_NEAR(plot(1)->value_range().maxValue(), 3e-9, 1.1e-9);
  EXPECT_NEAR(plot(2)->value_range().maxValue(), 4e-9, 1.1e-9);
}

TEST_F(PlotPanelTest, AConservedZeroIsAFlatLine) {
  Scene scene = head_on_scene();
  scene.bodies[0].velocity = Vec2(1.0, 0.7);
  scene.bodies[1].velocity = Vec2(-0.5, -0.35);  // no momentum in sum
  Frame frame = run_to(scene, 1.0);
  for (std::size_t i = 0; i < frame.samples.size(); ++i) {
    frame.samples[i].totals.momentum = Vec2(1e-16 * static_cast<double>(i % 7), -1e-16);
  }
  show(frame);
  EXPECT_GT(plot(1)->value_range().maxValue(), 1.0);
  EXPECT_LT(plot(1)->value_range().maxValue(), 10.0);
}

TEST_F(PlotPanelTest, ADriftHasAScaleOfItsOwn) {
  Frame frame = run_to(head_on_scene(), 1.0);
  for (std::size_t i = 0; i < frame.samples.size(); ++i) {
    frame.samples[i].drift = -1e-12 * static_cast<double>(i) / static_cast<double>(frame.samples.size());
  }
  panel.set_plots({"drift"});
  show(frame);
  EXPECT_LE(plot(0)->value_range().minValue(), -1e-12);
  EXPECT_GT(plot(0)->value_range().minValue(), -3e-12);
  for (Sample& sample : frame.samples) sample.drift = 1e-17;
  frame.run = 2;
  recorder.add(frame);
  panel.update_from(recorder);
  QApplication::processEvents();
  EXPECT_NEAR(plot(0)->value_range().maxValue(), 5e-15, 1e-16) << "rounding of 4.5 J";
}

TEST_F(PlotPanelTest, LegendHidesAndShowsACurve) {
  show(run_to(head_on_scene(), 0.5));
  const auto buttons = plot(0)->findChildren<LegendButton*>();
  ASSERT_EQ(buttons.size(), 3);
  const auto shown = [this](const QString& title) {
    for (const QwtPlotItem* item : plot(0)->plot()->itemList(QwtPlotItem::Rtti_PlotCurve)) {
      if (item->title().text() == title) return item->isVisible();
    }
    ADD_FAILURE() << "no curve " << title.toStdString();
    return false;
  };
  ASSERT_EQ(buttons[0]->text(), "kinetic");
  QTest::mouseClick(buttons[0], Qt::LeftButton);
  EXPECT_FALSE(shown("kinetic"));
  EXPECT_TRUE(shown("potential"));
  EXPECT_TRUE(shown("total"));
  QTest::mouseClick(buttons[0], Qt::LeftButton);
  EXPECT_TRUE(shown("kinetic"));
}

TEST_F(PlotPanelTest, WheelZoomsAllTimeAxesAboutTheCursorAndDoubleClickResets) {
  show(run_to(head_on_scene(), 1.0));
  const QPoint at(canvas(1)->width() / 4, canvas(1)->height() / 2);
  const double under = plot(1)->plot()->invTransform(QwtAxis::XBottom, at.x());
  wheel(canvas(1), at, 2);
  EXPECT_TRUE(panel.zoomed());
  const QwtInterval zoomed = plot(0)->time_range();
  EXPECT_NEAR(zoomed.width(), 0.64, 1e-12);
  for (const TimePlot* each : panel.plots()) EXPECT_EQ(each->time_range(), zoomed);
  // Labels that need more room may have moved the canvas by a few pixels.
  EXPECT_NEAR(plot(1)->plot()->transform(QwtAxis::XBottom, under), at.x(), 8.0);
  EXPECT_FALSE(chip_shown(0));
  EXPECT_TRUE(chip_shown(1));

  // While zoomed, new data leave the axes alone.
  Frame later = run_to(head_on_scene(), 5.0);
  later.run = 2;
  recorder.add(later);
  panel.update_from(recorder);
  QApplication::processEvents();
  EXPECT_EQ(plot(0)->time_range(), zoomed);

  QTest::mouseDClick(canvas(2), Qt::LeftButton);
  QApplication::processEvents();
  EXPECT_FALSE(panel.zoomed());
  EXPECT_FALSE(chip_shown(1));
  for (const TimePlot* each : panel.plots()) EXPECT_EQ(each->time_range(), QwtInterval(0.0, 5.0));
}

TEST_F(PlotPanelTest, CtrlWheelZoomsTheValuesOfOnePlotAndHomeResets) {
  show(run_to(head_on_scene(), 1.0));
  const QwtInterval energy = plot(0)->value_range();
  const QwtInterval momentum = plot(1)->value_range();
  wheel(canvas(0), {50, 20}, 1, Qt::ControlModifier);
  EXPECT_NEAR(plot(0)->value_range().width(), 0.8 * energy.width(), 1e-12);
  EXPECT_EQ(plot(1)->value_range(), momentum);
  EXPECT_EQ(plot(0)->time_range(), QwtInterval(0.0, 1.0));
  QTest::keyClick(canvas(0), Qt::Key_Home);
  QApplication::processEvents();
  EXPECT_FALSE(panel.zoomed());
  EXPECT_EQ(plot(0)->value_range(), energy);
}

TEST_F(PlotPanelTest, DragMovesTimeOfAllAndValuesOfOne) {
  show(run_to(head_on_scene(), 1.0));
  const QwtInterval momentum = plot(1)->value_range();
  QTest::mousePress(canvas(0), Qt::LeftButton, Qt::NoModifier, {100, 50});
  QTest::mouseMove(canvas(0), {101, 50});
  QApplication::processEvents();
  EXPECT_FALSE(panel.zoomed());
  QMouseEvent move(QEvent::MouseMove, QPointF(60, 50), canvas(0)->mapToGlobal(QPointF(60, 50)), Qt::NoButton,
                   Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(canvas(0), &move);
  QTest::mouseRelease(canvas(0), Qt::LeftButton, Qt::NoModifier, {60, 50});
  QApplication::processEvents();
  EXPECT_GT(plot(2)->time_range().minValue(), 0.05);
  EXPECT_NEAR(plot(2)->time_range().width(), 1.0, 1e-12);
  EXPECT_EQ(plot(1)->value_range(), momentum);
}

TEST_F(PlotPanelTest, ConstantDataHaveARange) {
  Scene scene;
  scene.bodies = {disc("A", {0.0, 0.0}, {0.1, 0.0}, 3.0)};
  show(run_to(scene, 1.0));
  const QwtInterval energy = plot(0)->value_range();
  EXPECT_TRUE(std::isfinite(energy.width()));
  EXPECT_LE(energy.minValue(), 0.0);
  EXPECT_GT(energy.maxValue(), 0.015);
  EXPECT_LT(energy.maxValue(), 0.05);
  EXPECT_EQ(plot(2)->value_range(), QwtInterval(-1.0, 1.0));  // no impacts
}

TEST_F(PlotPanelTest, HiddenItDoesNothing) {
  recorder.add(run_to(head_on_scene(), 2.0));
  panel.update_from(recorder);
  QApplication::processEvents();
  EXPECT_EQ(plot(0)->time_range(), QwtInterval(0.0, 1.0));
  panel.show();
  QApplication::processEvents();
  EXPECT_EQ(plot(0)->time_range(), QwtInterval(0.0, 2.0));
}

}  // namespace
}  // namespace carom
