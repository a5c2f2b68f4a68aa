#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "physics/collision/broad_phase.h"
#include "physics/collision/pair_contact.h"
#include "physics/run/simulation.h"
#include "tests/support/draws.h"
#include "tests/support/scenes.h"

// Discs, squares, triangles and hexagons dropped into a container come to rest without passing through each
// other.
namespace carom {
namespace {

Body cornered(const std::string& name, int corners, double radius) {
  Body b;
  b.name = name;
  Polygon polygon;
  for (int i = 0; i < corners; ++i)
    polygon.vertices.push_back(radius * direction_at(2.0 * std::numbers::pi * i / corners));
  b.shape = polygon;
  return b;
}

RunSetup crowd(int n, std::uint64_t seed) {
  constexpr double kSpacing = 0.8;
  test::Draws draw(seed);
  const int columns = static_cast<int>(std::lround(std::sqrt(n)));
  const double width = kSpacing * columns;
  const double height = kSpacing * n / columns + 5.0;
  std::vector<Body> bodies = {test::wall("floor", {0.5 * width, -0.5}, width + 2.0, 1.0),
                              test::wall("left", {-0.5, 0.5 * height}, 1.0, height + 2.0),
                              test::wall("right", {width + 0.5, 0.5 * height}, 1.0, height + 2.0)};
  for (int i = 0; i < n; ++i) {
    const std::string name = "body-" + std::to_string(i);
    Body b = i % 4 == 2 ? cornered(name, 3, 0.3) : cornered(name, 6, 0.27);
    if (i % 4 == 0) b.shape = Disc{0.25};
    if (i % 4 == 1) b.shape = Box{0.5, 0.5};
    b.density = 1.0;
    const int row = i / columns;
    b.position = kSpacing * Vec2(i % columns + 0.5, row + 0.5);
    b.angle = draw.angle();
    const double speed = draw.between(0.0, 1.0);
    b.velocity = speed * draw.direction();
    b.spin = draw.between(-10.0, 10.0);
    bodies.push_back(b);
  }
  RunSetup s = test::setup_with(bodies, 0.3, 0.4);
  s.scene.forces.gravity = {0.0, -9.81};
  s.method = {IntegratorId::kRk4, ImpactsId::kStepEnd, ContactsId::kLasting, 1.0 / 60.0};
  return s;
}

// Puts discs and boxes over the floor at y = `floor`, from x = `left` on.
void add_pile(int n, double left, double floor, test::Draws& draws, std::vector<Body>& bodies) {
  for (int i = 0; i < n; ++i) {
    const int row = i / 6;
    Body b = test::disc("body-" + std::to_string(i), {left + 0.4 + 0.55 * (i % 6), floor + 0.4 + 0.55 * row},
                        draws.in_square(0.5), 0.2);
    if (i % 3 > 0) {
      b.shape = Box{draws.between(0.2, 0.5), draws.between(0.2, 0.35)};
      b.angle = draws.angle();
    }
    bodies.push_back(b);
  }
}

// Under gravity, with impacts at their own time.
RunSetup rattling(const std::vector<Body>& bodies, double restitution, double friction) {
  RunSetup s = test::setup_with(bodies, restitution, friction);
  s.scene.forces.gravity = {0.0, -9.81};
  s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, 1.0 / 60.0};
  return s;
}

RunSetup small_pile(int n, double restitution, std::uint64_t seed) {
  test::Draws draws(seed);
  std::vector<Body> bodies = test::room(2.0, 1.0);
  add_pile(n, -2.0, -2.0, draws, bodies);
  return rattling(bodies, restitution, 0.1 + 0.1 * static_cast<double>(seed % 6));
}

double deepest(const Simulation& run) {
  std::vector<Bounds> bounds;
  for (int i = 0; i < static_cast<int>(run.bodies().size()); ++i) {
    const Eigen::Array2d x = run.state().position(i).array();
    const Eigen::Array2d extent = run.shapes().extent.col(i).array();
    bounds.push_back({x - extent, x + extent});
  }
  BroadPhase near;
  double most = 0.0;
  for (const auto& [a, b] : near.pairs(bounds, run.shapes().fixed)) {
    if (run.shapes().can_collide(a, b))
      most =
          std::max(most, -contact_between(run.shapes(), a, run.state().q.col(a), b, run.state().q.col(b)).gap);
  }
  return most;
}

TEST(MixedCrowd, ComesToRestWithoutDeepPenetrations) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    Simulation run(crowd(60, seed));
    double most = 0.0;
    int deep = 0;  // steps
    while (run.time() < 6.0) {
      run.step();
      const double now = deepest(run);
      most = std::max(most, now);
      if (now > 5e-3) ++deep;
      ASSERT_LT(run.totals().energy(), (1.0 + 1e-9) * run.ledger().initial) << seed << " at " << run.time();
    }
    // Two corners that pass one another within a step, by some 0.1 m, are found too late once in a while, and
    // parted in the next one.
    EXPECT_LT(most, 8e-3) << seed;
    EXPECT_LE(deep, 1) << seed;
    EXPECT_LT(deepest(run), 1e-4) << seed;
    EXPECT_LT(run.totals().kinetic(), 1e-4) << seed;
    EXPECT_GE(run.ledger().lost_to_friction, 0.0);
    EXPECT_GE(run.ledger().lost_to_restitution, 0.0);
  }
}

