#include "widgets/compare/log_scale.h"

#include <gtest/gtest.h>
#include <initializer_list>
#include <limits>

namespace carom {
namespace {

LogRange range_of(std::initializer_list<double> values) {
  LogRange range;
  for (const double value : values) range.take(value);
  return range;
}

TEST(LogScale, TicksArePowersOfTenInTheRange) {
  const QwtScaleDiv ticks = log_ticks(range_of({1e-9, 1e-3}).whole_powers(), 4);
  EXPECT_EQ(ticks.ticks(QwtScaleDiv::MajorTick).size(), 4);
  EXPECT_NEAR(ticks.lowerBound(), 1e-9, 1e-18);
  EXPECT_NEAR(ticks.upperBound(), 1e-3, 1e-12);
}

// With the least double as an end, the search for powers of ten went on for seconds.
TEST(LogScale, NumbersBeyondAllPowersOfTenAreIgnored) {
  for (const double value :
       {0.0, std::numeric_limits<double>::denorm_min(), 1e-310, 1e308, std::numeric_limits<double>::infinity(),
        std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_TRUE(range_of({value}).empty()) << value;
    const LogRange shown = range_of({value, 1e-5, 1.0}).widened(2.0).whole_powers();
    EXPECT_NEAR(shown.low, 1e-6, 1e-15) << value;
    EXPECT_NEAR(shown.high, 10.0, 1e-8) << value;
  }
  const LogRange widest = range_of({1e-300, 1e300}).widened(2.0).whole_powers();
  EXPECT_LE(log_ticks(widest, 5).ticks(QwtScaleDiv::MajorTick).size(), 6);
}

}  // namespace
}  // namespace carom
