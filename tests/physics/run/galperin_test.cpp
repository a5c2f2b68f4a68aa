#include <gtest/gtest.h>

#include "physics/ledger/step_limits.h"
#include "physics/run/run_setup.h"
#include "tests/support/scenes.h"

namespace carom {
namespace {

using test::disc;
using test::setup_with;
using test::wall;

Method exact_flight(double step) {
  return {IntegratorId::kExactFlight, ImpactsId::kLocated, ContactsId::kImpulse, step};
}

// G. Galperin, Regular and Chaotic Dynamics 8 (2003) 375: the number of impacts of a heavy disc, a light disc
// and a wall has the digits of pi.
TEST(Galperin, CountsAreExact) {
  double mass = 1.0;
  for (const std::int64_t digits : {3, 31, 314, 3141, 31415, 314159, 3141592}) {
    RunSetup s =
        setup_with({wall("wall", {-0.1, 0.0}, 0.2, 1.4), disc("light", {0.6, 0.0}, {0.0, 0.0}, 0.1, 1.0),
                    disc("heavy", {1.5, 0.0}, {-0.5, 0.0}, 0.3, mass)});
    s.method = exact_flight(0.005);
    Simulation run(s);
    run.advance_to(12.0);
    EXPECT_EQ(run.impact_count(), digits) << mass;
    EXPECT_EQ(run.notices().resting_since, -1.0) << mass;
    EXPECT_EQ(run.notices().collapsed_since, -1.0) << mass;
    EXPECT_EQ(run.notices().impacts_capped_since, -1.0) << mass;
    // Nearly all of the last run's impacts occur within 10 µs, more than the log of a step keeps.
    if (digits < static_cast<std::int64_t>(kMostLogged)) {
      EXPECT_EQ(run.notices().text(), "ok") << mass;
    }
    EXPECT_NEAR(run.totals().kinetic() / run.ledger().initial, 1.0, 1e-9) << mass;
    // They separate for good, and the light disc does not catch up with the heavy one.
    EXPECT_LE(std::abs(run.state().velocity(1).x()), run.state().velocity(2).x()) << mass;
    mass *= 100.0;
  }
}

RunSetup three_in_a_row(double restitution, double radius) {
  RunSetup s = setup_with({disc("left", {-1.0 - 2.0 * radius, 0.0}, {1.0, 0.0}, radius),
                           disc("middle", {0.0, 0.0}, {0.0, 0.0}, radius),
                           disc("right", {1.0 + 2.0 * radius, 0.0}, {-0.4, 0.0}, radius)},
                          restitution);
  s.method = exact_flight(0.005);
  return s;
}

// B. Bernu and R. Mazighi, Journal of Physics A 23 (1990) 5745: three equal points collapse where e < 7 - 4 √3
// = 0.0718.
TEST(InelasticCollapse, EndsInWords) {
  for (const double radius : {1e-9, 0.1}) {
    for (const double restitution : {0.0, 0.05, 0.0717}) {
      Simulation run(three_in_a_row(restitution, radius));
      run.advance_to(10.0);
      if (restitution == 0.05) {
        EXPECT_GE(run.impact_count(), 20) << radius;
        EXPECT_LE(run.impact_count(), 80) << radius;
      }
      EXPECT_LT(run.impact_count(), 500) << restitution;
      if (restitution > 0.0) {
        EXPECT_NE(run.notices().text().find("collapse"), std::string::npos) << run.notices().text();
      }
      for (const int i : {0, 1, 2}) EXPECT_NEAR(run.state().velocity(i).x(), 0.2, 1e-11) << restitution << i;
    }
    for (const double restitution : {0.08, 0.5, 1.0}) {
      Simulation run(three_in_a_row(restitution, radius));
      run.advance_to(20.0);
      EXPECT_EQ(run.notices().text(), "ok") << restitution;
      EXPECT_LT(run.state().velocity(0).x(), run.state().velocity(1).x() - 1e-9) << restitution;
      EXPECT_LT(run.state().velocity(1).x(), run.state().velocity(2).x() - 1e-9) << restitution;
    }
  }
}

// A disc between a wall and a piston that does not stop: every motion penetrates, so the run must report it
// and continue.
TEST(Crushed, EndsInWords) {
  Body piston = wall("piston", {-1.1, 0.0}, 0.2, 1.0);
  piston.fixed = false;
  piston.drive = Drive{{1.0, 0.0}, {0.0, 0.0}, 0.0, 0.0};
  RunSetup s = setup_with({wall("wall", {1.1, 0.0}, 0.2, 1.0), piston, disc("disc", {0.0, 0.0}, {1.0, 0.0})});
  s.method = exact_flight(0.01);
  Simulation run(s);
  run.advance_to(1.79);
  EXPECT_EQ(run.notices().text(), "ok");
  run.advance_to(1.81);
  EXPECT_NEAR(run.notices().impacts_capped_since, 1.8, 1e-6);
  EXPECT_TRUE(run.state().q.allFinite() && run.state().v.allFinite());
}

// A disc that starts inside two walls is thrown from one into the other, all at one time.
TEST(Crushed, BetweenTwoWallsItEndsInWordsToo) {
  RunSetup s = setup_with({wall("left", {-1.0, 0.0}, 1.2, 1.0), wall("right", {1.0, 0.0}, 1.2, 1.0),
                           disc("disc", {0.0, 0.0}, {1.0, 0.0}, 0.45)});
  s.method = exact_flight(0.01);
  Simulation run(s);
  run.step();
  EXPECT_EQ(run.notices().impacts_capped_since, 0.0);
  EXPECT_LT(run.impact_count(), 2 * kMostImpactsAtOnce);
  const std::int64_t first = run.impact_count();
  for (int i = 0; i < 20; ++i) run.step();
  EXPECT_LT(run.impact_count() - first, kMostImpactsAtOnce);
  EXPECT_TRUE(run.state().q.allFinite() && run.state().v.allFinite());
}

}  // namespace
}  // namespace carom
