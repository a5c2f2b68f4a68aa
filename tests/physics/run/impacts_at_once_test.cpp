#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numbers>
#include <numeric>
#include <random>
#include <stdexcept>
#include <vector>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/run/run_setup.h"
#include "tests/support/scenes.h"

// A body that meets several others at one moment: the impacts are resolved together, and neither the order of
// the bodies in the file nor rounding decides what comes out.
namespace carom {
namespace {

using test::disc;

Vec2 turned(const Vec2& v, double angle) {
  return {std::cos(angle) * v.x() - std::sin(angle) * v.y(), std::sin(angle) * v.x() + std::cos(angle) * v.y()};
}

// One ball on two at rest that touch, along the axis of symmetry; sizes and speeds times `scale`.
struct OneOnTwo {
  double scale = 1.0;
  double angle = 0.0;
  Vec2 shift = Vec2::Zero();
  std::array<int, 3> order = {0, 1, 2};  // of cue, upper and lower in the file
  double restitution = 1.0;
  double friction = 0.0;

  [[nodiscard]] RunSetup setup() const {
    const std::array<Body, 3> balls = {disc("cue", {-1.0, 0.0}, {2.0, 0.0}),
                                       disc("upper", {0.0, 0.1}, {0.0, 0.0}),
                                       disc("lower", {0.0, -0.1}, {0.0, 0.0})};
    RunSetup s = test::setup_with({}, restitution, friction);
    for (const int k : order) {
      Body b = balls[static_cast<std::size_t>(k)];
      b.position = shift + turned(scale * b.position, angle);
      b.velocity = turned(scale * b.velocity, angle);
      b.shape = Disc{0.1 * scale};
      s.scene.bodies.push_back(b);
    }
    s.method.step = 0.01;
    return s;
  }
};

// Velocities along and across the axis, by name; in units of the scale.
Vec2 velocity_of(const Simulation& run, const OneOnTwo& scene, const std::string& name) {
  for (int i = 0; i < run.state().size(); ++i) {
    if (run.bodies()[static_cast<std::size_t>(i)].name == name)
      return turned(run.state().v.col(i).head<2>(), -scene.angle) / scene.scale;
  }
  throw std::out_of_range(name);
}

void expect_symmetric(const Simulation& run, const OneOnTwo& scene, double tolerance) {
  // By momentum, symmetry and Newton's law: j = (1 + e) v cos 30°/(1 + 2 cos² 30°) on each, along its normal.
  const double c = 0.5 * std::numbers::sqrt3;
  const double j = (1.0 + scene.restitution) * 2.0 * c / (1.0 + 2.0 * c * c);
  const Vec2 cue = velocity_of(run, scene, "cue");
  const Vec2 upper = velocity_of(run, scene, "upper");
  const Vec2 lower = velocity_of(run, scene, "lower");
  EXPECT_NEAR(cue.y(), 0.0, tolerance);
  EXPECT_NEAR(upper.x(), lower.x(), tolerance);
  EXPECT_NEAR(upper.y(), -lower.y(), tolerance);
  if (scene.friction == 0.0) {
    EXPECT_NEAR(cue.x(), 2.0 - 2.0 * c * j, tolerance);
    EXPECT_NEAR(upper.x(), c * j, tolerance);
    EXPECT_NEAR(upper.y(), 0.5 * j, tolerance);
  }
  EXPECT_NEAR(run.ledger().numerical_drift(run.totals().energy()) / (scene.scale * scene.scale), 0.0, 1e-13);
}

TEST(ImpactsAtOnce, OneBallOnTwoInEveryOrderPlaceAndSize) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::array<int, 3> order = {0, 1, 2};
  for (int k = 0; k < 120; ++k) {
    std::next_permutation(order.begin(), order.end());
    OneOnTwo scene;
    scene.order = order;
    scene.scale = std::pow(10.0, 3.0 * uniform(random));
    scene.angle = k < 6 ? 0.0 : std::numbers::pi * uniform(random);
    scene.shift =
        k < 6 ? Vec2(Vec2::Zero()) : Vec2(30.0 * scene.scale * Vec2(uniform(random), uniform(random)));
    scene.restitution = k % 3 == 0 ? 1.0 : 0.5 * (1.0 + uniform(random));
    scene.friction = k % 4 == 3 ? 0.3 : 0.0;
    for (const IntegratorId integrator : {IntegratorId::kExactFlight, IntegratorId::kRk4}) {
      for (const ImpactsId impacts : {ImpactsId::kLocated, ImpactsId::kStepEnd}) {
        for (const ContactsId contacts : {ContactsId::kImpulse, ContactsId::kLasting}) {
          SCOPED_TRACE(fmt::format("{} {} {} {}", k, static_cast<int>(integrator), static_cast<int>(impacts),
                                   static_cast<int>(contacts)));
          RunSetup s = scene.setup();
          s.method.integrator = integrator;
          s.method.impacts = impacts;
          s.method.contacts = contacts;
          Simulation run(s);
          run.advance_to(1.0);
          // Located, the normals are those at the moment of the impact. At the step's end they are not.
          if (impacts == ImpactsId::kLocated) {
            expect_symmetric(run, scene, 1e-11);
          } else {
            EXPECT_NEAR(velocity_of(run, scene, "cue").y(), 0.0, 1e-10);
            EXPECT_NEAR(velocity_of(run, scene, "upper").y(), -velocity_of(run, scene, "lower").y(), 1e-10);
          }
          if (scene.friction == 0.0) {
            EXPECT_EQ(run.notices().text(), "ok");
          }
          if (HasFailure()) return;
        }
      }
    }
  }
}

// The way there adds up roundings: in many short steps, both impacts are found 1e-13 s apart.
TEST(ImpactsAtOnce, ClayKeepsItsSymmetryThroughManySteps) {
  for (int i = 0; i < 12; ++i) {
    OneOnTwo scene;
    scene.angle = 0.37 + 0.5 * i;
    scene.shift = {0.3 * i - 2.0, 1.0 - 0.21 * i};
    scene.restitution = 0.0;
    RunSetup s = scene.setup();
    s.method.step = 0.001;
    Simulation run(s);
    run.advance_to(1.0);
    expect_symmetric(run, scene, 1e-9);
  }
}

// The moment falls on the end of a step, where rounding says for each of the two in which step it is.
TEST(ImpactsAtOnce, AlsoAtTheEndOfAStep) {
  for (const ContactsId contacts : {ContactsId::kImpulse, ContactsId::kLasting}) {
    for (int k = 0; k < 100; ++k) {
      OneOnTwo scene;
      scene.angle = 0.03 * k;
      scene.shift = Vec2(0.37 * k, 0.11 * k);
      RunSetup s = scene.setup();
      // After 40 steps, at 0.1 √3 m from the line between the two.
      s.scene.bodies[0].position = scene.shift + turned({-0.1 * std::numbers::sqrt3 - 0.8, 0.0}, scene.angle);
      s.method.contacts = contacts;
      Simulation run(s);
      run.advance_to(1.0);
      expect_symmetric(run, scene, 1e-10);
      ASSERT_FALSE(HasFailure()) << k;
    }
  }
}

// Both ends of a row are hit at one moment: what they set off inside comes after both, in every order of the
// bodies.
TEST(ImpactsAtOnce, ARowHitFromBothSidesIsSymmetricInEveryOrder) {
  for (const double restitution : {0.3, 0.5, 0.9, 1.0}) {
    for (const int inside : {2, 3, 4}) {
      std::vector<int> order(static_cast<std::size_t>(inside) + 2);
      std::iota(order.begin(), order.end(), 0);
      std::mt19937 random(7);
      for (int k = 0; k < 20; ++k) {
        std::shuffle(order.begin(), order.end(), random);
        RunSetup s = test::setup_with({}, restitution);
        const double half = 0.1 * (inside - 1);
        for (const int i : order) {
          const bool moves = i == 0 || i == inside + 1;
          const double x = moves ? (i == 0 ? -half - 1.2 : half + 1.2) : 0.2 * (i - 1) - half;
          s.scene.bodies.push_back(
              disc(fmt::format("{}", i), {x, 0.0}, {moves ? (i == 0 ? 1.0 : -1.0) : 0.0, 0.0}));
        }
        Simulation run(s);
        run.advance_to(1.5);
        std::vector<double> v(order.size());
        for (std::size_t i = 0; i < order.size(); ++i)
          v[static_cast<std::size_t>(order[i])] = run.state().v(0, static_cast<Eigen::Index>(i));
        for (std::size_t i = 0; i < v.size(); ++i)
          EXPECT_NEAR(v[i], -v[v.size() - 1 - i], 1e-12)
              << restitution << ' ' << inside << ' ' << k << ' ' << i;
      }
    }
  }
}

// A rod holds the two: they can only move on together, as one body of two masses in one dimension.
TEST(ImpactsAtOnce, OneBallOnTwoThatALinkHolds) {
  for (const SeveralImpactsId several : {SeveralImpactsId::kPairwise, SeveralImpactsId::kSimultaneous}) {
    RunSetup s = OneOnTwo().setup();
    s.scene.several_impacts = several;
    Joint rod;
    rod.body = "upper";
    rod.to = "lower";
    s.scene.joints.push_back(rod);
    Simulation run(s);
    run.advance_to(1.0);
    EXPECT_NEAR(run.state().v(0, 0), -2.0 / 3.0, 1e-12);
    EXPECT_NEAR(run.state().v(1, 0), 0.0, 1e-12);
    EXPECT_NEAR(run.state().v(0, 1), 4.0 / 3.0, 1e-12);
    EXPECT_NEAR(run.state().v(1, 1), 0.0, 1e-12);
    EXPECT_NEAR(run.state().v(2, 1), 0.0, 1e-12);
    EXPECT_NEAR(run.ledger().numerical_drift(run.totals().energy()), 0.0, 1e-12);
  }
}

// Balls that touch at rest do not close: what meets the first of a row goes through it ball by ball.
TEST(ImpactsAtOnce, ACradleGoesOnBallByBall) {
  for (const ImpactsId impacts : {ImpactsId::kLocated, ImpactsId::kStepEnd}) {
    RunSetup s = test::setup_with({disc("left", {-0.8, 0.0}, {1.0, 0.0}), disc("1", {0.0, 0.0}, {0.0, 0.0}),
                                   disc("2", {0.2, 0.0}, {0.0, 0.0}), disc("right", {1.0, 0.0}, {-1.0, 0.0})});
    s.method.impacts = impacts;
    Simulation run(s);
    run.advance_to(1.2);
    EXPECT_NEAR(run.state().v(0, 0), -1.0, 1e-13);
    EXPECT_NEAR(run.state().v(0, 1), 0.0, 1e-13);
    EXPECT_NEAR(run.state().v(0, 3), 1.0, 1e-13);
  }
}

// Each contact keeps its own restitution: a middle ball between one that bounces and one of clay (e = 0).
TEST(ImpactsAtOnce, EachContactHasItsOwnRestitution) {
  RunSetup s = test::setup_with({disc("left", {-1.0, 0.0}, {1.0, 0.0}), disc("middle", {0.0, 0.0}, {0.0, 0.0}),
                                 disc("right", {1.0, 0.0}, {-1.0, 0.0})});
  s.scene.materials.push_back({"soft", 0.0});
  s.scene.bodies[2].material = "soft";
  s.method.integrator = IntegratorId::kExactFlight;
  Simulation run(s);
  while (run.impact_count() == 0) run.step();
  // u' = +1 at the left, 0 at the right, and p = 0: v = (-2/3, 1/3, 1/3).
  EXPECT_NEAR(run.state().v(0, 0), -2.0 / 3.0, 1e-14);
  EXPECT_NEAR(run.state().v(0, 1), 1.0 / 3.0, 1e-14);
  EXPECT_NEAR(run.state().v(0, 2), 1.0 / 3.0, 1e-14);
  EXPECT_NEAR(run.ledger().lost_to_restitution, 2.0 / 3.0, 1e-14);
}

// A ball breaks a triangle whose balls touch, at the steps' ends: neither the order of the bodies nor which of
// them is pushed out of the other first breaks the mirror symmetry.
TEST(ImpactsAtOnce, ATriangleBreaksAlikeInEveryOrderOfTheBodies) {
  const std::vector<Body> balls = {disc("cue", {-1.003, 0.0}, {2.0, 0.0}),
                                   disc("first", {0.0, 0.0}, {0.0, 0.0}),
                                   disc("upper", {0.1 * std::sqrt(3.0), 0.1}, {0.0, 0.0}),
                                   disc("lower", {0.1 * std::sqrt(3.0), -0.1}, {0.0, 0.0})};
  for (const double step : {0.01, 0.005, 0.001}) {
    std::vector<int> order = {0, 1, 2, 3};
    do {
      std::vector<Body> bodies;
      for (const int i : order) bodies.push_back(balls[static_cast<std::size_t>(i)]);
      RunSetup s = test::setup_with(bodies);
      s.method.impacts = ImpactsId::kStepEnd;
      s.method.step = step;
      Simulation run(s);
      run.advance_to(1.4);
      const auto velocity = [&](int ball) {
        const auto at = std::find(order.begin(), order.end(), ball) - order.begin();
        return Vec2(run.state().velocity(static_cast<int>(at)));
      };
      EXPECT_NEAR(velocity(0).y(), 0.0, 1e-9) << step;
      EXPECT_NEAR(velocity(1).y(), 0.0, 1e-9) << step;
      EXPECT_NEAR((velocity(2) - Vec2(velocity(3).x(), -velocity(3).y())).norm(), 0.0, 1e-9)
          << step << ", " << order[0] << order[1] << order[2] << order[3];
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

// A ball breaks a larger one, row by row: hits that follow one another, and at the steps' ends those that the
// first set off, come in the order of their moments, in every order of the bodies.
TEST(ImpactsAtOnce, ALargeTriangleBreaksAlikeOnBothSides) {
  std::mt19937 random(5);
  for (const ImpactsId impacts : {ImpactsId::kLocated, ImpactsId::kStepEnd}) {
    for (const ContactsId contacts : {ContactsId::kImpulse, ContactsId::kLasting}) {
      for (const double restitution : {0.0, 0.5, 0.95, 1.0}) {
        for (const int rows : {4, 5, 6}) {
          // Impacts of clay have no end: at a step's end they are listed at last, and 45 are too many at once.
          if (restitution == 0.0 && (impacts == ImpactsId::kStepEnd || rows > 5)) continue;
          std::vector<Body> balls = {disc("cue", {-0.557, 0.0}, {1.0, 0.0})};
          for (int row = 0; row < rows; ++row) {
            for (int k = 0; k <= row; ++k)
              balls.push_back(disc(fmt::format("{}/{}", row, k),
                                   {0.1 * std::sqrt(3.0) * row, 0.1 * (2 * k - row)}, {0.0, 0.0}));
          }
          std::shuffle(balls.begin(), balls.end(), random);
          RunSetup s = test::setup_with(balls, restitution);
          s.method = {IntegratorId::kRk4, impacts, contacts, 0.01};
          Simulation run(s);
          run.advance_to(1.0);
          const auto velocity = [&](int row, int k) {
            const auto ball = std::find_if(balls.begin(), balls.end(), [&](const Body& b) {
              return b.name == fmt::format("{}/{}", row, k);
            });
            return Vec2(run.state().velocity(static_cast<int>(ball - balls.begin())));
          };
          for (int row = 0; row < rows; ++row) {
            for (int k = 0; k <= row; ++k) {
              const Vec2 there = velocity(row, row - k);
              EXPECT_NEAR((velocity(row, k) - Vec2(there.x(), -there.y())).norm(), 0.0, 1e-12)
                  << rows << " rows, e = " << restitution << ": " << row << '/' << k << ", impacts "
                  << static_cast<int>(impacts) << ", contacts " << static_cast<int>(contacts);
            }
          }
        }
      }
    }
  }
}

// Two balls meet a third one when a step ends: rounding does not say for each in which step it is.
TEST(ImpactsAtOnce, TwoHitsWhenAStepEndsAreOne) {
  for (const ContactsId contacts : {ContactsId::kImpulse, ContactsId::kLasting}) {
    for (const double step : {0.01, 0.005, 0.002, 0.001}) {
      RunSetup s = test::setup_with(
          {disc("a", {0.0, 0.0}, {1.0, 0.0}, 0.1, 1.0), disc("b", {0.4, 0.0}, {0.0, 0.0}, 0.1, 3.0),
           disc("c", {0.65, 0.0}, {-0.25, 0.0}, 0.1, 3.0)},
          0.5);
      s.method = {IntegratorId::kRk4, ImpactsId::kStepEnd, contacts, step};
      Simulation run(s);
      run.advance_to(0.5);
      // The law of both contacts: -0.5 of what closes, at each; by momentum.
      EXPECT_NEAR(run.state().v(0, 0), -25.0 / 56.0, 1e-9) << step;
      EXPECT_NEAR(run.state().v(0, 1), 3.0 / 56.0, 1e-9) << step;
      EXPECT_NEAR(run.state().v(0, 2), 10.0 / 56.0, 1e-9) << step;
    }
  }
}

// A ball breaks a rhombus where bodies may come to rest on each other, at the steps' ends: what is struck
// strikes on in the next round, both sides at once.
TEST(ImpactsAtOnce, ARhombusBreaksAlikeInEveryOrderOfTheBodies) {
  const double far = 0.05 * std::sqrt(3.0);
  const std::vector<Body> balls = {
      disc("cue", {-0.37, 0.0}, {1.3, 0.0}, 0.05), disc("first", {0.0, 0.0}, {0.0, 0.0}, 0.05),
      disc("upper", {far, 0.05}, {0.0, 0.0}, 0.05), disc("lower", {far, -0.05}, {0.0, 0.0}, 0.05),
      disc("last", {2.0 * far, 0.0}, {0.0, 0.0}, 0.05)};
  for (const double restitution : {0.5, 0.9}) {
    std::vector<int> order = {0, 1, 2, 3, 4};
    do {
      std::vector<Body> bodies;
      for (const int i : order) bodies.push_back(balls[static_cast<std::size_t>(i)]);
      RunSetup s = test::setup_with(bodies, restitution);
      s.method = {IntegratorId::kRk4, ImpactsId::kStepEnd, ContactsId::kLasting, 0.005};
      Simulation run(s);
      run.advance_to(0.3);
      const auto velocity = [&](int ball) {
        const auto at = std::find(order.begin(), order.end(), ball) - order.begin();
        return Vec2(run.state().velocity(static_cast<int>(at)));
      };
      EXPECT_NEAR(velocity(4).y(), 0.0, 1e-9);
      EXPECT_NEAR((velocity(2) - Vec2(velocity(3).x(), -velocity(3).y())).norm(), 0.0, 1e-9) << restitution;
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

// A rough ball bounces on the seam of two tiles, or beside it by rounding and more: as on one floor.
TEST(ImpactsAtOnce, ABallOnASeamBouncesAsOnOneFloor) {
  constexpr double kGravity = 9.81;  // m/s²
  for (const double angle : {0.0, 0.3, -1.1}) {
    for (const double beside : {0.0, 1e-13, -1e-13, 1e-11, -1e-11, 1e-10, 1e-9}) {
      for (const double step : {1.0 / 60.0, 0.005}) {
        RunSetup s = test::setup_with(
            {test::wall("left", {-0.5, -0.1}, 1.0, 0.2), test::wall("right", {0.5, -0.1}, 1.0, 0.2),
             disc("ball", {beside, 0.57}, {0.0, 0.0})},
            0.9, 0.3);
        s.scene.forces.gravity = turned({0.0, -kGravity}, angle);
        for (Body& b : s.scene.bodies) {
          b.position = turned(b.position, angle);
          b.angle = angle;
        }
        s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, step};
        Simulation run(s);
        run.advance_to(1.9);
        EXPECT_EQ(run.impact_count(), 4) << angle << ", " << beside << ", h = " << step;
        // Of four bounces.
        const double left = std::pow(0.9, 8) * kGravity * 0.47;
        EXPECT_NEAR(run.ledger().lost_to_restitution, kGravity * 0.47 - left, 1e-6)
            << angle << ", " << beside << ", h = " << step;
        EXPECT_EQ(run.notices().text(), "ok");
      }
    }
  }
}

// Surfaces for which no law of several contacts is known: the run says that the order decided, and of whom.
TEST(ImpactsAtOnce, SaysWhereTheOrderDecides) {
  for (const bool sticks : {false, true}) {
    RunSetup s = OneOnTwo().setup();
    s.scene.materials[0].sticks = sticks;
    s.scene.materials[0].tangential_restitution = sticks ? 0.0 : 0.5;
    Simulation run(s);
    run.advance_to(1.0);
    EXPECT_NE(run.notices().text().find("in the order of the bodies"), std::string::npos);
    EXPECT_NE(run.status().find("(cue and "), std::string::npos) << run.status();
  }
}

// A box lands flat on two floors side by side: each end rebounds with its own e, in both orders of the file.
TEST(ImpactsAtOnce, ABoxLandsFlatOnTwoFloorsThatDiffer) {
  for (const bool swapped : {false, true}) {
    std::vector<Body> floors = {test::fixed("dull", Box{2.0, 1.0}, {-1.0, -0.5}),
                                test::fixed("lively", Box{2.0, 1.0}, {1.0, -0.5})};
    RunSetup s = test::setup_with({}, 1.0);
    for (const auto& [name, restitution] : {std::pair("dull", 0.2), std::pair("lively", 0.8)}) {
      s.scene.materials.push_back(s.scene.materials.front());
      s.scene.materials.back().name = name;
      s.scene.materials.back().restitution = restitution;
    }
    for (Body& floor : floors) floor.material = floor.name;
    if (swapped) std::swap(floors[0], floors[1]);
    s.scene.bodies = floors;
    s.scene.bodies.push_back(test::box("box", {0.0, 0.35}, {0.0, -2.0}, 0.8, 0.2));
    s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, 0.005};
    Simulation run(s);
    run.advance_to(0.126);
    EXPECT_NEAR(run.state().velocity(2).y(), 1.0, 1e-12) << swapped;
    EXPECT_NEAR(run.state().v(2, 2), 0.6 * 2.0 / 0.8, 1e-12) << swapped;
  }
}

// Where all that touches takes part, one ball on two that touch leaves with -1/3, at the step's end too.
TEST(ImpactsAtOnce, WhatTouchesTakesPartInEveryWay) {
  for (const auto& impacts : kImpacts) {
    for (const ContactsId contacts : {ContactsId::kLasting, ContactsId::kImpulse}) {
      for (const double h : {1.0 / 60.0, 0.01, 0.003}) {
        RunSetup s = test::setup_with({test::disc("cue", {-0.7, 0.0}, {1.0, 0.0}, 0.1),
                                       test::disc("b", {0.0, 0.0}, {0.0, 0.0}, 0.1),
                                       test::disc("c", {0.2, 0.0}, {0.0, 0.0}, 0.1)});
        s.scene.several_impacts = SeveralImpactsId::kSimultaneous;
        s.method = {IntegratorId::kRk4, impacts.id, contacts, h};
        Simulation run(s);
        run.advance_to(0.6);
        EXPECT_NEAR(run.state().velocity(0).x(), -1.0 / 3.0, 1e-12) << impacts.name << ", " << h;
        EXPECT_NEAR(run.state().velocity(1).x(), 2.0 / 3.0, 1e-12) << impacts.name << ", " << h;
        EXPECT_NEAR(run.state().velocity(2).x(), 2.0 / 3.0, 1e-12) << impacts.name << ", " << h;
      }
    }
  }
}

}  // namespace
}  // namespace carom
