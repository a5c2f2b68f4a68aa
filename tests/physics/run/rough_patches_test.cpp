#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "physics/run/simulation.h"
#include "tests/support/scenes.h"

// What slides over a seam between two flush surfaces has the friction of the one that it is on from there on,
// wherever in a step it passes the seam.
namespace carom {
namespace {

constexpr double kG = 9.81;
constexpr double kFriction = 0.4;

// Up to x = 0 one surface, then the other one; gravity turned with them.
RunSetup over(const Body& mover, bool rough_first, double turned) {
  RunSetup s = test::setup_with({test::fixed("first", Box{4.0, 0.4}, {-2.0, -0.2}),
                                 test::fixed("second", Box{6.0, 0.4}, {3.0, -0.2}), mover},
                                0.0, kFriction);
  s.scene.materials.push_back(s.scene.materials.front());
  s.scene.materials.back().name = "ice";
  s.scene.materials.back().static_friction = s.scene.materials.back().kinetic_friction = 0.0;
  s.scene.bodies[rough_first ? 1 : 0].material = "ice";
  for (Body& body : s.scene.bodies) {
    body.position = turned_by(turned, body.position);
    body.velocity = turned_by(turned, body.velocity);
    body.angle = turned;
  }
  s.scene.forces.gravity = turned_by(turned, Vec2(0.0, -kG));
  return s;
}

struct After {
  double x = 0.0;      // m, along the surfaces
  double speed = 0.0;  // m/s
  double spin = 0.0;   // rad/s
};

template <class Check>
void for_each_method(const Body& mover, bool rough_first, double until, const Check& check) {
  for (const IntegratorId integrator :
       {IntegratorId::kVelocityVerlet, IntegratorId::kRk4, IntegratorId::kExactFlight}) {
    for (const double h : {1.0 / 60.0, 0.01, 0.005, 0.002}) {
      for (const double turned : {0.0, 0.3}) {
        SCOPED_TRACE(testing::Message() << static_cast<int>(integrator) << ", h = " << h << ", " << turned);
        RunSetup s = over(mover, rough_first, turned);
        s.method = {integrator, ImpactsId::kLocated, ContactsId::kLasting, h};
        Simulation run(s);
        run.advance_to(until);
        const Vec2 along = turned_by(turned, Vec2::UnitX());
        check(
            After{run.state().position(2).dot(along), run.state().velocity(2).dot(along), run.state().v(2, 2)});
        EXPECT_EQ(run.status(), "ok");
      }
    }
  }
}

// It slides until v = 2/3 of the speed on the ice.
TEST(RoughPatches, ADiscComesFromIceToARoughSurface) {
  for (const double start : {-0.503, -0.4, -1.0 / 3.0}) {
    const double slides = 2.0 / (3.0 * kFriction * kG);
    const double until = 1.0;
    const double rolls = until + start / 2.0 - slides;
    const double x = (2.0 - 0.5 * kFriction * kG * slides) * slides + 4.0 / 3.0 * rolls;
    for_each_method(test::disc("disc", {start, 0.1}, {2.0, 0.0}, 0.1), false, until, [&](const After& end) {
      EXPECT_NEAR(end.speed, 4.0 / 3.0, 1e-6);
      EXPECT_NEAR(end.spin, -40.0 / 3.0, 1e-5);
      EXPECT_NEAR(end.x, x, 1e-6);
    });
  }
}

TEST(RoughPatches, ADiscComesFromARoughSurfaceToIce) {
  const double start = -0.2;
  const double speed = std::sqrt(4.0 + 2.0 * kFriction * kG * start);
  const double time = (2.0 - speed) / (kFriction * kG);
  for_each_method(test::disc("disc", {start, 0.1}, {2.0, 0.0}, 0.1), true, 0.6, [&](const After& end) {
    EXPECT_NEAR(end.speed, speed, 1e-6);
    EXPECT_NEAR(end.spin, -2.0 * kFriction * kG * time / 0.1, 1e-5);
    EXPECT_NEAR(end.x, speed * (0.6 - time), 1e-6);
  });
}

// Of a square of half-width b on two corners: with the front one on the rough surface alone, that is pressed by
// N = m g/2 + m a/2 and a = μ N/m; with both a = μ g.
// The last two starts are such that it reaches the seam at the end of a step, and a little past it.
TEST(RoughPatches, ABoxComesFromIceToARoughSurface) {
  for (const double start : {-0.511, -0.4, -0.4 + 1e-8}) {
    SCOPED_TRACE(start);
    Body box = test::box("box", {start, 0.1}, {2.0, 0.0}, 0.2, 0.2);
    const double one = 0.5 * kFriction * kG / (1.0 - 0.5 * kFriction);
    const double both = kFriction * kG;
    const double begins = (-0.1 - start) / 2.0;
    const double speed = std::sqrt(4.0 - 2.0 * one * 0.2);
    const double all_on = begins + (2.0 - speed) / one;
    const double until = 0.5;
    for_each_method(box, false, until, [&](const After& end) {
      EXPECT_NEAR(end.speed, speed - both * (until - all_on), 1e-6);
      EXPECT_NEAR(end.x, 0.1 + (until - all_on) * (speed - 0.5 * both * (until - all_on)), 1e-6);
      EXPECT_NEAR(end.spin, 0.0, 1e-9);
    });
  }
}

}  // namespace
}  // namespace carom
