#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <gtest/gtest.h>
#include <numbers>
#include <string>

#include "physics/run/simulation.h"
#include "tests/support/scenes.h"

// Bodies in contact that are joined, or become so: strings that go taut, bodies that stick, linked bodies that
// land. Contact forces follow from that moment on, not from the next step on.
namespace carom {
namespace {

using test::box;
using test::fixed;
using test::joint_between;

constexpr double kGravity = 9.81;  // m/s²
constexpr double kSteps[] = {1.0 / 60.0, 0.007, 1.0 / 240.0, 0.001};

RunSetup setup(const std::vector<Body>& bodies, double friction, double step) {
  RunSetup s = test::setup_with(bodies, 0.0, friction);
  s.scene.bodies.insert(s.scene.bodies.begin(), fixed("floor", Wall{}, {0.0, 0.0}));
  s.scene.forces.gravity = {0.0, -kGravity};
  s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, step};
  return s;
}

// Surfaces that stick, but not to the floor.
void add_clay(RunSetup& s, const std::vector<std::string>& bodies) {
  Material clay = s.scene.materials.front();
  const std::string other = clay.name;
  clay.name = "clay";
  clay.sticks = true;
  s.scene.materials.push_back(clay);
  MaterialPair with_floor;
  with_floor.a = other;
  with_floor.b = "clay";
  with_floor.surface = s.scene.materials.front();
  s.scene.pairs.push_back(with_floor);
  for (Body& b : s.scene.bodies) {
    if (std::find(bodies.begin(), bodies.end(), b.name) != bodies.end()) b.material = "clay";
  }
}

double drift(const Simulation& run) { return run.ledger().numerical_drift(run.totals().energy()); }

// Where discs that overlap are pushed apart, the rod of one takes momentum from its anchor: no wall does.
TEST(JoinedContacts, APushAgainstARodGivesTheWallsNothing) {
  for (const ContactsId contacts : {ContactsId::kImpulse, ContactsId::kLasting}) {
    for (const ImpactsId impacts : {ImpactsId::kStepEnd, ImpactsId::kLocated}) {
      RunSetup s = test::setup_with(
          {test::disc("held", {0.0, 0.0}, {1.0, 0.0}), test::disc("free", {0.15, 0.08}, {0.99, 0.0})});
      Joint rod;
      rod.kind = JointKind::kRod;
      rod.body = "held";
      rod.anchor = {0.0, 1.0};
      s.scene.joints = {rod};
      s.method = {IntegratorId::kRk4, impacts, contacts, 0.01};
      Simulation run(s);
      run.advance_to(0.05);
      EXPECT_GT(run.ledger().momentum_from_forces.norm(), 1e-3);
      EXPECT_EQ(run.ledger().momentum_to_walls.norm(), 0.0);
      EXPECT_LT(run.ledger().momentum_drift(run.totals().momentum).norm(), 1e-11);
    }
  }
}

// A box slides until a slack string jerks its equal from rest: both go on with half the speed.
TEST(JoinedContacts, AStringThatGoesTautJerksABoxOnTheFloor) {
  constexpr double kFriction = 0.3;
  constexpr double kSlack = 0.313;  // m
  const double slows = kFriction * kGravity;
  const double jerked_at = std::sqrt(4.0 - 2.0 * slows * kSlack);  // m/s
  for (const IntegratorId integrator : {IntegratorId::kRk4, IntegratorId::kVelocityVerlet}) {
    for (const double step : kSteps) {
      RunSetup s = setup(
          {box("first", {0.0, 0.1}, {2.0, 0.0}, 0.2, 0.2), box("second", {-0.5, 0.1}, {0.0, 0.0}, 0.2, 0.2)},
          kFriction, step);
      s.scene.joints = {joint_between(JointKind::kString, "first", "second")};
      s.scene.joints[0].length = 0.5 + kSlack;
      s.method.integrator = integrator;
      Simulation run(s);
      run.advance_to(1.0);
      const double slid = 0.25 * jerked_at * jerked_at / (2.0 * slows);
      EXPECT_NEAR(run.state().position(2).x(), -0.5 + slid, 1e-9) << step;
      EXPECT_NEAR(run.state().position(1).x(), slid + kSlack, 1e-9) << step;
      EXPECT_NEAR(drift(run), 0.0, 1e-9) << step;
    }
  }
}

// A hook that rises at a constant speed hoists a box: the work that it does is that of the jerk and of the
// lift.
TEST(JoinedContacts, AStringHoistsABoxOffTheFloor) {
  constexpr double kSpeed = 0.5;                      // m/s
  constexpr double kTautAt = (0.513 - 0.4) / kSpeed;  // s
  for (const double step : kSteps) {
    RunSetup s = setup(
        {box("box", {0.0, 0.1}, {0.0, 0.0}, 0.2, 0.2, 2.0), test::disc("hook", {0.0, 0.5}, {0.0, 0.0}, 0.02)},
        0.3, step);
    s.scene.bodies[2].drive = Drive{.velocity = {0.0, kSpeed}};
    s.scene.joints = {joint_between(JointKind::kString, "box", "hook")};
    s.scene.joints[0].length = 0.513;
    Simulation run(s);
    run.advance_to(0.8);
    const double work = 2.0 * (kSpeed * kSpeed + kGravity * kSpeed * (0.8 - kTautAt));
    EXPECT_NEAR(run.ledger().put_in_by_drives, work, 1e-9) << step;
    EXPECT_NEAR(drift(run), 0.0, 1e-9) << step;
  }
}

// The ballistic block on a rough floor: both stop after V²/(2 mu g).
TEST(JoinedContacts, ABulletThatSticksInABlockIsSlowedWithItFromTheHitOn) {
  constexpr double kFriction = 0.3;
  const double speed = 0.1 * 30.0 / 1.1;
  for (const double step : kSteps) {
    RunSetup s = setup({box("block", {0.0, 0.1}, {0.0, 0.0}, 0.2, 0.2),
                        test::disc("bullet", {-0.72, 0.098038}, {30.0, 0.1962}, 0.02, 0.1)},
                       kFriction, step);
    add_clay(s, {"block", "bullet"});
    Simulation run(s);
    run.advance_to(1.5);
    EXPECT_NEAR(run.state().position(1).x(), speed * speed / (2.0 * kFriction * kGravity), 1e-9) << step;
    EXPECT_NEAR(run.ledger().lost_to_friction, 0.5 * 1.1 * speed * speed, 1e-9) << step;
    EXPECT_NEAR(drift(run), 0.0, 1e-9) << step;
  }
}

// With impacts at the step's end bodies that stick are joined, too, and stay so when one of them is pulled.
TEST(JoinedContacts, BodiesStickAtTheStepsEnd) {
  for (const bool rests : {true, false}) {
    for (const double step : kSteps) {
      RunSetup s = setup(
          {box("first", {-0.513, 0.1}, {3.0, 0.0}, 0.2, 0.2), box("second", {0.0, 0.1}, {0.0, 0.0}, 0.2, 0.2)},
          0.0, step);
      add_clay(s, {"first", "second"});
      s.method.impacts = ImpactsId::kStepEnd;
      if (!rests) s.scene.forces.gravity.setZero();
      AppliedForce pull;
      pull.body = "second";
      pull.force = {20.0, 0.0};
      pull.start = 0.4;
      s.scene.forces.applied = {pull};
      Simulation run(s);
      run.advance_to(1.0);
      EXPECT_EQ(run.impact_count(), 1) << step;
      EXPECT_NEAR(run.ledger().lost_to_sticking, 0.25 * 9.0, 1e-12) << step;
      EXPECT_NEAR(run.state().velocity(1).x(), 1.5 + 0.6 * 10.0, 1e-9) << step;
      EXPECT_NEAR((run.state().velocity(2) - run.state().velocity(1)).norm(), 0.0, 1e-9) << step;
    }
  }
}

// Two welded boxes fall on a smooth disc that rests on the floor, off their centre of mass: what is lost is
// that of one body on a disc that can't give way.
TEST(JoinedContacts, WeldedBoxesLandOnADiscAsOneBody) {
  constexpr double kInertia = 2.0 * (0.05 / 12.0 + 0.01);  // kg m²
  constexpr double kArm = 0.12;                            // m
  const double lost = kGravity * 0.2 / (0.5 + kArm * kArm / kInertia);
  RunSetup s =
      setup({test::disc("disc", {0.0, 0.1}, {0.0, 0.0}, 0.1, 0.7),
             box("left", {0.02, 0.45}, {0.0, 0.0}, 0.2, 0.1), box("right", {0.22, 0.45}, {0.0, 0.0}, 0.2, 0.1)},
            0.0, 0.001);
  Joint weld = joint_between(JointKind::kWeld, "right", "left");
  weld.point = {-0.1, 0.0};
  weld.anchor = {0.1, 0.0};
  s.scene.joints = {weld};
  Simulation run(s);
  run.advance_to(0.25);
  EXPECT_NEAR(run.ledger().lost_to_restitution, lost, 1e-9);
  EXPECT_NEAR(drift(run), 0.0, 1e-8);
}

// On a rod, and so with one way to go, a bob stops where it lands on a block on the floor.
TEST(JoinedContacts, ABobThatLandsOnABlockStays) {
  for (const double step : kSteps) {
    RunSetup s = setup(
        {box("block", {0.0, 0.1}, {0.0, 0.0}, 0.4, 0.2, 2.0), test::disc("bob", {0.0, 0.5}, {0.0, 0.0}, 0.1)},
        0.0, step);
    s.scene.joints = {joint_between(JointKind::kRod, "bob", "")};
    s.scene.joints[0].anchor = {-1.0, 0.5};
    Simulation run(s);
    run.advance_to(0.4);
    EXPECT_EQ(run.status(), "ok") << step;
    EXPECT_NEAR(run.ledger().lost_to_restitution, kGravity * 0.2, 1e-6) << step;
    EXPECT_NEAR(run.state().velocity(2).norm(), 0.0, 1e-9) << step;
    EXPECT_NEAR(run.state().v(2, 2), 0.0, 1e-9) << step;
  }
}

// Forces and rods lead bodies past a floor or short of a ceiling that they would meet if they went straight on.
TEST(JoinedContacts, WhatPassesWithoutTouchingIsNotHit) {
  for (const ImpactsId impacts : {ImpactsId::kStepEnd, ImpactsId::kLocated}) {
    for (const double step : kSteps) {
      RunSetup swings = setup({test::disc("bob", {-1.0, 0.0}, {0.0, 0.0})}, 0.0, step);
      swings.scene.materials.front().restitution = 1.0;
      swings.scene.joints = {joint_between(JointKind::kRod, "bob", "")};
      swings.scene.bodies[0].position = {0.0, -1.101};
      RunSetup turns = swings;
      turns.scene.bodies[1] = box("bar", {0.5, 0.0}, {0.0, 0.0}, 1.0, 0.1);
      turns.scene.joints = {joint_between(JointKind::kPin, "bar", "")};
      turns.scene.joints[0].point = {-0.5, 0.0};
      turns.scene.bodies[0].position.y() = -std::hypot(1.0, 0.05) - 1e-4;
      RunSetup rises = swings;
      rises.scene.joints.clear();
      rises.scene.bodies[0].angle = std::numbers::pi;
      rises.scene.bodies[0].position = {0.0, 0.101 + 2.0 * 2.0 / (2.0 * kGravity)};
      rises.scene.bodies[1] = test::disc("ball", {0.0, 0.0}, {0.3, 2.0});
      for (RunSetup& s : {std::ref(swings), std::ref(turns), std::ref(rises)}) {
        s.method.impacts = impacts;
        RunSetup without = s;
        without.scene.bodies.erase(without.scene.bodies.begin());
        Simulation run(s);
        Simulation alone(without);
        run.advance_to(0.8);
        alone.advance_to(0.8);
        EXPECT_EQ(run.impact_count(), 0) << s.scene.bodies[1].name << ", h = " << step;
        EXPECT_NEAR((run.state().q.col(1) - alone.state().q.col(0)).norm(), 0.0, 1e-12)
            << s.scene.bodies[1].name << ", h = " << step;
      }
    }
  }
}

}  // namespace
}  // namespace carom
