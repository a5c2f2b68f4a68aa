#include <array>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/math/vectors.h"
#include "physics/run/run_setup.h"
#include "physics/scene/validate.h"
#include "tests/support/fitted_order.h"
#include "tests/support/scenes.h"

// Rods and pins in motion.
namespace carom {
namespace {

using test::disc;
using test::fitted_order;
using test::setup_with;

constexpr double kGravity = 9.81;

Joint rod(const std::string& body, const Vec2& anchor) {
  Joint joint;
  joint.body = body;
  joint.anchor = anchor;
  return joint;
}

Joint rod_to(const std::string& body, const std::string& to) {
  Joint joint;
  joint.body = body;
  joint.to = to;
  return joint;
}

Joint pin(const std::string& body, const Vec2& point, const Vec2& anchor) {
  Joint joint = rod(body, anchor);
  joint.kind = JointKind::kPin;
  joint.point = point;
  return joint;
}

// Jacobi's sn(u, k) by the descending arithmetic-geometric mean: Abramowitz and Stegun, 16.4.
double jacobi_sn(double u, double k) {
  std::array<double, 16> a{1.0};
  std::array<double, 16> c{k};
  double b = std::sqrt(1.0 - k * k);
  std::size_t n = 0;
  while (c[n] > 1e-17 && n + 1 < a.size()) {
    a[n + 1] = 0.5 * (a[n] + b);
    c[n + 1] = 0.5 * (a[n] - b);
    b = std::sqrt(a[n] * b);
    ++n;
  }
  double phi = std::ldexp(a[n] * u, static_cast<int>(n));
  for (; n > 0; --n) phi = 0.5 * (phi + std::asin(c[n] * std::sin(phi) / a[n]));
  return std::sin(phi);
}

// The angle from the vertical at t of a pendulum of this (equivalent) length that starts at rest at `start`:
// sin(θ/2) = k sn(K - ω t, k), k = sin(start/2).
double pendulum_angle(double start, double length, double t) {
  const double k = std::sin(0.5 * start);
  const double phase = std::comp_ellint_1(k) - std::sqrt(kGravity / length) * t;
  return 2.0 * std::asin(k * jacobi_sn(phase, k));
}

constexpr double kLength = 0.7;
constexpr double kStart = 2.0;  // rad

Vec2 on_circle(double angle, double length) { return length * Vec2(std::sin(angle), -std::cos(angle)); }

RunSetup pendulum() {
  RunSetup s = setup_with({disc("bob", on_circle(kStart, kLength), {0, 0}, 0.05, 0.3)});
  s.scene.forces.gravity = {0.0, -kGravity};
  s.scene.joints = {rod("bob", {0, 0})};
  return s;
}

// A disc that swings about a point on its rim: like a simple pendulum of length 3R/2.
constexpr double kRadius = 0.4;
RunSetup swinging_disc() {
  RunSetup s = setup_with({disc("disc", on_circle(kStart, kRadius), {0, 0}, kRadius, 2.0)});
  s.scene.bodies[0].angle = 0.3;
  s.scene.forces.gravity = {0.0, -kGravity};
  s.scene.joints = {pin("disc", turned_by(-0.3, -on_circle(kStart, kRadius)), {0, 0})};
  return s;
}

// Two discs and a point that are welded at odd places and swing as one body about a pin: I/(m d) is the length
// of the simple pendulum.
constexpr std::array<double, 3> kMasses = {2.0, 0.7, 0.3};
constexpr std::array<double, 3> kDepths = {0.25, 0.6, 0.8};  // m, from the pin
constexpr std::array<double, 3> kRadii = {0.2, 0.15, 0.0};
RunSetup welded_pendulum() {
  RunSetup s = setup_with({});
  const std::array<const char*, 3> names = {"a", "b", "c"};
  for (std::size_t i = 0; i < 3; ++i) {
    s.scene.bodies.push_back(disc(names[i], on_circle(kStart, kDepths[i]), {0, 0}, kRadii[i], kMasses[i]));
    s.scene.bodies[i].angle = 0.4 * static_cast<double>(i);
  }
  s.scene.forces.gravity = {0.0, -kGravity};
  s.scene.joints = {pin("a", -on_circle(kStart, kDepths[0]), {0, 0}), rod_to("a", "b"), rod_to("c", "b")};
  for (std::size_t i = 1; i < 3; ++i) {
    Joint& weld = s.scene.joints[i];
    const Body& body = s.scene.bodies[i == 1 ? 0 : 2];
    const Vec2 place = body.position + Vec2(0.1, 0.05);
    weld.kind = JointKind::kWeld;
    weld.point = turned_by(-body.angle, place - body.position);
    weld.anchor = turned_by(-s.scene.bodies[1].angle, place - s.scene.bodies[1].position);
  }
  return s;
}

double welded_length() {
  double inertia = 0.0;
  double moment = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    inertia += kMasses[i] * (0.5 * kRadii[i] * kRadii[i] + kDepths[i] * kDepths[i]);
    moment += kMasses[i] * kDepths[i];
  }
  return inertia / moment;
}

// Two bobs, the second on the first.
RunSetup double_pendulum() {
  RunSetup s = setup_with({disc("a", {0.6, 0.1}, {0, 0}, 0.05, 1.0), disc("b", {1.1, 0.3}, {0, 0}, 0.05, 0.4)});
  s.scene.forces.gravity = {0.0, -kGravity};
  s.scene.joints = {rod("a", {0, 0}), rod_to("b", "a")};
  return s;
}

// A disc pinned to the plane off its centre, another pinned to its rim and a third hung on a rod from that rim.
RunSetup jointed_discs() {
  RunSetup s = setup_with({disc("a", {0.3, 0.0}, {0, 0}, 0.3, 2.0), disc("b", {0.6, 0.2}, {0, 0}, 0.2, 1.0),
                           disc("c", {1.2, 0.2}, {0, 0}, 0.1, 0.5)});
  s.scene.forces.gravity = {0.0, -kGravity};
  s.scene.joints = {pin("a", {-0.3, 0.0}, {0, 0}), pin("b", {0.0, -0.2}, {0.3, 0.0}), rod_to("c", "b")};
  s.scene.joints[1].to = "a";
  s.scene.joints[2].anchor = {0.2, 0.0};
  s.scene.joints[2].point = {-0.1, 0.0};
  return s;
}

// A bob on a rod from a body that is driven to and fro.
RunSetup driven_joints() {
  RunSetup s = setup_with({disc("mover", {0, 2}, {0, 0}, 0.1), disc("a", {0.5, 1.0}, {0, 0}, 0.05, 1.0)});
  s.scene.bodies[0].mass.reset();
  s.scene.bodies[0].drive = Drive{{0.0, 0.0}, {0.3, 0.2}, 20.0, 0.5 * std::numbers::pi};
  s.scene.forces.gravity = {0.0, -kGravity};
  s.scene.joints = {rod_to("a", "mover")};
  return s;
}

State state_at(RunSetup s, IntegratorId id, double h, double time) {
  s.method.integrator = id;
  s.method.step = h;
  Simulation run(s);
  run.advance_to(time);
  return run.state();
}

// Errors are looked at at several moments, as at a single one they may happen to change their sign.
constexpr int kMoments = 5;
using Moments = std::array<Eigen::Matrix2Xd, kMoments>;

Moments positions_of(RunSetup s, IntegratorId id, int steps_a_moment, double time) {
  s.method.integrator = id;
  s.method.step = time / (kMoments * steps_a_moment);
  Simulation run(s);
  Moments moments;
  for (Eigen::Matrix2Xd& at : moments) {
    for (int i = 0; i < steps_a_moment; ++i) run.step();
    at = run.state().q.topRows<2>();
  }
  return moments;
}

double distance(const Moments& a, const Moments& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]).squaredNorm();
  return std::sqrt(sum / kMoments);
}

