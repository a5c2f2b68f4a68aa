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

TEST(ImpactScout, AnImpactStandsOutUnlessEachStepHasOne) {
  EXPECT_FALSE(stands_out(std::vector<double>{}, 0.0, 0.1, 0.01));
  EXPECT_FALSE(stands_out(std::vector{0.2}, 0.0, 0.1, 0.01)) << "later";
  EXPECT_TRUE(stands_out(std::vector{0.05}, 0.0, 0.1, 0.01));
  EXPECT_TRUE(stands_out(std::vector{0.05, 0.051, 0.052}, 0.0, 0.1, 0.01));
  std::vector<double> each;
  for (int i = 0; i < 10; ++i) each.push_back(0.01 * i + 0.005);
  EXPECT_FALSE(stands_out(each, 0.0, 0.1, 0.01));
  EXPECT_TRUE(stands_out(std::vector{0.05}, 0.0, 0.1, 0.05)) << "of two steps little is to be said";
}

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
    const bool slow = scout.near_impact(run, ImpactScout::Clock::now() + 10s);
    EXPECT_EQ(slow, std::abs(run.time() - 0.5) <= kNearImpact) << run.time();
    near += slow ? 1 : 0;
    run.step();
  }
  EXPECT_NEAR(near, 50, 1);
  EXPECT_EQ(run.simulation().impact_count(), 1) << "the run itself is not touched";
}

TEST(ImpactScout, FollowsAnEditOfTheRun) {
  RunSetup setup = head_on();
  give_ids(setup.scene);
  LiveRun run(setup, {}, ReferenceId::kNone);
  ImpactScout scout;
  while (run.time() < 0.47) run.step();
  EXPECT_TRUE(scout.near_impact(run, ImpactScout::Clock::now() + 10s));
  run.edit({.time = run.time(), .what = SceneEdits{Remove<Body>{setup.scene.bodies[1].id}}});
  run.step();
  EXPECT_FALSE(scout.near_impact(run, ImpactScout::Clock::now() + 10s));
}

TEST(ImpactScout, GivesUpAtItsDeadline) {
  LiveRun run(head_on(), {}, ReferenceId::kNone);
  while (run.time() < 0.47) run.step();
  ImpactScout scout;
  EXPECT_FALSE(scout.near_impact(run, ImpactScout::Clock::now() - 1s)) << "nothing is known yet";
  EXPECT_TRUE(scout.near_impact(run, ImpactScout::Clock::now() + 10s));
}

}  // namespace
}  // namespace carom
