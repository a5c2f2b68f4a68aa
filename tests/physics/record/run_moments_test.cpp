#include <array>
#include <gtest/gtest.h>
#include <span>

#include "physics/record/frame.h"
#include "physics/record/replay.h"
#include "tests/support/scenes.h"

namespace carom {
namespace {

using test::disc;
using test::room;

constexpr double kSpan = 0.25;  // s
const auto kGoOn = [](double) { return true; };

// Two discs in a box, to which a third comes after 30 steps, and another method after 60.
RunSetup edited_run() {
  std::vector<Body> bodies = room(1.0, 0.5);
  bodies.push_back(disc("a", {-0.5, 0.1}, {3.0, 1.0}));
  bodies.push_back(disc("b", {0.5, -0.1}, {-2.0, 2.0}));
  RunSetup setup = test::setup_with(std::move(bodies), 0.9, 0.2);
  setup.scene.forces.gravity = {0.0, -9.81};
  setup.method.step = 0.01;
  Method other = setup.method;
  other.integrator = IntegratorId::kVelocityVerlet;
  other.step = 0.004;
  setup.edits = {{0.3, 0, SceneEdits{Add<Body>{disc("c", {0.0, 0.3}, {0.5, 0.5})}}}, {0.6, 0, other}};
  return setup;
}

std::vector<Frame> moments(const RunSetup& setup, const std::vector<double>& times) {
  std::vector<Frame> frames;
  const auto keep = [&](std::span<const Frame> moment) {
    frames.push_back(moment.front());
    return true;
  };
  EXPECT_TRUE(visit_moments(std::array{setup}, times, kSpan, keep, kGoOn));
  return frames;
}

// At steps' ends the bits are those of the run; between them a look changes nothing that follows.
TEST(RunMoments, AreThoseOfTheRun) {
  const RunSetup setup = edited_run();
  Replay replay(setup);
  const auto run_to = [&](std::int64_t steps) {
    replay.go_through([](const RunEdit&) {}, [&](const Simulation& s) { return s.steps() < steps; },
                      [](const Simulation&) {});
    return replay.simulation();
  };
  const Simulation at_30 = run_to(30);
  const Simulation at_100 = run_to(100);
  const std::vector<Frame> frames = moments(setup, {0.0, 0.1234, 0.3, 0.3, 0.55551, 0.6 + 40 * 0.004});
  ASSERT_EQ(frames.size(), 6U);
  EXPECT_EQ(frames[0].steps, 0);
  EXPECT_DOUBLE_EQ(frames[1].time, 0.1234);
  EXPECT_EQ(frames[2].state.q, at_30.state().q);
  EXPECT_EQ(frames[3].state.q, at_30.state().q);
  EXPECT_EQ(frames[2].bodies->size(), setup.scene.bodies.size() + 1) << "a body stands there at once";
  EXPECT_EQ(frames[5].steps, 100);
  EXPECT_EQ(frames[5].state.q, at_100.state().q);
  EXPECT_EQ(frames[5].state.v, at_100.state().v);
  EXPECT_EQ(frames[5].impact_count, at_100.impact_count());
}

// Between two steps: what a run that ends there has.
TEST(RunMoments, BetweenStepsIsAStepOfTheMethod) {
  RunSetup setup = edited_run();
  setup.edits.clear();
  Simulation run(setup);
  run.advance_to(0.2345);
  const Frame frame = moments(setup, {0.2345}).front();
  EXPECT_EQ(frame.state.q, run.state().q);
  EXPECT_EQ(frame.time, run.time());
}

TEST(RunMoments, HaveTheImpactsOfLate) {
  const RunSetup setup = edited_run();
  std::vector<double> times;
  for (int i = 1; i <= 200; ++i) times.push_back(0.0083 * i);
  std::size_t seen = 0;
  for (const Frame& frame : moments(setup, times)) {
    for (const ImpactRecord& i : frame.impacts) {
      EXPECT_LE(i.time, frame.time);
      EXPECT_GT(i.time, frame.time - kSpan - setup.method.step);
      ++seen;
    }
  }
  EXPECT_GT(seen, 100U);
}

// Each at its own steps, all at the same times.
TEST(RunMoments, OfSeveralRunsStandSideBySide) {
  std::array<RunSetup, 2> runs{edited_run(), edited_run()};
  runs[1].method.integrator = IntegratorId::kExplicitEuler;
  runs[1].method.step = 0.003;
  runs[1].edits.clear();
  const std::vector<double> times{0.1, 0.35, 0.7};
  const std::vector<Frame> first = moments(runs[0], times);
  const std::vector<Frame> second = moments(runs[1], times);
  std::size_t shown = 0;
  const auto compare = [&](std::span<const Frame> both) {
    EXPECT_EQ(both.size(), 2U);
    EXPECT_EQ(both[0].state.q, first[shown].state.q);
    EXPECT_EQ(both[1].state.q, second[shown].state.q);
    EXPECT_EQ(both[1].time, second[shown].time);
    ++shown;
    return true;
  };
  EXPECT_TRUE(visit_moments(runs, times, kSpan, compare, kGoOn));
  EXPECT_EQ(shown, 3U);
}

TEST(RunMoments, StopWhereCancelled) {
  double last = -1.0;
  int shown = 0;
  const std::vector<double> times{0.1, 0.5, 1.0};
  const auto count = [&](std::span<const Frame>) { return ++shown < 3; };
  EXPECT_FALSE(visit_moments(std::array{edited_run()}, times, kSpan, count, [&](double time) {
    EXPECT_GT(time, last);
    last = time;
    return time < 0.3;
  }));
  EXPECT_EQ(shown, 1);
  shown = 0;
  EXPECT_FALSE(visit_moments(std::array{edited_run()}, std::vector<double>(10, 0.1), kSpan, count, kGoOn));
  EXPECT_EQ(shown, 3);
}

TEST(RunMoments, KeepTheNewestThousand) {
  std::vector<ImpactRecord> kept(600);
  for (ImpactRecord& i : kept) i.time = 1.0;
  kept.front().time = 0.7;
  kept.back().time = 1.3;
  std::vector<ImpactRecord> fresh(700);
  for (std::size_t i = 0; i < fresh.size(); ++i) fresh[i].time = 1.1;
  keep_recent(kept, fresh, 1.1, 0.25);
  ASSERT_EQ(kept.size(), kMostRecent);
  EXPECT_EQ(kept.front().time, 1.0);
  EXPECT_EQ(kept[299].time, 1.0);
  EXPECT_EQ(kept[300].time, 1.1);
}

}  // namespace
}  // namespace carom
