#include "widgets/plot/plot_impacts.h"

#include <QTest>
#include <cmath>
#include <gtest/gtest.h>
#include <qwt_axis.h>
#include <qwt_plot.h>

#include "tests/support/run_fixture.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/plot/run_plot.h"

// A hits B at 0.2 s with 4 N s.
namespace carom {
namespace {

class PlotImpacts : public testing::Test {
 protected:
  void SetUp() override {
    panel_.set_plots({named("energy"), named("impulse")}, head_on_scene().scene.bodies);
    panel_.resize(500, 600);
    panel_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel_));
    QObject::connect(&panel_, &PlotPanel::impactChosen, [this](double time) { chosen_.push_back(time); });
  }
  void show(const Frame& frame) {
    auto recorder = std::make_shared<Recorder>();
    recorder->add(frame);
    panel_.update_from({{recorder, "run"}});
    panel_.show_now();
    QApplication::processEvents();
  }
  [[nodiscard]] QwtPlot& plot(std::size_t i) const { return *panel_.plots()[i]->plot(); }
  [[nodiscard]] int x_of(double time) const { return qRound(plot(0).transform(QwtAxis::XBottom, time)); }
  [[nodiscard]] int y_of(double impulse) const { return qRound(plot(1).transform(QwtAxis::YLeft, impulse)); }
  void click(std::size_t i, const QPoint& at, Qt::KeyboardModifiers keys = {}) {
    QTest::mouseClick(plot(i).canvas(), Qt::LeftButton, keys, at);
  }

  PlotPanel panel_{light_theme()};
  std::vector<double> chosen_;
};

TEST_F(PlotImpacts, AClickGoesToTheMomentAndLeavesTheMarksAlone) {
  show(run_to(head_on_scene(), 1.0, panel_.curves()));
  click(0, {x_of(0.2) + 3, 40});
  ASSERT_EQ(chosen_.size(), 1U);
  EXPECT_NEAR(chosen_.front(), 0.2, 1e-12);
  EXPECT_FALSE(panel_.marks().a);
  click(0, {x_of(0.2) + 8, 40});
  EXPECT_EQ(chosen_.size(), 1U) << "beside it is no impact";
  EXPECT_TRUE(panel_.marks().a);
  click(0, {x_of(0.2), 40}, Qt::ShiftModifier);
  EXPECT_EQ(chosen_.size(), 1U) << "with Shift it is mark B";
  EXPECT_TRUE(panel_.marks().b);
}

TEST_F(PlotImpacts, ADoubleClickGoesThereOnceAndLeavesTheZoom) {
  show(run_to(head_on_scene(), 1.0, panel_.curves()));
  emit panel_.plots()[0]->timeZoomAsked(0.2, 0.8);
  QApplication::processEvents();
  ASSERT_TRUE(panel_.zoomed());
  const QPoint at(x_of(0.2), 40);
  click(0, at);
  QTest::mouseDClick(plot(0).canvas(), Qt::LeftButton, Qt::NoModifier, at);
  EXPECT_EQ(chosen_.size(), 1U);
  EXPECT_TRUE(panel_.zoomed());
  QTest::mouseDClick(plot(0).canvas(), Qt::LeftButton, Qt::NoModifier, at + QPoint(60, 0));
  EXPECT_FALSE(panel_.zoomed()) << "beside it a double click resets";
}

TEST_F(PlotImpacts, ABarIsClickedWhereItIs) {
  show(run_to(head_on_scene(), 1.0, panel_.curves()));
  ASSERT_GT(y_of(4.0), 20) << "room over the bar";
  click(1, {x_of(0.2), y_of(2.0)});
  EXPECT_EQ(chosen_.size(), 1U);
  click(1, {x_of(0.2), y_of(4.0) - 12});
  EXPECT_EQ(chosen_.size(), 1U) << "over the bar";
}

TEST_F(PlotImpacts, OnesThatCantBeToldApartAreNoTarget) {
  Frame frame = run_to(head_on_scene(), 1.0, panel_.curves());
  ImpactRecord second = frame.impacts.front();
  second.time += 0.012;
  frame.impacts.push_back(second);
  show(frame);
  const int apart = x_of(second.time) - x_of(0.2);
  ASSERT_GT(apart, 2);
  ASSERT_LT(apart, 8);
  click(0, {x_of(0.2), 40});
  EXPECT_TRUE(chosen_.empty());
  EXPECT_TRUE(panel_.marks().a);
  click(1, {x_of(second.time), y_of(2.0)});
  ASSERT_EQ(chosen_.size(), 1U) << "bars are the closest one";
  EXPECT_EQ(chosen_.front(), second.time);
}

}  // namespace
}  // namespace carom
