#include <gtest/gtest.h>
#include <vector>

#include "physics/world/frame.h"
#include "widgets/series_data.h"

namespace carom {
namespace {

double kinetic(const Sample& sample) { return sample.totals.translational; }

Sample sample_at(double time, double value) {
  Sample sample;
  sample.time = time;
  sample.totals.translational = value;
  return sample;
}

// `count` samples of 1 J within [0, 1) s.
std::vector<Sample> flat(int count) {
  std::vector<Sample> samples;
  for (int i = 0; i < count; ++i) samples.push_back(sample_at(static_cast<double>(i) / count, 1.0));
  return samples;
}

bool holds(const DecimatedSeries& series, const QPointF& point) {
  for (std::size_t i = 0; i < series.size(); ++i) {
    if (series.sample(i) == point) return true;
  }
  return false;
}

TEST(DecimatedSeries, KeepsASpikeOfOneSampleAndAnUprightJump) {
  std::vector<Sample> samples = flat(100'000);
  samples[31'337].totals.translational = 5.0;
  for (std::size_t i = 70'001; i < samples.size(); ++i) samples[i].totals.translational = 0.25;
  samples[70'001].time = samples[70'000].time;

  DecimatedSeries series;
  series.take(samples, kinetic, {0.0, 1.0}, 300);
  EXPECT_LE(series.size(), 4u * 300u);
  EXPECT_TRUE(holds(series, {samples[31'337].time, 5.0}));
  bool jumps = false;
  for (std::size_t i = 1; i < series.size(); ++i) {
    EXPECT_LE(series.sample(i - 1).x(), series.sample(i).x());
    const bool down = series.sample(i - 1).y() == 1.0 && series.sample(i).y() == 0.25;
    // Within the jump's own column of 1/300 s.
    jumps = jumps || (down && series.sample(i).x() - series.sample(i - 1).x() < 1.0 / 300.0);
  }
  EXPECT_TRUE(jumps);
  EXPECT_EQ(series.boundingRect().top(), 0.25);
  EXPECT_EQ(series.boundingRect().bottom(), 5.0);
}

TEST(DecimatedSeries, TakesOnlyTheVisibleAndOneBeyondEachEnd) {
  const std::vector<Sample> samples = flat(1000);
  DecimatedSeries series;
  series.take(samples, kinetic, {0.2995, 0.3045}, 300);
  ASSERT_EQ(series.size(), 7u);
  EXPECT_EQ(series.sample(0).x(), samples[299].time);
  EXPECT_EQ(series.sample(6).x(), samples[305].time);
}

TEST(DecimatedSeries, AddingEqualsTakingAllAtOnce) {
  std::vector<Sample> samples = flat(5000);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].totals.translational = static_cast<double>(i * i % 97);
  }
  std::vector<Sample> growing;
  DecimatedSeries stepwise;
  for (const Sample& sample : samples) {
    growing.push_back(sample);
    if (growing.size() % 37 == 0) stepwise.take(growing, kinetic, {0.0, 1.0}, 100);
  }
  stepwise.take(growing, kinetic, {0.0, 1.0}, 100);
  DecimatedSeries at_once;
  at_once.take(samples, kinetic, {0.0, 1.0}, 100);
  ASSERT_EQ(stepwise.size(), at_once.size());
  for (std::size_t i = 0; i < at_once.size(); ++i) EXPECT_EQ(stepwise.sample(i), at_once.sample(i));
}

TEST(DecimatedSeries, ForgetsARunThatWasReplaced) {
  DecimatedSeries series;
  series.take(flat(1000), kinetic, {0.0, 1.0}, 100);
  std::vector<Sample> other = flat(2000);
  for (Sample& sample : other) sample.totals.translational = 3.0;
  series.take(other, kinetic, {0.0, 1.0}, 100);
  EXPECT_EQ(series.boundingRect().top(), 3.0);
  series.take(std::vector<Sample>(), kinetic, {0.0, 1.0}, 100);
  EXPECT_EQ(series.size(), 0u);
  EXPECT_LT(series.boundingRect().width(), 0.0);
}

}  // namespace
}  // namespace carom
