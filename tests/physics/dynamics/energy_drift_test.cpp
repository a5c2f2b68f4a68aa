#include <cstdlib>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <random>

#include "physics/run/run_setup.h"
#include "tests/support/impacts.h"
#include "tests/support/scenes.h"

namespace carom {
namespace {

// 100 frictionless elastic discs of unlike size and mass in a room.
RunSetup hundred_discs() {
  std::vector<Body> bodies = test::room(1.0, 0.5);
  std::mt19937_64 random(7);
  const auto draw = [&] { return static_cast<double>(random() >> 11) * 0x1p-52 - 1.0; };
  for (int i = 0; i < 100; ++i) {
    bodies.push_back(test::disc(fmt::format("disc-{}", i), {-0.9 + 0.2 * (i % 10), -0.9 + 0.2 * (i / 10)},
                                {draw(), draw()}, 0.03 + 0.0004 * i, 1.0 + 0.01 * i));
  }
  RunSetup s = test::setup_with(std::move(bodies));
  s.method = {IntegratorId::kExactFlight, ImpactsId::kLocated, ContactsId::kImpulse, 0.1};
  return s;
}

// Momentum is a sum that the walls change at every impact with them, so its rounding is of the sum of all the
// impulses on the walls; energy never changes, so its rounding is of itself.
TEST(EnergyDrift, OfAMillionElasticImpactsIsRounding) {
  Simulation run(hundred_discs());
  const Totals start = run.totals();
  double to_walls = 0.0;
  ASSERT_TRUE(test::step_to_impact(run, 1'000'000, [&] {
    run.step();
    for (const ImpactRecord& r : run.last_impacts()) {
      if (run.shapes().fixed[r.a] != 0) to_walls += r.normal_impulse;
    }
  }));
  EXPECT_NEAR(run.totals().energy() / start.energy(), 1.0, 2e-13);
  EXPECT_LT(std::abs(run.ledger().numerical_drift(run.totals().energy())), 2e-13 * start.energy());
  EXPECT_LT(run.ledger().momentum_drift(run.totals().momentum).norm(), 1e-12 * to_walls);
  EXPECT_EQ(run.notices().text(), "ok");
  RecordProperty("energy", fmt::format("{}", run.totals().energy() / start.energy() - 1.0));
  RecordProperty("momentum",
                 fmt::format("{}", run.ledger().momentum_drift(run.totals().momentum).norm() / to_walls));
}

}  // namespace
}  // namespace carom
