#include "physics/record/series.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace carom {
namespace {

using Points = std::vector<SeriesPoint<1>>;

bool holds(const Points& points, double time, double value) {
  return std::find(points.begin(), points.end(), SeriesPoint<1>{time, {value}}) != points.end();
}

bool in_order(const Points& points) {
  return std::is_sorted(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.at < b.at; });
}

TEST(Series, GivesBackWhatItTook) {
  Series<1> series;
  Points all;
  for (int i = 0; i < 20'000; ++i) {
    all.push_back({0.01 * (i / 2), {std::sin(0.3 * i)}});  // times come twice
    series.append(all.back());
  }
  Points read;
  series.read(-1.0, 1e9, read);
  EXPECT_EQ(read, all);
  series.read(10.0, 10.1, read);
  EXPECT_EQ(read, Points(all.begin() + 1999, all.begin() + 2023));  // one beyond each end
  series.read(1e9, 2e9, read);
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read[0], all.back());
}

TEST(Series, ReadsAtATime) {
  Series<1> series;
  EXPECT_EQ(series.at(1.0), nullptr);
  for (int i = 0; i < 1'000'000; ++i) series.append({1.0 * (i / 2), {1.0 * i}});  // an upright jump each
  EXPECT_EQ(series.at(-1.0), nullptr);
  EXPECT_EQ(series.at(499'999.0)->value[0], 999'999.0);
  EXPECT_EQ(series.at(499'990.5)->value[0], 999'981.0) << "after the jump";
  EXPECT_EQ(series.at(1e9)->value[0], 999'999.0);
  const SeriesPoint<1>* old = series.at(100'000.2);
  ASSERT_NE(old, nullptr);
  EXPECT_LE(old->at, 100'000.2);
  EXPECT_GT(old->at, 100'000.2 - 64.0);
  EXPECT_LT(100'000.2, series.whole_since());
}

TEST(Series, LeavesOutWhatIsNotFinite) {
  Series<1> series;
  Points read;
  series.read(0.0, 1.0, read);
  EXPECT_TRUE(read.empty());
  series.append({0.0, {std::nan("")}});
  series.append({1.0, {1.0}});
  series.append({2.0, {-std::numeric_limits<double>::infinity()}});
  series.read(0.0, 9.0, read);
  EXPECT_EQ(read, (Points{{1.0, {1.0}}}));
}

// Ten million points: spikes of one point, high and low, early and late, are in every view that holds them; so
// are the first and the last point; what the newest part shows is exact; and the memory stays where it was.
TEST(Series, ALongRunKeepsItsSpikesInABoundedMemory) {
  constexpr int kPoints = 10'000'000;
  Series<1> series;
  const std::vector<std::pair<int, double>> spikes = {{7, 40.0},         {1'234'567, -7.0}, {5'000'001, 9.0},
                                                      {5'000'002, -9.0}, {9'990'000, 5.0},  {9'999'990, -30.0}};
  auto next = spikes.begin();
  std::size_t memory = 0;
  for (int i = 0; i < kPoints; ++i) {
    double value = std::sin(1e-3 * i);
    if (next != spikes.end() && i == next->first) value = (next++)->second;
    series.append({1e-3 * i, {value}});
    if (i == kPoints / 10) memory = series.memory();
  }
  EXPECT_EQ(series.count(), kPoints);
  EXPECT_LT(series.memory(), 4U << 20U);
  EXPECT_LT(series.memory(), 2 * memory);
  for (const double from : {-1.0, 0.0, 500.0, 4999.0, 9500.0}) {
    Points read;
    series.read(from, 1e9, read);
    EXPECT_LE(read.size(), 34'000U);
    EXPECT_TRUE(in_order(read));
    EXPECT_EQ(read.back().at, 1e-3 * (kPoints - 1));
    for (const auto& [i, value] : spikes) {
      if (1e-3 * i >= from) {
        EXPECT_TRUE(holds(read, 1e-3 * i, value)) << i << " from " << from;
      }
    }
  }
  Points read;
  series.read(0.0, 1e9, read);
  EXPECT_EQ(read.front(), (SeriesPoint<1>{0.0, {0.0}}));
  series.read(0.0, 2000.0, read);
  EXPECT_GE(read.back().at, 2000.0);
  EXPECT_LE(read.back().at, 2100.0);
  EXPECT_TRUE(holds(read, 1e-3 * 1'234'567, -7.0));

  const double newest = series.whole_since();
  series.read(newest, 1e9, read);
  EXPECT_EQ(read.size(), Series<1>::kPoints);
}

// The slow obvious version: the least and the largest of every window, against what is read of it.
TEST(Series, EveryWindowHasItsExtremes) {
  std::mt19937_64 random(3);
  const auto draw = [&] { return static_cast<double>(random() >> 11U) * 0x1p-53; };
  Series<1> series;
  Points all;
  for (int i = 0; i < 300'000; ++i) {
    all.push_back({static_cast<double>(i), {draw()}});
    series.append(all.back());
  }
  for (int k = 0; k < 300; ++k) {
    const double from = std::floor(300'000 * draw());
    const double to = from + std::floor((300'000 - from) * draw());
    Points read;
    series.read(from, to, read);
    ASSERT_TRUE(in_order(read));
    double least = 1.0;
    double largest = 0.0;
    for (auto i = static_cast<std::size_t>(from); i <= static_cast<std::size_t>(to); ++i) {
      least = std::min(least, all[i].value[0]);
      largest = std::max(largest, all[i].value[0]);
    }
    const auto [low, high] = std::minmax_element(
        read.begin(), read.end(), [](const auto& a, const auto& b) { return a.value[0] < b.value[0]; });
    // Buckets at the ends reach beyond them.
    ASSERT_LE(low->value[0], least) << from << " to " << to;
    ASSERT_GE(high->value[0], largest) << from << " to " << to;
    for (const SeriesPoint<1>& p : read) ASSERT_EQ(p, all[static_cast<std::size_t>(p.at)]);
  }
}

// Cut and continued many times it reads as what is left. Where a cut leaves all newest points behind, the last
// bucket of a level may have lost an extreme, but nothing is out of order or from after the cut.
TEST(Series, IsCutAndContinued) {
  std::mt19937_64 random(5);
  const auto draw = [&] { return static_cast<double>(random() >> 11U) * 0x1p-53; };
  for (const bool deep : {false, true}) {
    Series<1> series;
    Points all;
    const auto append = [&](int count) {
      for (int i = 0; i < count; ++i) {
        all.push_back({static_cast<double>(all.size()), {draw()}});
        series.append(all.back());
      }
    };
    append(deep ? 1'200'000 : 300'000);
    for (int k = 0; k < 40; ++k) {
      const double share = deep ? draw() : 1.0 - draw() * 20'000 / static_cast<double>(all.size());
      const auto left = static_cast<std::size_t>(share * static_cast<double>(all.size()));
      series.cut(static_cast<double>(left) - 0.5);
      all.resize(left);
      append(static_cast<int>(50'000 * draw()));
      for (int n = 0; n < 10; ++n) {
        const auto from = static_cast<std::size_t>(draw() * static_cast<double>(all.size()));
        Points read;
        series.read(static_cast<double>(from), 1e9, read);
        ASSERT_TRUE(in_order(read));
        for (const SeriesPoint<1>& p : read) {
          ASSERT_LT(p.at, static_cast<double>(all.size()));
          ASSERT_EQ(p, all[static_cast<std::size_t>(p.at)]);
        }
        if (deep || read.empty()) continue;
        const auto less = [](const auto& a, const auto& b) { return a.value[0] < b.value[0]; };
        const auto [least, largest] =
            std::minmax_element(all.begin() + static_cast<std::ptrdiff_t>(from), all.end(), less);
        ASSERT_TRUE(holds(read, least->at, least->value[0])) << k;
        ASSERT_TRUE(holds(read, largest->at, largest->value[0])) << k;
      }
    }
    series.cut(-1.0);
    Points read;
    series.read(-1.0, 1e9, read);
    EXPECT_TRUE(read.empty());
    EXPECT_EQ(series.at(1e9), nullptr);
  }
}

// Paths keep pairs together.
TEST(Series, PointsOfAPathStayTogether) {
  Series<2> path;
  for (int i = 0; i < 500'000; ++i)
    path.append({1.0 * i, {std::cos(1e-2 * i), i == 77 ? 5.0 : std::sin(1e-2 * i)}});
  std::vector<SeriesPoint<2>> read;
  path.read(0.0, 1e9, read);
  EXPECT_LE(read.size(), 50'000U);
  bool spike = false;
  for (const SeriesPoint<2>& p : read) {
    ASSERT_EQ(p.value[0], std::cos(1e-2 * p.at));
    spike = spike || p.value[1] == 5.0;
  }
  EXPECT_TRUE(spike);
}

}  // namespace
}  // namespace carom
