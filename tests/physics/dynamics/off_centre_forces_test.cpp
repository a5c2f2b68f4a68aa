#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

#include "physics/math/vectors.h"
#include "physics/run/simulation.h"
#include "physics/scene/facts.h"
#include "tests/support/body_literal.h"
#include "tests/support/fitted_order.h"
#include "tests/support/scenes.h"

// Springs and applied forces that act beside the centre of a body.
namespace carom {
namespace {

using namespace test::literals;
using test::box;
using test::disc;
using test::fixed;
using test::setup_with;

constexpr Method kExactly{.integrator = IntegratorId::kAdaptiveDormandPrince, .step = 0.01, .tolerance = 1e-13};

Spring spring_at(const std::string& body, const Vec2& point, double stiffness) {
  Spring spring;
  spring.body = body;
  spring.point = point;
  spring.stiffness = stiffness;
  return spring;
}

RunSetup free_bodies(std::vector<Body> bodies, const Method& method) {
  RunSetup setup = setup_with(std::move(bodies));
  setup.scene.forces.gravity.setZero();
  setup.method = method;
  return setup;
}

// s: the period of a pendulum whose small swings have the frequency omega (rad/s), from the angle `from` (rad).
double period_of_pendulum(double omega, double from) {
  return 4.0 / omega * std::comp_ellint_1(std::sin(0.5 * from));
}

// Springs without a length at rest, from the ends of a bar to points on its line on both sides: their forces on
// the centre cancel, their torques make it a pendulum with omega² = 2 k r a / I.
RunSetup bar_between_springs(const Method& method) {
  constexpr double kArm = 0.3;        // m
  constexpr double kAnchor = 0.8;     // m
  constexpr double kStiffness = 5.0;  // N/m
  Body bar = box("bar", {0.1, -0.2}, {0.0, 0.0}, 0.6, 0.1, 2.0);
  bar.angle = 1.2;
  RunSetup setup = free_bodies({bar}, method);
  for (const double side : {1.0, -1.0}) {
    Spring spring = spring_at("bar", {side * kArm, 0.0}, kStiffness);
    spring.anchor = bar.position + Vec2(side * kAnchor, 0.0);
    setup.scene.forces.springs.push_back(spring);
  }
  return setup;
}

double period_of_bar() {
  const double inertia = 2.0 * (0.6 * 0.6 + 0.1 * 0.1) / 12.0;
  return period_of_pendulum(std::sqrt(2.0 * 5.0 * 0.3 * 0.8 / inertia), 1.2);
}

TEST(OffCentreSprings, ABarBetweenTwoSwingsAsAPendulum) {
  Simulation run(bar_between_springs(kExactly));
  const double start = run.totals().kinetic() + run.totals().potential;
  run.advance_to(0.25 * period_of_bar());
  EXPECT_NEAR(run.state().q.col(0)[2], 0.0, 1e-10);
  run.advance_to(period_of_bar());
  EXPECT_NEAR(run.state().q.col(0)[2], 1.2, 1e-10);
  EXPECT_NEAR(run.state().v.col(0)[2], 0.0, 1e-9);
  EXPECT_NEAR((run.state().position(0_b) - Vec2(0.1, -0.2)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(run.totals().kinetic() + run.totals().potential, start, 1e-11);
}

TEST(OffCentreSprings, KeepTheOrderOfEachIntegrator) {
  struct Case {
    IntegratorId integrator;
    double order;
  };
  for (const auto& [integrator, order] : std::array<Case, 4>{{{IntegratorId::kExplicitEuler, 1.0},
                                                              {IntegratorId::kSemiImplicitEuler, 1.0},
                                                              {IntegratorId::kVelocityVerlet, 2.0},
                                                              {IntegratorId::kRk4, 4.0}}}) {
    std::vector<double> steps;
    std::vector<double> errors;
    for (int parts = 100; parts <= 800; parts *= 2) {
      steps.push_back(period_of_bar() / parts);
      Simulation run(bar_between_springs({.integrator = integrator, .step = steps.back()}));
      run.advance_to(0.25 * period_of_bar());
      errors.push_back(std::abs(run.state().q.col(0)[2]));
    }
    EXPECT_NEAR(test::fitted_order(steps, errors), order, 0.2) << static_cast<int>(integrator);
  }
}

// Bodies that turn under a damped spring between a point of each.
TEST(OffCentreSprings, BetweenTwoBodiesTheyKeepBothMomenta) {
  Body a = box("A", {0.0, 0.0}, {0.3, 0.1}, 0.4, 0.2, 1.5);
  a.spin = 2.0;
  Body b = disc("B", {1.0, 0.3}, {-0.4, 0.2}, 0.2, 0.7);
  b.spin = -3.0;
  RunSetup setup = free_bodies({a, b}, kExactly);
  Spring spring = spring_at("A", {0.2, 0.1}, 8.0);
  spring.to = "B";
  spring.anchor = Vec2(-0.1, 0.15);
  spring.rest_length = 0.5;
  spring.damping = 0.2;
  setup.scene.forces.springs = {spring};
  Simulation run(setup);
  const auto angular = [&] {
    const auto of = [&](BodyIndex i, double mass, double inertia) {
      return mass * cross(run.state().position(i), run.state().velocity(i)) + inertia * run.state().v.col(i)[2];
    };
    return of(0_b, 1.5, 1.5 * (0.16 + 0.04) / 12.0) + of(1_b, 0.7, 0.5 * 0.7 * 0.04);
  };
  const double before = angular();
  const double energy = run.totals().kinetic() + run.totals().potential;
  run.advance_to(2.0);
  EXPECT_NEAR(angular(), before, 1e-12);
  EXPECT_NEAR((1.5 * run.state().velocity(0_b) + 0.7 * run.state().velocity(1_b) - Vec2(0.17, 0.29)).norm(),
              0.0, 1e-12);
  EXPECT_GT(run.ledger().lost_to_dampers, 0.05);
  EXPECT_NEAR(run.totals().kinetic() + run.totals().potential + run.ledger().lost_to_dampers, energy, 1e-11);
}

// A point-like body turns nowhere: what would turn it counts as given from outside.
TEST(OffCentreSprings, BesideAPointTheLedgerCloses) {
  Body a = box("A", {0.0, 0.0}, {0.3, 0.1}, 0.4, 0.2, 1.5);
  a.spin = 2.0;
  RunSetup setup = free_bodies({a, disc("B", {1.0, 0.3}, {0.0, 0.2}, 0.0, 0.7)}, kExactly);
  Spring spring = spring_at("A", {0.2, 0.1}, 8.0);
  spring.to = "B";
  spring.anchor = Vec2(0.0, 0.3);
  setup.scene.forces.springs = {spring};
  Simulation run(setup);
  const double energy = run.totals().kinetic() + run.totals().potential;
  const double before = run.totals().angular_momentum;
  run.advance_to(0.5);
  EXPECT_GT(std::abs(run.totals().angular_momentum - before), 0.1);
  EXPECT_NEAR(run.ledger().angular_momentum_drift(run.totals().angular_momentum), 0.0, 1e-11);
  EXPECT_NEAR(run.totals().kinetic() + run.totals().potential, energy, 1e-11);
}

// A spin that no torque changes gives and takes energy: it is put in.
TEST(OffCentreSprings, BesideASpinningPointTheLedgerCloses) {
  Body point = disc("P", {1.0, 0.0}, {0.0, 0.0}, 0.0, 0.7);
  point.spin = 5.0;
  Body box_beside = box("A", {-1.0, 0.5}, {0.1, 0.2}, 0.4, 0.2, 1.5);
  box_beside.spin = -2.0;
  for (const bool between : {false, true}) {
    RunSetup setup = free_bodies({point, box_beside}, kExactly);
    Spring spring = spring_at("P", {0.3, 0.0}, 8.0);
    spring.damping = 0.4;
    if (between) {
      spring.to = "A";
      spring.anchor = Vec2(0.1, -0.05);
    }
    setup.scene.forces.springs = {spring};
    Simulation run(setup);
    run.advance_to(2.0);
    EXPECT_GT(std::abs(run.ledger().put_in_by_drives), 0.1) << between;
    EXPECT_NEAR(run.ledger().numerical_drift(run.totals().energy()), 0.0, 1e-10) << between;
  }
}

// Slack, the body spins freely: how long a band pulls on a turn is all that its motion has of a scale.
TEST(OffCentreSprings, ABandIsMetOnTheFirstTurn) {
  Body wheel = disc("A", {0.0, 0.0}, {0.0, 0.0}, 0.2, 1.0);
  wheel.spin = 3.0;
  Body crate = box("A", {0.0, 0.0}, {0.0, 0.0}, 0.4, 0.4, 1.0);
  crate.spin = 3.0;
  Body top = wheel;
  top.spin = 60.0;
  const auto when = [](double rest, const Body& body) {
    const double turn = std::acos((0.04 + 0.36 - rest * rest) / (2.0 * 0.2 * 0.6));
    return (turn - body.angle) / body.spin;
  };
  Body turned_crate = crate;
  turned_crate.angle = 0.8;
  Body late = wheel;
  late.angle = 0.8;
  for (const auto& [body, rest] : {std::pair{wheel, 0.5}, std::pair{crate, 0.5}, std::pair{turned_crate, 0.78},
                                   std::pair{late, 0.78}, std::pair{late, 0.7999}, std::pair{top, 0.799}}) {
    Spring band = spring_at("A", {0.2, 0.0}, 6.0);
    band.anchor = Vec2(0.6, 0.0);
    band.rest_length = rest;
    band.acts = SpringActs::kPull;
    const double taut = when(rest, body);
    for (const IntegratorId integrator : {IntegratorId::kAdaptiveDormandPrince, IntegratorId::kRk4}) {
      RunSetup setup = free_bodies({body}, Method{.integrator = integrator, .step = 0.05, .tolerance = 1e-9});
      setup.scene.forces.springs = {band};
      Simulation run(setup);
      run.advance_to(taut - 1e-9);
      EXPECT_EQ(run.state().v(2, 0), body.spin) << rest;
      run.advance_to(taut + 0.02 / body.spin);
      EXPECT_LT(run.state().v(2, 0), body.spin) << rest;
    }
  }
}

// A disc at rest and a driven end that comes and goes.
TEST(OffCentreSprings, ASwingingEndIsMetByABodyAtRest) {
  Body post = fixed("post", Box{0.1, 0.1}, {1.0, 0.0});
  post.fixed = false;
  post.drive = Drive{.amplitude = Vec2(0.2, 0.0), .angular_frequency = 3.0};
  Spring band = spring_at("A", Vec2::Zero(), 6.0);
  band.to = "post";
  band.rest_length = 1.15;
  band.acts = SpringActs::kPull;
  const auto run_with = [&](const Method& method) {
    RunSetup setup = free_bodies({disc("A", {0.0, 0.0}, {0.0, 0.0}, 0.1, 1.0), post}, method);
    setup.scene.forces.springs = {band};
    Simulation run(setup);
    run.advance_to(1.5);
    return run.state().q(0, 0);
  };
  const double fine = run_with({.integrator = IntegratorId::kRk4, .step = 1e-4});
  EXPECT_GT(fine, 0.01);
  EXPECT_NEAR(run_with(kExactly), fine, 1e-9);
}

// A post that is driven past a disc at rest, 0.4 m beside it, with a bumper of half a metre.
TEST(OffCentreSprings, ADrivenEndThatPassesIsMet) {
  Body post = fixed("post", Box{0.02, 0.02}, {-20.0, 0.4});
  post.fixed = false;
  post.drive = Drive{.velocity = Vec2(1.0, 0.0)};
  Spring bumper = spring_at("A", Vec2::Zero(), 6.0);
  bumper.to = "post";
  bumper.rest_length = 0.5;
  bumper.acts = SpringActs::kPush;
  const auto run_with = [&](const Method& method) {
    RunSetup setup = free_bodies({disc("A", {0.0, 0.0}, {0.0, 0.0}, 0.1, 1.0), post}, method);
    setup.scene.forces.springs = {bumper};
    Simulation run(setup);
    run.advance_to(22.0);
    return run.state().position(0);
  };
  const Vec2 fine = run_with({.integrator = IntegratorId::kRk4, .step = 1e-3});
  EXPECT_LT(fine.y(), -0.1);
  EXPECT_NEAR((run_with(kExactly) - fine).norm(), 0.0, 1e-7);
}

// A string from the rim of a wheel that spins in place: no force bends its flight until it is taut.
TEST(OffCentreSprings, AStringIsMetOnTheFirstTurn) {
  Body wheel = disc("A", {0.0, 0.0}, {0.0, 0.0}, 0.2, 1.0);
  wheel.spin = 3.0;
  wheel.angle = 0.8;
  Joint string;
  string.kind = JointKind::kString;
  string.body = "A";
  string.point = Vec2(0.2, 0.0);
  string.anchor = Vec2(0.6, 0.0);
  string.length = 0.78;
  RunSetup setup = free_bodies({wheel}, kExactly);
  setup.scene.joints = {string};
  Simulation run(setup);
  const double taut = (std::acos((0.04 + 0.36 - 0.78 * 0.78) / 0.24) - 0.8) / 3.0;
  run.advance_to(taut - 1e-9);
  EXPECT_EQ(run.state().v(2, 0), 3.0);
  run.advance_to(taut + 1e-9);
  EXPECT_LT(run.state().v(2, 0), 3.0);
}

// A point of a fixed body is a point of the plane; that of a driven one moves with it.
TEST(OffCentreSprings, HoldToPointsOfBodiesThatNothingMoves) {
  const auto end_of = [](const RunSetup& setup) {
    Simulation run(setup);
    run.advance_to(1.0);
    return run.state().q.col(0).eval();
  };
  Body bar = box("bar", {0.0, 0.0}, {0.2, 0.1}, 0.6, 0.1, 2.0);
  Body post = fixed("post", Box{0.2, 0.2}, {2.0, 1.0});
  post.angle = 0.7;
  RunSetup setup = free_bodies({bar, post}, kExactly);
  setup.scene.forces.springs = {spring_at("bar", {0.3, 0.0}, 4.0)};
  Spring& spring = setup.scene.forces.springs[0];
  spring.rest_length = 1.0;
  spring.to = "post";
  spring.anchor = Vec2(-0.1, 0.1);
  const Eigen::Vector3d to_post = end_of(setup);
  spring.to.clear();
  spring.anchor = post.position + turned_by(0.7, {-0.1, 0.1});
  EXPECT_EQ(end_of(setup), to_post);
  EXPECT_GT(std::abs(to_post[2]), 0.1);

  // Driven to and fro: its point moves as a post does whose place is there.
  setup.scene.bodies[1].fixed = false;
  setup.scene.bodies[1].drive =
      Drive{.velocity = Vec2(0.1, 0.0), .amplitude = Vec2(0.0, 0.2), .angular_frequency = 3.0};
  spring.to = "post";
  spring.anchor = Vec2(-0.1, 0.1);
  Simulation driven(setup);
  const double energy = driven.totals().kinetic() + driven.totals().potential;
  driven.advance_to(1.0);
  EXPECT_NEAR(driven.totals().kinetic() + driven.totals().potential - driven.ledger().put_in_by_drives, energy,
              1e-11);
  setup.scene.bodies[1].position += turned_by(0.7, {-0.1, 0.1});
  spring.anchor.setZero();
  EXPECT_NEAR((end_of(setup) - driven.state().q.col(0)).norm(), 0.0, 1e-12);
}

// A rubber band from a corner: it goes slack and taut again as the box turns.
TEST(OffCentreSprings, SwitchWhereTheirEndsAre) {
  Body body = box("box", {0.0, 0.0}, {0.0, 0.0}, 0.4, 0.4, 1.0);
  body.spin = 9.0;
  RunSetup setup = free_bodies({body}, kExactly);
  Spring band = spring_at("box", {0.2, 0.2}, 6.0);
  band.anchor = Vec2(0.6, 0.0);
  band.rest_length = 0.5;
  band.acts = SpringActs::kPull;
  setup.scene.forces.springs = {band};
  Simulation run(setup);
  const double energy = run.totals().kinetic() + run.totals().potential;
  int changes = 0;
  bool pulled = false;
  while (run.time() < 3.0) {
    run.step();
    const bool pulls = run.totals().potential > 0.0;
    changes += pulls != pulled ? 1 : 0;
    pulled = pulls;
    ASSERT_NEAR(run.totals().kinetic() + run.totals().potential, energy, 1e-10) << run.time();
  }
  EXPECT_GE(changes, 4);
}

// A constant force at a point that turns with the disc: the centre falls along a parabola, the disc swings.
TEST(OffCentreForces, ADiscHangsFromItsPointAndFalls) {
  Body body = disc("A", {0.0, 0.0}, {0.1, 0.0}, 0.2, 3.0);
  body.angle = 1.0;
  RunSetup setup = free_bodies({body}, kExactly);
  AppliedForce force;
  force.body = "A";
  force.point = Vec2(0.15, 0.0);
  force.force = Vec2(2.0, 0.0);
  setup.scene.forces.applied = {force};
  const double inertia = 0.5 * 3.0 * 0.04;
  const double period = period_of_pendulum(std::sqrt(0.15 * 2.0 / inertia), 1.0);
  Simulation run(setup);
  const double kinetic = run.totals().kinetic();
  run.advance_to(0.25 * period);
  EXPECT_NEAR(run.state().q.col(0)[2], 0.0, 1e-10);
  const double t = run.time();
  EXPECT_NEAR(run.state().q.col(0)[0], 0.1 * t + t * t / 3.0, 1e-11);
  const double work = 2.0 * (run.state().q.col(0)[0] + 0.15 * (1.0 - std::cos(1.0)));
  EXPECT_NEAR(run.ledger().put_in_by_drives, work, 1e-11);
  EXPECT_NEAR(run.totals().kinetic() - kinetic, work, 1e-11);
  EXPECT_EQ(
      why_not(setup.scene, IntegratorId::kExactFlight),
      "exact flight is not possible with forces beside a centre; allowed: gravity and constant forces alone, "
      "or another integrator");
}

// In the middle of a side nothing turns; at a corner the box is pulled round.
TEST(OffCentreForces, BesideGravityTheyPressOnTheFloor) {
  Body body = box("box", {0.0, 0.1}, {0.0, 0.0}, 0.4, 0.2, 1.0);
  RunSetup setup = setup_with({body, fixed("floor", Wall{}, {0.0, 0.0})}, 0.0, 0.5);
  setup.scene.forces.gravity = Vec2(0.0, -10.0);
  setup.method = {.integrator = IntegratorId::kRk4, .contacts = ContactsId::kLasting, .step = 0.005};
  AppliedForce force;
  force.body = "box";
  force.point = Vec2(0.2, 0.1);
  force.force = Vec2(0.0, 4.9);
  setup.scene.forces.applied = {force};
  // About the far corner: 4.9 N * 0.4 m against 10 N * 0.2 m.
  Simulation rests(setup);
  rests.advance_to(1.0);
  EXPECT_NEAR(rests.state().q.col(0)[2], 0.0, 1e-12);
  setup.scene.forces.applied[0].force.y() = 5.1;
  Simulation tips(setup);
  tips.advance_to(1.0);
  EXPECT_GT(tips.state().q.col(0)[2], 0.02);
}

}  // namespace
}  // namespace carom
