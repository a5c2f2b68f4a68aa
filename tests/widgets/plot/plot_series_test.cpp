#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "widgets/plot/series_data.h"

namespace carom {
namespace {

// `count` points of 1 within [0, 1) s.
Series<1> series_of(
    int count, double (*value)(int) = [](int) { return 1.0; }) {
  Series<1> series;
  for (int i = 0; i < count; ++i) series.append({static_cast<double>(i) / count, {value(i)}});
  return series;
}

bool holds(const DecimatedSeries& series, const QPointF& point) {
  for (std::size_t i = 0; i < series.size(); ++i) {
    if (series.sample(i) == point) return true;
  }
  return false;
}

TEST(DecimatedSeries, KeepsASpikeOfOneSampleAndAnUprightJump) {
  Series<1> series;
  for (int i = 0; i < 100'000; ++i) {
    const double value = i == 31'337 ? 5.0 : i > 70'000 ? 0.25 : 1.0;
    series.append({(i == 70'001 ? 70'000 : i) / 1e5, {value}});
  }
  DecimatedSeries shown;
  shown.take(series, {0.0, 1.0}, 300, false);
  EXPECT_LE(shown.size(), 4u * 300u);
  EXPECT_TRUE(holds(shown, {31'337 / 1e5, 5.0}));
  bool jumps = false;
  for (std::size_t i = 1; i < shown.size(); ++i) {
    EXPECT_LE(shown.sample(i - 1).x(), shown.sample(i).x());
    const bool down = shown.sample(i - 1).y() == 1.0 && shown.sample(i).y() == 0.25;
    // Within the jump's own column of 1/300 s.
    jumps = jumps || (down && shown.sample(i).x() - shown.sample(i - 1).x() < 1.0 / 300.0);
  }
  EXPECT_TRUE(jumps);
  EXPECT_EQ(shown.boundingRect().top(), 0.25);
  EXPECT_EQ(shown.boundingRect().bottom(), 5.0);
}

TEST(DecimatedSeries, TakesOnlyTheVisibleAndOneBeyondEachEnd) {
  DecimatedSeries shown;
  shown.take(series_of(1000), {0.2995, 0.3045}, 300, false);
  ASSERT_EQ(shown.size(), 7u);
  EXPECT_EQ(shown.sample(0).x(), 0.299);
  EXPECT_EQ(shown.sample(6).x(), 0.305);
}

// Of each pixel column the extremes, against a plain search.
TEST(DecimatedSeries, EachColumnHasItsExtremesInOrder) {
  const auto value = [](int i) { return std::sin(static_cast<double>(i) * i); };
  constexpr int kCount = 20'000;
  constexpr int kColumns = 100;
  DecimatedSeries shown;
  shown.take(series_of(kCount, value), {0.0, 1.0}, kColumns, false);
  EXPECT_LE(shown.size(), 4u * kColumns);
  for (int column = 0; column < kColumns; ++column) {
    double least = 2.0;
    double largest = -2.0;
    const int first = column * kCount / kColumns;
    for (int i = first; i < first + kCount / kColumns; ++i) {
      least = std::min(least, value(i));
      largest = std::max(largest, value(i));
    }
    double low = 2.0;
    double high = -2.0;
    for (std::size_t i = 0; i < shown.size(); ++i) {
      if (std::floor(shown.sample(i).x() * kColumns) != column) continue;
      low = std::min(low, shown.sample(i).y());
      high = std::max(high, shown.sample(i).y());
    }
    EXPECT_EQ(low, least) << column;
    EXPECT_EQ(high, largest) << column;
  }
  for (std::size_t i = 1; i < shown.size(); ++i) EXPECT_LT(shown.sample(i - 1).x(), shown.sample(i).x());
}

TEST(DecimatedSeries, ShowsMagnitudesWithoutZeros) {
  DecimatedSeries shown;
  shown.take(series_of(5, [](int i) { return i - 2.0; }), {0.0, 1.0}, 300, true);
  ASSERT_EQ(shown.size(), 4u);
  EXPECT_EQ(shown.sample(0).y(), 2.0);
  EXPECT_EQ(shown.sample(1).y(), 1.0);
  EXPECT_EQ(shown.sample(2), QPointF(0.6, 1.0));
}

TEST(DecimatedSeries, ForgetsARunThatWasReplaced) {
  DecimatedSeries shown;
  shown.take(series_of(1000), {0.0, 1.0}, 100, false);
  shown.take(series_of(2000, [](int) { return 3.0; }), {0.0, 1.0}, 100, false);
  EXPECT_EQ(shown.boundingRect().top(), 3.0);
  shown.take(Series<1>(), {0.0, 1.0}, 100, false);
  EXPECT_EQ(shown.size(), 0u);
  EXPECT_LT(shown.boundingRect().width(), 0.0);
}

// A circle: y over x.
TEST(DecimatedSeries, DrawsAPath) {
  Series<2> path;
  for (int i = 0; i < 100; ++i) path.append({0.01 * i, {std::sin(0.1 * i), std::cos(0.1 * i)}});
  DecimatedSeries shown;
  shown.take(path, {0.0, 1.0}, false);
  ASSERT_EQ(shown.size(), 100u);
  EXPECT_EQ(shown.sample(10), QPointF(std::cos(1.0), std::sin(1.0)));
  EXPECT_NEAR(shown.boundingRect().left(), -1.0, 1e-2);
  EXPECT_NEAR(shown.boundingRect().bottom(), 1.0, 1e-2);
}

}  // namespace
}  // namespace carom
