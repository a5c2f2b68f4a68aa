#include "widgets/plot/plot_before.h"

#include <QApplication>
#include <algorithm>
#include <gtest/gtest.h>
#include <qwt_plot.h>
#include <qwt_plot_curve.h>

#include "tests/support/run_fixture.h"
#include "widgets/plot/plot_panel.h"

namespace carom {
namespace {

// A run to 0.2 s beside a run before of 0.45 s.
class PlotBeforeTest : public testing::Test {
 protected:
  void SetUp() override {
    panel_.set_plots({named("momentum")}, head_on_scene().scene.bodies);
    Frame now = run_to(head_on_scene(), 0.2, panel_.curves());
    now.run = 2;
    now_->add(now);
    panel_.resize(400, 560);
    panel_.show();
    panel_.update_from({{now_, "run"}});
  }
  [[nodiscard]] PaleRun before() const {
    auto recorder = std::make_shared<Recorder>();
    const Frame frame = run_to(head_on_scene(), 0.45, panel_.curves());
    recorder->add(frame);
    return {.run = {.recorder = recorder, .bodies = frame.bodies}, .shift = 0.0, .reach = 0.45};
  }
  void show(const std::optional<PaleRun>& run) {
    panel_.set_run_before(run);
    panel_.show_now();
  }
  [[nodiscard]] RunPlot& plot() const { return *panel_.plots().front(); }
  [[nodiscard]] bool in_legend() const {
    const auto legend = plot().legend();
    return std::any_of(legend.begin(), legend.end(),
                       [](const auto& each) { return each.first == "run before"; });
  }
  // Those that have points, at this depth of the plot.
  [[nodiscard]] std::vector<const QwtPlotCurve*> curves(double depth) const {
    std::vector<const QwtPlotCurve*> found;
    for (const QwtPlotItem* item : plot().plot()->itemList(QwtPlotItem::Rtti_PlotCurve)) {
      const auto* curve = static_cast<const QwtPlotCurve*>(item);
      if (curve->z() == depth && curve->isVisible() && curve->dataSize() > 0) found.push_back(curve);
    }
    return found;
  }
  [[nodiscard]] std::vector<QPen> pens(double depth) const {
    std::vector<QPen> pens;
    for (const QwtPlotCurve* curve : curves(depth)) pens.push_back(curve->pen());
    return pens;
  }
  // From its first to its last point, in s of the plot.
  [[nodiscard]] QwtInterval pale() const {
    if (curves(kPale).empty()) return {};
    const QwtPlotCurve& curve = *curves(kPale).front();
    return {curve.sample(0).x(), curve.sample(static_cast<int>(curve.dataSize()) - 1).x()};
  }

  static constexpr double kPale = 10.0;
  static constexpr double kFirst = 20.0;

  std::shared_ptr<Recorder> now_ = std::make_shared<Recorder>();
  PlotPanel panel_{light_theme()};
};

TEST_F(PlotBeforeTest, IsBelowTheRunAndInTheLegendWhileThereIsOne) {
  show(std::nullopt);
  EXPECT_FALSE(in_legend());
  EXPECT_EQ(plot().time_range(), QwtInterval(0.0, 0.2));
  show(before());
  EXPECT_TRUE(in_legend());
  EXPECT_EQ(plot().time_range(), QwtInterval(0.0, 0.5));
  EXPECT_EQ(pale().minValue(), 0.0);
  EXPECT_NEAR(pale().maxValue(), 0.45, 1e-9);
  show(std::nullopt);
  EXPECT_FALSE(in_legend());
  EXPECT_FALSE(pale().isValid());
}

// x and y, beside one run or several.
TEST_F(PlotBeforeTest, ItsCurvesHaveTheLinesOfTheFirstRunButPale) {
  for (const std::size_t runs : {1U, 2U}) {
    panel_.update_from(std::vector<PlottedRun>(runs, {now_, "run"}));
    show(before());
    const std::vector<QPen> pale = pens(kPale);
    const std::vector<QPen> first = pens(kFirst);
    ASSERT_EQ(pale.size(), 2U) << runs;
    ASSERT_EQ(first.size(), 2U) << runs;
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(pale[i].dashPattern(), first[i].dashPattern()) << runs;
      EXPECT_NE(pale[i].color(), first[i].color()) << runs;
    }
    EXPECT_NE(pale[0].dashPattern(), pale[1].dashPattern()) << runs;
  }
}

TEST_F(PlotBeforeTest, StandsByTheClockOfThePresentRun) {
  PaleRun late = before();
  late.shift = 10.0;
  late.reach = 10.45;
  show(late);
  EXPECT_NEAR(pale().minValue(), 10.0, 1e-9);
  EXPECT_NEAR(pale().maxValue(), 10.45, 1e-9);
}

TEST_F(PlotBeforeTest, TheRestOfARunBeginsWhereItWasCut) {
  PaleRun rest = before();
  rest.run.from = 0.3;
  show(rest);
  EXPECT_NEAR(pale().minValue(), 0.3, 0.011);
  EXPECT_NEAR(pale().maxValue(), 0.45, 1e-9);
}

// Its last values may be beyond all measure.
TEST_F(PlotBeforeTest, ALostRunLeavesTheAxisToThePresentOne) {
  const auto grown = [this] {
    PaleRun run = before();
    Frame frame = run_to(head_on_scene(), 0.45, panel_.curves());
    for (double& value : frame.rows[0].values) value *= 1e9;
    auto recorder = std::make_shared<Recorder>();
    recorder->add(frame);
    run.run.recorder = recorder;
    return run;
  }();
  show(grown);
  EXPECT_GT(plot().value_range().maxValue(), 1e9);
  PaleRun lost = grown;
  lost.run.lost = true;
  show(std::nullopt);
  panel_.reset_zoom();
  show(lost);
  EXPECT_LT(plot().value_range().maxValue(), 100.0);
  EXPECT_TRUE(in_legend());
}

TEST_F(PlotBeforeTest, CurvesAreThoseOfTheSameBodies) {
  std::vector<Body> bodies = head_on_scene().scene.bodies;
  const Curve speed{quantity_of({"speed", {"B"}}, bodies), {}};
  std::vector<Body> others = {bodies[1]};
  EXPECT_EQ(curve_among(speed, bodies, others)->y.bodies, std::vector<BodyIndex>{BodyIndex{0}});
  EXPECT_FALSE(curve_among(speed, bodies, std::vector<Body>{bodies[0]}));
  others[0].id.number = bodies[1].id.number = 7;
  others[0].name = "B of old";
  EXPECT_EQ(curve_among(speed, bodies, others)->y.bodies, std::vector<BodyIndex>{BodyIndex{0}})
      << "it was renamed";
}

}  // namespace
}  // namespace carom
