#include "widgets/plot/distribution.h"

#include <QApplication>
#include <QLabel>
#include <QMouseEvent>
#include <QTest>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numeric>
#include <qwt_plot.h>

#include "physics/preset/preset.h"
#include "tests/support/run_fixture.h"
#include "widgets/plot/legend_button.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/plot/run_plot.h"

namespace carom {
namespace {

// Forty discs of two masses that fly apart, and two that collide.
Preset crowd() {
  Preset preset = head_on_scene();
  for (int i = 0; i < 40; ++i) {
    Body body = disc(fmt::format("d{}", i), {10.0 + i, 5.0}, {0.0, 0.05 * (i + 1)}, i % 2 == 0 ? 1.0 : 4.0);
    preset.scene.bodies.push_back(body);
  }
  return preset;
}

class DistributionPlot : public testing::Test {
 protected:
  DistributionPlot() {
    panel.set_plots({named("speeds"), named("impulses"), named("energy")}, preset.scene.bodies);
    recorder->add(run_to(preset, 1.0, panel.curves()));
    panel.resize(500, 700);
    panel.show();
    show();
  }
  void show() {
    panel.update_from({{recorder, "run"}});
    QApplication::processEvents();
  }
  [[nodiscard]] RunPlot* plot(std::size_t i) const { return panel.plots()[i]; }
  [[nodiscard]] static std::int64_t sum(const Histogram& h) {
    return std::accumulate(h.counts.begin(), h.counts.end(), std::int64_t{0});
  }

