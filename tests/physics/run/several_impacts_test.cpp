#include <fmt/format.h>
#include <gtest/gtest.h>

#include "physics/run/run_setup.h"
#include "tests/support/impacts.h"
#include "tests/support/scenes.h"

// Several contacts at one time, under both choices of a scene, and the law of eccentric impacts.
namespace carom {
namespace {

using test::disc;

RunSetup three(SeveralImpactsId several, double restitution = 1.0) {
  RunSetup s = test::setup_with({disc("left", {-0.8, 0.0}, {1.0, 0.0}), disc("middle", {0.0, 0.0}, {0.0, 0.0}),
                                 disc("right", {0.2, 0.0}, {0.0, 0.0})},
                                restitution);
  s.scene.several_impacts = several;
  return s;
}

TEST(SeveralImpacts, TwoLawsKeepMomentumAndEnergy) {
  for (const IntegratorId integrator : {IntegratorId::kRk4, IntegratorId::kExactFlight}) {
    RunSetup s = three(SeveralImpactsId::kPairwise);
    s.method.integrator = integrator;
    Simulation pairwise(s);
    pairwise.advance_to(1.0);
    EXPECT_NEAR(pairwise.state().v(0, 2), 1.0, 1e-14);
    EXPECT_NEAR(pairwise.state().v(0, 0), 0.0, 1e-14);

    s = three(SeveralImpactsId::kSimultaneous);
    s.method.integrator = integrator;
    Simulation at_once(s);
    at_once.advance_to(1.0);
    EXPECT_NEAR(at_once.state().v(0, 0), -1.0 / 3.0, 1e-14);
    EXPECT_NEAR(at_once.state().v(0, 1), 2.0 / 3.0, 1e-14);
    EXPECT_NEAR(at_once.state().v(0, 2), 2.0 / 3.0, 1e-14);
    EXPECT_EQ(at_once.impact_count(), 2);
    EXPECT_NEAR(at_once.ledger().numerical_drift(at_once.totals().energy()), 0.0, 1e-15);
    EXPECT_EQ(at_once.notices().text(), "ok");
  }
}

// A ball falls onto two that lie side by side on the floor: mirror symmetric under the simultaneous law, but
// not pair by pair.
TEST(SeveralImpacts, KeepASymmetry) {
  Body floor = test::wall("floor", {0.0, -0.5}, 4.0, 1.0);
  RunSetup s = test::setup_with({floor, disc("a", {-0.1, 0.1}, {0.0, 0.0}), disc("b", {0.1, 0.1}, {0.0, 0.0}),
                                 disc("top", {0.0, 1.0}, {0.0, -1.0})},
                                0.8);
  s.scene.several_impacts = SeveralImpactsId::kSimultaneous;
  s.method.integrator = IntegratorId::kExactFlight;
  Simulation run(s);
  run.advance_to(1.0);
  EXPECT_NEAR(run.state().v(0, 1), -run.state().v(0, 2), 1e-13);
  EXPECT_NEAR(run.state().v(0, 3), 0.0, 1e-13);
  EXPECT_LT(run.state().v(0, 1), -0.1);
  EXPECT_NEAR(run.ledger().numerical_drift(run.totals().energy()), 0.0, 1e-13);
}

// The log and its jumps stay parallel where a cluster adds several entries.
TEST(SeveralImpacts, EachEntryHasItsJump) {
  Simulation run(three(SeveralImpactsId::kSimultaneous, 0.5));
  run.watch_impacts(true);
  ASSERT_TRUE(test::step_to_impact(run, 1));
  ASSERT_EQ(run.last_impacts().size(), 2U);
  ASSERT_EQ(run.last_jumps().size(), 2U);
  EXPECT_NEAR(run.totals_of(run.last_jumps()[0].before).kinetic(), 0.5, 1e-15);
  EXPECT_NEAR(run.totals_of(run.last_jumps()[1].after).kinetic(), 0.25, 1e-15);
  EXPECT_NEAR(run.ledger().lost_to_restitution, 0.25, 1e-15);
}

// A rod thrown against the floor with friction: Newton's law may gain energy and then reports it; the
// energetic law never does.
TEST(ImpactLaw, NewtonReportsTheEnergyGained) {
  int gained = 0;
  for (int k = 0; k < 200; ++k) {
    Body floor = disc("floor", {0.0, 0.0}, {0.0, 0.0});
    floor.shape = Wall{};
    floor.mass.reset();
    floor.fixed = true;
    Body rod = disc("rod", {0.0, 1.0}, {-3.0 + 0.03 * k, -1.0});
    rod.shape = Wall{1.0};
    rod.angle = 1.1;
    RunSetup s = test::setup_with({floor, rod}, 0.9, 0.6);
    for (const ImpactLawId law : {ImpactLawId::kNewton, ImpactLawId::kEnergetic}) {
      s.scene.impact_law = law;
      s.method.integrator = IntegratorId::kExactFlight;
      Simulation run(s);
      while (run.impact_count() == 0 && run.time() < 5.0) run.step();
      ASSERT_GE(run.impact_count(), 1);
      const double before = run.ledger().initial;
      const double gain = run.totals().energy() - before;
      EXPECT_NEAR(run.ledger().numerical_drift(run.totals().energy()), 0.0, 1e-13 * before);
      if (law == ImpactLawId::kEnergetic) {
        EXPECT_LE(gain, 1e-12 * before) << k;
        EXPECT_EQ(run.notices().gained, 0.0);
      } else if (run.impact_count() == 1 && gain > 1e-9 * before) {
        ++gained;
        EXPECT_NEAR(run.notices().gained, gain, 1e-12 * before);
        EXPECT_NE(run.notices().text().find("gained energy"), std::string::npos);
      }
    }
  }
  EXPECT_GT(gained, 0);
}

}  // namespace
}  // namespace carom
