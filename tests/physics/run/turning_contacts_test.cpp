#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/run/simulation.h"
#include "tests/support/draws.h"
#include "tests/support/scenes.h"

// Contacts that turn with their bodies, and the moments at which they let go, break away or stop slipping:
// resting contacts have the integrator's order there, up to 4, and keep angular momentum where only inner
// forces act.
namespace carom {
namespace {

constexpr double kG = 9.81;  // m/s²

Method method(IntegratorId integrator, ImpactsId impacts, double h) {
  return {integrator, impacts, ContactsId::kLasting, h};
}

// Two equal smooth discs of 1 kg that touch, attract and circle each other at an angular velocity of 1 rad/s.
RunSetup circling_pair() {
  RunSetup s = test::setup_with(
      {test::disc("first", {-0.5, 0.0}, {0.0, -0.5}, 0.5), test::disc("second", {0.5, 0.0}, {0.0, 0.5}, 0.5)});
  s.scene.forces.attraction = {2.0, 0.0};
  return s;
}

// A disc of radius 0.5 m that rolls round a fixed one at 1 rad/s; a spring holds it.
RunSetup rolling_round() {
  Body centre = test::disc("centre", {0.0, 0.0}, {0.0, 0.0}, 1.0);
  centre.fixed = true;
  Body wheel = test::disc("wheel", {1.5, 0.0}, {0.0, 1.5}, 0.5);
  wheel.spin = 3.0;
  RunSetup s = test::setup_with({centre, wheel}, 0.0, 0.9);
  Spring spring;
  spring.body = "wheel";
  spring.stiffness = 10.0;
  s.scene.forces.springs = {spring};
  return s;
}

// A square of 1 m that stands on a corner, 0.1 rad off, and tips without slipping.
RunSetup tipping_box() {
  Body box = test::disc("box", std::sqrt(0.5) * Vec2(std::sin(0.1), std::cos(0.1)), {0.0, 0.0});
  box.shape = Box{1.0, 1.0};
  box.angle = 0.25 * std::numbers::pi - 0.1;
  RunSetup s = test::setup_with({test::wall("floor", {0.0, -0.5}, 20.0, 1.0), box}, 0.0, 5.0);
  s.scene.forces.gravity = {0.0, -kG};
  return s;
}

// A smooth disc that slides off a fixed one of 1 m, from 0.1 rad off its top.
RunSetup sliding_off() {
  Body top = test::disc("top", {0.0, 0.0}, {0.0, 0.0}, 1.0);
  top.fixed = true;
  RunSetup s = test::setup_with(
      {top, test::disc("disc", 1.5 * Vec2(std::sin(0.1), std::cos(0.1)), {0.0, 0.0}, 0.5)}, 0.0, 0.0);
  s.scene.forces.gravity = {0.0, -kG};
  return s;
}

// φ'' = k sin φ from rest at 0.1 rad, by the classical Runge-Kutta method, until `time` or until stop(φ).
struct Pendulum {
  double angle = 0.1;
  double rate = 0.0;
  double time = 0.0;
};
Pendulum pendulum(double k, double time, const std::function<bool(double)>& stop) {
  Pendulum p;
  constexpr int kSteps = 2'000'000;
  const double h = time / kSteps;
  for (int i = 0; i < kSteps && !stop(p.angle); ++i, p.time = i * h) {
    const double k1 = p.rate, l1 = k * std::sin(p.angle);
    const double k2 = p.rate + 0.5 * h * l1, l2 = k * std::sin(p.angle + 0.5 * h * k1);
    const double k3 = p.rate + 0.5 * h * l2, l3 = k * std::sin(p.angle + 0.5 * h * k2);
    const double k4 = p.rate + h * l3, l4 = k * std::sin(p.angle + h * k3);
    p.angle += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    p.rate += h / 6.0 * (l1 + 2.0 * l2 + 2.0 * l3 + l4);
  }
  return p;
}

// What happens on the way: nothing, contacts that let go, or others that break away or stop slipping. Linear
// contact forces end at such moments only where impacts are located, constant ones are of order 1 at the
// others.
enum class Modes { kStay, kLetGo, kRub };

// The order over three halvings of the step is at least the integrator's; neither friction nor restitution
// makes energy.
void expect_order(const RunSetup& setup, double until, Modes modes,
                  const std::function<double(const Simulation&)>& error) {
  for (const IntegratorId integrator :
       {IntegratorId::kVelocityVerlet, IntegratorId::kRk4, IntegratorId::kDormandPrince}) {
    const bool linear = integrator != IntegratorId::kVelocityVerlet;
    for (const auto& impacts : kImpacts) {
      if (modes != Modes::kStay && linear && impacts.id == ImpactsId::kStepEnd) continue;
      if (modes == Modes::kRub && !linear) continue;
      std::vector<double> errors;
      for (const double h : {0.02, 0.01, 0.005, 0.0025}) {
        RunSetup s = setup;
        s.method = method(integrator, impacts.id, h);
        Simulation run(s);
        run.advance_to(until);
        errors.push_back(error(run));
        EXPECT_EQ(run.impact_count(), 0);
        EXPECT_EQ(run.notices().text(), "ok");
        EXPECT_GE(run.ledger().lost_to_friction, 0.0);
        EXPECT_GE(run.ledger().lost_to_restitution, 0.0);
      }
      const double order = std::log2(errors.front() / errors.back()) / 3.0;
      EXPECT_GT(order, linear ? 3.8 : 1.8) << choice_of(kIntegrators, integrator).name << ", " << impacts.name
                                           << ", errors " << errors.front() << " ... " << errors.back();
    }
  }
}

// The distance of all places from those of a run with a far shorter step.
void expect_order(const RunSetup& setup, double until, Modes modes) {
  RunSetup close = setup;
  close.method = method(IntegratorId::kRk4, ImpactsId::kLocated, 0.0005);
  Simulation reference(close);
  reference.advance_to(until);
  expect_order(setup, until, modes,
               [&](const Simulation& run) { return (run.state().q - reference.state().q).norm(); });
}

TEST(TurningContacts, ACirclingPairHasTheIntegratorsOrder) {
  expect_order(circling_pair(), 2.0, Modes::kStay, [](const Simulation& run) {
    return (run.state().position(1) - 0.5 * direction_at(run.time())).norm();
  });
}

TEST(TurningContacts, RollingRoundADiscHasTheIntegratorsOrder) {
  expect_order(rolling_round(), 2.0, Modes::kStay, [](const Simulation& run) {
    return (run.state().position(1) - 1.5 * direction_at(run.time())).norm();
  });
}

TEST(TurningContacts, ATippingBoxHasTheIntegratorsOrder) {
  const double r = std::sqrt(0.5);
  const double end = pendulum(r * kG / (1.0 / 6.0 + r * r), 0.6, [](double) { return false; }).angle;
  expect_order(tipping_box(), 0.6, Modes::kStay, [&](const Simulation& run) {
    return std::abs(0.25 * std::numbers::pi - run.state().q(2, 1) - end);
  });
}

// It leaves at cos φ = 2/3 cos φ_0, and flies on.
TEST(TurningContacts, LiftOffHasTheIntegratorsOrder) {
  constexpr double kEnd = 1.5;
  const Pendulum off =
      pendulum(kG / 1.5, kEnd, [](double angle) { return std::cos(angle) <= 2.0 / 3.0 * std::cos(0.1); });
  const double left = kEnd - off.time;
  const Vec2 end = 1.5 * Vec2(std::sin(off.angle), std::cos(off.angle)) +
                   left * 1.5 * off.rate * Vec2(std::cos(off.angle), -std::sin(off.angle)) +
                   0.5 * left * left * Vec2(0.0, -kG);
  expect_order(sliding_off(), kEnd, Modes::kLetGo,
               [&](const Simulation& run) { return (run.state().position(1) - end).norm(); });
}

// A ladder of 2 m in a corner, 0.5 rad from the wall; on its way its corners come to face floor and wall by
// their other edges.
RunSetup ladder(double friction) {
  const Vec2 half(0.01, 1.0);
  const Vec2 x = std::cos(0.5) * Vec2::UnitX();
  const double reach_x = half.x() * x.x() + half.y() * std::sin(0.5);
  const double reach_y = half.x() * std::sin(0.5) + half.y() * x.x();
  Body body = test::disc("ladder", {reach_x, reach_y}, {0.0, 0.0});
  body.shape = Box{2.0 * half.x(), 2.0 * half.y()};
  body.angle = 0.5;
  RunSetup s = test::setup_with(
      {test::wall("floor", {0.0, -0.5}, 20.0, 1.0), test::wall("wall", {-0.5, 5.0}, 1.0, 9.99), body}, 0.0,
      friction);
  s.scene.forces.gravity = {0.0, -kG};
  return s;
}

TEST(TurningContacts, ALadderHasTheIntegratorsOrder) {
  for (const double friction : {0.0, 0.1}) {
    expect_order(ladder(friction), 0.35, Modes::kStay);
    expect_order(ladder(friction), 0.5, Modes::kRub);
  }
}

// A thin smooth one, whose ends are touched from their other side once it has turned by 45°. Its kinetic energy
// is m (L ω)²/6 while both ends touch.
TEST(TurningContacts, AThinLadderGoesOnPast45Degrees) {
  constexpr double kLength = 2.0;  // m
  constexpr double kAngle = 1.2;   // rad
  for (const IntegratorId integrator : {IntegratorId::kVelocityVerlet, IntegratorId::kRk4}) {
    for (const double h : {1.0 / 60.0, 1.0 / 120.0, 1.0 / 240.0}) {
      Body body = test::disc("ladder", 0.5 * kLength * Vec2(std::cos(kAngle), std::sin(kAngle)), {0.0, 0.0});
      body.shape = Wall{kLength};
      body.angle = -kAngle;
      body.inertia = kLength * kLength / 12.0;
      Body floor = test::fixed("floor", Wall{}, {0.0, 0.0});
      Body wall = floor;
      wall.name = "wall";
      wall.angle = -0.5 * std::numbers::pi;
      RunSetup s = test::setup_with({floor, wall, body}, 0.0, 0.0);
      s.scene.forces.gravity = {0.0, -kG};
      s.method = method(integrator, ImpactsId::kLocated, h);
      Simulation run(s);
      run.advance_to(0.55);
      SCOPED_TRACE(testing::Message() << static_cast<int>(integrator) << ' ' << h);
      const double spin =
          std::sqrt(3.0 * kG / kLength * (std::sin(kAngle) + std::sin(run.state().q.col(2)[2])));
      EXPECT_NEAR(run.state().v.col(2)[2], spin, 3.0 * h * h);
      EXPECT_EQ(run.impact_count(), 0);
      EXPECT_LT(run.ledger().lost_to_restitution, 1e-5);
    }
  }
}

// Two discs on a rod roll off a fixed one: what closes their contacts passes through the rod.
TEST(TurningContacts, RodsShareTheContactForces) {
  const auto on_top = [](double angle) { return Vec2(1.3 * Vec2(std::sin(angle), std::cos(angle))); };
  Body top = test::disc("top", {0.0, 0.0}, {0.0, 0.0}, 1.0);
  top.fixed = true;
  RunSetup s = test::setup_with({top, test::disc("first", on_top(-0.2), {0.0, 0.0}, 0.3),
                                 test::disc("second", on_top(0.35), {0.0, 0.0}, 0.3, 2.0)},
                                0.0, 0.9);
  Joint rod;
  rod.body = "first";
  rod.to = "second";
  s.scene.joints = {rod};
  s.scene.forces.gravity = {0.0, -kG};
  expect_order(s, 0.6, Modes::kStay);
}

// Slips at first, rolls, slips again and lets go.
TEST(TurningContacts, SlipAndStickHaveTheIntegratorsOrder) {
  RunSetup s = sliding_off();
  s.scene.materials[0].static_friction = s.scene.materials[0].kinetic_friction = 0.3;
  s.scene.bodies[1].spin = -2.0;
  expect_order(s, 1.5, Modes::kRub);
  RunSetup reverses = rolling_round();
  reverses.scene.materials[0].static_friction = reverses.scene.materials[0].kinetic_friction = 0.3;
  reverses.scene.bodies[1].spin = 30.0;
  reverses.scene.bodies[1].velocity = {0.0, -1.5};
  expect_order(reverses, 2.0, Modes::kRub);
}

// A plank on two rollers, ±d from the middle, that turn inwards slips on both; friction acts h below its
// centre, so that the load shifts by x/(d - μ h) and x'' = -μ g x/(d - μ h).
TEST(TurningContacts, APlankSwingsOnTwoRollers) {
  constexpr double kFriction = 0.3;
  constexpr double kHalf = 0.5;    // m, d
  constexpr double kBelow = 0.05;  // m, h
  constexpr double kEnd = 2.0;     // s
  const double wanted = 0.1 * std::cos(kEnd * std::sqrt(kFriction * kG / (kHalf - kFriction * kBelow)));
  const auto error = [&](IntegratorId integrator, double step, double angle) {
    RunSetup s = test::setup_with({}, 0.0, kFriction);
    for (const double side : {-1.0, 1.0}) {
      Body roller =
          test::disc(side < 0.0 ? "left" : "right", turned_by(angle, Vec2(side * kHalf, 0.0)), Vec2::Zero());
      roller.inertia = 1e12;
      roller.spin = side * 20.0;
      Joint axle;
      axle.kind = JointKind::kPin;
      axle.body = roller.name;
      axle.anchor = roller.position;
      s.scene.bodies.push_back(roller);
      s.scene.joints.push_back(axle);
    }
    Body plank =
        test::box("plank", turned_by(angle, Vec2(0.1, 0.1 + kBelow)), Vec2::Zero(), 3.0, 2.0 * kBelow, 2.0);
    plank.angle = angle;
    s.scene.bodies.push_back(plank);
    s.scene.forces.gravity = turned_by(angle, Vec2(0.0, -kG));
    s.method = method(integrator, ImpactsId::kLocated, step);
    Simulation run(s);
    run.advance_to(kEnd);
    return std::abs(turned_by(-angle, run.state().position(2)).x() - wanted);
  };
  for (const double angle : {0.0, 0.7}) {
    for (const double step : {0.02, 0.01, 0.005}) {
      EXPECT_LT(error(IntegratorId::kRk4, step, angle), std::max(0.02 * std::pow(step, 4), 1e-10));
      EXPECT_LT(error(IntegratorId::kDormandPrince, step, angle), std::max(0.02 * std::pow(step, 4), 1e-10));
      EXPECT_LT(error(IntegratorId::kVelocityVerlet, step, angle), 0.3 * step * step);
    }
  }
}

// A push that rises by 10 N/s moves a box at μ_s m g; from then on μ_k holds it back. Its start is at all parts
// of a step. Velocity Verlet has the speed as exactly, and places to its order.
TEST(TurningContacts, BreakingAwayIsLocated) {
  for (const IntegratorId integrator : {IntegratorId::kRk4, IntegratorId::kVelocityVerlet}) {
    // Of velocity Verlet h² F' t/12 with the force F, in m.
    const double near = integrator == IntegratorId::kRk4 ? 1e-9 : 1e-4;
    for (int k = 0; k < 10; ++k) {
      Body box = test::disc("box", {0.0, 0.1}, {0.0, 0.0});
      box.shape = Box{1.0, 0.2};
      RunSetup s = test::setup_with({test::wall("floor", {0.0, -0.5}, 20.0, 1.0), box});
      s.scene.materials[0] = {"default", 0.0, 0.0, 0.5, 0.3};
      s.scene.forces.gravity = {0.0, -kG};
      AppliedForce push;
      push.body = "box";
      push.force = {10.0, 0.0};
      push.start = 1e-3 * k;
      push.rise = 1.0;
      s.scene.forces.applied = {push};
      s.method = method(integrator, ImpactsId::kLocated, 0.01);
      Simulation run(s);
      run.advance_to(0.9);
      const double breaks = push.start + 0.5 * kG / 10.0;
      const double moves = 0.9 - breaks;
      const double speed = 5.0 * moves * moves + (0.5 - 0.3) * kG * moves;
      const double way = 5.0 / 3.0 * moves * moves * moves + 0.5 * (0.5 - 0.3) * kG * moves * moves;
      EXPECT_NEAR(run.state().velocity(1).x(), speed, 1e-9) << k;
      EXPECT_NEAR(run.state().position(1).x(), way, near) << k;
      EXPECT_NEAR(run.ledger().lost_to_friction, 0.3 * kG * way, 3.0 * near) << k;
      EXPECT_EQ(run.notices().text(), "ok");
    }
  }
}

// A U falls on a slope, comes to rest on a corner and tips onto its bottom, whose three flush parts land at one
// moment.
TEST(TurningContacts, ACompoundLandsFlatBesideARestingCorner) {
  Compound u;
  u.shapes = {{Box{0.5, 0.08}, {0.0, 0.0}, 0.0, ""},
              {Box{0.08, 0.3}, {-0.29, 0.11}, 0.0, ""},
              {Box{0.08, 0.3}, {0.29, 0.11}, 0.0, ""}};
  Body slope = test::disc("slope", {0.0, 0.0}, {0.0, 0.0});
  slope.shape = Wall{};
  slope.fixed = true;
  slope.angle = -0.19676;
  Body body = test::disc("u", {-0.259057, 0.641736}, {-0.400876, -0.210271});
  body.shape = u;
  body.spin = 0.635792;
  body.angle = 1.363458;
  RunSetup s = test::setup_with({slope, body}, 0.0, 0.51774);
  s.scene.materials[0].static_friction = 0.53172;
  s.scene.forces.gravity = {0.0, -kG};
  for (int i = 0; i < 40; ++i) {
    s.method = method(IntegratorId::kRk4, ImpactsId::kLocated, 0.001 * std::pow(1.06, i));
    Simulation run(s);
    run.advance_to(0.8);
    EXPECT_NEAR(run.state().v(2, 1), 0.0, 1e-9) << s.method.step;
  }
}

// A stack that is pushed, and one on a shaken table, stay where they are as long as friction holds them.
TEST(TurningContacts, FrictionHoldsAStackUnderForcesThatChange) {
  std::vector<Body> bodies = {test::wall("floor", {0.0, -0.5}, 20.0, 1.0)};
  for (int i = 0; i < 3; ++i) {
    bodies.push_back(test::disc("box-" + std::to_string(i), {0.0, 0.25 + 0.5 * i}, {0.0, 0.0}));
    bodies.back().shape = Box{1.0, 0.5};
  }
  RunSetup s = test::setup_with(bodies, 0.0, 0.8);
  s.scene.forces.gravity = {0.0, -kG};
  AppliedForce push;
  push.body = "box-0";
  push.force = {18.0, 0.0};
  push.rise = 5.0;
  s.scene.forces.applied = {push};
  s.method = method(IntegratorId::kRk4, ImpactsId::kLocated, 0.01);
  Simulation run(s);
  const Eigen::Matrix3Xd before = run.state().q;
  run.advance_to(5.0);
  EXPECT_LT((run.state().q - before).norm(), 1e-11);
  EXPECT_LT(run.ledger().lost_to_friction, 1e-12);
}

TEST(TurningContacts, ACirclingPairKeepsItsAngularMomentum) {
  for (const auto& impacts : kImpacts) {
    for (const double h : {0.01, 0.005, 0.0025}) {
      RunSetup s = circling_pair();
      s.method = method(IntegratorId::kVelocityVerlet, impacts.id, h);
      Simulation run(s);
      run.advance_to(2.0);
      EXPECT_NEAR(run.totals().angular_momentum, 0.5, 1e-13) << impacts.name << ", h = " << h;
    }
  }
}

// A square falls over onto its other corner, and rocks on about that: whatever part of a step is over by then,
// errors are those of order 4.
TEST(TurningContacts, ALandingKeepsTheOrder) {
  constexpr double kTilt = 0.85;  // rad
  Body box = test::box("box", turned_by(-kTilt, Vec2(-0.15, 0.15)), {0.0, 0.0}, 0.3, 0.3);
  box.angle = -kTilt;
  const auto end = [&](double h) {
    RunSetup s = test::setup_with({test::fixed("floor", Wall{}, {0.0, 0.0}), box}, 0.0, 1000.0);
    s.scene.forces.gravity = {0.0, -kG};
    s.method = method(IntegratorId::kRk4, ImpactsId::kLocated, h);
    Simulation run(s);
    run.advance_to(0.594);
    return Eigen::Vector3d(run.state().v.col(1));
  };
  const Eigen::Vector3d reference = end(0.0005);
  for (const double h : {1.0 / 60.0, 0.0151, 0.014, 0.0125, 0.011, 0.01, 0.007, 0.006, 0.005})
    EXPECT_LT((end(h) - reference).norm(), 60.0 * std::pow(h, 4)) << h;
}

// 20 smooth discs in rows, at 43 contacts, turn as one body while they attract each other: more contacts than
// their places determine.
TEST(TurningContacts, ATurningClusterHasTheIntegratorsOrder) {
  constexpr double kRadius = 0.1;  // m
  for (const double h : {0.02, 0.01}) {
    RunSetup s = test::setup_with({}, 0.0, 0.0);
    for (int i = 0; i < 20; ++i) {
      const int row = i / 4;
      const Vec2 place(2.0 * kRadius * (i % 4 + 0.5 * (row % 2)) - 0.7, std::sqrt(3.0) * kRadius * row - 0.35);
      s.scene.bodies.push_back(test::disc("disc-" + std::to_string(i), place, crossed(place), kRadius));
      s.scene.bodies.back().spin = 1.0;
    }
    s.scene.forces.attraction = {1.0, 0.1};
    s.method = method(IntegratorId::kRk4, ImpactsId::kLocated, h);
    Simulation run(s);
    const double angular_momentum = run.totals().angular_momentum;
    const double energy = run.totals().energy();
    run.advance_to(1.0);
    EXPECT_NEAR(run.totals().angular_momentum, angular_momentum, std::pow(h, 4) * std::abs(angular_momentum))
        << h;
    EXPECT_NEAR(run.totals().energy(), energy, 5.0 * std::pow(h, 4)) << h;
    EXPECT_EQ(run.impact_count(), 0) << h;
  }
}

// 20 rough discs in contact, spinning and moving as they were thrown together.
TEST(TurningContacts, AFreeClusterKeepsItsAngularMomentum) {
  for (const auto& impacts : kImpacts) {
    test::Draws draw(3);
    std::vector<Body> bodies;
    for (int i = 0; i < 20; ++i) {
      bodies.push_back(
          test::disc("disc-" + std::to_string(i), {0.5 * (i % 5), 0.5 * (i / 5)}, draw.in_square(0.5), 0.25));
      bodies.back().spin = draw.between(-3.0, 3.0);
    }
    RunSetup s = test::setup_with(bodies, 0.3, 0.5);
    s.method = method(IntegratorId::kRk4, impacts.id, 0.01);
    Simulation run(s);
    const double before = run.totals().angular_momentum;
    run.advance_to(4.0);
    EXPECT_NEAR(run.totals().angular_momentum, before, 1e-12) << impacts.name;
  }
}

// After an inelastic hit two free boxes slide and turn along each other until they part: nothing presses them
// but their own turning.
TEST(TurningContacts, FreeBoxesThatSlideAndTurnHaveTheIntegratorsOrder) {
  const auto spin = [](double step) {
    RunSetup s = test::setup_with({test::box("first", {-1.0, 0.0}, {2.0, 0.0}, 0.4, 0.2),
                                   test::box("second", {0.0, 0.17975818923729742}, {0.0, 0.0}, 0.4, 0.2)},
                                  0.0);
    s.scene.bodies[0].angle = 0.4948195629497427;
    s.scene.bodies[1].angle = 0.044177047429320826;
    s.method = method(IntegratorId::kRk4, ImpactsId::kLocated, step);
    Simulation run(s);
    run.advance_to(1.5);
    return run.state().v(2, 0);
  };
  const double exact = spin(2.5e-4);
  EXPECT_NEAR(exact, -1.14280108, 1e-8);
  EXPECT_NEAR(spin(0.005), exact, 1e-7);
  EXPECT_NEAR(spin(0.0025), exact, 1e-8);
}

// In a step in which it would fall by more than its own size it does not get to the other side of what it lies
// on.
TEST(TurningContacts, ASmallDiscStaysOnAThinPlate) {
  struct Case {
    double radius, thickness, step, gravity;
  };
  for (const auto& [radius, thickness, step, gravity] :
       {Case{5e-4, 0.0, 1.0 / 60.0, 9.81}, Case{5e-4, 1e-4, 1.0 / 60.0, 9.81}, Case{0.01, 0.0, 0.1, 9.81},
        Case{0.1, 0.1, 0.3, 9.81}, Case{0.005, 0.0, 1.0 / 60.0, 274.0}}) {
    for (const IntegratorId integrator :
         {IntegratorId::kRk4, IntegratorId::kVelocityVerlet, IntegratorId::kSemiImplicitEuler}) {
      Body plate = test::fixed("plate", Box{40.0 * radius, thickness}, {0.0, -0.5 * thickness});
      if (thickness == 0.0) plate.shape = Wall{40.0 * radius};
      RunSetup s = test::setup_with({plate, test::disc("lower", {0.0, radius}, {0.0, 0.0}, radius),
                                     test::disc("upper", {0.0, 3.0 * radius}, {0.0, 0.0}, radius)},
                                    0.3, 0.2);
      s.scene.forces.gravity = {0.0, -gravity};
      s.method = {integrator, ImpactsId::kLocated, ContactsId::kLasting, step};
      Simulation run(s);
      run.advance_to(20.0 * step);
      EXPECT_NEAR(run.state().q(1, 1), radius, 1e-9 * radius) << step << ", " << static_cast<int>(integrator);
      EXPECT_NEAR(run.state().q(1, 2), 3.0 * radius, 1e-9 * radius) << step;
      EXPECT_EQ(run.status(), "ok");
    }
  }
}

}  // namespace
}  // namespace carom
