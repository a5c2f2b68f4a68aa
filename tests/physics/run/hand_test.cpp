#include "physics/scene/hand.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "physics/run/simulation.h"
#include "physics/scene/facts.h"
#include "tests/support/body_literal.h"
#include "tests/support/fitted_order.h"
#include "tests/support/scenes.h"

// A hand that pulls bodies of a run: a damped spring from a point of the body to a place.
namespace carom {
namespace {

using namespace test::literals;
using test::disc;
using test::setup_with;
using test::wall;

Simulation held(std::vector<Body> bodies, const Hand& hand, const Method& method, double friction = 0.0,
                Vec2 gravity = Vec2::Zero()) {
  RunSetup setup = setup_with(std::move(bodies), 0.0, friction);
  setup.scene.forces.gravity = gravity;
  setup.method = method;
  Simulation run(setup);
  run.apply({SetHand{hand}});
  return run;
}

// m: of a body that a hand takes at its centre, at rest, and moves by 1 m at once.
double closed_form(double t) {
  const double omega = 4.0 * std::numbers::pi;
  const double decay = 0.7 * omega;
  const double swing = omega * std::sqrt(1.0 - 0.7 * 0.7);
  return 1.0 - std::exp(-decay * t) * (std::cos(swing * t) + decay / swing * std::sin(swing * t));
}

TEST(HandOnABody, SwingsItAsADampedSpring) {
  Body body = disc("A", {0.0, 0.0}, {0.0, 0.0}, 0.1, 2.5);
  Hand hand = hand_on(body, body.position);
  hand.place = {0.6, 0.8};
  const auto error = [&](const Method& method) {
    Simulation run = held({body}, hand, method);
    double most = 0.0;
    while (run.time() < 0.79) {
      run.step();
      most = std::max(most, (run.state().position(0_b) - closed_form(run.time()) * Vec2(0.6, 0.8)).norm());
    }
    return most;
  };
  std::vector<double> errors;
  std::vector<double> steps;
  for (double h = 0.02; h > 0.002; h *= 0.5) {
    steps.push_back(h);
    errors.push_back(error({.integrator = IntegratorId::kRk4, .step = h}));
  }
  EXPECT_NEAR(test::fitted_order(steps, errors), 4.0, 0.15);
  EXPECT_LT(errors.back(), 1e-6);
  EXPECT_LT(error({.integrator = IntegratorId::kAdaptiveDormandPrince, .step = 0.01, .tolerance = 1e-13}),
            1e-11);
}

// The force acts at the grip, which turns with the body: against an independent integration.
TEST(HandOnABody, TurnsItWhereTheGripIsOffItsCentre) {
  Body box = disc("box", {0.2, 0.1}, {0.3, -0.2}, 0.1, 1.7);
  box.shape = Box{0.4, 0.2};
  box.angle = 0.4;
  box.spin = 1.5;
  Hand hand = hand_on(box, {0.32, 0.2});
  hand.place = {0.9, 0.4};
  Simulation run =
      held({box}, hand, {.integrator = IntegratorId::kAdaptiveDormandPrince, .step = 0.01, .tolerance = 1e-13});
  run.advance_to(0.7);

  const double inertia = 1.7 * (0.4 * 0.4 + 0.2 * 0.2) / 12.0;
  using Vector = std::array<double, 7>;  // x, y, angle, v_x, v_y, spin, work
  const auto rate = [&](const Vector& s) {
    const double c = std::cos(s[2]);
    const double n = std::sin(s[2]);
    const double ax = c * hand.grip.x() - n * hand.grip.y();
    const double ay = n * hand.grip.x() + c * hand.grip.y();
    const double ux = s[3] - s[5] * ay;
    const double uy = s[4] + s[5] * ax;
    const double fx = hand.stiffness * (hand.place.x() - s[0] - ax) - hand.damping * ux;
    const double fy = hand.stiffness * (hand.place.y() - s[1] - ay) - hand.damping * uy;
    return Vector{s[3], s[4], s[5], fx / 1.7, fy / 1.7, (ax * fy - ay * fx) / inertia, fx * ux + fy * uy};
  };
  Vector s{0.2, 0.1, 0.4, 0.3, -0.2, 1.5, 0.0};
  constexpr int kSteps = 20000;
  const double h = 0.7 / kSteps;
  const auto off = [](const Vector& a, double by, const Vector& k) {
    Vector sum = a;
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += by * k[i];
    return sum;
  };
  for (int i = 0; i < kSteps; ++i) {
    const Vector a = rate(s);
    const Vector b = rate(off(s, 0.5 * h, a));
    const Vector c = rate(off(s, 0.5 * h, b));
    const Vector d = rate(off(s, h, c));
    for (std::size_t k = 0; k < s.size(); ++k) s[k] += h / 6.0 * (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]);
  }
  const State& state = run.state();
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(state.q.col(0)[i], s[static_cast<std::size_t>(i)], 1e-10) << i;
    EXPECT_NEAR(state.v.col(0)[i], s[static_cast<std::size_t>(i) + 3], 1e-9) << i;
  }
  const Ledger ledger = run.ledger();
  EXPECT_NEAR(ledger.put_in_by_user, s[6], 1e-9);
  EXPECT_EQ(ledger.put_in_by_drives, 0.0);
  EXPECT_NEAR(ledger.numerical_drift(run.totals().energy()), 0.0, 1e-9);
  EXPECT_NEAR(ledger.momentum_drift(run.totals().momentum).norm(), 0.0, 1e-10);
  EXPECT_NEAR(ledger.angular_momentum_drift(run.totals().angular_momentum), 0.0, 1e-10);
}

