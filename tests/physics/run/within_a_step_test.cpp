#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numbers>
#include <string>

#include "physics/math/vectors.h"
#include "physics/run/simulation.h"
#include "tests/support/scenes.h"

// Where bodies rest or slide, what happens within a step counts from its own moment on: a hit on a resting
// body, a landing, a corner that slides off the end of a face.
namespace carom {
namespace {

using test::fixed;

constexpr double kGravity = 9.81;  // m/s²
constexpr double kSteps[] = {1.0 / 60.0, 0.008, 0.005, 1.0 / 240.0};

RunSetup setup(double restitution, double friction, double step) {
  RunSetup s = test::setup_with({}, restitution, friction);
  s.scene.forces.gravity = {0.0, -kGravity};
  s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, step};
  return s;
}

void turn(RunSetup& s, double angle) {
  s.scene.forces.gravity = turned_by(angle, s.scene.forces.gravity);
  for (Body& b : s.scene.bodies) {
    b.position = turned_by(angle, b.position);
    b.velocity = turned_by(angle, b.velocity);
    b.angle += angle;
  }
}

double drift(const Simulation& run) { return run.ledger().numerical_drift(run.totals().energy()); }

// A smooth disc at 1 m/s hands all of its motion over to an equal body that rests on a rough floor; where in
// the step it does so makes no difference.
TEST(WithinAStep, AStruckBodySlidesFromTheHitOn) {
  constexpr double kFriction = 0.2;
  for (const bool box : {true, false}) {
    for (const double step : kSteps) {
      for (const double start : {-0.05 - 0.3, -0.05 - 0.237, -0.05 - 0.1}) {
        RunSetup s = setup(1.0, kFriction, step);
        s.scene.bodies = {fixed("floor", Wall{}, {0.0, 0.0}),
                          test::disc("first", {start, 0.05}, {1.0, 0.0}, 0.05, 1.0),
                          test::disc("second", {0.1, 0.05}, {0.0, 0.0}, 0.05, 1.0)};
        if (box) s.scene.bodies[2].shape = Box{0.1, 0.1};
        Material smooth = s.scene.materials.front();
        smooth.name = "smooth";
        smooth.kinetic_friction = smooth.static_friction = 0.0;
        s.scene.materials.push_back(smooth);
        s.scene.bodies[1].material = "smooth";
        Simulation run(s);
        const double hit = 0.05 - start - 0.05;  // s
        run.advance_to(2.0);
        const double slows = kFriction * kGravity;
        // A disc slides until it rolls, at two thirds of its speed.
        const double slides = box ? 1.0 / slows : 1.0 / (3.0 * slows);
        const double place =
            box ? 0.1 + 0.5 / slows
                : 0.1 + slides - 0.5 * slows * slides * slides + 2.0 / 3.0 * (2.0 - hit - slides);
        EXPECT_NEAR(run.state().position(2).x(), place, 1e-9) << (box ? "box" : "disc") << ", h = " << step;
        EXPECT_NEAR(drift(run), 0.0, 1e-12);
      }
    }
  }
}

// A hit that falls on the end of a step, but for rounding, on a box that touches another one: no step is
// divided so near its end, where gaps of rounding would close at any speed.
TEST(WithinAStep, AHitAtTheEndOfAStepStopsTouchingBoxesTogether) {
  for (const double angle : {0.0, 0.7}) {
    for (const double step : {1.0 / 60.0, 0.02, 0.01, 0.005, 0.001}) {
      RunSetup s = setup(0.0, 0.0, step);
      s.scene.bodies = {fixed("floor", Wall{}, {0.0, 0.0})};
      for (const double x : {-0.5, 0.0, 0.2}) {
        s.scene.bodies.push_back(
            test::disc("box at " + std::to_string(x), {x, 0.1}, {x < 0.0 ? 2.0 : 0.0, 0.0}));
        s.scene.bodies.back().shape = Box{0.2, 0.2};
      }
      turn(s, angle);
      Simulation run(s);
      run.advance_to(0.3);
      const Vec2 after = turned_by(angle, Vec2(2.0 / 3.0, 0.0));
      for (int i = 1; i <= 3; ++i)
        EXPECT_NEAR((run.state().velocity(i) - after).norm(), 0.0, 1e-9) << angle << ", h = " << step;
      EXPECT_NEAR(run.ledger().lost_to_restitution, 4.0 / 3.0, 1e-9) << angle << ", h = " << step;
      EXPECT_NEAR(drift(run), 0.0, 1e-11) << angle << ", h = " << step;
    }
  }
}

// The bounces that are too short to follow are lost to restitution, with all that is left of them.
TEST(WithinAStep, ABouncingBallLosesItsEnergyToRestitution) {
  for (const double restitution : {0.0, 0.3, 0.5, 0.8}) {
    for (const double step : kSteps) {
      RunSetup s = setup(restitution, 0.0, step);
      s.scene.bodies = {fixed("floor", Wall{}, {0.0, 0.0}),
                        test::disc("ball", {0.0, 0.6}, {0.0, 0.0}, 0.1, 1.0)};
      Simulation run(s);
      run.advance_to(4.0);
      EXPECT_NEAR(run.ledger().lost_to_restitution, kGravity * 0.5, 1e-12) << restitution << ", h = " << step;
      EXPECT_NEAR(run.state().position(1).y(), 0.1, 1e-13);
    }
  }
}

// A smooth box that slides over a table's edge at 1 m/s tips about it until its rear corner is there, with this
// spin: two coupled equations of motion, solved by a Runge-Kutta method with steps of 10 µs.
TEST(WithinAStep, ABoxThatTipsOffATableIsFreeFromItsRearCornerOn) {
  constexpr double kSpin = -3.63068677;
  for (const double side : {1.0, -1.0}) {
    for (const double angle : {0.0, 0.3}) {
      for (const double step : {1.0 / 60.0, 0.005, 0.001}) {
        RunSetup s = setup(0.0, 0.0, step);
        Body box = test::disc("box", {side * -0.237, 0.05}, {side, 0.0}, 0.05, 1.0);
        box.shape = Box{0.2, 0.1};
        s.scene.bodies = {fixed("table", Box{1.0, 0.2}, {side * -0.5, -0.1}), box};
        turn(s, angle);
        Simulation run(s);
        run.advance_to(0.5);
        EXPECT_NEAR(side * run.state().v(2, 1), kSpin, 1e-3) << side << ", " << angle << ", h = " << step;
      }
    }
  }
}

TEST(WithinAStep, APointLeavesATableAtItsEdge) {
  for (const double step : kSteps) {
    RunSetup s = setup(0.0, 0.0, step);
    s.scene.bodies = {fixed("table", Box{1.0, 0.2}, {-0.5, -0.1}),
                      test::disc("point", {-0.437, 0.0}, {1.3, 0.0}, 0.0, 1.0)};
    Simulation run(s);
    run.advance_to(0.62);
    const double falls = 0.62 - 0.437 / 1.3;
    EXPECT_NEAR(run.state().position(1).y(), -0.5 * kGravity * falls * falls, 1e-9) << "h = " << step;
  }
}

// A block slides up a slope, stops and slides back, under every method that is exact under gravity: it turns
// where friction does, and the floor gets all of the angular momentum that friction and normal force take.
TEST(WithinAStep, ABlockTurnsBackOnASlopeWhereItStops) {
  constexpr double kSlope = 0.5;
  constexpr double kFriction = 0.23;
  constexpr double kUntil = 1.2;  // s
  const double up = kGravity * (std::sin(kSlope) + kFriction * std::cos(kSlope));
  const double down = kGravity * (std::sin(kSlope) - kFriction * std::cos(kSlope));
  for (const double speed : {2.0, 1.37}) {
    const double stops = speed / up;
    const double place = 0.5 * speed * stops - 0.5 * down * (kUntil - stops) * (kUntil - stops);
    for (const IntegratorId integrator :
         {IntegratorId::kVelocityVerlet, IntegratorId::kRk4, IntegratorId::kDormandPrince,
          IntegratorId::kAdaptiveDormandPrince, IntegratorId::kExactFlight}) {
      for (const double step : kSteps) {
        RunSetup s = setup(0.0, kFriction, step);
        s.method.integrator = integrator;
        Body block = test::disc("block", {0.0, 0.05}, {speed, 0.0}, 0.1, 1.0);
        block.shape = Box{0.2, 0.1};
        s.scene.bodies = {fixed("floor", Wall{}, {0.0, 0.0}), block};
        turn(s, kSlope);
        s.scene.forces.gravity = {0.0, -kGravity};
        Simulation run(s);
        run.advance_to(kUntil);
        EXPECT_NEAR(turned_by(-kSlope, Vec2(run.state().position(1))).x(), place, 1e-9)
            << static_cast<int>(integrator) << ", h = " << step;
        EXPECT_NEAR(drift(run), 0.0, 1e-11);
        EXPECT_NEAR(run.ledger().angular_momentum_drift(run.totals().angular_momentum), 0.0, 1e-11)
            << static_cast<int>(integrator) << ", h = " << step;
      }
    }
  }
}

// A disc rolls up a slope with rolling resistance c, which brakes it on the way up and on the way down: it
// turns back where it stops, also within a step. a = 2 g (sin ± c cos)/3.
TEST(WithinAStep, ADiscWithRollingResistanceTurnsBackWhereItStops) {
  constexpr double kSlope = 0.3;  // rad
  constexpr double kRolling = 0.05;
  for (const IntegratorId integrator :
       {IntegratorId::kVelocityVerlet, IntegratorId::kRk4, IntegratorId::kExactFlight}) {
    for (const double step : kSteps) {
      RunSetup s = setup(0.0, 0.5, step);
      s.method.integrator = integrator;
      s.scene.materials.front().rolling_resistance = kRolling;
      s.scene.bodies = {fixed("floor", Wall{}, {0.0, 0.0}), test::disc("disc", {0.0, 0.1}, {2.0, 0.0})};
      s.scene.bodies[1].spin = -20.0;
      turn(s, kSlope);
      s.scene.forces.gravity = {0.0, -kGravity};
      Simulation run(s);
      run.advance_to(1.5);
      const auto slows = [](double sign) {
        return 2.0 / 3.0 * kGravity * (std::sin(kSlope) + sign * kRolling * std::cos(kSlope));
      };
      const double stops = 2.0 / slows(1.0);
      EXPECT_NEAR(turned_by(-kSlope, run.state().velocity(1)).x(), -slows(-1.0) * (1.5 - stops), 1e-7) << step;
      EXPECT_NEAR(run.ledger().lost_to_rolling,
                  kRolling * kGravity * std::cos(kSlope) *
                      (2.0 / slows(1.0) + 0.5 * slows(-1.0) * (1.5 - stops) * (1.5 - stops)),
                  1e-6)
          << step;
    }
  }
}

// A box of two squares bounces flat on two tiles; each square ends where the other one's tile begins, and
// passes that edge flush. A box falls along a wall that it touches. Nothing is said of forces that change fast.
TEST(WithinAStep, FacesThatPassFlushOnCurvedPathsAreClear) {
  for (const double angle : {0.0, 0.3}) {
    for (const double step : kSteps) {
      RunSetup s = setup(1.0, 0.4, step);
      Body body = test::disc("body", {0.13, 0.57}, {0.0, 0.0}, 0.1, 1.0);
      body.shape = Compound{{{Box{0.2, 0.2}, {-0.1, 0.0}, 0.0, ""}, {Box{0.2, 0.2}, {0.1, 0.0}, 0.0, ""}}};
      s.scene.bodies = {fixed("left", Box{1.0, 0.2}, {-0.37, -0.1}),
                        fixed("right", Box{1.0, 0.2}, {0.63, -0.1}), body};
      turn(s, angle);
      Simulation run(s);
      run.advance_to(2.0);
      EXPECT_EQ(run.notices().text(), "ok") << angle << ", h = " << step;
      EXPECT_NEAR(run.state().v(2, 2), 0.0, 1e-9);

      s.scene.bodies = {fixed("wall", Box{1.0, 4.0}, {-0.5, 0.0}), fixed("floor", Box{4.0, 1.0}, {0.0, -2.5}),
                        test::disc("box", {0.1, 1.0}, {0.0, 0.0}, 0.1, 1.0)};
      s.scene.bodies[2].shape = Box{0.2, 0.2};
      s.scene.materials[0].kinetic_friction = s.scene.materials[0].static_friction = 0.0;
      for (Body& b : s.scene.bodies) {
        b.position = turned_by(angle, b.position);
        b.angle = angle;
      }
      Simulation falls(s);
      falls.advance_to(2.0);
      EXPECT_EQ(falls.notices().text(), "ok") << angle << ", h = " << step;
    }
  }
}

// Two thin walls end to end are one: which side of them is touched does not hang on rounding at their ends.
TEST(WithinAStep, ABoxSlidesOverTheSeamOfTwoThinWalls) {
  for (const double angle : {0.0, 0.1, 0.3, -1.0}) {
    for (const double start : {-0.57, -0.571, -0.5637, -0.6}) {
      for (const double step : kSteps) {
        RunSetup s = setup(0.0, 0.0, step);
        Body box = test::disc("box", {start, 0.1}, {1.0, 0.0}, 0.1, 1.0);
        box.shape = Box{0.2, 0.2};
        s.scene.bodies = {fixed("left", Wall{1.0}, {-0.5, 0.0}), fixed("right", Wall{2.0}, {1.0, 0.0}), box};
        turn(s, angle);
        Simulation run(s);
        run.advance_to(1.2);
        EXPECT_NEAR(run.state().velocity(2).dot(direction_at(angle)), 1.0, 1e-9)
            << angle << ", " << start << ", h = " << step;
        EXPECT_EQ(run.impact_count(), 0);
      }
    }
  }
}

TEST(WithinAStep, TwoSquaresLandFlatOnTwoThinWalls) {
  for (const double place : {0.13, 0.2, 0.0, -0.03}) {
    for (const double angle : {0.0, 0.1, 0.3, -0.7, 2.0}) {
      for (const double step : {0.02, 1.0 / 60.0, 0.0125, 0.005}) {
        RunSetup s = setup(1.0, 0.4, step);
        Body body = test::disc("body", {place, 0.57}, {0.0, 0.0}, 0.1, 1.0);
        body.shape = Compound{{{Box{0.2, 0.2}, {-0.1, 0.0}, 0.0, ""}, {Box{0.2, 0.2}, {0.1, 0.0}, 0.0, ""}}};
        s.scene.bodies = {fixed("left", Wall{1.0}, {-0.4, 0.0}), fixed("right", Wall{1.0}, {0.6, 0.0}), body};
        turn(s, angle);
        Simulation run(s);
        run.advance_to(2.0);
        EXPECT_NEAR(run.state().v(2, 2), 0.0, 1e-9) << place << ", " << angle << ", h = " << step;
        EXPECT_NEAR(run.totals().energy(), kGravity * 0.57, 1e-9);
      }
    }
  }
}

// A box that slides against a low kerb tips over its edge: its face leaves the edge so slowly that the search
// for the next hit would have to look very often, but the step is divided there.
TEST(WithinAStep, ABoxThatHitsAKerbMissesNoImpacts) {
  for (const double step : kSteps) {
    RunSetup s = setup(0.0, 0.5, step);
    s.scene.bodies = {fixed("floor", Wall{}, {0.0, 0.0}), fixed("kerb", Box{1.0, 0.05}, {1.0, 0.025}),
                      test::box("block", {0.0, 0.2}, {3.0, 0.0}, 0.4, 0.4)};
    Simulation run(s);
    run.advance_to(0.4);
    EXPECT_EQ(run.status(), "ok") << step;
    EXPECT_EQ(run.impact_count(), 1) << step;
    EXPECT_NEAR(run.state().q(2, 2), -0.51242, 2e-5) << step;
  }
}

// Boxes that hit each other at an angle part slowly while their faces turn: along a fixed normal the far end of
// a face comes near, and the search for the next hit would have to look very often.
TEST(WithinAStep, FacesThatTurnApartMissNoImpacts) {
  for (const double restitution : {0.0, 0.1, 0.5}) {
    for (const double angle : {0.456, 0.1, 1.2}) {
      for (const double step : kSteps) {
        RunSetup s = setup(restitution, 0.0, step);
        s.scene.forces.gravity.setZero();
        s.scene.bodies = {test::box("first", {-1.0, 0.0}, {2.0, 0.0}, 0.4, 0.2),
                          test::box("second", {0.0, 0.179}, {0.0, 0.0}, 0.4, 0.2)};
        s.scene.bodies[0].angle = angle;
        s.scene.bodies[1].angle = -0.443;
        Simulation run(s);
        run.advance_to(1.5);
        EXPECT_EQ(run.status(), "ok") << restitution << ' ' << angle << ' ' << step;
        EXPECT_GT(run.impact_count(), 0);
      }
    }
  }
}

// Two discs on a belt meet at the very end of a step: the part of the next one until then has no length, and no
// work is undefined.
TEST(WithinAStep, AnImpactAtItsStartLeavesTheWorkOfADriveDefined) {
  RunSetup s = setup(1.0, 0.0, 0.005);
  Body belt = fixed("belt", Wall{}, {0.0, 0.0});
  belt.fixed = false;
  belt.drive = Drive{};
  belt.drive->velocity = {0.7, 0.0};
  s.scene.bodies = {belt, test::disc("first", {0.0, 0.1}, {1.1, 0.0}, 0.1),
                    test::disc("second", {0.3, 0.1}, {0.7, 0.0}, 0.1)};
  Simulation run(s);
  run.advance_to(0.3);
  EXPECT_EQ(run.impact_count(), 1);
  EXPECT_NEAR(run.ledger().put_in_by_drives, 0.0, 1e-12);
  EXPECT_NEAR(run.ledger().numerical_drift(run.totals().energy()), 0.0, 1e-9);
}

}  // namespace
}  // namespace carom
