#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

#include "physics/run/simulation.h"
#include "tests/support/fine_step.h"
#include "tests/support/scenes.h"

// What is hit while contacts carry and turn it: in the middle of a step these are open or closed by the error
// of their forces, and all the same they take part in the hit as at a step's end.
namespace carom {
namespace {

RunSetup setup(std::vector<Body> bodies, double restitution, double friction, double step) {
  RunSetup s = test::setup_with(std::move(bodies), restitution, friction);
  s.scene.forces.gravity = {0.0, -9.81};
  s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, step};
  return s;
}

// A plank on an edge carries a weight at its left and turns to it; a ball falls on its right.
struct Seesaw {
  double fall = 0.0;  // m
  double ball = 0.0;  // kg
  double restitution = 0.0;
  double friction = 0.0;
};
RunSetup seesaw(const Seesaw& s, double step) {
  const Polygon pivot{{{-0.1, -0.05}, {0.1, -0.05}, {0.0, 0.1}}};
  return setup(
      {test::fixed("pivot", pivot, {0.0, 0.05}), test::box("plank", {0.0, 0.17}, {0.0, 0.0}, 1.2, 0.04),
       test::box("weight", {-0.5, 0.24}, {0.0, 0.0}, 0.1, 0.1, 0.3),
       test::disc("ball", {0.5, 0.25 + s.fall}, {0.0, 0.0}, 0.06, s.ball)},
      s.restitution, s.friction, step);
}

// A ball that falls beside an upright domino and pushes it over.
RunSetup domino(double speed, double friction, double step) {
  return setup(
      {test::fixed("floor", Wall{}, {0.0, 0.0}), test::box("domino", {0.0, 0.1}, {0.0, 0.0}, 0.03, 0.2),
       test::disc("ball", {-0.2, 0.18}, {speed, 0.0}, 0.03, 0.5)},
      0.0, friction, step);
}

// A stack of boxes that a ball hits.
struct Stack {
  int boxes = 2;
  double height = 0.0;  // of the ball, m
  double speed = 0.0;   // m/s
  double ball = 0.0;    // kg
  double until = 0.0;   // s
};
RunSetup stack(const Stack& s, double step) {
  std::vector<Body> bodies{test::fixed("floor", Wall{}, {0.0, 0.0})};
  for (int k = 0; k < s.boxes; ++k)
    bodies.push_back(test::box("box-" + std::to_string(k), {0.0, 0.075 + 0.15 * k}, {0.0, 0.0}, 0.2, 0.15));
  bodies.push_back(test::disc("ball", {-0.5, s.height}, {s.speed, 0.0}, 0.05, s.ball));
  return setup(std::move(bodies), 0.0, 0.5, step);
}

// s: when it comes.
double first_impact(const RunSetup& setup) {
  Simulation run(setup);
  while (run.impact_count() == 0 && run.time() < 1.0) run.step();
  return run.time();
}

TEST(HitsInContact, ASeesawIsHitInTheSameWayAnywhereInAStep) {
  const Seesaw scenes[] = {
      {0.2185, 0.336, 0.3, 0.3}, {0.3, 0.5, 0.3, 0.6}, {0.39, 0.465, 0.0, 0.9}, {0.39, 0.465, 0.0, 0.3}};
  for (const Seesaw& scene : scenes) {
    const double after = std::ceil(60.0 * first_impact(seesaw(scene, 1.0 / 3840.0))) / 60.0;
    for (const double step : {1.0 / 60.0, 1.0 / 120.0, 1.0 / 240.0}) {
      const auto at = [&](double h) { return seesaw(scene, h); };
      EXPECT_LT(test::off_from_fine_step(at, after, step), 1e-5)
          << scene.fall << " m, e = " << scene.restitution << ", mu = " << scene.friction << ", h = " << step;
    }
  }
}

// The domino's friction lifts the ball off the floor, onto which it comes back within the step.
TEST(HitsInContact, WhatLiftsOffMayLandWithinTheStep) {
  for (const double speed : {0.845, 0.87, 0.9}) {
    for (const double friction : {0.2, 0.4}) {
      for (const double step : {1.0 / 60.0, 1.0 / 120.0, 1.0 / 240.0}) {
        const auto at = [&](double h) { return domino(speed, friction, h); };
        EXPECT_LT(test::off_from_fine_step(at, 0.28, step), 2e-4)
            << speed << " m/s, mu = " << friction << ", h = " << step;
      }
    }
  }
}

// A box that has tipped against a low step falls back: its side meets the step, and its base the floor, at one
// moment, in which friction acts. What is later in a list, or nearer by rounding, decides nothing.
TEST(HitsInContact, ABoxFallsBackIntoACornerAtOnce) {
  struct Case {
    double step_height, width, height, speed, friction, until;
  };
  for (const Case& c : {Case{0.02, 0.158, 0.093, 1.39, 0.1, 0.5}, Case{0.01, 0.2, 0.15, 1.2, 0.3, 0.6},
                        Case{0.02, 0.12, 0.2, 0.9, 0.1, 0.7}, Case{0.005, 0.25, 0.1, 1.7, 0.1, 0.5}}) {
    const auto at = [&](double h) {
      return setup({test::wall("floor", {0.0, -0.1}, 3.0, 0.2),
                    test::wall("step", {1.0, 0.5 * c.step_height}, 1.0, c.step_height),
                    test::box("box", {0.3 - 0.5 * c.width, 0.5 * c.height}, {c.speed, 0.0}, c.width, c.height)},
                   0.0, c.friction, h);
    };
    for (const double step : {1.0 / 60.0, 1.0 / 120.0, 1.0 / 240.0, 1.0 / 960.0})
      EXPECT_LT(test::off_from_fine_step(at, c.until, step), 1e-6)
          << c.step_height << " m, mu = " << c.friction << ", h = " << step;
  }
}

// Without rebound, what is hit and what it pushes on stop at once. A ball may hit beside the seam of two boxes,
// and then the upper one too, as the lower one has moved on; or push a box down that was in contact on both of
// its sides.
TEST(HitsInContact, AStackIsHitInTheSameWayAtAnyStep) {
  for (const Stack& scene : {Stack{2, 0.29033116789975727, 2.4315703366337105, 0.6372415173305916, 0.897},
                             Stack{3, 0.4186326745169498, 2.834293079072636, 0.9872434992229927, 0.575},
                             Stack{3, 0.42988462035729624, 1.4512596876860187, 0.7568371060114276, 0.598}}) {
    const auto at = [&](double h) { return stack(scene, h); };
    EXPECT_LT(test::off_from_fine_step(at, scene.until, 1.0 / 60.0), 2e-3) << scene.height;
    for (const double step : {1.0 / 120.0, 1.0 / 200.0, 1.0 / 240.0})
      EXPECT_LT(test::off_from_fine_step(at, scene.until, step), 4e-4) << scene.height << " m, h = " << step;
  }
}

TEST(HitsInContact, DominoesFallInTheSameWayAtAnyStep) {
  const auto at = [](double h) {
    RunSetup s = domino(1.094053871786383, 0.6, h);
    s.scene.bodies.push_back(test::box("next", {0.11009663006259722, 0.1}, {0.0, 0.0}, 0.03, 0.2));
    return s;
  };
  EXPECT_LT(test::off_from_fine_step(at, 0.653, 1.0 / 60.0), 2e-3);
  for (const double step : {1.0 / 120.0, 1.0 / 200.0, 1.0 / 240.0})
    EXPECT_LT(test::off_from_fine_step(at, 0.653, step), 4e-4) << step;
}

}  // namespace
}  // namespace carom
