#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <random>
#include <utility>
#include <vector>

#include "physics/run/simulation.h"
#include "tests/support/convex_reference.h"
#include "tests/support/scenes.h"

// Static friction at several contacts that hold one body, or one row of bodies, under a force that grows: it
// gives way when all are at their limits, not when the first one is.
namespace carom {
namespace {

constexpr double kG = 9.81;
constexpr double kStatic = 0.5;
constexpr double kKinetic = 0.3;

// The velocity and the way of a mass (kg) at `time` (s) whose force grows by `rate` (N/s), held by this much of
// its weight and then by that.
struct Slid {
  double speed = 0.0;  // m/s
  double way = 0.0;    // m
};
Slid slid(double mass, double rate, double time, double held = kStatic, double rubbed = kKinetic) {
  const double from = held * mass * kG / rate;
  const double t = time - from;
  const double a = (held - rubbed) * kG;
  return {a * t + 0.5 * rate / mass * t * t, 0.5 * a * t * t + rate / mass * t * t * t / 6.0};
}

Body block(const std::string& name, double x, double mass) {
  Body body = test::disc(name, {x, 0.05}, {0.0, 0.0}, 0.1, mass);
  body.shape = Box{0.3, 0.1};
  return body;
}

// Rough floors and blocks, smooth against one another, turned about the origin and shifted; a force on the
// first block that reaches `force` at `rise` s.
RunSetup pushed(std::vector<Body> bodies, const std::string& first, double force, double rise, double turned,
                const Vec2& shift) {
  RunSetup s = test::setup_with({}, 0.0, kKinetic);
  s.scene.materials.front().static_friction = kStatic;
  Material smooth;
  smooth.restitution = 0.0;
  s.scene.pairs.push_back({"block", "block", smooth});
  s.scene.materials.push_back(s.scene.materials.front());
  s.scene.materials.back().name = "block";
  for (Body& body : bodies) {
    if (!body.fixed) body.material = "block";
    body.position = shift + turned_by(turned, body.position);
    body.angle = turned;
  }
  s.scene.bodies = std::move(bodies);
  s.scene.forces.gravity = turned_by(turned, Vec2(0.0, -kG));
  AppliedForce push;
  push.body = first;
  push.force = turned_by(turned, Vec2(force, 0.0));
  push.rise = rise;
  s.scene.forces.applied.push_back(push);
  return s;
}

// m: velocity Verlet, of order 2, is behind where a force changes in time.
double way_off(const Simulation& run) {
  const double h = run.method().step;
  return run.method().integrator == IntegratorId::kVelocityVerlet ? h * h : 1e-10;
}

template <class Check>
void for_each_method(RunSetup setup, double until, const Check& check) {
  for (const IntegratorId integrator :
       {IntegratorId::kVelocityVerlet, IntegratorId::kRk4, IntegratorId::kDormandPrince}) {
    for (const double h : {1.0 / 60.0, 0.01, 0.005, 0.002}) {
      SCOPED_TRACE(testing::Message() << static_cast<int>(integrator) << ", h = " << h);
      setup.method = {integrator, ImpactsId::kLocated, ContactsId::kLasting, h};
      Simulation run(setup);
      run.advance_to(until);
      check(run);
    }
  }
}

TEST(BreakAway, OfABlockOnSeveralTiles) {
  const Slid right = slid(1.3, 15.0, 0.8);
  for (const int tiles : {1, 2, 3}) {
    for (const double turned : {0.0, 0.4, 3.0}) {
      std::vector<Body> bodies;
      const double width = tiles == 3 ? 0.2 : 2.0;
      for (int i = 0; i < tiles; ++i)
        bodies.push_back(test::fixed(fmt::format("tile {}", i), Box{width, 0.1},
                                     {0.02 + width * (i - 0.5 * (tiles - 1)), -0.05}));
      if (tiles == 3) bodies.push_back(test::fixed("last", Box{2.0, 0.1}, {0.02 + 1.5 * width + 1.0, -0.05}));
      // Also between them in the order of the bodies.
      const int place = tiles == 2 ? 1 : tiles;
      bodies.insert(bodies.begin() + place, block("block", 0.0, 1.3));
      const Vec2 shift = {turned, -7.0 * turned};
      SCOPED_TRACE(testing::Message() << tiles << " tiles, turned by " << turned);
      for_each_method(pushed(bodies, "block", 12.0, 0.8, turned, shift), 0.8, [&](const Simulation& run) {
        const Vec2 along = turned_by(turned, Vec2::UnitX());
        EXPECT_NEAR(run.state().velocity(place).dot(along), right.speed, 1e-9);
        EXPECT_NEAR((run.state().position(place) - shift).dot(along), right.way, way_off(run));
        EXPECT_EQ(run.status(), "ok");
      });
    }
  }
}

// Each corner on a tile of its own material; the push tilts the load towards the one in front.
TEST(BreakAway, OfABlockOnTilesOfTwoMaterials) {
  constexpr double kUntil = 0.7;  // s
  for (const auto& [behind, in_front] : {std::pair(0.2, 0.6), std::pair(0.7, 0.3)}) {
    // Both at the same share of what holds.
    constexpr double kShare = 0.75;
    // Of the weight: with N1 + N2 = m g and 0.15 (N2 - N1) = 0.05 T, T = f1 N1 + f2 N2.
    const auto friction = [](double f1, double f2) { return 0.5 * (f1 + f2) / (1.0 + (f1 - f2) / 6.0); };
    const Slid right =
        slid(1.3, 15.0, kUntil, friction(behind, in_front), friction(kShare * behind, kShare * in_front));
    RunSetup s = pushed({test::fixed("behind", Box{2.0, 0.1}, {-0.98, -0.05}),
                         test::fixed("in front", Box{2.0, 0.1}, {1.02, -0.05}), block("block", 0.0, 1.3)},
                        "block", 12.0, 0.8, 0.0, Vec2::Zero());
    for (const auto& [i, holds] : {std::pair(0U, behind), std::pair(1U, in_front)}) {
      Material material = s.scene.materials.front();
      material.name = s.scene.bodies[i].name;
      s.scene.bodies[i].material = material.name;
      s.scene.materials.push_back(material);
      material.static_friction = holds;
      material.kinetic_friction = kShare * holds;
      s.scene.pairs.push_back({material.name, "block", material});
    }
    SCOPED_TRACE(testing::Message() << behind << " behind, " << in_front << " in front");
    for_each_method(s, kUntil, [&](const Simulation& run) {
      EXPECT_NEAR(run.state().v(0, 2), right.speed, 1e-8);
      EXPECT_NEAR(run.state().q(0, 2), right.way, way_off(run));
      EXPECT_EQ(run.status(), "ok");
    });
  }
}

TEST(BreakAway, OfABlockThatPushesAnother) {
  for (const auto& [pusher, other] : {std::pair(2.0, 0.5), std::pair(1.0, 1.0), std::pair(0.3, 1.2)}) {
    const double mass = pusher + other;
    const double until = kStatic * mass * kG / 20.0 + 0.087;
    const Slid right = slid(mass, 20.0, until);
    const RunSetup setup = pushed({test::fixed("floor", Box{8.0, 0.1}, {0.0, -0.05}),
                                   block("pusher", 0.0, pusher), block("other", 0.3, other)},
                                  "pusher", 30.0, 1.5, 0.0, Vec2::Zero());
    SCOPED_TRACE(testing::Message() << pusher << " kg and " << other << " kg");
    for_each_method(setup, until, [&](const Simulation& run) {
      for (const int i : {1, 2}) EXPECT_NEAR(run.state().v(0, i), right.speed, 1e-8);
      EXPECT_NEAR(run.state().q(0, 2) - run.state().q(0, 1), 0.3, 1e-9);
      EXPECT_EQ(run.status(), "ok");
    });
  }
}

// Up to four blocks of different masses and lengths, which share out the force as they reach their limits one
// after the other; the order of the bodies is another one too.
TEST(BreakAway, OfARowThatIsPushed) {
  std::mt19937_64 random(5);
  const auto between = [&](double low, double high) { return test::uniform(random, low, high); };
  for (int scene = 0; scene < 12; ++scene) {
    const int blocks = 1 + scene % 4;
    const double rate = between(30.0, 60.0);
    double mass = 0.0;
    double x = 0.0;
    std::vector<Body> bodies{test::fixed("floor", Box{20.0, 0.1}, {0.0, -0.05})};
    for (int i = 0; i < blocks; ++i) {
      const double width = between(0.1, 0.4);
      Body next = block(fmt::format("block {}", i), x + 0.5 * width, between(1.0, 2.0));
      next.shape = Box{width, 0.02};
      next.position.y() = 0.01;
      mass += *next.mass;
      x += width;
      bodies.insert(scene % 3 == 0 ? bodies.begin() : bodies.end(), next);
    }
    const double until = kStatic * mass * kG / rate + between(0.05, 0.15);
    const Slid right = slid(mass, rate, until);
    RunSetup setup = pushed(bodies, "block 0", rate, 1.0, between(-3.0, 3.0), Vec2::Zero());
    // It goes on growing.
    setup.scene.forces.applied.front().force *= 10.0;
    setup.scene.forces.applied.front().rise *= 10.0;
    const auto fastest_off = [&](const Simulation& run) {
      double off = 0.0;
      for (int i = 0; i < run.state().size(); ++i) {
        if (run.mass().inverse_mass[i] > 0.0)
          off = std::max(off, std::abs(run.state().velocity(i).norm() - right.speed));
      }
      return off;
    };
    SCOPED_TRACE(testing::Message() << "scene " << scene << " of " << blocks << " blocks");
    for_each_method(setup, until, [&](const Simulation& run) {
      EXPECT_LE(fastest_off(run), 1e-5);
      EXPECT_EQ(run.status(), "ok");
    });
    for (const double h : {1.0 / 60.0, 0.005, 0.002}) {
      setup.method = {IntegratorId::kRk4, ImpactsId::kStepEnd, ContactsId::kLasting, h};
      Simulation run(setup);
      run.advance_to(until);
      EXPECT_LE(fastest_off(run), 2.0 * h * (kStatic - kKinetic) * kG) << "at the step's end, h = " << h;
      EXPECT_EQ(run.status(), "ok");
    }
  }
}

// Of a surface that rubs only while it sticks: the foot of a leaning block stays in its place, as it does with
// kinetic friction beside, until the block has turned so far that it slips.
TEST(BreakAway, AFootStandsOnStaticFrictionAlone) {
  const double width = 0.2;
  const double height = 0.4;
  const double leaning = 0.8;  // rad
  const auto foot_after = [&](double kinetic, double step) {
    const Vec2 foot(0.5 * width, -0.5 * height);
    Body body = test::disc("block", -turned_by(-leaning, foot), {0.0, 0.0}, 0.1, 1.0);
    body.shape = Box{width, height};
    body.angle = -leaning;
    RunSetup s = test::setup_with({test::fixed("floor", Wall{}, {0.0, 0.0}), body}, 0.0, kinetic);
    s.scene.materials.front().static_friction = 1.0;
    s.scene.forces.gravity = {0.0, -kG};
    s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, step};
    Simulation run(s);
    run.advance_to(0.1);
    return Vec2(run.state().q.col(1).head<2>() + turned_by(run.state().q(2, 1), foot));
  };
  for (const double kinetic : {0.0, 0.5}) {
    EXPECT_LT(foot_after(kinetic, 1.0 / 60.0).norm(), 1e-8) << kinetic;
    EXPECT_LT(foot_after(kinetic, 1.0 / 960.0).norm(), 1e-12) << kinetic;
  }
}

}  // namespace
}  // namespace carom
