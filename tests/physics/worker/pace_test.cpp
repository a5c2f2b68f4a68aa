#include "physics/worker/pace.h"

#include <chrono>
#include <gtest/gtest.h>
#include <limits>
#include <optional>

// The pace of a run, at times that are made up.
namespace carom {
namespace {

using namespace std::chrono_literals;

constexpr Pace::Clock::time_point kBegin{1000s};

double seconds(Pace::Clock::duration d) { return std::chrono::duration<double>(d).count(); }

TEST(Pace, IsTheClocksAtFirst) {
  Pace pace(kBegin);
  pace.begin(3.0, kBegin);
  EXPECT_EQ(pace.due(kBegin), 3.0);
  EXPECT_DOUBLE_EQ(pace.due(kBegin + 500ms), 3.5);
  EXPECT_DOUBLE_EQ(seconds(pace.until(4.0, kBegin + 250ms)), 0.75);
}

TEST(Pace, AtSpeedTwoTakesHalfTheTime) {
  Pace pace(kBegin);
  pace.set_speed(2.0);
  pace.begin(0.0, kBegin);
  EXPECT_DOUBLE_EQ(seconds(pace.until(0.4, kBegin)), 0.2);
  EXPECT_DOUBLE_EQ(pace.due(kBegin + 200ms), 0.4);
  EXPECT_DOUBLE_EQ(seconds(pace.until(0.4, kBegin + 150ms)), 0.05);
  EXPECT_DOUBLE_EQ(seconds(pace.until(0.4, kBegin + 300ms)), -0.1);
}

TEST(Pace, IsMuchSlowerNearImpacts) {
  Pace pace(kBegin);
  pace.set_speed(2.0);
  pace.begin(0.0, kBegin);
  EXPECT_DOUBLE_EQ(pace.due_near_impacts(9.0, 0.3, 0.4, kBegin + 200ms), 0.4) << "far from any";
  EXPECT_FALSE(pace.slow());
  EXPECT_DOUBLE_EQ(pace.due_near_impacts(0.35, 0.3, 0.4, kBegin + 200ms), 0.35) << "up to where one is near";
  EXPECT_DOUBLE_EQ(pace.due(kBegin + 200ms), 0.35);
  EXPECT_DOUBLE_EQ(pace.due_near_impacts(std::nullopt, 0.35, 0.4, kBegin + 200ms), 0.35) << "it becomes slow";
  EXPECT_TRUE(pace.slow());
  EXPECT_DOUBLE_EQ(pace.due(kBegin + 1200ms), 0.45);
  EXPECT_NEAR(seconds(pace.until(0.45, kBegin + 200ms)), 1.0, 1e-8);
  EXPECT_DOUBLE_EQ(pace.due_near_impacts(std::nullopt, 0.4, 0.45, kBegin + 1200ms), 0.45);
  EXPECT_DOUBLE_EQ(pace.due_near_impacts(9.0, 0.45, 0.45, kBegin + 1200ms), 0.45) << "and fast again";
  EXPECT_FALSE(pace.slow());
  EXPECT_DOUBLE_EQ(pace.due(kBegin + 1300ms), 0.65);
}

TEST(Pace, WaitsForALostRunNoLongerThanADay) {
  const Pace pace(kBegin);
  EXPECT_EQ(pace.until(std::numeric_limits<double>::infinity(), kBegin), 24h);
}

// A lag counts in seconds of the wall clock, at every speed.
TEST(Pace, GivesUpALagButNotAShortOne) {
  for (const double speed : {0.5, 1.0, 20.0}) {
    Pace pace(kBegin);
    pace.set_speed(speed);
    pace.begin(0.0, kBegin);
    pace.give_up_lag(speed * 0.91, speed * 1.0, kBegin + 1s);
    EXPECT_DOUBLE_EQ(pace.due(kBegin + 1s), speed * 1.0) << "it is caught up";
    pace.give_up_lag(speed * 0.8, speed * 1.0, kBegin + 1s);
    EXPECT_DOUBLE_EQ(pace.due(kBegin + 1s), speed * 0.8) << "it is given up";
    EXPECT_DOUBLE_EQ(pace.due(kBegin + 2s), speed * 1.8);
  }
}

TEST(Pace, IsMeasuredOverHalfASecond) {
  Pace pace(kBegin);
  pace.begin_measurement(10.0, kBegin);
  pace.measure(10.4, kBegin + 500ms);
  EXPECT_EQ(pace.reached(), 0.0) << "not known yet";
  pace.measure(10.9, kBegin + 600ms);
  EXPECT_DOUBLE_EQ(pace.reached(), 1.5);
  // The next measurement begins there, and until its end this one holds.
  pace.measure(11.0, kBegin + 1000ms);
  EXPECT_DOUBLE_EQ(pace.reached(), 1.5);
  pace.measure(11.4, kBegin + 1200ms);
  EXPECT_NEAR(pace.reached(), 0.5 / 0.6, 1e-12);
}

// Neither a pause nor the run before counts.
TEST(Pace, IsMeasuredAnew) {
  Pace pace(kBegin);
  pace.set_speed(20.0);
  pace.begin_measurement(0.0, kBegin);
  pace.measure(12.0, kBegin + 600ms);
  EXPECT_DOUBLE_EQ(pace.reached(), 20.0);
  pace.begin_measurement(0.0, kBegin + 10s);
  EXPECT_EQ(pace.reached(), 0.0);
  pace.measure(0.3, kBegin + 10300ms);
  EXPECT_EQ(pace.reached(), 0.0);
  pace.measure(0.6, kBegin + 10600ms);
  EXPECT_DOUBLE_EQ(pace.reached(), 1.0);
}

}  // namespace
}  // namespace carom
