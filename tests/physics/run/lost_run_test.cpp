#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "physics/collision/pair_contact.h"
#include "physics/dynamics/integrators/integrators.h"
#include "physics/preset/preset.h"
#include "physics/run/simulation.h"
#include "physics/scene/facts.h"
#include "tests/support/body_literal.h"
#include "tests/support/scenes.h"

// Runs that can't continue: they stay at the end of their last good step and report why.
namespace carom {
namespace {

using namespace test::literals;

using test::disc;

// A spring far too stiff for the step: every explicit method multiplies its amplitude in each step.
RunSetup stiff_spring(IntegratorId integrator) {
  RunSetup s = test::setup_with({disc("a", {1, 0}, {0, 0}), disc("b", {5, 0}, {0, 1})});
  Spring spring;
  spring.body = "a";
  spring.stiffness = 1e6;
  s.scene.forces.springs = {spring};
  s.method = {.integrator = integrator, .impacts = ImpactsId::kLocated, .step = 0.005};
  return s;
}

TEST(LostRun, StopsAtItsLastGoodStepWithTheReason) {
  for (const IntegratorId id :
       {IntegratorId::kExplicitEuler, IntegratorId::kSemiImplicitEuler, IntegratorId::kVelocityVerlet,
        IntegratorId::kRk4, IntegratorId::kDormandPrince}) {
    for (const ImpactsId impacts : {ImpactsId::kLocated, ImpactsId::kStepEnd}) {
      RunSetup s = stiff_spring(id);
      s.method.impacts = impacts;
      Simulation run(s);
      run.advance_to(5.0);
      ASSERT_TRUE(run.lost()) << choice_of(kIntegrators, id).name;
      EXPECT_LT(run.time(), 5.0);
      EXPECT_EQ(run.lost()->body, 0);
      EXPECT_GT(run.lost()->time, run.time() - 1e-12);
      EXPECT_NE(run.status().find("lost at t = "), std::string::npos);
      EXPECT_NE(run.status().find("\"a\""), std::string::npos);
      EXPECT_TRUE(run.state().q.allFinite() && run.state().v.allFinite() &&
                  run.state().quadratures.allFinite());

      // All results are those of a run that ends there.
      Simulation before(s);
      for (std::int64_t k = 0; k < run.steps(); ++k) before.step();
      EXPECT_FALSE(before.lost());
      EXPECT_EQ(run.state().q, before.state().q);
      EXPECT_EQ(run.state().v, before.state().v);
      EXPECT_EQ(run.totals().energy(), before.totals().energy());
      EXPECT_EQ(run.ledger().expected(), before.ledger().expected());
      EXPECT_EQ(run.impact_count(), before.impact_count());

      // Nothing changes it any more.
      run.step();
      run.set_method({.integrator = IntegratorId::kExactFlight});
      run.apply({Add<Body>{disc("c", {0, 3}, {0, 0})}});
      run.advance_to(6.0);
      EXPECT_EQ(run.time(), before.time());
      EXPECT_EQ(run.state().q, before.state().q);
    }
  }
}

TEST(LostRun, AStepThatResolvesTheSpringIsNotLost) {
  RunSetup s = stiff_spring(IntegratorId::kRk4);
  s.method.step = 5e-4;
  Simulation run(s);
  run.advance_to(0.1);
  EXPECT_FALSE(run.lost());
  EXPECT_EQ(run.status(), "ok");
}

TEST(LostRun, FarIsNoLoss) {
  // Fast, but every digit is significant.
  RunSetup s = test::setup_with({disc("a", {0, 0}, {1e9, 0})});
  s.method = {.integrator = IntegratorId::kExactFlight, .step = 1.0};
  Simulation run(s);
  run.advance_to(1000.0);
  EXPECT_FALSE(run.lost());
  EXPECT_NEAR(run.state().position(0).x(), 1e12, 100.0);  // 250 thousand trajectories, each rounded once
}

// A method that can't keep its tolerance reports it instead of stepping for ever.
TEST(LostRun, TheAdaptiveMethodSaysThatItNeedsTooManySteps) {
  RunSetup s = test::setup_with({disc("a", {0, 0}, {1, 0})});
  s.scene.forces.linear_drag = 1e12;
  s.method = {.integrator = IntegratorId::kAdaptiveDormandPrince, .step = 0.005, .tolerance = 1e-12};
  Simulation run(s);
  run.advance_to(0.2);
  ASSERT_TRUE(run.lost());
  EXPECT_EQ(run.lost()->reason, LossReason::kTooManySteps);
  EXPECT_NE(run.status().find("tolerance"), std::string::npos);
  EXPECT_EQ(run.time(), 0.0);
}

// Forces so strong that coordinates become infinite or NaN within a step.
TEST(LostRun, CoordinatesThatAreNoNumbersEndNoProgram) {
  std::vector<RunSetup> scenes;
  RunSetup drag = test::setup_with({disc("A", {0, 0.5}, {1, 3}), disc("B", {0.5, 0.6}, {-1, 1})});
  drag.scene.bodies[0].shape = Box{0.2, 0.1};
  drag.scene.bodies[1].shape = Polygon{{{0, 0}, {0.2, 0}, {0.1, 0.2}}};
  scenes.push_back(drag);
  scenes.back().scene.forces.quadratic_drag = 30.0;
  scenes.push_back(drag);
  scenes.back().scene.forces.gravity = {0, -1e12};
  scenes.push_back(drag);
  Spring spring;
  spring.body = "A";
  spring.to = "B";
  spring.stiffness = 100.0;
  spring.rest_length = 1e12;
  scenes.back().scene.forces.springs = {spring};
  for (RunSetup s : scenes) {
    for (const IntegratorChoice& integrator : kIntegrators) {
      if (why_not(s.scene, integrator.id)) continue;
      for (const ImpactsId impacts : {ImpactsId::kLocated, ImpactsId::kStepEnd}) {
        for (const ContactsId contacts : {ContactsId::kImpulse, ContactsId::kLasting}) {
          s.method = {.integrator = integrator.id, .impacts = impacts, .contacts = contacts, .step = 0.05};
          Simulation run(s);
          run.advance_to(2.0);
          EXPECT_TRUE(run.state().q.allFinite() && run.state().v.allFinite());
          EXPECT_TRUE(run.lost() || std::abs(run.time() - 2.0) < 1e-9);
        }
      }
    }
  }
}

TEST(LostRun, PosesThatAreNoNumbersLieNowhereNear) {
  RunSetup s = test::setup_with({disc("a", {0, 0}, {0, 0}), disc("b", {1, 0}, {0, 0})});
  s.scene.bodies[0].shape = Polygon{{{0, 0}, {0.2, 0}, {0.1, 0.2}}};
  s.scene.bodies[1].shape = Polygon{{{0, 0}, {0.2, 0}, {0.1, 0.2}}};
  const Geometry g = geometry(s.scene.bodies, {});
  const double nan = std::nan("");
  EXPECT_FALSE(contact_between(g, 0_b, {nan, 0, 0}, 1_b, {1, 0, 0}).gap <= 0.0);
  EXPECT_FALSE(contact_between(g, 0_b, {0, 0, 0}, 1_b, {1, nan, nan}).gap <= 0.0);
}

// Reported before the run is lost, and also where impacts keep it bounded.
TEST(LostRun, EnergyThatTheMethodMakesIsSaid) {
  for (const IntegratorId id : {IntegratorId::kExplicitEuler, IntegratorId::kSemiImplicitEuler,
                                IntegratorId::kVelocityVerlet, IntegratorId::kRk4}) {
    Simulation run(stiff_spring(id));
    run.step();
    run.step();
    run.step();
    EXPECT_FALSE(run.lost());
    EXPECT_NE(run.status().find("comes from the method's error"), std::string::npos)
        << choice_of(kIntegrators, id).name;
    EXPECT_LE(run.notices().energy_made_since, 0.015);
  }
}

TEST(LostRun, EnergyThatTheSceneHasIsNotTheMethods) {
  // Falls 20 m, bounces and comes to rest; and an oscillation under a method that keeps its energy bounded.
  RunSetup falls = test::setup_with({disc("a", {0, 20}, {1, 0}), test::wall("floor", {0, -1}, 80, 2)}, 0.5);
  falls.scene.forces.gravity = {0, -9.81};
  RunSetup swings = stiff_spring(IntegratorId::kVelocityVerlet);
  swings.scene.forces.springs[0].stiffness = 100.0;
  for (RunSetup s : {falls, swings}) {
    for (const ContactsId contacts : {ContactsId::kImpulse, ContactsId::kLasting}) {
      s.method.contacts = contacts;
      s.method.step = 0.01;
      Simulation run(s);
      run.advance_to(20.0);
      EXPECT_LT(run.notices().energy_made_since, 0.0) << run.status();
    }
  }
}

// What friction almost balances: in the first steps from rest the Euler methods' error is larger than the
// energy that a body has got, at any step.
TEST(LostRun, FirstStepsFromRestUnderFrictionAreNoTrouble) {
  for (const IntegratorId id : {IntegratorId::kExplicitEuler, IntegratorId::kSemiImplicitEuler}) {
    for (const double slope : {0.0, 0.3, 0.5}) {
      for (const double step : {1.0 / 60.0, 1.0 / 240.0, 0.001}) {
        RunSetup s = test::setup_with(
            {test::wall("floor", {0.0, -0.5}, 100.0, 1.0), test::disc("box", {0.0, 0.05}, {0.0, 0.0})}, 0.0,
            0.3);
        s.scene.bodies[1].shape = Box{0.3, 0.1};
        s.scene.forces.gravity = {9.81 * std::sin(slope), -9.81 * std::cos(slope)};
        AppliedForce pull;
        pull.body = "box";
        pull.force = {8.0, 0.0};
        if (slope == 0.0) s.scene.forces.applied = {pull};
        s.method = {id, ImpactsId::kLocated, ContactsId::kLasting, step};
        Simulation run(s);
        run.advance_to(1.0);
        EXPECT_EQ(run.status(), "ok") << choice_of(kIntegrators, id).name << ", slope " << slope << ", h "
                                      << step;
      }
    }
  }
}

}  // namespace
}  // namespace carom
