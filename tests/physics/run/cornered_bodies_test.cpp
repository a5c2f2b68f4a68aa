#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <random>

#include "physics/collision/pair_contact.h"
#include "physics/run/run_setup.h"
#include "tests/support/impacts.h"
#include "tests/support/scenes.h"

// Complete runs of bodies that are not discs.
namespace carom {
namespace {

using test::disc;

Body shaped(const std::string& name, const Shape& shape, Vec2 position, double angle = 0.0) {
  Body b = disc(name, position, {0.0, 0.0});
  b.shape = shape;
  b.angle = angle;
  return b;
}

Body ground(const std::string& name, Vec2 position, double angle) {
  Body b = shaped(name, Wall{}, position, angle);
  b.mass.reset();
  b.fixed = true;
  return b;
}

std::vector<Body> half_planes(double half) {
  return {ground("floor", {0.0, -half}, 0.0), ground("ceiling", {0.0, half}, M_PI),
          ground("left", {-half, 0.0}, -M_PI / 2), ground("right", {half, 0.0}, M_PI / 2)};
}

Method exact_flight(double step) {
  return {IntegratorId::kExactFlight, ImpactsId::kLocated, ContactsId::kImpulse, step};
}

// A thin rod at the angle θ falls on one end without friction: the speed v just before gives the impulse
// J = (1 + e) m v/(1 + 3cos²θ) and the spin 6 (1 + e) v cosθ/(L (1 + 3cos²θ)), from K_nn = 1/m + (L cosθ/2)²/I.
TEST(FallingRod, OneEndLands) {
  for (const double angle : {0.1, 0.7, 1.3}) {
    for (const double e : {0.0, 0.4, 1.0}) {
      const double length = 0.8;
      const double height = 1.0;
      Body rod = shaped("rod", Wall{length}, {0.0, height + 0.5 * length * std::sin(angle)}, angle);
      rod.mass = 2.0;
      RunSetup s = test::setup_with({ground("floor", {0.0, 0.0}, 0.0), rod}, e);
      s.scene.forces.gravity = {0.0, -9.81};
      s.method = exact_flight(0.01);
      Simulation run(s);
      while (run.impact_count() == 0 && run.time() < 1.0) run.step();
      ASSERT_FALSE(run.last_impacts().empty());
      const double v = std::sqrt(2.0 * 9.81 * height);
      const double c = std::cos(angle);
      const ImpactRecord& hit = run.last_impacts().front();
      EXPECT_NEAR(hit.time, std::sqrt(2.0 * height / 9.81), 1e-13);
      EXPECT_NEAR(hit.normal_impulse, (1.0 + e) * 2.0 * v / (1.0 + 3.0 * c * c), 1e-12);
      const double spin = 6.0 * (1.0 + e) * v * c / (length * (1.0 + 3.0 * c * c));
      if (run.impact_count() == 1) {
        EXPECT_NEAR(run.state().v(2, 1), -spin, 1e-11);
      }
    }
  }
}

TEST(CorneredBodies, BoxThatLandsFlatBouncesFlat) {
  Body box = shaped("box", Box{0.6, 0.4}, {0.0, 1.2});
  RunSetup s = test::setup_with({ground("floor", {0.0, 0.0}, 0.0), box}, 1.0, 0.5);
  s.scene.forces.gravity = {0.0, -9.81};
  s.method = exact_flight(0.01);
  Simulation run(s);
  run.advance_to(5.0);
  EXPECT_EQ(run.state().v(2, 1), 0.0);
  EXPECT_GE(run.impact_count(), 5);
  EXPECT_NEAR(run.ledger().numerical_drift(run.totals().energy()), 0.0, 1e-12);
}

// Elastic and without friction: a gas of all shapes conserves energy, and momentum including that of the
// walls.
TEST(CorneredBodies, GasKeepsEnergyAndMomentum) {
  std::vector<Body> bodies = half_planes(2.0);
  std::mt19937_64 random(5);
  const auto draw = [&] { return static_cast<double>(random() >> 11) * 0x1p-52 - 1.0; };
  const std::vector<Shape> shapes = {Disc{0.2}, Box{0.5, 0.2}, Polygon{{{0, 0}, {0.4, 0}, {0.1, 0.4}}, 0.0},
                                     Polygon{{{0, 0}, {0.4, 0}}, 0.1},
                                     Polygon{{{0, 0}, {0.3, 0}, {0.1, 0.3}}, 0.05}};
  for (int i = 0; i < 25; ++i) {
    Body b = shaped(fmt::format("b{}", i), shapes[static_cast<std::size_t>(i) % shapes.size()],
                    {-1.4 + 0.7 * (i % 5), -1.4 + 0.7 * (i / 5)}, draw());
    const double vx = draw();
    b.velocity = {vx, draw()};
    b.spin = 3.0 * draw();
    bodies.push_back(b);
  }
  for (const bool located : {true, false}) {
    RunSetup s = test::setup_with(bodies);
    s.method = exact_flight(0.01);
    if (!located) s.method = {IntegratorId::kRk4, ImpactsId::kStepEnd, ContactsId::kImpulse, 0.001};
    Simulation run(s);
    const double before = run.totals().energy();
    ASSERT_TRUE(test::step_to_impact(run, located ? 5000 : 500, [&] {
      run.step();
      for (const ImpactRecord& r : run.last_impacts()) EXPECT_NEAR(r.lost_to_restitution, 0.0, 1e-13 * before);
    }));
    EXPECT_NEAR(run.totals().energy() / before, 1.0, 1e-12) << located;
    EXPECT_NEAR(run.ledger().momentum_drift(run.totals().momentum).norm(), 0.0, 1e-10) << located;
    if (!located) continue;
    EXPECT_EQ(run.notices().text(), "ok");
    for (BodyIndex a{0}; a < run.state().size(); ++a) {
      for (BodyIndex b{a + 1}; b < run.state().size(); ++b) {
        if (!run.shapes().can_collide(a, b)) continue;
        EXPECT_GT(contact_between(run.shapes(), a, run.state().q.col(a), b, run.state().q.col(b)).gap, -1e-12);
      }
    }
  }
}

// With e < 1 and friction they come to rest on the floor.
TEST(CorneredBodies, ComeToLieOnTheFloor) {
  for (const ImpactsId impacts : {ImpactsId::kLocated, ImpactsId::kStepEnd}) {
    Body box = shaped("box", Box{0.6, 0.4}, {0.0, 1.0}, 0.4);
    Body capsule = shaped("capsule", Polygon{{{0, 0}, {0.5, 0}}, 0.1}, {1.5, 1.0}, 1.0);
    RunSetup s = test::setup_with({ground("floor", {0.0, 0.0}, 0.0), box, capsule}, 0.3, 0.6);
    s.scene.forces.gravity = {0.0, -9.81};
    s.method = {IntegratorId::kRk4, impacts, ContactsId::kImpulse, 0.002};
    Simulation run(s);
    run.advance_to(6.0);
    EXPECT_NEAR(run.state().q(1, 1), 0.2, 5e-3);
    EXPECT_NEAR(std::remainder(run.state().q(2, 1), M_PI), 0.0, 2e-2);
    EXPECT_NEAR(run.state().q(1, 2), 0.1, 5e-3);
    EXPECT_LT(run.totals().kinetic(), 1e-2);
  }
}

TEST(Groups, PassThroughEachOther) {
  Body a = disc("a", {-1.0, 0.0}, {1.0, 0.0});
  Body b = disc("b", {1.0, 0.0}, {-1.0, 0.0});
  a.group = b.group = "ghosts";
  const Body c = disc("c", {3.0, 0.0}, {-1.0, 0.0});
  for (const ImpactsId impacts : {ImpactsId::kLocated, ImpactsId::kStepEnd}) {
    RunSetup s = test::setup_with({a, b, c});
    s.method.impacts = impacts;
    Simulation run(s);
    run.advance_to(3.0);
    EXPECT_EQ(run.impact_count(), 1);
    EXPECT_EQ(run.state().velocity(1), Vec2(-1.0, 0.0));
    EXPECT_EQ(run.state().velocity(0), Vec2(-1.0, 0.0));
  }
}

// Two point-like bodies collide head on; a box turns by a given moment of inertia.
TEST(Bodies, PointLikeAndWithAGivenInertia) {
  Body point = disc("point", {0.0, 0.3}, {1.0, 0.0}, 0.0);
  Body box = shaped("box", Box{1.0, 1.0}, {1.0, 0.0});
  box.inertia = 0.5;
  RunSetup s = test::setup_with({point, box});
  Simulation run(s);
  run.advance_to(1.0);
  ASSERT_EQ(run.impact_count(), 1);
  // K_nn = 1/m + 1/M + r²/I, J = 2 u/K_nn
  const double impulse = 2.0 / (2.0 + 0.3 * 0.3 / 0.5);
  EXPECT_NEAR(run.state().v(0, 1), impulse, 1e-15);
  EXPECT_NEAR(run.state().v(2, 1), -0.3 * impulse / 0.5, 1e-15);
}

}  // namespace
}  // namespace carom
