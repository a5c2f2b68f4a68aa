#include "physics/record/impact_moments.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "physics/record/recorder.h"

// Impacts by their times, in a record of more of them than are kept.
namespace carom {
namespace {

constexpr double kApart = 0.001;  // s

// Impacts at kApart, 2 kApart, ...
Recorder recorded(int count) {
  Recorder recorder;
  Frame frame;
  frame.run = 1;
  frame.time = kApart * count;
  for (int i = 1; i <= count; ++i) {
    ImpactRecord impact;
    impact.time = kApart * i;
    impact.normal_impulse = 1.0 + std::sin(i);
    frame.impacts.push_back(impact);
  }
  recorder.add(frame);
  return recorder;
}

TEST(ImpactMoments, AreOneAfterTheOtherWhereAllAreKept) {
  const Recorder recorder = recorded(50);
  for (int i = 1; i < 50; ++i) {
    EXPECT_EQ(impact_after(recorder, kApart * i), kApart * (i + 1));
    EXPECT_EQ(impact_until(recorder, kApart * (i + 0.5)), kApart * i);
  }
  EXPECT_EQ(impact_after(recorder, 0.0), kApart);
  EXPECT_EQ(impact_until(recorder, 0.5 * kApart), std::nullopt);
  EXPECT_EQ(impact_after(recorder, 50 * kApart), std::nullopt);
}

// There and back through the times that are known, of which none is left out either way.
TEST(ImpactMoments, EarlierOnesAreKnownByTheirTimesBothWays) {
  const int count = 2 * static_cast<int>(Recorder::kMostImpacts) + 50'000;
  const Recorder recorder = recorded(count);
  const double oldest_kept = recorder.impacts()[0].time;
  std::vector<double> forth;
  for (auto at = impact_after(recorder, 0.0); at && *at <= oldest_kept; at = impact_after(recorder, *at))
    forth.push_back(*at);
  ASSERT_FALSE(forth.empty());
  EXPECT_EQ(forth.front(), kApart);
  EXPECT_EQ(forth.back(), oldest_kept);
  EXPECT_GT(forth.size(), 10'000U);
  std::vector<double> back{oldest_kept};
  while (const auto at = impact_until(recorder, back.back() - 0.5 * kApart)) back.push_back(*at);
  EXPECT_EQ(back, std::vector<double>(forth.rbegin(), forth.rend()));
}

}  // namespace
}  // namespace carom
