#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "physics/run/run_setup.h"
#include "physics/run/simulation.h"
#include "tests/support/fine_step.h"
#include "tests/support/scenes.h"

// A body that lands with one corner after the other bounces ever faster until it rests, within few steps.
namespace carom {
namespace {

RunSetup on_a_table(std::vector<Body> bodies, double slope, double restitution, double friction, double step) {
  Body table = test::wall("table", {0.1 * std::sin(slope), -0.1 * std::cos(slope)}, 4.0, 0.2, -slope);
  bodies.insert(bodies.begin(), table);
  RunSetup setup = test::setup_with(std::move(bodies), restitution, friction);
  setup.scene.forces.gravity = Vec2(0.0, -9.81);
  setup.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting};
  setup.method.step = step;
  return setup;
}

// A disc, a box or a polygon that drops a few centimetres, turning.
RunSetup random_drop(int seed, double step) {
  std::mt19937 random(static_cast<unsigned>(seed));
  const auto number = [&random](double from, double to) {
    return std::uniform_real_distribution<>(from, to)(random);
  };
  const auto choice = [&random](int count) { return std::uniform_int_distribution<>(0, count - 1)(random); };
  const double size = 0.1 * (1 + choice(3));
  Body body = test::box("body", {number(-0.6, 0.2), size + number(0.02, 0.15)},
                        {number(-0.5, 1.0), number(-0.3, 0.3)}, size, size * number(0.5, 1.5));
  if (choice(2) == 0) {
    Polygon polygon;
    const int corners = 3 + choice(4);
    for (int k = 0; k < corners; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / corners;
      polygon.vertices.emplace_back(0.5 * size * std::cos(angle), 0.5 * size * std::sin(angle));
    }
    body.shape = polygon;
  }
  body.angle = number(-3.0, 3.0);
  body.spin = number(-2.0, 2.0);
  const double slope = 0.1 * choice(3);
  const double restitution = 0.2 + 0.1 * choice(6);
  return on_a_table({body}, slope, restitution, 0.1 * choice(5), step);
}

Eigen::Vector3d pose_after(const RunSetup& setup, double time) {
  Simulation run(setup);
  run.advance_to(time, [] {});
  return run.state().q.col(1);
}

double largest_rise(const RunSetup& setup, double until) {
  Simulation run(setup);
  double last = run.totals().energy();
  double rise = 0.0;
  run.advance_to(until, [&] {
    const double now = run.totals().energy();
    rise = std::max(rise, now - last);
    last = now;
  });
  return rise;
}

// The reference is of 64 times as many steps, and half of them tell its error.
TEST(Clatter, ADropIsRightWithLargeSteps) {
  int known = 0;
  for (int seed = 1; seed <= 24; ++seed) {
    const auto after = [seed](int parts) { return pose_after(random_drop(seed, 1.0 / 60.0 / parts), 1.0); };
    const Eigen::Vector3d reference = after(64);
    const double unknown = (reference - after(32)).cwiseAbs().maxCoeff();
    if (unknown > 1e-6) continue;
    ++known;
    EXPECT_LT((after(1) - reference).cwiseAbs().maxCoeff(), 1e-3) << "seed " << seed;
    EXPECT_LT((after(4) - reference).cwiseAbs().maxCoeff(), 2e-5) << "seed " << seed;
  }
  EXPECT_GT(known, 16);
}

// It rocked on for ever, and gained energy: what had just been hit was held in the air by the forces of the
// step.
TEST(Clatter, ATriangleComesToRest) {
  Body body = test::box("body", {-0.08082035749046057, 0.33711706392758095},
                        {0.2036035716732456, -0.1520563004281018}, 0.1, 0.1);
  body.shape = Polygon{{{0.0535413465094767, -0.0844590090751256},
                        {0.04637297418278093, 0.08859767076759488},
                        {-0.09991432069225757, -0.00413866169246917}}};
  body.angle = -2.3207642120811336;
  body.spin = 0.1750434369437217;
  const RunSetup setup = on_a_table({body}, 0.0, 0.7, 0.2, 1.0 / 60.0);
  EXPECT_LT(largest_rise(setup, 1.5), 1e-5);
  Simulation run(setup);
  run.advance_to(1.5, [] {});
  EXPECT_LT(run.state().v.col(1).norm(), 1e-9);
}

// Where one of three corners is left out of the forces, it sinks in.
TEST(Clatter, BodiesThatLandOnEachOtherGainNothing) {
  Body lower =
      test::box("lower", {0.047211160236633465, 0.2}, {-0.012569198461883313, 0.0}, 0.2, 0.2895906511384162);
  lower.angle = -1.5021393127398992;
  Body upper = test::box("upper", {0.030979039083016552, 0.54}, {0.2393693204055553, 0.0}, 0.2,
                         0.24284816543688353, 2.0);
  upper.angle = -0.9687820421898614;
  for (const double step : {0.005, 0.0025})
    EXPECT_LT(largest_rise(on_a_table({lower, upper}, 0.0, 0.2, 0.0, step), 1.5), 1e-8) << step;
}

// Corners of a stack that a ball hits rattle, while what is above them presses on others.
TEST(Clatter, CornersUnderALoadComeToRest) {
  struct Case {
    int boxes;
    double height, speed, mass, restitution, friction, until;  // of the ball: m, m/s, kg
    double off, overlap;                                       // at most; overlap corrections in J
  };
  for (const Case& c :
       {Case{3, 0.1659, 2.859, 0.2124, 0.5, 0.3, 0.65, 3e-4, 1e-9},
        Case{2, 0.09852022913794845, 3.895270451396945, 0.4661505128432418, 0.5, 0.8, 0.665, 2e-5, 1e-9},
        Case{2, 0.1007692822756092, 3.647592845983203, 0.5020293604494064, 0.2, 0.5, 0.774, 1e-4, 1e-7}}) {
    const auto at = [&](double h) {
      std::vector<Body> bodies{test::disc("ball", {-0.5, c.height}, {c.speed, 0.0}, 0.05, c.mass)};
      for (int k = 0; k < c.boxes; ++k)
        bodies.push_back(test::box(fmt::format("box-{}", k), {0.0, 0.075 + 0.15 * k}, {0.0, 0.0}, 0.2, 0.15));
      return on_a_table(std::move(bodies), 0.0, c.restitution, c.friction, h);
    };
    for (const double step : {1.0 / 60.0, 1.0 / 120.0}) {
      EXPECT_LT(test::off_from_fine_step(at, c.until, step), c.off) << c.speed << ' ' << step;
      Simulation run(at(step));
      run.advance_to(c.until);
      EXPECT_LT(std::abs(run.ledger().penetration_correction), c.overlap) << c.speed << ' ' << step;
    }
  }
}

struct Layer {
  double width;
  double height;
  double x;
  double bottom;
  double mass;
};

// Boxes that fall onto each other rattle from corner to corner, hundreds of times within a step. They come to
// rest without sinking in.
TEST(Clatter, StacksThatAreDroppedDoNotSinkIn) {
  struct Drop {
    double restitution;
    double friction;
    std::vector<Layer> layers;
  };
  const Drop drops[] = {
      {0.3,
       0.2,
       {{0.4, 0.2, -0.03, 0.0, 2.0},
        {0.6, 0.2, 0.05, 0.25, 2.0},
        {0.4, 0.2, 0.0, 0.5, 1.0},
        {0.6, 0.2, 0.0, 0.7, 1.0}}},
      {0.3, 0.0, {{0.63, 0.1, -0.03, 0.05, 0.5}, {0.39, 0.2, -0.005, 0.2, 1.0}, {0.75, 0.2, 0.0, 0.4, 1.0}}},
      {0.5,
       0.0,
       {{0.32, 0.2, -0.01, 0.1, 2.0},
        {0.59, 0.2, 0.0, 0.31, 1.0},
        {0.61, 0.1, 0.0, 0.56, 2.0},
        {0.66, 0.1, 0.0, 0.71, 2.0},
        {0.46, 0.2, 0.05, 0.82, 2.0}}},
      {0.5,
       0.5,
       {{0.39, 0.3, 0.0, 0.02, 0.5},
        {0.7, 0.1, 0.0, 0.37, 2.0},
        {0.73, 0.2, 0.0, 0.47, 2.0},
        {0.72, 0.3, 0.0, 0.72, 0.5},
        {0.72, 0.2, 0.02, 1.03, 1.0}}}};
  for (const Drop& drop : drops) {
    for (const double h : {1.0 / 60.0, 0.01, 1.0 / 240.0}) {
      std::vector<Body> bodies;
      for (const Layer& at : drop.layers) {
        const std::string name = fmt::format("box {}", bodies.size());
        bodies.push_back(test::box(name, {at.x, at.bottom + 0.5 * at.height}, {0.0, 0.0}, at.width, at.height));
        bodies.back().mass = at.mass;
      }
      Simulation run(on_a_table(std::move(bodies), 0.0, drop.restitution, drop.friction, h));
      run.advance_to(1.5, [] {});
      SCOPED_TRACE(fmt::format("{} boxes, e = {}, h = {}", drop.layers.size(), drop.restitution, h));
      EXPECT_LT(std::abs(run.ledger().penetration_correction), 1e-4);
      double top = 0.0;
      for (std::size_t k = 0; k < drop.layers.size(); ++k) {
        const auto body = static_cast<int>(k + 1);
        EXPECT_NEAR(run.state().position(body).y(), top + 0.5 * drop.layers[k].height, 1e-7) << k;
        top += drop.layers[k].height;
      }
    }
  }
}

}  // namespace
}  // namespace carom