Moments on_circle_at(double time, double length, double equivalent_length) {
  Moments moments;
  for (int k = 0; k < kMoments; ++k)
    moments[k] = on_circle(pendulum_angle(kStart, equivalent_length, time * (k + 1) / kMoments), length);
  return moments;
}

// Fits the order of the error in all positions up to `time` for every integrator with a step.
void expect_orders(const RunSetup& s, double time, const Moments& exact, const char* what) {
  for (const IntegratorChoice& choice : kIntegrators) {
    if (choice.order == 0 || choice.adaptive) continue;
    const int coarsest = choice.order == 1 ? 1600 : choice.order == 2 ? 200 : choice.order == 4 ? 100 : 32;
    std::vector<double> steps;
    std::vector<double> errors;
    for (int i = 0; i < 5; ++i) {
      const int steps_a_moment = static_cast<int>(std::round(coarsest * std::exp2(0.5 * i)));
      steps.push_back(time / steps_a_moment);
      errors.push_back(distance(positions_of(s, choice.id, steps_a_moment, time), exact));
    }
    const double order = fitted_order(steps, errors);
    testing::Test::RecordProperty(what + (" " + std::string(choice.name)), std::to_string(order));
    EXPECT_NEAR(order, choice.order, 0.25)
        << what << ", " << choice.name << ", errors " << errors.front() << " to " << errors.back();
  }
}