// Under every integrator that allows it: moved on the way, let go, and free from then on.
TEST(HandOnABody, LetsItGoAtItsVelocity) {
  for (const IntegratorId integrator :
       {IntegratorId::kExplicitEuler, IntegratorId::kSemiImplicitEuler, IntegratorId::kVelocityVerlet,
        IntegratorId::kRk4, IntegratorId::kDormandPrince, IntegratorId::kAdaptiveDormandPrince}) {
    Body body = disc("A", {0.0, 0.0}, {0.0, 0.0});
    Hand hand = hand_on(body, {0.05, 0.0});
    RunSetup setup = setup_with({body, disc("B", {0.0, 3.0}, {0.1, 0.0})});
    setup.method = {.integrator = integrator, .step = 0.005};
    std::uint64_t id = 1;
    for (int i = 1; i <= 40; ++i) {
      hand.place = {0.05 + 0.02 * i, 0.01 * i};
      setup.edits.push_back({0.01 * i, id, SceneEdits{SetHand{hand}}});
    }
    setup.edits.push_back({0.45, id, SceneEdits{SetHand{}}});
    Simulation run(setup);
    run.advance_to(0.46);
    const Vec2 thrown = run.state().velocity(0_b);
    EXPECT_GT(thrown.norm(), 0.5);
    const double put_in = run.ledger().put_in_by_user;
    run.advance_to(1.0);
    EXPECT_EQ(run.state().velocity(0_b), thrown);
    EXPECT_EQ(run.ledger().put_in_by_user, put_in);
    EXPECT_NEAR(run.state().position(1_b).x(), 0.1, 1e-12) << "the other body knows nothing of it";
    Simulation again(setup);
    again.advance_to(1.0);
    EXPECT_TRUE(test::same_bytes(run.state(), again.state()));
  }
}

