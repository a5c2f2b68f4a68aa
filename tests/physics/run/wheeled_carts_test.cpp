#include <cmath>
#include <gtest/gtest.h>

#include "physics/math/vectors.h"
#include "physics/run/simulation.h"
#include "tests/support/fine_step.h"
#include "tests/support/scenes.h"

// A body pinned to two wheels that land, roll and hit: what happens to one wheel moves the other one at once.
namespace carom {
namespace {

struct Cart {
  double height = 0.0;  // of the wheels over the floor, m
  double tilt = 0.0;    // rad
  double speed = 0.0;   // m/s
  double restitution = 0.0;
  double friction = 0.0;
};

RunSetup setup(const Cart& cart, double step) {
  constexpr double kRadius = 0.08;
  const Vec2 middle(0.0, 0.15 + cart.height);
  const auto place = [&](const Vec2& at) -> Vec2 { return middle + turned_by(cart.tilt, at); };
  const Vec2 axles[] = {{-0.2, -0.07}, {0.2, -0.07}};
  Body chassis = test::box("chassis", middle, {cart.speed, 0.0}, 0.5, 0.1);
  chassis.angle = cart.tilt;
  RunSetup s = test::setup_with({test::fixed("floor", Wall{}, {0.0, 0.0}), chassis,
                                 test::disc("rear", place(axles[0]), {cart.speed, 0.0}, kRadius, 0.2),
                                 test::disc("front", place(axles[1]), {cart.speed, 0.0}, kRadius, 0.2)},
                                cart.restitution, cart.friction);
  // On the floor they roll.
  if (cart.height == 0.0 && cart.friction > 0.0)
    s.scene.bodies[2].spin = s.scene.bodies[3].spin = -cart.speed / kRadius;
  for (int k = 0; k < 2; ++k) {
    Joint pin;
    pin.kind = JointKind::kPin;
    pin.body = k == 0 ? "rear" : "front";
    pin.to = "chassis";
    pin.anchor = axles[k];
    s.scene.joints.push_back(pin);
  }
  s.scene.forces.gravity = {0.0, -9.81};
  s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, step};
  return s;
}

RunSetup with_wall(RunSetup s) {
  s.scene.bodies.push_back(test::fixed("wall", Box{0.2, 1.0}, {0.679, 0.5}));
  return s;
}

RunSetup with_box(RunSetup s) {
  s.scene.bodies.push_back(test::box("box", {0.679, 0.15}, {0.0, 0.0}, 0.2, 0.3));
  s.scene.bodies.back().mass = 0.525;
  return s;
}

// Both wheels touch the floor at one moment. They did so one after the other, and the cart turned.
TEST(WheeledCarts, LandOnBothWheelsAtOnce) {
  for (const double restitution : {0.0, 0.3, 1.0}) {
    for (const double friction : {0.0, 0.8}) {
      const Cart cart{0.05, 0.0, 0.0, restitution, friction};
      const double falls = std::sqrt(2.0 * 0.05 / 9.81);
      for (const double step : {1.0 / 60.0, 1.0 / 240.0}) {
        Simulation run(setup(cart, step));
        run.advance_to(falls + 0.01);
        const double up = restitution > 0.0 ? restitution * std::sqrt(2.0 * 0.05 * 9.81) - 9.81 * 0.01 : 0.0;
        for (const int body : {1, 2, 3}) {
          EXPECT_NEAR(run.state().v(1, body), up, 1e-9) << "e = " << restitution << ", mu = " << friction;
          EXPECT_NEAR(run.state().v(2, body), 0.0, 1e-9) << "e = " << restitution << ", mu = " << friction;
        }
      }
    }
  }
}

// The contact forces on one wheel were kept until the step's end as if nothing had hit the other one: it sank
// in, and from then on the wheels were hit at each step's end.
TEST(WheeledCarts, OneWheelFeelsWhatHitsTheOtherOne) {
  const Cart cart{0.05, 0.02, 0.5, 0.3, 0.8};
  const auto at = [&](double h) { return setup(cart, h); };
  EXPECT_LT(test::off_from_fine_step(at, 0.5, 1.0 / 60.0), 1e-4);
  EXPECT_LT(test::off_from_fine_step(at, 0.5, 1.0 / 240.0), 1e-5);
  for (const double step : {1.0 / 60.0, 1.0 / 240.0, 1.0 / 960.0, 1.0 / 3840.0}) {
    Simulation run(at(step));
    run.advance_to(0.5);
    EXPECT_EQ(run.ledger().penetration_correction, 0.0) << step;
    EXPECT_LT(run.impact_count(), 60) << step;
  }
}

// Forces are found by a guess that joints put off, and by then linear ones may have taken its place; and a cart
// that is at rest at both ends of a part of a step only seems to turn round there.
TEST(WheeledCarts, StopAtAWallWithoutAWarning) {
  for (const double friction : {0.0, 0.3, 0.8}) {
    const Cart cart{0.0, 0.0, 1.016, 0.0, friction};
    for (const IntegratorId integrator : {IntegratorId::kRk4, IntegratorId::kVelocityVerlet}) {
      for (const double step : {1.0 / 60.0, 1.0 / 240.0, 1.0 / 960.0}) {
        RunSetup s = with_wall(setup(cart, step));
        s.method.integrator = integrator;
        Simulation run(s);
        run.advance_to(0.7);
        EXPECT_EQ(run.status(), "ok") << "mu = " << friction << ", h = " << step;
      }
    }
    const auto at = [&](double h) { return with_wall(setup(cart, h)); };
    EXPECT_LT(test::off_from_fine_step(at, 0.7, 1.0 / 240.0), 1e-5) << "mu = " << friction;
  }
}

// A wheel that a hit lifts off by micrometres comes back as a landing. It was held there, with forces that
// pressed and pulled within a part of a step: parts became ever shorter, and more than a step may have.
TEST(WheeledCarts, HitAFreeBox) {
  for (const double speed : {0.5641835440091899, 0.7274335645293292}) {
    const auto at = [&](double h) { return with_box(setup({0.0, 0.0, speed, 0.0, 0.8}, h)); };
    EXPECT_LT(test::off_from_fine_step(at, 0.7, 1.0 / 120.0), 1e-3) << speed;
    EXPECT_LT(test::off_from_fine_step(at, 0.7, 1.0 / 240.0), 1e-3) << speed;
  }
}

// Flights that are not used say nothing of links: those under forces that are found again, or past a landing.
TEST(WheeledCarts, JamUnderABoxWithoutAWarning) {
  for (const Cart& cart :
       {Cart{0.0, 0.0, 0.7274335645293292, 0.0, 0.8}, Cart{0.0, 0.0, 1.5069103132437773, 0.3, 0.8},
        Cart{0.0, 0.0, 1.3795626461239994, 0.3, 0.8}, Cart{0.0, 0.0, 0.9723145889496753, 0.3, 0.8}}) {
    for (const double step : {1.0 / 60.0, 0.01, 1.0 / 240.0}) {
      Simulation run(with_box(setup(cart, step)));
      run.advance_to(0.7);
      EXPECT_EQ(run.status(), "ok") << cart.speed << ", h = " << step;
    }
  }
}

}  // namespace
}  // namespace carom
