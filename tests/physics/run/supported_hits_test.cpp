#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/run/simulation.h"
#include "tests/support/draws.h"
#include "tests/support/scenes.h"

// Bodies that rest on a floor and hit each other: nothing presses the pair together along its normal, so the
// hit has the restitution that was asked for, however slow it is.
namespace carom {
namespace {

constexpr double kWidth = 1.0;  // m, of boxes and discs

Body body(const std::string& name, bool box, double x, double speed, double mass) {
  Body b = test::disc(name, {x, 0.5 * kWidth}, {speed, 0.0}, 0.5 * kWidth, mass);
  if (box) b.shape = Box{kWidth, kWidth};
  return b;
}

struct Hit {
  bool boxes[2];
  double masses[2];  // kg
  double speed;      // m/s, of the first one
  double gap;        // m
  double restitution;
  double gravity;  // m/s²
  double turned;   // rad, of the whole scene
  Method method;
};

RunSetup setup(const Hit& hit) {
  Body floor;
  floor.name = "floor";
  floor.shape = Wall{};
  floor.fixed = true;
  RunSetup s = test::setup_with({floor, body("first", hit.boxes[0], 0.0, hit.speed, hit.masses[0]),
                                 body("second", hit.boxes[1], kWidth + hit.gap, 0.0, hit.masses[1])},
                                hit.restitution);
  s.scene.forces.gravity = turned_by(hit.turned, {0.0, -hit.gravity});
  for (Body& b : s.scene.bodies) {
    b.position = turned_by(hit.turned, b.position);
    b.velocity = turned_by(hit.turned, b.velocity);
    b.angle = hit.turned;
  }
  s.method = hit.method;
  return s;
}

// The speeds along the floor after the hit, over the first one's before it.
Vec2 speeds_after(const Hit& hit) {
  Simulation run(setup(hit));
  run.advance_to(1.2 * hit.gap / hit.speed + 5.0 * hit.method.step);
  EXPECT_EQ(run.notices().text(), "ok");
  const Vec2 along = direction_at(hit.turned);
  return Vec2(run.state().velocity(1).dot(along), run.state().velocity(2).dot(along)) / hit.speed;
}

Vec2 expected(const Hit& hit) {
  const double of_first = hit.masses[0] / (hit.masses[0] + hit.masses[1]);
  return {of_first - hit.restitution * (1.0 - of_first), of_first * (1.0 + hit.restitution)};
}

TEST(SupportedHits, SlowBodiesSwapTheirSpeeds) {
  for (const bool boxes : {false, true}) {
    for (const auto& impacts : kImpacts) {
      for (const double h : {0.01, 0.005, 0.0025}) {
        for (const double speed : {1.0, 0.2, 0.04, 0.01}) {
          const Hit hit{{boxes, boxes},
                        {1.0, 1.0},
                        speed,
                        0.05,
                        1.0,
                        9.81,
                        0.0,
                        {IntegratorId::kRk4, impacts.id, ContactsId::kLasting, h}};
          EXPECT_LT((speeds_after(hit) - expected(hit)).norm(), 1e-9)
              << (boxes ? "boxes, " : "discs, ") << impacts.name << ", h = " << h << ", " << speed << " m/s";
        }
      }
    }
  }
}

TEST(SupportedHits, RandomOnesHaveTheirRestitution) {
  test::Draws draw(17);
  for (int k = 0; k < 200; ++k) {
    const auto flip = [&] { return draw.chance(0.5); };
    const Hit hit{
        {flip(), flip()},
        {draw.between(0.2, 5.0), draw.between(0.2, 5.0)},
        std::pow(10.0, draw.between(-2.0, 0.5)),
        draw.between(0.02, 0.4),
        draw.between(0.1, 1.0),
        draw.between(1.0, 30.0),
        flip() ? 0.5 * std::numbers::pi * std::floor(draw.between(-2.0, 3.0)) : draw.between(-3.0, 3.0),
        {flip() ? IntegratorId::kRk4 : IntegratorId::kVelocityVerlet,
         flip() ? ImpactsId::kLocated : ImpactsId::kStepEnd, ContactsId::kLasting,
         std::pow(10.0, draw.between(-2.7, -1.7))}};
    EXPECT_LT((speeds_after(hit) - expected(hit)).norm(), 1e-8)
        << k << ": " << (hit.boxes[0] ? "box" : "disc") << " hits " << (hit.boxes[1] ? "box" : "disc")
        << ", e = " << hit.restitution << ", " << hit.speed << " m/s, turned by " << hit.turned
        << ", h = " << hit.method.step;
  }
}

// A ball hits a box that lies on a smooth floor below its centre: the box turns, and its corner hits the floor
// at once. What is left of the box's own speed, downwards or upwards by rounding, decides nothing.
TEST(SupportedHits, ACornerThatAHitTurnsDownHitsTheFloor) {
  constexpr double kInertia = (0.2 * 0.2 + 0.1 * 0.1) / 12.0;
  constexpr double kLow = 0.03;  // m, of the hit below the centre
  for (const double restitution : {0.5, 1.0}) {
    const double hit = (1.0 + restitution) * 2.0 / (2.0 + kLow * kLow / kInertia);
    const double spin = -kLow * hit / kInertia;
    const double push = (1.0 + restitution) * -0.1 * spin / (1.0 + 0.01 / kInertia);
    for (const double h : {0.02, 0.01, 0.005, 0.0025}) {
      for (const double way : {0.03, 0.0313, 0.0337, 0.035}) {
        RunSetup s = test::setup_with(
            {test::fixed("floor", Wall{}, {0.0, 0.0}), test::box("box", {0.0, 0.05}, {0.0, 0.0}, 0.2, 0.1),
             test::disc("ball", {0.12 + way, 0.05 - kLow}, {-2.0, 0.0}, 0.02)},
            restitution);
        s.scene.forces.gravity = {0.0, -9.81};
        s.method.contacts = ContactsId::kLasting;
        s.method.step = h;
        Simulation run(s);
        run.advance_to(0.5 * way + 0.01);
        EXPECT_NEAR(run.state().v(2, 1), spin + 0.1 * push / kInertia, 1e-9)
            << "e = " << restitution << ", h = " << h << ", way " << way;
        EXPECT_NEAR(run.state().v(0, 1), -hit, 1e-9);
        EXPECT_EQ(run.notices().text(), "ok");
      }
    }
  }
}

// Likewise where impacts come at the step's end: a kerb of 1 mm turns a sliding box, whose middle moves down
// with what the solver of its contacts leaves meanwhile. With e = 1 nothing is lost.
TEST(SupportedHits, AKerbTurnsABoxWithoutLoss) {
  for (const ImpactsId impacts : {ImpactsId::kLocated, ImpactsId::kStepEnd}) {
    for (const double h : {0.02, 0.01, 0.005, 0.002}) {
      for (const double x : {-0.2537, -0.3, -0.251, -0.2777}) {
        RunSetup s = test::setup_with(
            {test::wall("floor", {0.0, -0.1}, 4.0, 0.2), test::wall("kerb", {0.5, -0.0495}, 1.0, 0.101),
             test::box("box", {x, 0.05}, {1.5, 0.0}, 0.2, 0.1)},
            1.0);
        s.scene.forces.gravity = {0.0, -9.81};
        s.method.impacts = impacts;
        s.method.contacts = ContactsId::kLasting;
        s.method.step = h;
        Simulation run(s);
        while (run.impact_count() == 0) run.step();
        EXPECT_NEAR(run.ledger().lost_to_restitution, 0.0, 1e-9) << "h = " << h << ", x = " << x;
        EXPECT_GT(run.state().v(2, 2), 4.0) << "h = " << h << ", x = " << x;
      }
    }
  }
}

// A rolling ball hits a box that rests, with friction and without rebound: it is the same impact where it falls
// on the end of a step, in the middle of one, and anywhere else.
TEST(SupportedHits, AHitAtTheEndOfAStepIsTheSame) {
  const auto after = [](double radius, double step) {
    Body ball = test::disc("ball", {-0.2 - radius, radius}, {1.5, 0.0}, radius, 0.5);
    ball.spin = -1.5 / radius;
    RunSetup s = test::setup_with({test::wall("floor", {0.0, -0.25}, 4.0, 0.5), ball,
                                   test::box("box", {0.0, 0.1}, {0.0, 0.0}, 0.2, 0.2, 1.0)},
                                  0.0, 0.5);
    s.scene.forces.gravity = {0.0, -9.81};
    s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, step};
    Simulation run(s);
    run.advance_to(0.12, [] {});
    return Eigen::Vector3d(run.state().v(0, 1), run.state().v(1, 1), run.state().v(0, 2));
  };
  for (const double radius : {0.05, 0.1}) {
    const Eigen::Vector3d expected = after(radius, 0.00067);
    for (const double step : {1.0 / 60.0, 1.0 / 75.0, 1.0 / 97.0, 1.0 / 15.0 / 4.5, 0.004})
      EXPECT_LT((after(radius, step) - expected).norm(), 1e-4) << radius << ' ' << step;
  }
}

// Two boxes that touch along all of their sides come back from a wall one after the other.
TEST(SupportedHits, TwoBoxesComeBackFromAWall) {
  for (const double step : {1.0 / 60.0, 0.01, 1.0 / 3000.0, 1.0 / 4000.0}) {
    RunSetup s = test::setup_with(
        {test::wall("left tile", {-2.0, -0.25}, 4.0, 0.5), test::wall("right tile", {2.0, -0.25}, 4.0, 0.5),
         test::wall("wall", {0.3, 0.5}, 0.2, 1.0), test::box("front", {-0.05, 0.1}, {1.0, 0.0}, 0.3, 0.2, 1.0),
         test::box("rear", {-0.3, 0.1}, {1.0, 0.0}, 0.2, 0.2, 1.0)},
        1.0);
    s.scene.forces.gravity = {0.0, -9.81};
    s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, step};
    Simulation run(s);
    run.advance_to(0.3, [] {});
    for (const int i : {3, 4}) {
      EXPECT_NEAR(run.state().v(0, i), -1.0, 1e-9) << i << ' ' << step;
      EXPECT_NEAR(run.state().v(2, i), 0.0, 1e-9) << i << ' ' << step;
    }
  }
}

}  // namespace
}  // namespace carom
