#include "physics/observe/histogram.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>

#include "physics/preset/preset.h"
#include "physics/record/recorder.h"
#include "physics/worker/worker.h"
#include "tests/support/scenes.h"
#include "tests/support/threads.h"
#include "tests/support/wait.h"

namespace carom {
namespace {

TEST(Histogram, CountsWhatFallsIntoEachBin) {
  const std::vector<double> values = {0.0, 0.5, 0.5, 0.999, 1.0, 2.75, std::nan("")};
  const Histogram h = histogram_of(values, 0.5);
  EXPECT_EQ(h.counts, (std::vector<std::int64_t>{1, 3, 1, 0, 0, 1}));
  EXPECT_EQ(h.total, 6);
  EXPECT_DOUBLE_EQ(h.density(1), 3.0 / (6.0 * 0.5));
  EXPECT_DOUBLE_EQ(h.quantile(0.6), 1.0);
  EXPECT_DOUBLE_EQ(h.quantile(1.0), 3.0);
  EXPECT_TRUE(histogram_of({}, 0.5).counts.empty());
  EXPECT_EQ(histogram_of(std::vector<double>{0.0, 0.0}, 1.0).counts, std::vector<std::int64_t>{2});
}

TEST(Histogram, HasNoMoreThanSoManyBins) {
  const Histogram h = histogram_of(std::vector<double>{1e-3, 1e6}, 1e-3);
  EXPECT_LE(h.counts.size(), static_cast<std::size_t>(kMostBins));
  EXPECT_EQ(h.total, 2);
}

TEST(Histogram, BinsAreAsWideAsTheRulesSay) {
  std::vector<double> even(1001);
  for (std::size_t i = 0; i < even.size(); ++i) even[i] = static_cast<double>(i) / 1000.0;
  EXPECT_NEAR(bin_width(even), 2.0 * 0.5 / std::cbrt(1001.0), 1e-12);
  // More than half of the values are one: by their standard deviation.
  std::vector<double> one(100, 0.0);
  one[0] = 10.0;
  EXPECT_NEAR(bin_width(one), 3.49 * 1.0 / std::cbrt(100.0), 1e-12);
  EXPECT_EQ(bin_width(std::vector<double>(5, 3.0)), 0.0);
  EXPECT_EQ(bin_width({}), 0.0);
}

TEST(Histogram, BinsStandStillWhileTheValuesGoOn) {
  EXPECT_DOUBLE_EQ(steady_bin_width(0.0, 0.19), 0.2);
  EXPECT_DOUBLE_EQ(steady_bin_width(0.0, 7.5), 10.0);
  EXPECT_DOUBLE_EQ(steady_bin_width(0.0, 0.0), 1.0);
  double width = 0.2;
  for (const double wanted : {0.09, 0.4, 0.17, 0.48}) EXPECT_EQ(width = steady_bin_width(width, wanted), 0.2);
  EXPECT_DOUBLE_EQ(steady_bin_width(0.2, 0.07), 0.05);
  EXPECT_DOUBLE_EQ(steady_bin_width(0.2, 0.6), 0.5);
  EXPECT_DOUBLE_EQ(steady_bin_width(0.2, std::numeric_limits<double>::infinity()), 0.2);
}

TEST(Maxwell, HasTheGivenMeanEnergy) {
  const std::vector<double> masses = {1.0, 1.0, 4.0};
  const std::vector<double> speeds = {1.0, 3.0, 0.5};
  const Maxwell law(masses, speeds);
  EXPECT_DOUBLE_EQ(law.thermal_energy(), (0.5 + 4.5 + 0.5) / 3.0);
  // By the trapezoidal rule up to where nothing is left: it integrates to 1, and to its own distribution.
  double sum = 0.0;
  constexpr double kStep = 1e-3;
  for (int i = 0; i < 20'000; ++i) {
    EXPECT_NEAR(sum, law.share_below(i * kStep), 1e-6);
    sum += 0.5 * kStep * (law.density(i * kStep) + law.density((i + 1) * kStep));
  }
  EXPECT_NEAR(sum, 1.0, 1e-6);
  // f = (m v/kT) exp(-m v²/2kT) of one kind.
  const Maxwell one(std::vector<double>{2.0}, std::vector<double>{3.0});  // kT = 9 J
  EXPECT_NEAR(one.density(1.5), 2.0 * 1.5 / 9.0 * std::exp(-2.0 * 1.5 * 1.5 / 18.0), 1e-15);
  EXPECT_EQ(Maxwell(masses, std::vector<double>(3, 0.0)).density(1.0), 0.0);
  EXPECT_EQ(Maxwell().share_below(1.0), 0.0);
}

// A thousand discs with velocity components drawn evenly from ±1 m/s in a box of 8 by 8 m.
Preset gas() {
  Preset preset;
  preset.scene.materials = {{"default", 1.0}};
  preset.scene.bodies = test::room(4.0, 0.2);
  GridGenerator grid;
  grid.columns = 40;
  grid.rows = 25;
  grid.origin = {-3.8, -2.3};
  grid.spacing = {0.195, 0.19};
  grid.jitter = 0.02;
  grid.radius_min = grid.radius_max = 0.04;
  grid.speed_max = 1.0;
  grid.density = 200.0;
  preset.scene.generators = {grid};
  preset.method.integrator = IntegratorId::kExactFlight;
  preset.method.step = 0.05;
  return preset;
}

// Pearson's sum over the bins, those of an expectation below 5 with the one before; how many bins are left.
std::pair<double, int> chi_square(const Histogram& h, const Maxwell& law) {
  const auto n = static_cast<double>(h.total);
  std::vector<std::pair<double, double>> bins;  // found, expected
  double found = 0.0;
  double below = 0.0;
  for (std::size_t k = 0; k < h.counts.size(); ++k) {
    found += static_cast<double>(h.counts[k]);
    const double expected = n * (law.share_below(h.from(k + 1)) - below);
    if (expected < 5.0) continue;
    bins.emplace_back(found, expected);
    below = law.share_below(h.from(k + 1));
    found = 0.0;
  }
  bins.back().first += found;
  bins.back().second += n * (1.0 - below);
  double sum = 0.0;
  for (const auto& [o, e] : bins) sum += (o - e) * (o - e) / e;
  return {sum, static_cast<int>(bins.size())};
}

// The 99.9 % point of χ² with so many degrees of freedom, by Wilson and Hilferty (PNAS 17 (1931) 684).
double bound(int freedom) {
  const double a = 2.0 / (9.0 * freedom);
  return freedom * std::pow(1.0 - a + 3.09 * std::sqrt(a), 3);
}

// After some 60 impacts of each disc the speeds follow Maxwell's law; at the start they don't. One is fitted:
// kT.
TEST(Maxwell, IsWhatAGasOfManyDiscsRelaxesTo) {
  Simulation simulation(setup_of(gas()));
  simulation.watch_impacts(true);
  Sampler sampler({});
  sampler.begin(simulation);
  Recorder recorder;
  const auto look = [&] {
    Frame frame;
    frame.run = 1;
    take_moment(simulation, frame);
    frame.bodies = std::make_shared<const std::vector<Body>>(simulation.bodies());
    frame.rows = {sampler.take()};
    recorder.add(frame);
    const SpeedRecord& speeds = recorder.speeds();
    const Histogram h = histogram_of(speeds.now(), steady_bin_width(0.0, bin_width(speeds.now())));
    EXPECT_EQ(h.total, 1000);
    return chi_square(h, Maxwell(speeds.masses(), speeds.now()));
  };
  const auto [start, start_bins] = look();
  EXPECT_GT(start, 5.0 * bound(start_bins - 2));
  simulation.advance_to(20.0, [&] { sampler.after_step(simulation); });
  EXPECT_GT(simulation.impact_count(), 10'000);
  const auto [relaxed, bins] = look();
  EXPECT_GE(bins, 10);
  EXPECT_LT(relaxed, bound(bins - 2));

  // And the mean over moments that lie some 12 impacts of each disc apart.
  std::vector<double> many;
  const SpeedRecord& speeds = recorder.speeds();
  double next = 8.0;
  for (const SpeedMoment& m : speeds.moments()) {
    if (m.time < next) continue;
    next += 4.0;
    many.insert(many.end(), m.speeds.begin(), m.speeds.end());
  }
  ASSERT_GE(many.size(), 3000u);
  const Histogram h = histogram_of(many, steady_bin_width(0.0, bin_width(many)));
  const auto [sum, count] = chi_square(h, Maxwell(speeds.masses(), speeds.now()));
  EXPECT_LT(sum, bound(count - 2));
}

// Moments lie evenly over a run of any length, whatever the frames, and no more than so many.
TEST(SpeedRecord, KeepsMomentsAllOverTheRun) {
  EXPECT_EQ(moment_stride(0), 1);
  EXPECT_EQ(moment_stride(255), 1);
  EXPECT_EQ(moment_stride(256), 2);
  EXPECT_EQ(moment_stride(511), 2);
  EXPECT_EQ(moment_stride(512), 4);
  SpeedRecord record;
  for (std::int64_t step = 0; step <= 100'000; ++step) {
    if (is_moment(step)) record.add({step, 0.01 * static_cast<double>(step), {1.0F, static_cast<float>(step)}});
    ASSERT_LE(record.moments().size(), static_cast<std::size_t>(kMostMoments));
  }
  ASSERT_GE(record.moments().size(), static_cast<std::size_t>(kMostMoments / 2));
  const std::int64_t stride = moment_stride(100'000);
  for (std::size_t i = 0; i < record.moments().size(); ++i) {
    EXPECT_EQ(record.moments()[i].step, static_cast<std::int64_t>(i) * stride);
  }
  // What is known already, as a run that is gone through once more tells it, changes nothing.
  record.add({stride, 0.0, {7.0F}});
  EXPECT_EQ(record.moments()[1].speeds.size(), 2u);
  EXPECT_EQ(record.between(0.0, 0.01 * static_cast<double>(stride)).size(), 4u);
}

// A run that is watched, frame by frame, has the moments of one that is not, also after it was gone through
// once more for a plot that came late.
TEST(SpeedRecord, IsTheSameHoweverTheRunIsWatched) {
  Preset preset = gas();
  preset.scene.generators[0].columns = 4;
  preset.scene.generators[0].rows = 2;
  Worker worker(preset);
  Recorder recorder;
  const auto watch_until = [&](double time) {
    worker.run_until(time);
    ASSERT_TRUE(test::wait_until_other_threads_sleep());  // frames that nobody takes become one
    ASSERT_TRUE(test::wait_until([&] {
      for (const auto& frame : worker.take_frames()) recorder.add(*frame);
      return recorder.time() >= time - 1e-9;
    }));
    ASSERT_NEAR(recorder.time(), time, 1e-9);
  };
  watch_until(10.0);
  worker.record({{{find_observable("kinetic_energy"), {}}, std::nullopt}});
  watch_until(40.0);

  Simulation simulation(setup_of(preset));
  Sampler sampler({});
  sampler.begin(simulation);
  SpeedRecord alone;
  simulation.advance_to(40.0, [&] { sampler.after_step(simulation); });
  for (const SpeedMoment& moment : sampler.take().moments) alone.add(moment);
  ASSERT_EQ(recorder.speeds().moments().size(), alone.moments().size());
  EXPECT_EQ(alone.moments().size(), 201u);  // 800 steps, every fourth
  for (std::size_t i = 0; i < alone.moments().size(); ++i) {
    EXPECT_EQ(recorder.speeds().moments()[i].step, alone.moments()[i].step);
    EXPECT_EQ(recorder.speeds().moments()[i].speeds, alone.moments()[i].speeds);
  }
  EXPECT_EQ(recorder.speeds().now().size(), 8u);
}

}  // namespace
}  // namespace carom
