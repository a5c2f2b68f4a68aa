#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

#include "physics/run/simulation.h"
#include "tests/support/draws.h"
#include "tests/support/scenes.h"

// Contacts that turn with their bodies: resting contacts are of order 2 there, and keep angular momentum where
// only inner forces act.
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
  const double h = time / 200000;
  for (int i = 0; i < 200000 && !stop(p.angle); ++i, p.time += h) {
    const double k1 = p.rate, l1 = k * std::sin(p.angle);
    const double k2 = p.rate + 0.5 * h * l1, l2 = k * std::sin(p.angle + 0.5 * h * k1);
    const double k3 = p.rate + 0.5 * h * l2, l3 = k * std::sin(p.angle + 0.5 * h * k2);
    const double k4 = p.rate + h * l3, l4 = k * std::sin(p.angle + h * k3);
    p.angle += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    p.rate += h / 6.0 * (l1 + 2.0 * l2 + 2.0 * l3 + l4);
  }
  return p;
}

// The error falls fourfold as the step is halved, three times over all; neither friction nor restitution makes
// energy.
void expect_second_order(const RunSetup& setup, double until,
                         const std::function<double(const Simulation&)>& error) {
  for (const IntegratorId integrator : {IntegratorId::kVelocityVerlet, IntegratorId::kRk4}) {
    for (const auto& impacts : kImpacts) {
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
      EXPECT_NEAR(order, 2.0, 0.2) << impacts.name << ", errors " << errors.front() << " ... " << errors.back();
    }
  }
}

TEST(TurningContacts, ACirclingPairIsOfSecondOrder) {
  expect_second_order(circling_pair(), 2.0, [](const Simulation& run) {
    return (run.state().position(1) - 0.5 * direction_at(run.time())).norm();
  });
}

TEST(TurningContacts, RollingRoundADiscIsOfSecondOrder) {
  expect_second_order(rolling_round(), 2.0, [](const Simulation& run) {
    return (run.state().position(1) - 1.5 * direction_at(run.time())).norm();
  });
}

TEST(TurningContacts, ATippingBoxIsOfSecondOrder) {
  const double r = std::sqrt(0.5);
  const double end = pendulum(r * kG / (1.0 / 6.0 + r * r), 0.6, [](double) { return false; }).angle;
  expect_second_order(tipping_box(), 0.6, [&](const Simulation& run) {
    return std::abs(0.25 * std::numbers::pi - run.state().q(2, 1) - end);
  });
}

// It leaves at cos φ = 2/3 cos φ_0, and flies on.
TEST(TurningContacts, LiftOffIsOfSecondOrder) {
  constexpr double kEnd = 1.5;
  const Pendulum off =
      pendulum(kG / 1.5, kEnd, [](double angle) { return std::cos(angle) <= 2.0 / 3.0 * std::cos(0.1); });
  const double left = kEnd - off.time;
  const Vec2 end = 1.5 * Vec2(std::sin(off.angle), std::cos(off.angle)) +
                   left * 1.5 * off.rate * Vec2(std::cos(off.angle), -std::sin(off.angle)) +
                   0.5 * left * left * Vec2(0.0, -kG);
  expect_second_order(sliding_off(), kEnd,
                      [&](const Simulation& run) { return (run.state().position(1) - end).norm(); });
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

}  // namespace
}  // namespace carom
