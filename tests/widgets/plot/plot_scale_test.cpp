#include "widgets/plot/plot_scale.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "widgets/base/number_text.h"

namespace carom {
namespace {

TEST(PlotScale, TimeEndIsRoundAndGrowsInSteps) {
  EXPECT_EQ(nice_time_end(0.0), 1.0);
  EXPECT_DOUBLE_EQ(nice_time_end(2.0), 2.0);
  EXPECT_DOUBLE_EQ(nice_time_end(2.01), 2.5);
  EXPECT_DOUBLE_EQ(nice_time_end(0.0301), 0.04);
  EXPECT_DOUBLE_EQ(nice_time_end(0.1 + 0.2), 0.3);  // 0.30000000000000004
  double last = 0.0;
  for (double t = 1e-3; t < 300.0; t *= 1.01) {
    const double end = nice_time_end(t);
    EXPECT_GE(end, t * (1.0 - 1e-9));
    EXPECT_LE(end, 1.55 * t);
    EXPECT_GE(end, last);
    last = end;
  }
}

TEST(PlotScale, TimeAxisSpansTheRunFromTheStart) {
  EXPECT_DOUBLE_EQ(time_axis_end(0.0, 3.0), 3.0);
  EXPECT_DOUBLE_EQ(time_axis_end(2.9, 3.0), 3.0);
  EXPECT_DOUBLE_EQ(time_axis_end(3.0 + 1e-12, 3.0), 3.0);
  EXPECT_DOUBLE_EQ(time_axis_end(0.0, 20.0), 20.0);
  EXPECT_DOUBLE_EQ(time_axis_end(0.0, 0.0), 1.0);  // of unknown length
}

TEST(PlotScale, TimeAxisGrowsInRareSteps) {
  EXPECT_DOUBLE_EQ(time_axis_end(3.01, 3.0), 5.0);  // played on past the end
  EXPECT_DOUBLE_EQ(time_axis_end(0.0, 60.0), 20.0);
  EXPECT_DOUBLE_EQ(time_axis_end(51.0, 60.0), 60.0);
  int steps = 0;
  double last = 0.0;
  for (double t = 0.0; t < 1000.0; t += 0.1) {
    const double end = time_axis_end(t, 1000.0);
    EXPECT_GE(end, t * (1.0 - 1e-9));
    EXPECT_GE(end, last);
    if (end > last) ++steps;
    last = end;
  }
  EXPECT_LE(steps, 6);
}

TEST(PlotScale, NoiseIsNotBlownUp) {
  EXPECT_EQ(nice_range(0.0, 0.0), QwtInterval(-1.0, 1.0));
  EXPECT_EQ(nice_range(-3e-16, 2e-16, {.below = 1e-9, .range = 1.0}), QwtInterval(-1.0, 1.0));
  const QwtInterval constant = nice_range(2.0, 2.0 + 4e-16);
  EXPECT_LT(constant.minValue(), 2.0);
  EXPECT_GT(constant.maxValue(), 2.0);
  EXPECT_GT(constant.width(), 0.1);
}

// The noise level depends on the run's own scale.
TEST(PlotScale, SmallIsNotZero) {
  const Zero tiny{.below = 1e-21, .range = 3e-12};
  EXPECT_EQ(nice_range(-2e-25, 3e-25, tiny), QwtInterval(-5e-12, 5e-12));
  const QwtInterval range = nice_range(0.0, 1.1e-12, tiny);
  EXPECT_EQ(range.minValue(), 0.0);
  EXPECT_GE(range.maxValue(), 1.1e-12);
  EXPECT_LT(range.maxValue(), 2e-12);
  const Zero huge{.below = 1e3, .range = 1e12};
  EXPECT_EQ(nice_range(-20.0, 30.0, huge), QwtInterval(-1e12, 1e12));
}

TEST(PlotScale, RangeIsFiniteWhateverComes) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(nice_range(-infinity, infinity), QwtInterval(-1.0, 1.0));
  EXPECT_EQ(nice_range(std::nan(""), 1.0), QwtInterval(-1.0, 1.0));
  for (const double high : {1e-8, 1e-3, 1.0, 14.3, 1e6, 1e200}) {
    const QwtInterval range = nice_range(-0.3 * high, high);
    EXPECT_TRUE(std::isfinite(range.width()));
    EXPECT_LT(range.minValue(), -0.3 * high);
    EXPECT_GT(range.maxValue(), high);
    EXPECT_LT(range.width(), 2.5 * high);
  }
}

TEST(PlotScale, RangeKeepsForSmallChanges) {
  const QwtInterval range = nice_range(0.0, 9.0);
  EXPECT_EQ(steady_range(range, 0.0, 8.0), range);
  EXPECT_NE(steady_range(range, 0.0, 11.0), range);
  EXPECT_NE(steady_range(range, 0.0, 2.0), range);
}

TEST(NumberText, FourDigitsAtMostAndProperMinus) {
  EXPECT_EQ(figure(0.0), "0");
  EXPECT_EQ(figure(-0.0), "0");
  EXPECT_EQ(figure(1.91), "1.910");
  EXPECT_EQ(figure(-0.42), "−0.4200");
  EXPECT_EQ(figure(9.99996), "10.00");
  EXPECT_EQ(figure(12345.0), "1.23e4");
  EXPECT_EQ(figure(3.14e-13), "3.1e−13");
  EXPECT_EQ(figure(-5.75e-3), "−5.75e−3");
  EXPECT_EQ(figure(-std::numeric_limits<double>::infinity()), "−∞");
}

TEST(NumberText, VectorsShareTheirDecimalPlace) {
  EXPECT_EQ(figures(Vec2(1.91, -1e-17)), "1.91, 0.00");
  EXPECT_EQ(figures(Vec2(-12.34, 0.567)), "−12.3, 0.6");
  EXPECT_EQ(figures(Vec2(0.0, -0.0)), "0, 0");
  EXPECT_EQ(figures(Vec2(1.2e-16, 0.0)), "1.2e−16, 0");
  EXPECT_EQ(figures(Vec2(1.2e-6, -3.4e-5)), "1.2e−6, −3.4e−5");
  EXPECT_EQ(figures(Vec2(-1.2e-6, 3.4e-8)), "−1.2e−6, 0");
  EXPECT_EQ(figures(Vec2(1.2e-13, -3.4e-13)), "1e−13, −3e−13");
  EXPECT_EQ(figures(Vec2(1.2e-13, -6.4e-15)), "1e−13, 0");
}

TEST(PlotScale, PowersHoldTheMagnitudesAndStandStill) {
  EXPECT_EQ(steady_powers({}, 2e-7, 0.3), QwtInterval(1e-7, 1.0));
  EXPECT_EQ(steady_powers({1e-7, 1.0}, 3e-7, 0.2), QwtInterval(1e-7, 1.0));
  EXPECT_EQ(steady_powers({1e-7, 1.0}, 3e-9, 0.2), QwtInterval(1e-9, 1.0));
  EXPECT_NEAR(steady_powers({}, 1e-60, 1.0).minValue() * std::pow(10.0, kMostPowers), 10.0, 10.0);
  EXPECT_EQ(steady_powers({}, 1.0, -1.0), QwtInterval(0.1, 10.0));  // nothing to show
  const QwtInterval one = steady_powers({}, 5.0, 5.0);
  EXPECT_EQ(one, QwtInterval(1.0, 10.0));
  EXPECT_GE(power_ticks({1e-7, 1.0}, 4).ticks(QwtScaleDiv::MajorTick).size(), 2);
}

}  // namespace
}  // namespace carom