TEST(JointConstraints, JacobisSineMeetsItsTable) {
  // Abramowitz and Stegun's example: sn(K/2, k) = 1/√(1 + k').
  const double k = 0.8;
  EXPECT_NEAR(jacobi_sn(0.5 * std::comp_ellint_1(k), k), 1.0 / std::sqrt(1.6), 1e-15);
  EXPECT_NEAR(pendulum_angle(kStart, kLength, 0.0), kStart, 1e-15);
}

TEST(JointConstraints, EveryIntegratorKeepsItsOrderOnAPendulum) {
  const double time = 1.7;
  expect_orders(pendulum(), time, on_circle_at(time, kLength, kLength), "rod");
}

TEST(JointConstraints, EveryIntegratorKeepsItsOrderOnAPinnedDisc) {
  const double time = 1.7;
  expect_orders(swinging_disc(), time, on_circle_at(time, kRadius, 1.5 * kRadius), "pin");
}

TEST(JointConstraints, EveryIntegratorKeepsItsOrderOnWeldedBodies) {
  const double time = 1.7;
  const RunSetup s = welded_pendulum();
  validate(s.scene);
  Moments exact;
  for (int k = 0; k < kMoments; ++k) {
    exact[k].resize(2, 3);
    const double angle = pendulum_angle(kStart, welded_length(), time * (k + 1) / kMoments);
    for (std::size_t i = 0; i < 3; ++i)
      exact[k].col(static_cast<Eigen::Index>(i)) = on_circle(angle, kDepths[i]);
  }
  expect_orders(s, time, exact, "weld");
}

// A frame of welds that holds itself in a circle, fastened to the plane: nothing moves or turns.
TEST(JointConstraints, WeldsInACircleHold) {
  RunSetup s = setup_with({disc("a", {0, 1}, {0, 0}), disc("b", {1, 1}, {0, 0}), disc("c", {0.5, 2}, {0, 0})});
  s.scene.forces.gravity = {0.0, -kGravity};
  s.scene.joints = {rod_to("a", "b"), rod_to("b", "c"), rod_to("c", "a"), rod("a", {0, 1})};
  for (Joint& l : s.scene.joints) l.kind = JointKind::kWeld;
  s.scene.joints[0].point = {1, 0};
  s.scene.joints[1].anchor = {0.5, -1};
  s.scene.joints[2].anchor = {0.5, 1};
  s.method.step = 0.01;
  validate(s.scene);
  Simulation run(s);
  const Eigen::Matrix3Xd q = run.state().q;
  run.advance_to(5.0);
  EXPECT_LT((run.state().q - q).norm(), 1e-13);
  EXPECT_EQ(run.impact_count(), 0);
  EXPECT_EQ(run.notices().text(), "ok");
}

TEST(JointConstraints, EveryIntegratorKeepsItsOrderOnCoupledBodies) {
  for (const auto& [name, s] :
       {std::pair("double pendulum", double_pendulum()), std::pair("linked discs", jointed_discs()),
        std::pair("driven", driven_joints())}) {
    const double time = 0.9;
    const Moments fine = positions_of(s, IntegratorId::kDormandPrince, 1600, time);
    EXPECT_LT(distance(fine, positions_of(s, IntegratorId::kDormandPrince, 800, time)), 2e-13) << name;
    expect_orders(s, time, fine, name);
  }
}

TEST(JointConstraints, TheAdaptiveIntegratorFollowsItsTolerance) {
  const double time = 1.7;
  const Vec2 exact = on_circle(pendulum_angle(kStart, kLength, time), kLength);
  double last = 1.0;
  for (const double tolerance : {1e-5, 1e-7, 1e-9, 1e-11}) {
    RunSetup s = pendulum();
    s.method.tolerance = tolerance;
    const double error =
        (state_at(s, IntegratorId::kAdaptiveDormandPrince, 0.05, time).position(0) - exact).norm();
    EXPECT_LT(error, 1000.0 * tolerance);
    EXPECT_LT(error, 0.3 * last);
    last = error;
  }
}

