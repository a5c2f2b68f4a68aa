#include <QApplication>
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <qwt_plot.h>
#include <qwt_scale_map.h>

#include "physics/preset/preset.h"
#include "physics/scene/validate.h"
#include "tests/support/run_fixture.h"
#include "widgets/plot/curve_row.h"
#include "widgets/plot/legend_button.h"
#include "widgets/plot/plot_content.h"
#include "widgets/plot/plot_dialog.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/plot/run_plot.h"
#include "widgets/plot/theory_curve.h"

namespace carom {
namespace {

// A canvas of 100 by 100 px that shows 0 to 1 and -2 to 2.
struct Canvas {
  QwtScaleMap x, y;
  QRectF area{0.0, 0.0, 100.0, 100.0};
  Canvas() {
    x.setPaintInterval(0.0, 100.0);
    x.setScaleInterval(0.0, 1.0);
    y.setPaintInterval(100.0, 0.0);
    y.setScaleInterval(-2.0, 2.0);
  }
  [[nodiscard]] std::vector<QPolygonF> pieces(const char* formula) const {
    return TheoryCurve(Expression(formula, true), true, false).pieces(x, y, area);
  }
};

TEST(TheoryCurve, PassesThroughItsValuesAtEachPixel) {
  const Canvas canvas;
  const std::vector<QPolygonF> pieces = canvas.pieces("sin(6*x)");
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_GE(pieces[0].size(), 101);
  for (const QPointF& p : pieces[0]) {
    EXPECT_NEAR(canvas.y.invTransform(p.y()), std::sin(6.0 * canvas.x.invTransform(p.x())), 1e-12);
  }
}

TEST(TheoryCurve, IsVerticalWhereItJumps) {
  const std::vector<QPolygonF> pieces = Canvas().pieces("x < 0.3333 ? -1 : 1");
  ASSERT_EQ(pieces.size(), 1u);
  double across = 100.0;  // px
  for (int i = 1; i < pieces[0].size(); ++i) {
    if (std::abs(pieces[0][i].y() - pieces[0][i - 1].y()) < 1.0) continue;
    across = pieces[0][i].x() - pieces[0][i - 1].x();
    EXPECT_NEAR(pieces[0][i].x(), 33.33, 0.02);
  }
  EXPECT_LT(across, 0.02);
}

TEST(TheoryCurve, IsBrokenAtAPoleAndWhereItHasNoValue) {
  const Canvas canvas;
  EXPECT_EQ(canvas.pieces("1/(x - 0.5004)").size(), 2u);
  EXPECT_EQ(canvas.pieces("1/(x - 0.5)").size(), 2u);  // on a pixel
  const std::vector<QPolygonF> root = canvas.pieces("sqrt(x - 0.253)");
  ASSERT_EQ(root.size(), 1u);
  EXPECT_NEAR(root[0].front().x(), 25.3, 0.02);
  EXPECT_EQ(canvas.pieces("ln(0.25 - abs(x - 0.5))").size(), 1u);
  EXPECT_TRUE(canvas.pieces("sqrt(-1 - x)").empty());
}

// Even a wildly oscillating form is cheap to draw.
TEST(TheoryCurve, DoesNotLookForEver) {
  std::size_t points = 0;
  for (const QPolygonF& piece : Canvas().pieces("sin(1e9*x)")) points += static_cast<std::size_t>(piece.size());
  EXPECT_LT(points, 50'000u);
  EXPECT_GT(points, 100u);
}

class PlotTheory : public testing::Test {
 protected:
  PlotTheory() {
    panel.set_plots({plot}, preset.scene.bodies);
    panel.resize(500, 300);
    panel.show();
    recorder->add(run_to(preset, 1.0, panel.curves()));
    panel.update_from({{recorder, "run"}});
    QApplication::processEvents();
  }
  static Plot plot_of(bool residual) {
    Plot p;
    p.y = {{"x", {"A"}, "t < 0.2 ? -1 + 3*t : -0.4 - (t - 0.2)", residual}};
    return p;
  }
  [[nodiscard]] static QStringList legend(RunPlot* of) {
    QStringList names;
    for (const auto& entry : of->legend()) names << entry.first;
    return names;
  }

  Preset preset = head_on_scene();
  Plot plot = plot_of(false);
  std::shared_ptr<Recorder> recorder = std::make_shared<Recorder>();
  PlotPanel panel{light_theme()};
};

TEST_F(PlotTheory, IsInTheLegendAndCanBeHidden) {
  EXPECT_EQ(legend(panel.plots()[0]), QStringList{"theory"});
  LegendButton* theory = nullptr;
  for (auto* button : panel.findChildren<LegendButton*>()) {
    if (button->text() == "theory") theory = button;
  }
  ASSERT_NE(theory, nullptr);
  EXPECT_TRUE(theory->toolTip().startsWith("t < 0.2 ?")) << theory->toolTip().toStdString();
  const QImage shown = panel.plots()[0]->plot()->grab().toImage();
  theory->click();
  QApplication::processEvents();
  EXPECT_TRUE(legend(panel.plots()[0]).isEmpty());
  // The theory is visible only beyond the record: make it differ.
  Plot other = plot;
  other.y[0].theory = "1";
  panel.replace(panel.plots()[0], other);
  QApplication::processEvents();
  EXPECT_NE(panel.plots()[0]->plot()->grab().toImage(), shown);
  EXPECT_GE(panel.plots()[0]->value_range().maxValue(), 0.0);
}

// So that nothing has to be guessed before the first run.
TEST_F(PlotTheory, IsWholeBeforeTheRunHasBegun) {
  const auto range_with = [this](const char* theory) {
    Plot other = plot;
    other.y[0].theory = theory;
    panel.set_plots({other}, preset.scene.bodies);
    recorder->clear();
    recorder->add(run_to(preset, 0.0, panel.curves()));
    panel.update_from({{recorder, "run"}});
    QApplication::processEvents();
    return panel.plots()[0]->value_range();
  };
  const QwtInterval wave = range_with("5*sin(20*t)");
  EXPECT_LE(wave.minValue(), -5.0);
  EXPECT_GE(wave.maxValue(), 5.0);
  EXPECT_LE(wave.width(), 20.0);
  const QwtInterval pole = range_with("1/(t - 0.4999)");
  EXPECT_LE(pole.width(), 200.0) << "not the whole of it";
  EXPECT_GE(pole.maxValue(), 10.0);
}

TEST_F(PlotTheory, IsShownUnderTheMouse) {
  panel.plots()[0]->set_cursor(0.1);
  bool told = false;
  for (const auto* label : panel.findChildren<QLabel*>()) {
    told = told || label->text().contains(QString::fromUtf8("−0.7000 (theory −0.7000)"));
  }
  EXPECT_TRUE(told);
}

TEST_F(PlotTheory, ResidualIsALineOfItsOwnWithEveryDigit) {
  const Plot residual = plot_of(true);
  panel.set_plots({residual}, preset.scene.bodies);
  ASSERT_EQ(panel.curves().size(), 1u);
  recorder->clear();
  recorder->add(run_to(preset, 1.0, panel.curves()));
  panel.update_from({{recorder, "run"}});
  QApplication::processEvents();
  const Series<1>* series = recorder->series(panel.curves()[0]);
  ASSERT_NE(series, nullptr);
  std::vector<SeriesPoint<1>> points;
  series->read(0.0, 1.0, points);
  EXPECT_GT(points.size(), 100u);
  for (const SeriesPoint<1>& p : points) EXPECT_LT(std::abs(p.value[0]), 1e-14) << p.at;
  EXPECT_EQ(panel.contents()[0].title, QString::fromUtf8("x of A − theory"));
  EXPECT_TRUE(legend(panel.plots()[0]).isEmpty());
  // Rounding is shown, not replaced by zero.
  EXPECT_LT(panel.plots()[0]->value_range().width(), 1e-12);
}

TEST_F(PlotTheory, OverAnotherQuantityFollowsTheRunWhereItHangsOnTime) {
  Plot over = plot;
  over.x = QuantityName{"x", {"B"}};
  over.y[0].theory = "-1 + 3*t + 0*x";
  panel.set_plots({over}, preset.scene.bodies);
  recorder->clear();
  recorder->add(run_to(preset, 0.5, panel.curves()));
  panel.update_from({{recorder, "run"}});
  QApplication::processEvents();
  EXPECT_EQ(legend(panel.plots()[0]), QStringList{"theory"});
}

TEST(PlotTheoryDialog, TakesATheoryAndSaysWhatIsWrong) {
  PlotDialog dialog(head_on_scene().scene.bodies);
  dialog.show();
  auto* ok = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
  auto* row = dialog.findChild<CurveRow*>();
  row->set_quantity({"x", {"A"}});
  auto* theory = row->findChild<QLineEdit*>("theory");
  auto* open = row->findChild<QToolButton*>();
  auto* residual = row->findChild<QCheckBox*>();
  EXPECT_FALSE(theory->isVisible());
  QTest::mouseClick(open, Qt::LeftButton);
  EXPECT_TRUE(theory->isVisible());
  QTest::keyClicks(theory, "2*exq(t)");
  EXPECT_FALSE(ok->isEnabled());
  bool told = false;
  for (const auto* label : dialog.findChildren<QLabel*>())
    told = told || label->text().contains("\"exq\" is not known");
  EXPECT_TRUE(told);
  theory->setText("2*exp(t)");
  EXPECT_TRUE(ok->isEnabled());
  EXPECT_EQ(dialog.plot().y, (std::vector<QuantityName>{{"x", {"A"}, "2*exp(t)", false}}));
  residual->click();
  EXPECT_EQ(dialog.plot().y, (std::vector<QuantityName>{{"x", {"A"}, "2*exp(t)", true}}));
  QTest::mouseClick(open, Qt::LeftButton);
  EXPECT_EQ(dialog.plot().y, (std::vector<QuantityName>{{"x", {"A"}}}));
  Plot wanted;
  wanted.y = {{"speed", {"B"}, "t", true}, {"time", {}}};
  wanted.notes = {{1.0, 2.0, "kept"}};
  dialog.set_plot(wanted);
  EXPECT_EQ(dialog.plot(), wanted);
}

}  // namespace
}  // namespace carom