// Discs and boxes that rattle for a second, hit after hit in every step: they come to rest, what parts them
// lifts them little, and what is booked as lost is lost: neither steps that gain energy nor those that lose
// more add up to more than 0.1 per cent of it.
TEST(MixedCrowd, WhatRattlesIsNeitherLiftedNorMakesEnergy) {
  for (const std::uint64_t seed : {6, 7}) {
    for (const double restitution : {0.3, 0.6}) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", e = " << restitution);
      Simulation run(small_pile(18 + static_cast<int>(seed), restitution, seed));
      const double before = run.totals().energy();
      double gained = 0.0;
      double drift = 0.0;
      while (run.time() < 6.0) {
        run.step();
        const double now = run.ledger().numerical_drift(run.totals().energy());
        gained += std::max(0.0, now - drift);
        drift = now;
      }
      const double lost = before - run.totals().energy();
      EXPECT_LT(run.totals().kinetic(), 1e-4 * lost);
      EXPECT_LT(run.ledger().penetration_correction, 0.03 * lost);
      EXPECT_LT(gained, 1e-3 * lost);
      EXPECT_LT(gained - drift, 1e-3 * lost);
      EXPECT_LT(deepest(run), 1e-4);
    }
  }
}

// Where sixteen of them block each other, linear contact forces that would meet everything grow beyond all
// bounds at 0.673 s: there the constant ones stay.
TEST(MixedCrowd, IsNotLostWhereItsContactForcesHaveNoSolution) {
  test::Draws draws(6);
  std::vector<Body> bodies = test::room(2.0, 1.0);
  for (int i = 0; i < 16; ++i) {
    const Vec2 place(-1.6 + 0.55 * (i % 6), -1.6 + 0.55 * (i / 6));  // NOLINT(bugprone-integer-division): rows
    Body b = test::disc("body-" + std::to_string(i), place, draws.in_square(0.5), 0.2);
    const double kind = draws.between(0.0, 1.0);
    if (kind > 0.33) {
      b.shape = Box{draws.between(0.2, 0.5), draws.between(0.2, 0.35)};
      b.angle = draws.angle();
    }
    bodies.push_back(b);
  }
  Simulation run(rattling(bodies, 0.0, 0.1 + 0.2 * 2));
  run.advance_to(1.0);
  EXPECT_GE(run.time(), 1.0) << run.status();
  EXPECT_LE(run.state().v.cwiseAbs().maxCoeff(), 10.0);
}

// Beside such a pile twenty slow discs of 1 cm, each hit by another one at 40 m/s, over a plate of 2 mm that
// lies on two posts. Some fall off beside it; between the posts none comes under it.
TEST(MixedCrowd, WhatIsFastBesideItMeetsAThinPlate) {
  constexpr double kTop = -3.598;  // m, of the plate
  constexpr double kSpeed = 40.0;  // m/s
  int through = 0;
  for (const std::uint64_t seed : {0, 1, 2, 3}) {
    test::Draws draws(seed);
    std::vector<Body> bodies{
        test::wall("floor", {0.0, -4.5}, 10.0, 1.0), test::wall("left", {-4.5, 0.0}, 1.0, 200.0),
        test::wall("right", {4.5, 0.0}, 1.0, 200.0), test::wall("fence", {0.0, -2.0}, 0.2, 4.0)};
    add_pile(24, -4.0, -4.0, draws, bodies);
    for (const double x : {0.8, 3.2})
      bodies.push_back(test::wall("post-" + std::to_string(x), {x, -3.8}, 0.4, 0.4));
    Body& plate = bodies.emplace_back(test::disc("plate", {2.0, kTop - 0.001}, Vec2::Zero(), 1.0));
    plate.shape = Box{2.8, 0.002};
    plate.mass = 20.0;
    const int first = static_cast<int>(bodies.size());
    for (int k = 0; k < 20; ++k) {
      const double x = 1.1 + 0.09 * k;
      const std::string number = std::to_string(k);
      bodies.push_back(test::disc("slow-" + number, {x, kTop + 0.16}, {0.0, 0.2}, 0.01));
      bodies.push_back(
          test::disc("fast-" + number, {x, kTop + 0.2 + kSpeed * (0.35 + 0.03 * k)}, {0.0, -kSpeed}, 0.01));
    }
    Simulation run(rattling(bodies, 0.6, 0.5));
    run.advance_to(1.2);
    for (int i = first; i < run.state().size(); ++i) {
      const Vec2 at = run.state().position(i);
      through += at.y() < -3.6 && at.x() > 1.0 && at.x() < 3.0 ? 1 : 0;
    }
  }
  EXPECT_EQ(through, 0);
}

}  // namespace
}  // namespace carom