// Lengths and their rates stay within rounding, whatever the integrator and its step.
TEST(JointConstraints, AreKeptWithinRounding) {
  for (const IntegratorChoice& choice : kIntegrators) {
    if (choice.order == 0) continue;
    for (const auto& impacts : kImpacts) {
      RunSetup s = double_pendulum();
      s.method = {choice.id, impacts.id, ContactsId::kImpulse, choice.order == 1 ? 0.002 : 0.01};
      Simulation run(s);
      const double length = Vec2(0.5, 0.2).norm();
      for (int i = 0; i < 500; ++i) {
        run.step();
        const Vec2 d = run.state().position(1) - run.state().position(0);
        const Vec2 u = run.state().velocity(1) - run.state().velocity(0);
        ASSERT_NEAR(d.norm(), length, 2e-15) << choice.name << ", step " << i;
        ASSERT_NEAR(d.dot(u) / length, 0.0, 1e-15 * (1.0 + run.state().v.norm()))
            << choice.name << ", step " << i;
        const Vec2 x = run.state().position(0);
        ASSERT_NEAR(x.norm(), std::hypot(0.6, 0.1), 2e-15) << choice.name;
        ASSERT_NEAR(x.dot(run.state().velocity(0)), 0.0, 1e-15 * (1.0 + run.state().v.norm())) << choice.name;
      }
      EXPECT_EQ(run.notices().text(), "ok") << choice.name;
    }
  }
}

double drift(RunSetup s, double h, double time) {
  s.method.step = h;
  Simulation run(s);
  double most = 0.0;
  run.advance_to(time,
                 [&] { most = std::max(most, std::abs(run.ledger().numerical_drift(run.totals().energy()))); });
  return most;
}

// Joints do no work: what the ledger does not name falls with the order of the method, drives included.
TEST(JointConstraints, EnergyDriftFallsWithTheOrder) {
  for (const RunSetup& s : {double_pendulum(), jointed_discs(), driven_joints()}) {
    const double coarse = drift(s, 1.0 / 256, 1.0);
    const double fine = drift(s, 1.0 / 512, 1.0);
    EXPECT_GT(coarse / fine, 11.0) << coarse;
    EXPECT_LT(coarse / fine, 45.0) << coarse;
    EXPECT_LT(drift(s, 1.0 / 8192, 1.0), 1e-10);
  }
}

// What the plane and drives gave through joints stands in the ledger.
TEST(JointConstraints, MomentumLedgerCloses) {
  for (const RunSetup& s : {double_pendulum(), jointed_discs(), driven_joints()}) {
    RunSetup fine = s;
    fine.method.step = 1.0 / 4096;
    Simulation run(fine);
    run.advance_to(1.0);
    EXPECT_LT(run.ledger().momentum_drift(run.totals().momentum).norm(), 1e-9);
    EXPECT_GT(run.ledger().momentum_from_forces.norm(), 0.1);
  }
}

// Two discs on a rod turn about their common centre.
TEST(JointConstraints, ADumbbellTurnsFreely) {
  RunSetup s =
      setup_with({disc("a", {1.0, 0}, {0.3, 2.0}, 0.1, 1.0), disc("b", {-0.5, 0}, {0.3, -1.0}, 0.1, 2.0)});
  s.scene.joints = {rod_to("a", "b")};
  s.method.step = 1.0 / 1024;
  Simulation run(s);
  run.advance_to(2.0);
  const Vec2 center(0.6, 0.0);
  EXPECT_LT((run.state().position(0) - center - Vec2(std::cos(4.0), std::sin(4.0))).norm(), 1e-10);
  EXPECT_LT((run.state().position(1) - center + 0.5 * Vec2(std::cos(4.0), std::sin(4.0))).norm(), 1e-10);
  EXPECT_LT(run.ledger().momentum_drift(run.totals().momentum).norm(), 1e-12);
}

// Thirty rods and an end a thousand times as heavy as a joint.
TEST(JointConstraints, AChainWithAHeavyEndStaysTogether) {
  for (const auto& impacts : kImpacts) {
    RunSetup s = setup_with({});
    s.scene.forces.gravity = {0.0, -kGravity};
    const Vec2 along = Vec2(std::cos(0.2), -std::sin(0.2));
    for (int i = 1; i <= 30; ++i) {
      s.scene.bodies.push_back(
          disc(fmt::format("d{}", i), 0.1 * i * along, {0, 0}, 0.02, i == 30 ? 10.0 : 0.01));
      s.scene.joints.push_back(i == 1 ? rod("d1", {0, 0})
                                      : rod_to(fmt::format("d{}", i), fmt::format("d{}", i - 1)));
    }
    s.method = {IntegratorId::kRk4, impacts.id, ContactsId::kImpulse, 1.0 / 2000};
    Simulation run(s);
    const double whole = 10.0 * kGravity * 3.0;  // J
    run.advance_to(3.0, [&] {
      for (int i = 0; i < 30; ++i) {
        const Vec2 from = i == 0 ? Vec2(Vec2::Zero()) : run.state().position(i - 1);
        ASSERT_NEAR((run.state().position(i) - from).norm(), 0.1, 1e-14) << run.time();
      }
    });
    EXPECT_EQ(run.notices().text(), "ok");
    EXPECT_LT(std::abs(run.ledger().numerical_drift(run.totals().energy())), 1e-5 * whole);
  }
}

