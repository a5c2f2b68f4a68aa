#include <QApplication>
#include <QLabel>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <numbers>
#include <qwt_axis.h>
#include <qwt_plot.h>
#include <qwt_scale_draw.h>
#include <qwt_text.h>

#include "tests/support/run_fixture.h"
#include "tests/widgets/plot/plot_panel_fixture.h"
#include "widgets/plot/plot_content.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/plot/reading_table.h"
#include "widgets/plot/run_plot.h"
#include "widgets/theme/theme.h"

// Plots show the units of the inspector, and keep SI.
namespace carom {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;  // rad

class PlotUnitsTest : public PlotPanelFixture {
 protected:
  // A turns by 2 rad/s.
  void show(const std::vector<Plot>& plots) {
    Preset preset = head_on_scene();
    preset.scene.bodies[0].spin = 2.0;
    panel.set_plots(plots, preset.scene.bodies);
    PlotPanelFixture::show(run_to(preset, 1.0, panel.curves()));
  }
  [[nodiscard]] RunPlot* plot(int index) const { return panel.plots()[static_cast<std::size_t>(index)]; }
  [[nodiscard]] QList<double> ticks(int index, int axis) const {
    return plot(index)->plot()->axisScaleDiv(axis).ticks(QwtScaleDiv::MajorTick);
  }
  [[nodiscard]] QString label(int index, int axis, double at) const {
    return plot(index)->plot()->axisScaleDraw(axis)->label(at).text();
  }
  [[nodiscard]] const QLabel* readout_label(int index) const {
    for (const QLabel* chip : plot(index)->findChildren<QLabel*>("chip")) {
      if (chip->isVisible() && !chip->text().startsWith("zoomed")) return chip;
    }
    return nullptr;
  }
  [[nodiscard]] QString readout(int index) const {
    const QLabel* label = readout_label(index);
    return label == nullptr ? QString() : label->text();
  }

  static Plot plot_of(const char* observable) {
    QuantityName quantity;
    quantity.observable = observable;
    quantity.bodies = {"A"};
    Plot plot;
    plot.y = {quantity};
    return plot;
  }

  Plot angle = plot_of("angle");
  Plot spin = plot_of("spin");
};

TEST_F(PlotUnitsTest, AnglesAreInDegrees) {
  angle.y.front().theory = "2*t";
  Plot over = spin;
  over.x = QuantityName{"angle", {"A"}};
  show({angle, spin, over});
  EXPECT_EQ(plot(0)->content().unit.name, "°");
  EXPECT_EQ(plot(1)->content().unit.name, "rad/s");
  EXPECT_NEAR(recorder->series(*plot(0)->content().lines[0].curve)->at(1.0)->value[0], 2.0, 1e-9) << "in SI";
  for (const auto& [index, axis] : {std::pair(0, int(QwtAxis::YLeft)), std::pair(2, int(QwtAxis::XBottom))}) {
    ASSERT_GE(ticks(index, axis).size(), 2);
    for (const double at : ticks(index, axis)) {
      EXPECT_NEAR(std::remainder(at / kDegree, 10.0), 0.0, 1e-9) << "round in degrees";
      const QString text = label(index, axis, at);
      EXPECT_EQ(text.chopped(text.endsWith("°") ? 1 : 0).toInt(), std::lround(at / kDegree));
    }
    EXPECT_GE(ticks(index, axis).back(), 100.0 * kDegree);
  }
  EXPECT_TRUE(label(2, QwtAxis::XBottom, ticks(2, QwtAxis::XBottom).back()).endsWith("°"));
  plot(0)->set_cursor(0.1);
  EXPECT_TRUE(readout(0).endsWith("11.46 (theory 11.46)°")) << readout(0).toStdString();

  ReadingTable table;
  table.update_from({{recorder, "run"}}, panel.contents(), {0.1, 0.6, 0.0, 1.0});
  const auto text = [&](int row, int column) { return table.model()->index(row, column).data().toString(); };
  EXPECT_EQ(text(1, 0), "Angle of A / °");
  EXPECT_EQ(text(1, 1), "11.46");
  EXPECT_EQ(text(1, 3), "57.30");
  EXPECT_EQ(text(1, 4), "115") << "° in a second";
  EXPECT_EQ(text(1, 6), "40.1") << "mean";
  EXPECT_EQ(text(2, 0), "Spin of A / rad/s");
  EXPECT_EQ(text(2, 1), "2.000");
}

// One axis for several units has SI.
TEST_F(PlotUnitsTest, AMixedPlotIsInSi) {
  angle.y.push_back({"spin", {"A"}});
  show({angle});
  const PlotContent& content = plot(0)->content();
  EXPECT_EQ(content.legend(content.lines[0]), "angle of A / rad");
  EXPECT_LT(plot(0)->value_range().maxValue(), 5.0);
  plot(0)->set_cursor(0.1);
  EXPECT_TRUE(readout(0).contains("angle of A 0.2000 rad")) << readout(0).toStdString();
}

// Where its values don't fit into one line they stand below each other, beside the cursor and not over it.
TEST_F(PlotUnitsTest, ANarrowPlotReadsOutLineByLine) {
  angle.y.push_back({"spin", {"A"}});
  angle.y.push_back({"speed", {"A"}});
  show({angle});
  panel.resize(300, 400);
  for (const double time : {0.1, 0.9}) {
    plot(0)->set_cursor(time);
    QApplication::processEvents();
    EXPECT_EQ(readout(0).split('\n').size(), 4) << readout(0).toStdString();
    EXPECT_FALSE(readout(0).contains(QChar(0x2026))) << readout(0).toStdString();
    const int cursor = qRound(plot(0)->plot()->transform(QwtAxis::XBottom, time));
    EXPECT_EQ(readout_label(0)->geometry().center().x() > cursor, time < 0.5);
  }
}

}  // namespace
}  // namespace carom
