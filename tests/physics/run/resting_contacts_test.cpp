#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "physics/collision/contact.h"
#include "physics/collision/pair_contact.h"
#include "physics/dynamics/integrators/integrators.h"
#include "physics/run/run_setup.h"
#include "tests/support/body_literal.h"
#include "tests/support/scenes.h"

// Resting contacts against closed forms.
namespace carom {
namespace {

using namespace test::literals;

constexpr double kG = 9.81;
constexpr double kStep = 1.0 / 60.0;

Material rough(double friction, double restitution = 0.0) {
  Material m;
  m.restitution = restitution;
  m.static_friction = m.kinetic_friction = friction;
  return m;
}

Body ground(double angle = 0.0) {
  Body b;
  b.name = "ground";
  b.shape = Wall{};
  b.angle = angle;
  b.fixed = true;
  return b;
}

Body box(const std::string& name, const Vec2& at, double density = 1.0) {
  Body b;
  b.name = name;
  b.shape = Box{1.0, 1.0};
  b.position = at;
  b.density = density;
  return b;
}

Body round_body(const std::string& name, const Vec2& at, double radius) {
  Body b;
  b.name = name;
  b.shape = Disc{radius};
  b.position = at;
  b.density = 1.0;
  return b;
}

RunSetup scene(const Material& material, std::vector<Body> bodies) {
  RunSetup s;
  s.scene.forces.gravity = Vec2(0.0, -kG);
  s.scene.materials = {material};
  s.scene.bodies = std::move(bodies);
  s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, kStep};
  return s;
}

Simulation run(const RunSetup& s, double until) {
  Simulation simulation(s);
  simulation.advance_to(until);
  return simulation;
}

// Every integrator, with both choices for impacts.
template <class Check>
void for_every_method(RunSetup s, const Check& check) {
  for (const auto& integrator : kIntegrators) {
    for (const auto& impacts : kImpacts) {
      SCOPED_TRACE(std::string(integrator.name) + ", " + std::string(impacts.name));
      s.method.integrator = integrator.id;
      s.method.impacts = impacts.id;
      check(s);
    }
  }
}

RunSetup incline(double slope, double friction) {
  const double angle = std::atan(slope);
  Body block = box("block", 0.5 * Vec2(-std::sin(angle), std::cos(angle)));
  block.angle = angle;
  return scene(rough(friction), {ground(angle), block});
}

double drift(const Simulation& s) { return s.ledger().numerical_drift(s.totals().energy()); }

TEST(RestingContacts, ImpulsesOnlySayThatTheyHaveNoLawsOfRest) {
  Material rolling = rough(0.3);
  rolling.rolling_resistance = 0.01;
  Material held = rough(0.3);
  held.static_friction = 0.5;
  const std::vector<std::pair<Material, bool>> surfaces = {{rough(0.3), false}, {rolling, true}, {held, true}};
  for (const auto& [material, unused] : surfaces) {
    RunSetup setup = scene(material, {ground(), round_body("ball", Vec2(0.0, 1.0), 0.5)});
    EXPECT_EQ(run(setup, 0.0).status(), "ok");
    setup.method.contacts = ContactsId::kImpulse;
    EXPECT_EQ(run(setup, 0.0).notices().laws_of_rest_unused_since, unused ? 0.0 : -1.0);
  }
}

TEST(RestingContacts, ABlockBelowTheFrictionConeStays) {
  const RunSetup s = incline(0.995 * 0.5, 0.5);
  for_every_method(s, [](const RunSetup& each) {
    const Simulation end = run(each, 60.0);
    EXPECT_LT((end.state().position(1) - end.bodies()[1].position).norm(), 1e-9);
    EXPECT_EQ(end.notices().text(), "ok");
  });
}

TEST(RestingContacts, ABlockAboveTheFrictionConeSlidesAsItMust) {
  const double angle = std::atan(1.005 * 0.5);
  const double a = kG * (std::sin(angle) - 0.5 * std::cos(angle));
  for_every_method(incline(1.005 * 0.5, 0.5), [&](const RunSetup& each) {
    const Simulation end = run(each, 10.0);
    EXPECT_NEAR(end.state().velocity(1).norm(), 10.0 * a, 1e-9 * 10.0 * a);
    EXPECT_NEAR(end.state().velocity(1).normalized().dot(Vec2(-std::cos(angle), -std::sin(angle))), 1.0, 1e-12);
    EXPECT_NEAR(end.state().q(2, 1), angle, 1e-9);
  });
}

TEST(RestingContacts, StaticFrictionHoldsWhatKineticFrictionDoesNot) {
  RunSetup s = incline(0.45, 0.5);
  s.scene.materials[0].kinetic_friction = 0.4;
  EXPECT_LT(run(s, 10.0).state().velocity(1).norm(), 1e-10);
  s.scene.bodies[1].velocity =
      0.1 * Vec2(-std::cos(s.scene.bodies[1].angle), -std::sin(s.scene.bodies[1].angle));
  const double a = kG * (std::sin(s.scene.bodies[1].angle) - 0.4 * std::cos(s.scene.bodies[1].angle));
  EXPECT_NEAR(run(s, 10.0).state().velocity(1).norm(), 0.1 + 10.0 * a, 1e-8);
}

// From rest on a slope that is too steep for static friction, kinetic friction acts from the first moment on.
TEST(RestingContacts, ABlockBreaksAwayUnderKineticFriction) {
  const double angle = std::atan(0.6);
  const double a = kG * (std::sin(angle) - 0.3 * std::cos(angle));
  RunSetup s = incline(0.6, 0.5);
  s.scene.materials[0].kinetic_friction = 0.3;
  for_every_method(s, [&](const RunSetup& each) {
    const Simulation end = run(each, 1.0);
    EXPECT_NEAR(end.state().velocity(1).norm(), a, 1e-9);
  });
}

// v = v0/(1 + 1/β) with β = 1/2, for any friction.
TEST(RestingContacts, SlidingBecomesRolling) {
  Body disc = round_body("disc", {0.0, 0.25}, 0.25);
  disc.velocity = Vec2(3.0, 0.0);
  for_every_method(scene(rough(0.3), {ground(), disc}), [](const RunSetup& each) {
    const Simulation end = run(each, 3.0);
    EXPECT_NEAR(end.state().velocity(1).x(), 2.0, 1e-12);
    EXPECT_NEAR(end.state().v(2, 1), -8.0, 1e-11);
    EXPECT_NEAR(drift(end), 0.0, 1e-12);
    EXPECT_NEAR(end.ledger().lost_to_friction, end.mass().mass[1] * 1.5, 1e-12);
  });
}

TEST(RestingContacts, ADiscRollsUpToThriceTheFrictionAngle) {
  for (const double share : {0.99, 1.01}) {
    const double angle = std::atan(share * 3.0 * 0.2);
    const Body disc = round_body("disc", 0.25 * Vec2(-std::sin(angle), std::cos(angle)), 0.25);
    const Simulation end = run(scene(rough(0.2), {ground(angle), disc}), 5.0);
    const double slip = end.state().v(2, 1) * 0.25 - end.state().velocity(1).norm();
    const double a =
        share < 1.0 ? 2.0 / 3.0 * kG * std::sin(angle) : kG * (std::sin(angle) - 0.2 * std::cos(angle));
    EXPECT_NEAR(end.state().velocity(1).norm(), 5.0 * a, 1e-9 * 5.0 * a) << share;
    EXPECT_NEAR(slip, share < 1.0 ? 0.0 : 5.0 * (2.0 * kG * 0.2 * std::cos(angle) - a), 1e-8) << share;
  }
}

TEST(RestingContacts, RollingResistanceStopsADisc) {
  Body disc = round_body("disc", {0.0, 0.25}, 0.25);
  disc.velocity = Vec2(1.0, 0.0);
  disc.spin = -4.0;
  RunSetup s = scene(rough(0.5), {ground(), disc});
  s.scene.materials[0].rolling_resistance = 0.02;
  // The moment c R N on the inertia 3/2 m R² about the contact: a = 2/3 c g.
  const double a = 2.0 / 3.0 * 0.02 * kG;
  const Simulation half = run(s, 3.0);
  EXPECT_NEAR(half.state().velocity(1).x(), 1.0 - 3.0 * a, 1e-10);
  const Simulation end = run(s, 20.0);
  EXPECT_LT(end.state().velocity(1).norm(), 1e-10);
  EXPECT_LT(std::abs(end.state().v(2, 1)), 1e-10);
  EXPECT_NEAR(end.ledger().lost_to_rolling, end.ledger().initial - end.totals().energy(), 1e-11);
  EXPECT_NEAR(end.state().position(1).x(), 0.5 / a, 1e-3);
}

TEST(RestingContacts, AStackStands) {
  RunSetup s = scene(rough(0.6), {ground()});
  for (int i = 0; i < 20; ++i) s.scene.bodies.push_back(box("box-" + std::to_string(i), {0.0, 0.5 + i}));
  for_every_method(s, [](const RunSetup& each) {
    const Simulation end = run(each, 5.0);
    for (int i = 1; i <= 20; ++i)
      EXPECT_LT((end.state().position(i) - end.bodies()[i].position).norm(), 1e-7) << i;
    EXPECT_EQ(end.notices().text(), "ok");
  });
}

// Eighty contacts: more than an island may have that is solved exactly at any speed.
TEST(RestingContacts, ATallStackStands) {
  RunSetup s = scene(rough(0.6), {ground()});
  for (int i = 0; i < 40; ++i) s.scene.bodies.push_back(box("box-" + std::to_string(i), {0.0, 0.5 + i}));
  for (const IntegratorId integrator : {IntegratorId::kExplicitEuler, IntegratorId::kRk4}) {
    s.method.integrator = integrator;
    const Simulation end = run(s, 3.0);
    for (int i = 1; i <= 40; ++i)
      EXPECT_LT((end.state().position(i) - end.bodies()[i].position).norm(), 1e-8) << i;
    EXPECT_EQ(end.notices().text(), "ok");
  }
}

// Each face carries the weight above it.
TEST(RestingContacts, ForcesAreTheWeightsAbove) {
  RunSetup s = scene(rough(0.6), {ground()});
  for (int i = 0; i < 5; ++i) s.scene.bodies.push_back(box("box-" + std::to_string(i), {0.0, 0.5 + i}));
  const Simulation end = run(s, 1.0);
  for (int i = 0; i < 5; ++i) {
    double force = 0.0;
    for (const ContactForce& f : end.contact_forces()) {
      if (f.a == i && f.b == i + 1) force += f.normal_force;
      EXPECT_TRUE(f.sticks);
    }
    EXPECT_NEAR(force, (5 - i) * kG, 1e-8) << i;
  }
}

TEST(RestingContacts, AHeavyBoxRestsOnALightOne) {
  const RunSetup s = scene(rough(0.6), {ground(), box("light", {0.0, 0.5}), box("heavy", {0.0, 1.5}, 1e6)});
  for_every_method(s, [](const RunSetup& each) {
    const Simulation end = run(each, 10.0);
    EXPECT_NEAR(end.state().position(2).y(), 1.5, 1e-8);
  });
}

TEST(RestingContacts, BoxesComeToRestAndTheLedgerTellsLossesFromDrift) {
  RunSetup s = scene(rough(0.4, 0.3), {ground()});
  for (int i = 0; i < 5; ++i) {
    s.scene.bodies.push_back(box("box-" + std::to_string(i), {0.3 * i, 1.5 + 1.6 * i}));
    s.scene.bodies.back().angle = 0.3 * i;
  }
  for (const auto& impacts : kImpacts) {
    s.method.impacts = impacts.id;
    const Simulation end = run(s, 20.0);
    EXPECT_LT(end.totals().kinetic(), 1e-18) << impacts.name;
    EXPECT_LT(end.ledger().momentum_drift(end.totals().momentum).norm(), 1e-9) << impacts.name;
    EXPECT_NEAR(drift(end), 0.0, 0.01 * end.ledger().initial) << impacts.name;
    for (const double lost : {end.ledger().lost_to_friction, end.ledger().lost_to_restitution})
      EXPECT_GE(lost, 0.0) << impacts.name;
  }
}

// Discs that start penetrating are pushed apart without gaining speed.
TEST(RestingContacts, OverlapsPartWithoutSpeed) {
  RunSetup s = scene(rough(0.0), {});
  s.scene.forces.gravity.setZero();
  for (int i = 0; i < 25; ++i)
    s.scene.bodies.push_back(round_body("disc-" + std::to_string(i), {0.375 * (i % 5), 0.375 * (i / 5)}, 0.25));
  Body press;  // a body that may press: otherwise the scene needs no resting contacts
  press = round_body("far", {50.0, 0.0}, 0.1);
  press.velocity = Vec2(0.0, 1.0);
  s.scene.bodies.push_back(press);
  for_every_method(s, [](const RunSetup& each) {
    Simulation simulation(each);
    for (int k = 0; k < 240; ++k) {
      simulation.step();
      for (int i = 0; i < 25; ++i) ASSERT_LT(simulation.state().velocity(i).norm(), 1e-12);
    }
    for (int i = 0; i < 25; ++i) {
      for (int j = 0; j < i; ++j)
        ASSERT_GT((simulation.state().position(i) - simulation.state().position(j)).norm(), 0.5 - 1e-6);
    }
  });
}

TEST(RestingContacts, ABoxRidesOnADrivenTable) {
  Body table = box("table", {0.0, -0.5});
  table.density.reset();
  table.drive = Drive{.amplitude = Vec2(0.0, 0.02), .angular_frequency = std::sqrt(0.9 * kG / 0.02)};
  RunSetup s = scene(rough(0.5), {table, box("box", {0.0, 0.5})});
  for (const auto& impacts : kImpacts) {
    s.method.impacts = impacts.id;
    Simulation simulation(s);
    double most = 0.0;
    while (simulation.time() < 5.0) {
      simulation.step();
      most = std::max(most,
                      std::abs(simulation.state().position(1).y() - simulation.state().position(0).y() - 1.0));
    }
    // Within a step the forces are constant, while the drive's acceleration changes by A ω³ h.
    const double w = s.scene.bodies[0].drive->angular_frequency;
    EXPECT_LT(most, 0.02 * w * w * w * kStep * kStep * kStep) << impacts.name;
  }
}

// Explicit Euler moves the box by the velocity at the step's start: where the table turns away it leaves a gap
// of half its acceleration times h², which the next step closes. The first step starts inside by as much.
TEST(RestingContacts, ABoxStaysOnADrivenTableUnderExplicitEuler) {
  constexpr double kSwing = 0.9;  // of g
  const double w = 4.0 * std::numbers::pi;
  const double amplitude = kSwing * kG / (w * w);
  Body table = box("table", {0.0, -0.5});
  table.density.reset();
  table.shape = Box{2.0, 1.0};
  table.drive =
      Drive{.amplitude = Vec2(0.0, amplitude), .angular_frequency = w, .phase = -0.5 * std::numbers::pi};
  RunSetup s = scene(rough(0.5, 0.5), {table, box("box", {0.0, 0.5 - amplitude})});
  s.method.integrator = IntegratorId::kExplicitEuler;
  for (const double step : {1.0 / 60.0, 1.0 / 240.0, 1.0 / 960.0}) {
    s.method.step = step;
    Simulation simulation(s);
    const double most = 0.5 * kSwing * kG * step * step;  // m
    double gap = 0.0;
    double overlap = 0.0;
    while (simulation.time() < 3.0) {
      simulation.step();
      const double apart = simulation.state().position(1).y() - simulation.state().position(0).y() - 1.0;
      gap = std::max(gap, apart);
      overlap = std::max(overlap, -apart);
    }
    EXPECT_LT(gap, 1.001 * most) << step;
    EXPECT_LT(overlap, 2.002 * most) << step;
    EXPECT_EQ(simulation.impact_count(), 0);
  }
}

// A box falls onto a face corner by corner, a thin rod onto its other tip: the second landing is located too.
// While they pivot, the contact is on the surface within the order of the method: g h³ in m, h in s.
TEST(RestingContacts, WhatLandsDoesNotSinkIn) {
  Body tile = box("tile", {0.0, 1.0});
  tile.angle = 0.5;
  Body rod = box("rod", {3.0, 0.6});
  rod.shape = Wall{1.0};
  rod.density.reset();
  rod.mass = 1.0;
  rod.angle = 0.7;
  RunSetup s = scene(rough(0.3), {ground(), tile, rod});
  for (const double restitution : {0.0, 0.5}) {
    s.scene.materials[0].restitution = restitution;
    Simulation simulation(s);
    while (simulation.time() < 3.0) {
      simulation.step();
      for (const BodyIndex i : {1_b, 2_b}) {
        const Contact c = contact_between(simulation.shapes(), 0_b, simulation.state().q.col(0), i,
                                          simulation.state().q.col(i));
        ASSERT_GT(c.gap, -kG * kStep * kStep * kStep)
            << restitution << ", " << simulation.bodies()[i].name << " at t = " << simulation.time();
      }
    }
    EXPECT_LT(simulation.totals().kinetic(), 1e-15) << restitution;
  }
}

// A thin wall rests on the floor with both ends, on either side.
TEST(RestingContacts, AThinWallLiesOnEitherSide) {
  for (const double angle : {0.0, std::numbers::pi}) {
    Body rod = box("rod", {0.0, 0.0});
    rod.shape = Wall{1.0};
    rod.density.reset();
    rod.mass = 2.0;
    rod.angle = angle;
    const Simulation end = run(scene(rough(0.3), {ground(), rod}), 2.0);
    ASSERT_EQ(end.contact_forces().size(), 2U) << angle;
    for (const ContactForce& f : end.contact_forces()) EXPECT_NEAR(f.normal_force, kG, 1e-8) << angle;
    EXPECT_NEAR(end.state().position(1).y(), 0.0, 1e-10);
  }
}

// Discs on a grid in a container of the same width: a large island once they touch.
RunSetup crowd(const Vec2& spacing) {
  constexpr int kColumns = 20;
  Body left = ground(-0.5 * std::numbers::pi);
  Body right = ground(0.5 * std::numbers::pi);
  left.name = "left";
  right.name = "right";
  right.position.x() = kColumns * spacing.x();
  RunSetup s = scene(rough(0.5), {ground(), left, right});
  s.scene.materials[0].rolling_resistance = 0.05;
  s.scene.generators = {{.columns = kColumns,
                         .rows = 12,
                         .origin = 0.5 * spacing,
                         .spacing = spacing,
                         .jitter = 0.5 * (spacing.x() - 0.5),
                         .radius_min = 0.25,
                         .radius_max = 0.25,
                         .seed = 1}};
  return s;
}

TEST(RestingContacts, ShortStepsForgetNoContact) {
  RunSetup s = crowd(Vec2(0.5, 0.5));
  for (const auto& impacts : kImpacts) {
    s.method.impacts = impacts.id;
    Simulation simulation(s);
    simulation.advance_to(2.0);  // a large island comes to rest gradually
    for (const double share : {1.0, 1e-9, 1.0, 1e-6, 1.0, 1e-3, 1.0, 0.3, 1.0, 1.0}) {
      simulation.step(share * kStep);
      ASSERT_GT(simulation.contact_forces().size(), 400U);
      EXPECT_LT(simulation.state().v.cwiseAbs().maxCoeff(), 1e-6) << impacts.name << ", " << share;
    }
  }
}

// The forces of a very short step are all solver tolerance: the next step must not start from them.
TEST(RestingContacts, ShortStepsLeaveNoBurst) {
  RunSetup s = crowd(Vec2(0.55, 0.75));
  s.method.impacts = ImpactsId::kStepEnd;
  Simulation simulation(s);
  for (int k = 0; k < 150; ++k) {
    simulation.step(kStep);
    if (k % 5 == 0) simulation.step(1e-9 * kStep);
    ASSERT_LT(simulation.totals().energy(), (1.0 + 1e-12) * simulation.ledger().initial) << k;
  }
  EXPECT_GT(simulation.contact_forces().size(), 400U);
  EXPECT_LT(simulation.totals().kinetic(), 1e-2 * simulation.ledger().initial);
}

TEST(RestingContacts, TheSameRunGivesTheSameBits) {
  RunSetup s = scene(rough(0.5), {ground()});
  for (int i = 0; i < 30; ++i)
    s.scene.bodies.push_back(
        round_body("disc-" + std::to_string(i), {0.51 * (i % 6) + 0.01 * i, 0.3 + 0.55 * (i / 6)}, 0.25));
  const Simulation one = run(s, 2.0);
  Simulation begun(s);
  begun.advance_to(1.0);
  Simulation copy = begun;
  copy.advance_to(2.0);
  EXPECT_EQ(one.state().q, copy.state().q);
  EXPECT_EQ(one.state().v, copy.state().v);
}

// The normal turns with the motion.
TEST(RestingContacts, RollingOffARoundTopIsOfSecondOrder) {
  Body top = round_body("top", {0.0, 0.0}, 1.0);
  top.density.reset();
  top.fixed = true;
  const double start = 0.3;
  RunSetup s =
      scene(rough(5.0), {top, round_body("disc", 1.25 * Vec2(std::sin(start), std::cos(start)), 0.25)});
  // Rolling: ½ (3/2) m v² = m g 1.25 (cos θ0 - cos θ).
  std::vector<double> errors;
  for (const double h : {0.01, 0.005, 0.0025}) {
    s.method.step = h;
    const Simulation end = run(s, 0.8);
    const double cosine = end.state().position(1).y() / end.state().position(1).norm();
    const double speed = std::sqrt(4.0 / 3.0 * kG * 1.25 * (std::cos(start) - cosine));
    ASSERT_LT(cosine, std::cos(start) - 0.05);
    ASSERT_NEAR(end.state().position(1).norm(), 1.25, 1e-3);
    errors.push_back(std::abs(end.state().velocity(1).norm() - speed));
  }
  EXPECT_LT(errors[1], 0.3 * errors[0]);
  EXPECT_LT(errors[2], 0.3 * errors[1]);
  EXPECT_LT(errors[2], kG * 0.0025 * 0.0025);
}

// A disc of 2 kg, R = 0.1 m, that a torque τ = 3 N m spins on a rough floor: it slides all the way, x = μ g
// t²/2 and ω = -(τ - μ m g R) t/I, however far it turns in a step.
TEST(RestingContacts, WheelspinLosesTheWorkOfItsSlip) {
  for (const ImpactsId impacts : {ImpactsId::kLocated, ImpactsId::kStepEnd}) {
    for (const double h : {1.0 / 30.0, 1.0 / 60.0, 0.01, 0.002}) {
      RunSetup s = test::setup_with(
          {test::fixed("floor", Wall{}, {0.0, 0.0}), test::disc("wheel", {0.0, 0.1}, {0.0, 0.0}, 0.1)}, 0.0,
          0.5);
      s.scene.bodies[1].mass = 2.0;
      s.scene.forces.gravity = {0.0, -9.81};
      AppliedForce motor;
      motor.body = "wheel";
      motor.torque = -3.0;
      s.scene.forces.applied = {motor};
      s.method = {IntegratorId::kRk4, impacts, ContactsId::kLasting, h};
      Simulation run(s);
      const double t = 0.6;
      run.advance_to(t);
      const double acceleration = 0.5 * 9.81;
      const double turning = (3.0 - 0.5 * 2.0 * 9.81 * 0.1) / (0.5 * 2.0 * 0.01);
      EXPECT_NEAR(run.state().position(1).x(), 0.5 * acceleration * t * t, 1e-9) << h;
      EXPECT_NEAR(run.state().v(2, 1), -turning * t, 1e-9) << h;
      const double slip = 0.5 * t * t * (0.1 * turning - acceleration);
      EXPECT_NEAR(run.ledger().lost_to_friction, 0.5 * 2.0 * 9.81 * slip, 1e-9) << h;
    }
  }
}

// A disc that is put onto a rough floor, with backspin or topspin, lands on nothing: slip takes all that is
// lost, whatever static friction may hold later.
TEST(RestingContacts, ASpinningDiscLosesEnergyToFrictionAlone) {
  for (const double spin : {-80.0, -2.0, 16.12, 50.0}) {
    for (const double static_friction : {1.0, 1.3}) {
      Body disc = round_body("disc", {0.0, 0.15}, 0.15);
      disc.velocity = Vec2(1.615, 0.0);
      disc.spin = spin;
      Material material = rough(1.0);
      material.static_friction = static_friction;
      for_every_method(scene(material, {ground(), disc}), [&](RunSetup each) {
        for (const double h : {kStep, 1.0 / 240.0}) {
          each.method.step = h;
          const Simulation end = run(each, 1.5);
          // What rolls keeps v = (v0 - R ω0/2)/(3/2), with ω0 against the sense of rolling.
          const double rolls = (1.615 - 0.5 * 0.15 * spin) / 1.5;
          const double mass = end.mass().mass[1];
          const double lost =
              0.5 * mass * (1.615 * 1.615 + 0.5 * 0.15 * 0.15 * spin * spin - 1.5 * rolls * rolls);
          EXPECT_NEAR(end.ledger().lost_to_friction, lost, 1e-10) << spin << ' ' << h;
          EXPECT_NEAR(end.ledger().lost_to_restitution, 0.0, 1e-13) << spin << ' ' << h;
          EXPECT_NEAR(drift(end), 0.0, 1e-12) << spin << ' ' << h;
        }
      });
    }
  }
}

}  // namespace
}  // namespace carom
