#include "physics/worker/impact_scout.h"

#include <chrono>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "physics/run/run_setup.h"
#include "physics/scene/edit.h"
#include "tests/support/scenes.h"

namespace carom {
namespace {

using namespace std::chrono_literals;

// At 0.5 s, of a run with a step of `h` whose steps end at multiples of it.
bool near(const std::vector<double>& impacts, double h, double from = 0.0, double to = 1.0) {
  return near_impact({impacts, from, to, h, 0.0}, 0.5);
}

TEST(NearImpact, IsWithin50MillisecondsOfIt) {
  EXPECT_FALSE(near({}, 0.01));
  EXPECT_FALSE(near({0.44, 0.56}, 0.01));
  EXPECT_TRUE(near({0.46}, 0.01));
  EXPECT_TRUE(near({0.54}, 0.01));
  EXPECT_TRUE(near({0.5, 0.501, 0.502, 0.503}, 0.01));
  EXPECT_FALSE(near({0.46}, 0.01, 0.48)) << "it is not known";
  EXPECT_TRUE(near({0.5}, 0.08)) << "of one step little is to be said";
}

// Bodies at rest under impulses alone, whose impacts are at the ends of steps or on the way.
TEST(NearImpact, IsNotWhereNearlyEachStepHasOne) {
  for (const double h : {0.001, 0.002, 1.0 / 240.0, 0.005, 0.01, 1.0 / 60.0, 0.025}) {
    for (const double share : {0.5, 1.0}) {
      std::vector<double> each;
      for (int k = 0; k * h < 1.0; ++k) each.push_back((k + share) * h);
      EXPECT_FALSE(near(each, h)) << h;
      EXPECT_FALSE(near(each, h, 0.5)) << h << ", from its start on";
      EXPECT_FALSE(near(each, h, 0.0, 0.5)) << h << ", until its end";
    }
  }
}

TEST(NearImpact, IsFreeUntilThen) {
  const std::vector<double> impacts = {0.2, 0.9};
  const KnownImpacts known{impacts, 0.0, 2.0, 0.01, 0.0};
  EXPECT_EQ(free_until(known, 0.5, 0.7, 0.01), 0.7);
  EXPECT_NEAR(free_until(known, 0.5, 1.5, 0.01).value(), 0.85, 1e-12) << "not beyond it";
  EXPECT_FALSE(free_until(known, 0.845, 0.846, 0.01)) << "less than a step before";
  EXPECT_FALSE(free_until(known, 0.9, 1.5, 0.01));
  EXPECT_EQ(free_until(known, 0.96, 1.5, 0.01), 1.5);
  EXPECT_EQ(free_until(known, 0.5, 0.4, 0.01), 0.4);
}

ImpactScout::Clock::time_point soon() { return ImpactScout::Clock::now() + 10s; }

// Two discs that close a gap of 1 m at 2 m/s meet after 0.5 s.
RunSetup head_on() {
  return test::setup_with({test::disc("a", {-0.6, 0.0}, {1.0, 0.0}), test::disc("b", {0.6, 0.0}, {-1.0, 0.0})});
}

TEST(ImpactScout, KnowsOfAnImpactBeforeItComesAndForAWhileAfterIt) {
  RunSetup setup = head_on();
  setup.method.step = 0.002;
  LiveRun run(setup, {}, ReferenceId::kNone);
  ImpactScout scout;
  int near = 0;
  while (run.time() < 1.0) {
    const auto known = scout.look(run, run.time(), soon());
    ASSERT_TRUE(known);
    const bool slow = near_impact(*known, run.time());
    EXPECT_EQ(slow, std::abs(run.time() - 0.5) <= kNearImpact) << run.time();
    near += slow ? 1 : 0;
    run.step();
  }
  EXPECT_NEAR(near, 50, 1);
  EXPECT_EQ(run.simulation().impact_count(), 1) << "the run itself is not touched";
}

TEST(ImpactScout, LooksAsFarAsTheRunIsToGo) {
  const LiveRun run(head_on(), {}, ReferenceId::kNone);
  ImpactScout scout;
  const auto known = scout.look(run, 0.8, soon());
  ASSERT_TRUE(known);
  EXPECT_NEAR(free_until(*known, 0.0, 0.8, 0.005).value(), 0.45, 1e-9);
}

TEST(ImpactScout, FollowsAnEditOfTheRun) {
  RunSetup setup = head_on();
  give_ids(setup.scene);
  LiveRun run(setup, {}, ReferenceId::kNone);
  ImpactScout scout;
  while (run.time() < 0.47) run.step();
  EXPECT_TRUE(near_impact(scout.look(run, run.time(), soon()).value(), run.time()));
  run.edit({.time = run.time(), .what = SceneEdits{Remove<Body>{setup.scene.bodies[1].id}}});
  run.step();
  EXPECT_FALSE(near_impact(scout.look(run, run.time(), soon()).value(), run.time()));
}

// A hand that pulls edits the run at every picture.
TEST(ImpactScout, KeepsWhatARunHasPassedThatIsEdited) {
  RunSetup setup = head_on();
  setup.method.step = 0.002;
  give_ids(setup.scene);
  LiveRun run(setup, {}, ReferenceId::kNone);
  ImpactScout scout;
  while (run.time() < 0.52) {
    static_cast<void>(scout.look(run, run.time(), soon()));
    run.step();
  }
  run.edit({.time = run.time(), .what = SceneEdits{Remove<Body>{setup.scene.bodies[1].id}}});
  EXPECT_TRUE(near_impact(scout.look(run, run.time(), soon()).value(), run.time()));
  while (run.time() < 0.56) run.step();
  EXPECT_FALSE(near_impact(scout.look(run, run.time(), soon()).value(), run.time()));
}

TEST(ImpactScout, KnowsNothingWhereItTakesTooLongAndPauses) {
  LiveRun run(head_on(), {}, ReferenceId::kNone);
  while (run.time() < 0.47) run.step();
  ImpactScout scout;
  for (int i = 0; i < 5; ++i) EXPECT_FALSE(scout.look(run, run.time(), ImpactScout::Clock::now() - 1s));
  EXPECT_FALSE(scout.look(run, run.time(), soon())) << "not asked now";
  for (int i = 0; i < 100; ++i) static_cast<void>(scout.look(run, run.time(), soon()));
  EXPECT_TRUE(scout.look(run, run.time(), soon()));
}

}  // namespace
}  // namespace carom