// More rods than a frame needs: those that depend on the others get no force, and nothing moves.
TEST(JointConstraints, AFrameWithSpareRodsStands) {
  RunSetup s = setup_with({disc("a", {0, 1}, {0, 0}), disc("b", {1, 1}, {0, 0})});
  s.scene.forces.gravity = {0.0, -kGravity};
  s.scene.joints = {rod("a", {0, 0}), rod("a", {1, 0}), rod("b", {1, 0}), rod("b", {0, 0}), rod_to("b", "a")};
  s.method.step = 0.01;
  Simulation run(s);
  run.advance_to(5.0);
  EXPECT_LT((run.state().position(0) - Vec2(0, 1)).norm(), 1e-13);
  EXPECT_LT((run.state().position(1) - Vec2(1, 1)).norm(), 1e-13);
  EXPECT_EQ(run.notices().text(), "ok");
}

// What hangs still does so wherever rounding leaves the balance of its forces.
TEST(JointConstraints, WhatHangsStillIsNotTooFast) {
  RunSetup s = setup_with({disc("a", {0, 0}, {0, 0}, 0.1, 0.9)});
  s.scene.forces.gravity = {0.0, -kGravity};
  s.scene.joints = {rod("a", {-0.1, 1.1}), rod("a", {0.1, 1.1})};
  s.scene.joints[0].point = {-0.1, 0.1};
  s.scene.joints[1].point = {0.1, 0.1};
  s.method.step = 0.001;
  Simulation run(s);
  run.advance_to(0.1);
  EXPECT_EQ(run.notices().text(), "ok");
  EXPECT_LT(run.state().q.norm(), 1e-13);
}

// Seven digits in a file are enough, and the run starts on the joints.
TEST(JointConstraints, StartWithinRounding) {
  RunSetup s = pendulum();
  s.scene.joints[0].length = 0.7000001;
  validate(s.scene);
  Simulation run(s);
  EXPECT_NEAR(run.state().position(0).norm(), 0.7000001, 2e-16);
  EXPECT_EQ(run.ledger().numerical_drift(run.totals().energy()), 0.0);
}

// Where all coordinates are zero, the size of the body tells what is rounding.
TEST(JointConstraints, AWheelPinnedAtTheOriginIsNotMissed) {
  for (const double radius : {0.3, 0.0}) {
    for (const Vec2& gravity : {Vec2(0.0, 0.0), Vec2(0.0, -9.81)}) {
      RunSetup s = test::setup_with({test::disc("wheel", {0.0, 0.0}, {0.0, 0.0}, radius)});
      s.scene.bodies[0].spin = radius > 0.0 ? 2.0 : 0.0;
      s.scene.joints = {pin("wheel", {0.0, 0.0}, {0.0, 0.0})};
      s.scene.forces.gravity = gravity;
      s.method.step = 0.01;
      Simulation run(s);
      run.advance_to(1.0);
      EXPECT_EQ(run.status(), "ok") << radius;
      EXPECT_EQ(run.state().position(0).norm(), 0.0);
    }
  }
}

// A step that no motion near the joints resolves is told.
TEST(JointConstraints, MissedJointsAreReported) {
  RunSetup s = double_pendulum();
  s.scene.bodies[0].spin = 0.0;
  s.scene.bodies[1].velocity = 1e9 * crossed(Vec2(0.5, 0.2));
  for (const auto& impacts : kImpacts) {
    s.method = {IntegratorId::kExplicitEuler, impacts.id, ContactsId::kImpulse, 1.0};
    validate(s.scene);
    Simulation run(s);
    for (int i = 0; i < 50; ++i) run.step();
    EXPECT_NE(run.status().find("take shorter steps"), std::string::npos) << run.status();
  }
}

}  // namespace
}  // namespace carom