// A box on a floor with friction stays until the hand pulls harder than it.
TEST(HandOnABody, PullsAgainstFriction) {
  constexpr double kFriction = 0.4;
  constexpr double kGravity = 9.81;
  Body box = disc("box", {0.0, 0.1}, {0.0, 0.0}, 0.1, 2.0);
  box.shape = Box{0.4, 0.2};
  const std::vector<Body> bodies = {box, wall("floor", {0.0, -0.5}, 10.0, 1.0)};
  const Method method{.integrator = IntegratorId::kRk4, .contacts = ContactsId::kLasting, .step = 0.005};
  Hand hand = hand_on(box, {0.0, 0.0});                               // low, so that it does not tip
  const double breaks = kFriction * 2.0 * kGravity / hand.stiffness;  // m
  hand.place = {0.95 * breaks, 0.0};
  Simulation holds = held(bodies, hand, method, kFriction, {0.0, -kGravity});
  holds.advance_to(1.0);
  EXPECT_LT(holds.state().velocity(0_b).norm(), 1e-12);
  EXPECT_LT((holds.state().position(0_b) - box.position).norm(), 1e-12);
  hand.place = {2.0 * breaks, 0.0};
  Simulation slides = held(bodies, hand, method, kFriction, {0.0, -kGravity});
  slides.advance_to(3.0);
  EXPECT_LT(slides.state().velocity(0_b).norm(), 1e-9) << "it comes to rest where friction holds it";
  EXPECT_GT(slides.state().position(0_b).x(), 0.9 * breaks);
  EXPECT_GT(slides.ledger().lost_to_friction, 0.0);
}

TEST(HandOnABody, HoldsNoBodyThatIsFixedOrGone) {
  Body body = disc("A", {0.0, 0.0}, {1.0, 0.0});
  Hand hand = hand_on(body, {0.0, 0.0});
  hand.place = {5.0, 5.0};
  for (const char* name : {"floor", "nobody"}) {
    hand.body = name;
    Simulation run = held({body, wall("floor", {0.0, -2.0}, 4.0, 1.0)}, hand, {.step = 0.01});
    run.advance_to(0.5);
    EXPECT_NEAR(run.state().position(0_b).x(), 0.5, 1e-12) << name;
  }
}

TEST(HandOnABody, NeedsAnotherMethodThanExactFlight) {
  Scene scene = test::scene_with({disc("A", {0.0, 0.0}, {0.0, 0.0})});
  EXPECT_FALSE(why_not(scene, IntegratorId::kExactFlight));
  scene.forces.hand = hand_on(scene.bodies[0], {0.0, 0.0});
  ASSERT_TRUE(why_not(scene, IntegratorId::kExactFlight));
  EXPECT_NE(why_not(scene, IntegratorId::kExactFlight)->find("a hand that pulls"), std::string::npos);
}

// Bodies that lie on others under impulses alone, while the hand moves another one in each step.
TEST(HandOnABody, LeavesTheContactsOfOthersAlone) {
  const std::vector<Body> bodies = {
      disc("A", {0.0, 3.0}, {0.0, 0.0}, 0.1, 1.0), disc("low", {2.0, 0.09}, {0.0, 0.0}, 0.1, 1.0),
      disc("high", {2.0, 0.29}, {0.0, 0.0}, 0.1, 1.0), wall("floor", {0.0, -0.5}, 10.0, 1.0)};
  Method method{.integrator = IntegratorId::kAdaptiveDormandPrince, .step = 0.01};
  const Hand hand = hand_on(bodies[0], bodies[0].position);
  Simulation still = held(bodies, hand, method, 0.0, {0.0, -9.81});
  Simulation moved = held(bodies, hand, method, 0.0, {0.0, -9.81});
  while (still.time() < 1.0) {
    Hand there = hand;
    there.place += Vec2(0.1 * std::sin(9.0 * moved.time()), 0.0);
    moved.apply({SetHand{there}});
    still.step();
    moved.step();
    for (const BodyIndex body : {1_b, 2_b})
      ASSERT_NEAR(moved.state().position(body).y(), still.state().position(body).y(), 1e-6) << moved.time();
  }
}

}  // namespace
}  // namespace carom