  Preset preset = crowd();
  std::shared_ptr<Recorder> recorder = std::make_shared<Recorder>();
  PlotPanel panel{light_theme()};
};

TEST_F(DistributionPlot, CountsEveryMovingBodyNowAndAllOverTheTimeShown) {
  const std::vector<ShownBins> bins = plot(0)->distribution()->bins();
  ASSERT_EQ(bins.size(), 2u);
  EXPECT_EQ(sum(bins[0].bins), 42);
  const auto moments = static_cast<std::int64_t>(recorder->speeds().moments().size());
  EXPECT_EQ(moments, 201);  // of 1 s in steps of 5 ms, with the start
  EXPECT_EQ(sum(bins[1].bins), 42 * moments);
  EXPECT_GT(bins[0].law.thermal_energy(), 0.0);
  EXPECT_EQ(plot(0)->legend().size(), 3u);
  EXPECT_FALSE(plot(0)->over_time());
  EXPECT_GE(plot(0)->axes().x().maxValue(), 2.0);
  EXPECT_EQ(plot(0)->axes().x().minValue(), 0.0);
}

TEST_F(DistributionPlot, ItsMeanIsOverTheTimeThatIsShown) {
  emit plot(2)->boxAsked(QRectF(QPointF(0.5, 0.0), QPointF(0.75, 1.0)));
  QApplication::processEvents();
  const std::vector<ShownBins> bins = plot(0)->distribution()->bins();
  EXPECT_NEAR(static_cast<double>(sum(bins[1].bins)), 42.0 * 51.0, 42.0);
  EXPECT_EQ(sum(plot(1)->distribution()->bins()[0].bins), 0);  // the impact was at 0.2 s
  panel.reset_zoom();
  QApplication::processEvents();
  EXPECT_EQ(sum(plot(1)->distribution()->bins()[0].bins), 1);
}

TEST_F(DistributionPlot, BinsStandStillFromFrameToFrame) {
  const double width = plot(0)->distribution()->bins()[0].bins.width;
  for (const double time : {1.1, 1.2, 1.3}) {
    recorder->add(run_to(preset, time, panel.curves()));
    show();
    EXPECT_EQ(plot(0)->distribution()->bins()[0].bins.width, width);
  }
}

TEST_F(DistributionPlot, ShowsValuesUnderTheMouse) {
  const QString text = plot(0)->distribution()->readout(0.01);
  EXPECT_TRUE(text.contains("of 42 bodies, by Maxwell ")) << text.toStdString();
  EXPECT_TRUE(plot(0)->distribution()->readout(1e6).isEmpty());
  EXPECT_TRUE(plot(0)->distribution()->readout(-1.0).isEmpty());
}

TEST_F(DistributionPlot, EachPartCanBeHidden) {
  const QImage all = plot(0)->plot()->grab().toImage();
  for (auto* button : plot(0)->findChildren<LegendButton*>()) {
    if (button->text() == "Maxwell") button->click();
  }
  QApplication::processEvents();
  EXPECT_EQ(plot(0)->legend().size(), 2u);
  EXPECT_NE(plot(0)->plot()->grab().toImage(), all);
}

// Before anything moves, and without any bodies.
TEST(Distribution, OfNothingIsEmpty) {
  PlotPanel panel(light_theme());
  panel.set_plots({named("speeds"), named("impulses")}, {});
  panel.resize(400, 400);
  panel.show();
  QApplication::processEvents();
  const auto recorder = std::make_shared<Recorder>();
  Preset still;
  still.scene.bodies = {disc("A", {0.0, 0.0}, {0.0, 0.0}, 1.0)};
  recorder->add(run_to(still, 0.0));
  panel.update_from({{recorder, "run"}});
  QApplication::processEvents();
  const std::vector<ShownBins> bins = panel.plots()[0]->distribution()->bins();
  EXPECT_EQ(bins[0].bins.counts, std::vector<std::int64_t>{1});
  EXPECT_EQ(bins[0].law.thermal_energy(), 0.0);
  EXPECT_TRUE(panel.plots()[1]->distribution()->bins()[0].bins.counts.empty());
}

// --- the zoom box

void drag(QWidget* canvas, const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers) {
  QTest::mousePress(canvas, Qt::LeftButton, modifiers, from);
  for (const double share : {0.3, 0.7, 1.0}) {
    const QPointF at = QPointF(from) + share * QPointF(to - from);
    QMouseEvent move(QEvent::MouseMove, at, canvas->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, modifiers);
    QApplication::sendEvent(canvas, &move);
  }
  QTest::mouseRelease(canvas, Qt::LeftButton, modifiers, to);
  QApplication::processEvents();
}

class ZoomBoxTest : public DistributionPlot {
 protected:
  [[nodiscard]] QPointF value_at(std::size_t i, const QPoint& pixel) const {
    return {plot(i)->plot()->invTransform(QwtAxis::XBottom, pixel.x()),
            plot(i)->plot()->invTransform(QwtAxis::YLeft, pixel.y())};
  }
  [[nodiscard]] bool chip(std::size_t i) const {
    for (const auto* label : plot(i)->findChildren<QLabel*>()) {
      if (label->text().startsWith("zoomed") && label->isVisible()) return true;
    }
    return false;
  }
};

TEST_F(ZoomBoxTest, ShowsWhatTheBoxHolds) {
  QWidget* canvas = plot(2)->plot()->canvas();
  const QPoint a(100, 20);
  const QPoint b(220, 70);
  const QPointF low = value_at(2, {a.x(), b.y()});
  const QPointF high = value_at(2, {b.x(), a.y()});
  drag(canvas, a, b, Qt::ControlModifier);
  EXPECT_NEAR(plot(2)->time_range().minValue(), low.x(), 1e-9);
  EXPECT_NEAR(plot(2)->time_range().maxValue(), high.x(), 1e-9);
  EXPECT_NEAR(plot(2)->value_range().minValue(), low.y(), 1e-9);
  EXPECT_NEAR(plot(2)->value_range().maxValue(), high.y(), 1e-9);
  EXPECT_TRUE(panel.zoomed());
  EXPECT_TRUE(chip(2));
  EXPECT_FALSE(panel.marks().a.has_value());  // a drag is no click
  QTest::mouseDClick(canvas, Qt::LeftButton, Qt::NoModifier, a);
  QApplication::processEvents();
  EXPECT_FALSE(panel.zoomed());
  EXPECT_FALSE(chip(2));
  EXPECT_EQ(plot(2)->time_range(), QwtInterval(0.0, 1.0));
}

TEST_F(ZoomBoxTest, AFlatOneKeepsTheHeightAndANarrowOneTheWidth) {
  QWidget* canvas = plot(2)->plot()->canvas();
  const QwtInterval values = plot(2)->value_range();
  const double from = value_at(2, {100, 30}).x();
  drag(canvas, {100, 30}, {220, 33}, Qt::ControlModifier);
  EXPECT_NEAR(plot(2)->time_range().minValue(), from, 1e-9);
  EXPECT_NEAR(plot(2)->value_range().width(), values.width(), 0.05 * values.width());
  panel.reset_zoom();
  QApplication::processEvents();
  drag(canvas, {100, 30}, {102, 80}, Qt::ControlModifier);
  EXPECT_NEAR(plot(2)->time_range().width(), 1.0, 0.02);
  EXPECT_LT(plot(2)->value_range().width(), 0.8 * values.width());
  panel.reset_zoom();
  QApplication::processEvents();
  drag(canvas, {100, 30}, {103, 32}, Qt::ControlModifier);
  EXPECT_FALSE(panel.zoomed());
}

TEST_F(ZoomBoxTest, EscapeLetsGoOfIt) {
  QWidget* canvas = plot(2)->plot()->canvas();
  QTest::mousePress(canvas, Qt::LeftButton, Qt::ControlModifier, {100, 20});
  QMouseEvent move(QEvent::MouseMove, QPointF(200, 60), canvas->mapToGlobal(QPointF(200, 60)), Qt::NoButton,
                   Qt::LeftButton, Qt::ControlModifier);
  QApplication::sendEvent(canvas, &move);
  QTest::keyClick(canvas, Qt::Key_Escape);
  QTest::mouseRelease(canvas, Qt::LeftButton, Qt::ControlModifier, {200, 60});
  EXPECT_FALSE(panel.zoomed());
}

TEST_F(ZoomBoxTest, APlainDragStillMoves) {
  drag(plot(2)->plot()->canvas(), {100, 30}, {160, 30}, Qt::NoModifier);
  EXPECT_NEAR(plot(2)->time_range().width(), 1.0, 1e-9);
  EXPECT_LT(plot(2)->time_range().minValue(), 0.0);
}

// The histogram's own axes.
TEST_F(ZoomBoxTest, OfAHistogramStaysWithIt) {
  const QPointF low = value_at(0, {60, 70});
  drag(plot(0)->plot()->canvas(), {60, 70}, {160, 20}, Qt::ControlModifier);
  EXPECT_NEAR(plot(0)->axes().x().minValue(), low.x(), 1e-9);
  EXPECT_EQ(plot(2)->time_range(), QwtInterval(0.0, 1.0));
  EXPECT_TRUE(chip(0));
}

}  // namespace
}  // namespace carom
