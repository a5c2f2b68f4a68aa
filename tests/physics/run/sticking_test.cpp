#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/math/vectors.h"
#include "physics/model/mass.h"
#include "physics/run/run_setup.h"
#include "physics/run/run_state.h"
#include "physics/scene/validate.h"
#include "tests/support/draws.h"
#include "tests/support/impacts.h"
#include "tests/support/scenes.h"

// Bodies that stay joined from their first impact on.
namespace carom {
namespace {

using test::box;
using test::disc;
using test::Draws;
using test::setup_with;
using test::wall;

RunSetup clay(std::vector<Body> bodies) {
  RunSetup s = setup_with(std::move(bodies));
  s.scene.materials[0].sticks = true;
  return s;
}

Joint pin_to_plane(const std::string& body, const Vec2& point, const Vec2& anchor) {
  Joint l;
  l.kind = JointKind::kPin;
  l.body = body;
  l.point = point;
  l.anchor = anchor;
  return l;
}

// Position and angle of body a in the frame of body b.
Eigen::Vector3d place_of(const State& state, int a, int b) {
  const Vec2 d = turned_by(-state.q(2, b), state.position(a) - state.position(b));
  return {d.x(), d.y(), state.q(2, a) - state.q(2, b)};
}

// --- one impact

enum class Held { kFree, kByARod, kByAPin };

// A disc or a box each; the second one moves past the first one's centre.
RunSetup random_pair(Draws& draw, Held held) {
  const auto body = [&](const char* name, const Vec2& position, const Vec2& velocity) {
    const double size = draw.between(0.1, 0.5);
    const double mass = std::exp(draw.between(-3.0, 3.0));
    Body b = draw.between(0.0, 1.0) < 0.5
                 ? disc(name, position, velocity, size, mass)
                 : box(name, position, velocity, 2.0 * size, 2.0 * size * draw.between(0.3, 1.0), mass);
    b.angle = draw.between(-3.0, 3.0);
    b.spin = draw.between(-4.0, 4.0);
    return b;
  };
  const Vec2 towards = draw.direction();
  const Vec2 home(draw.between(-1.0, 1.0), draw.between(-1.0, 1.0));
  const Vec2 drift(draw.between(-0.3, 0.3), draw.between(-0.3, 0.3));
  RunSetup s = clay({body("a", home, drift)});
  s.scene.bodies.push_back(body("b", home - 1.6 * towards + draw.between(-0.05, 0.05) * crossed(towards),
                                drift + draw.between(1.0, 4.0) * towards));
  s.method.step = 0.05;
  if (held == Held::kFree) return s;
  Body& a = s.scene.bodies[0];
  if (held == Held::kByAPin) {
    // About the origin, the reference point of the angular momentum.
    s.scene.joints = {pin_to_plane("a", turned_by(-a.angle, -a.position), {0, 0})};
    a.velocity = a.spin * crossed(a.position);
    s.scene.bodies[1].velocity = draw.between(1.0, 4.0) * towards;
    a.spin *= 0.1;
    a.velocity *= 0.1;
    return s;
  }
  // A rod on the far side, from somewhere on the body to a disc, all moving as one.
  const Vec2 arm = 0.1 * towards;
  Body c = disc("c", a.position + 1.5 * towards, a.velocity, 0.1, std::exp(draw.between(-2.0, 2.0)));
  c.velocity += a.spin * crossed(Vec2(c.position - a.position));
  Joint rod;
  rod.body = "a";
  rod.point = turned_by(-a.angle, arm);
  rod.to = "c";
  s.scene.bodies.push_back(c);
  s.scene.joints = {rod};
  return s;
}

TEST(Sticking, KeepsTheLaws) {
  Draws draw(41);
  int met = 0;
  int jointed = 0;
  for (int i = 0; i < 10'000; ++i) {
    const Held held = i % 4 == 1 ? Held::kByARod : i % 4 == 3 ? Held::kByAPin : Held::kFree;
    const RunSetup s = random_pair(draw, held);
    Simulation run(s);
    run.watch_impacts(true);
    while (run.impact_count() == 0 && run.time() < 2.0) run.step();
    if (run.impact_count() == 0) continue;
    ++met;
    jointed += held != Held::kFree ? 1 : 0;
    const Totals before = run.totals_of(run.last_jumps()[0].before);
    const Totals after = run.totals_of(run.last_jumps()[0].after);
    const ImpactRecord& record = run.last_impacts()[0];
    const MassProperties& mass = run.mass();
    const double energy = before.energy();
    double sum = 0.0;
    for (int b = 0; b < run.state().size(); ++b) sum += mass.mass[b];
    const double size = std::sqrt(2.0 * energy * sum);
    if (held != Held::kByAPin) {
      ASSERT_LE((after.momentum - before.momentum).norm(), 1e-13 * size) << "case " << i;
    }
    ASSERT_NEAR(after.angular_momentum, before.angular_momentum, 1e-13 * 3.0 * size) << "case " << i;
    ASSERT_LE(after.energy(), energy * (1.0 + 1e-15)) << "case " << i;
    ASSERT_NEAR(energy - after.energy(), record.lost_to_sticking, 1e-13 * energy) << "case " << i;
    ASSERT_GT(record.lost_to_sticking, 0.0) << "case " << i;
    ASSERT_EQ(record.lost_to_restitution, 0.0);
    ASSERT_EQ(run.ledger().lost_to_sticking, record.lost_to_sticking);
    ASSERT_EQ(run.joints().size(), s.scene.joints.size() + 1);
    const double spin = run.state().v.col(record.a)[2];
    ASSERT_NEAR(spin, run.state().v.col(record.b)[2], 1e-13 * (1.0 + std::abs(spin))) << "case " << i;
  }
  EXPECT_GT(met, 8'000);
  EXPECT_GT(jointed, 3'500);
}

// Two free bodies: P = (m_a + m_b) v of the common centre, L about it = (I_a + I_b + μ d²) ω, and the impulse
// is that on body b.
TEST(Sticking, TwoBodiesTurnAsOne) {
  Draws draw(43);
  for (int i = 0; i < 300; ++i) {
    RunSetup s = random_pair(draw, Held::kFree);
    s.method.step = 0.001;  // up to its end the spin is constant within rounding
    Simulation run(s);
    while (run.impact_count() == 0 && run.time() < 2.0) run.step();
    if (run.impact_count() == 0) continue;
    const ImpactRecord& record = run.last_impacts()[0];
    const MassProperties& mass = run.mass();
    const Body& a = s.scene.bodies[0];
    const Body& b = s.scene.bodies[1];
    const Vec2 xa = a.position + record.time * a.velocity;
    const Vec2 xb = b.position + record.time * b.velocity;
    const double m = mass.mass[0] + mass.mass[1];
    const double reduced = mass.mass[0] * mass.mass[1] / m;
    const Vec2 d = xb - xa;
    const Vec2 u = b.velocity - a.velocity;
    const double inertia = mass.inertia[0] + mass.inertia[1] + reduced * d.squaredNorm();
    const double spin =
        (mass.inertia[0] * a.spin + mass.inertia[1] * b.spin + reduced * (d.x() * u.y() - d.y() * u.x())) /
        inertia;
    ASSERT_NEAR(run.state().v(2, 0), spin, 1e-11) << "case " << i;
    const Vec2 centre = (mass.mass[0] * a.velocity + mass.mass[1] * b.velocity) / m;
    const Vec2 after = centre + mass.mass[0] / m * spin * crossed(d);  // of b
    const Vec2 j = mass.mass[1] * (after - b.velocity);
    ASSERT_NEAR(record.normal_impulse, j.dot(record.normal), 1e-11 * (1.0 + j.norm())) << "case " << i;
    ASSERT_NEAR(record.tangential_impulse, j.dot(crossed(record.normal)), 1e-11 * (1.0 + j.norm()))
        << "case " << i;
    const double lost = 0.5 * reduced * u.squaredNorm() + 0.5 * mass.inertia[0] * a.spin * a.spin +
                        0.5 * mass.inertia[1] * b.spin * b.spin - 0.5 * inertia * spin * spin;
    ASSERT_NEAR(record.lost_to_sticking, lost, 1e-11 * (1.0 + lost)) << "case " << i;
  }
}

// --- what is joined

// A box on a spring, and a disc and a bar that fall onto it one after the other.
RunSetup lumps() {
  RunSetup s = clay({box("box", {0, 0}, {0.2, 0}, 0.4, 0.3, 1.0), disc("disc", {0.15, 0.8}, {0, -1}, 0.1, 0.5),
                     box("bar", {-0.9, 0.1}, {0.9, 0.1}, 0.5, 0.1, 0.3)});
  s.scene.bodies[0].spin = 1.0;
  s.scene.bodies[1].spin = 3.0;
  s.scene.bodies[2].angle = 0.4;
  Spring spring;
  spring.body = "box";
  spring.anchor = {0.1, 0.3};
  spring.stiffness = 8.0;
  spring.rest_length = 0.1;
  s.scene.forces.springs = {spring};
  s.scene.forces.quadratic_drag = 0.05;
  return s;
}

TEST(Sticking, JoinedBodiesKeepTheirPlace) {
  for (const IntegratorChoice& choice : kIntegrators) {
    if (choice.order == 0) continue;
    for (const auto& impacts : kImpacts) {
      RunSetup s = lumps();
      s.method = {choice.id, impacts.id, ContactsId::kImpulse, choice.order == 1 ? 0.001 : 0.01};
      Simulation run(s);
      while (run.impact_count() < 2 && run.time() < 3.0) run.step();
      ASSERT_EQ(run.joints().size(), 2U) << choice.name;
      const Eigen::Vector3d of_disc = place_of(run.state(), 1, 0);
      const Eigen::Vector3d of_bar = place_of(run.state(), 2, 0);
      double turned = 0.0;
      run.advance_to(run.time() + 10.0, [&] {
        turned = std::max(turned, std::abs(run.state().q(2, 0)));
        ASSERT_LT((place_of(run.state(), 1, 0) - of_disc).norm(), 2e-14) << choice.name << ' ' << run.time();
        ASSERT_LT((place_of(run.state(), 2, 0) - of_bar).norm(), 2e-14) << choice.name << ' ' << run.time();
        const double spin = run.state().v(2, 0);
        ASSERT_NEAR(run.state().v(2, 1), spin, 1e-14 * (1.0 + std::abs(spin))) << choice.name;
      });
      EXPECT_GT(turned, 1.0);
      EXPECT_EQ(run.impact_count(), 2) << choice.name;
      EXPECT_EQ(run.notices().text(), "ok") << choice.name;
      EXPECT_GT(run.ledger().lost_to_sticking, 0.1);
      if (choice.order < 4) continue;
      EXPECT_LT(std::abs(run.ledger().numerical_drift(run.totals().energy())), 1e-5) << choice.name;
      EXPECT_LT(run.ledger().momentum_drift(run.totals().momentum).norm(), 1e-5) << choice.name;
    }
  }
}

Eigen::Matrix3Xd end_of(IntegratorId id, double h) {
  RunSetup s = lumps();
  s.method.integrator = id;
  s.method.step = h;
  Simulation run(s);
  run.advance_to(2.0);
  EXPECT_EQ(run.joints().size(), 2U);
  return run.state().q;
}

// The impacts' times fall anywhere within a step, which scatters each error: many steps are fitted.
TEST(Sticking, KeepsTheOrderOfEveryIntegrator) {
  const Eigen::Matrix3Xd exact = end_of(IntegratorId::kDormandPrince, 1.0 / 2048);
  ASSERT_LT((end_of(IntegratorId::kDormandPrince, 1.0 / 1024) - exact).norm(), 1e-12);
  for (const IntegratorChoice& choice : kIntegrators) {
    if (choice.order == 0 || choice.adaptive) continue;
    const double coarsest = choice.order == 1 ? 300.0 : choice.order == 2 ? 60.0 : 24.0;
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    constexpr int kSteps = 24;
    for (int i = 0; i < kSteps; ++i) {
      const double h = 2.0 / std::round(2.0 * coarsest * std::exp2(i / 8.0));
      const double error = (end_of(choice.id, h) - exact).norm();
      const double x = std::log(h);
      const double y = std::log(error);
      sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    const double order = (kSteps * sxy - sx * sy) / (kSteps * sxx - sx * sx);
    RecordProperty(std::string(choice.name), std::to_string(order));
    EXPECT_NEAR(order, choice.order, 0.25) << choice.name;
  }
}

// The adaptive integrator's queue and trajectories continue across the joining.
TEST(Sticking, TheAdaptiveIntegratorFollowsItsTolerance) {
  const Eigen::Matrix3Xd exact = end_of(IntegratorId::kDormandPrince, 1.0 / 2048);
  for (const double tolerance : {1e-7, 1e-9, 1e-11}) {
    RunSetup s = lumps();
    s.method.integrator = IntegratorId::kAdaptiveDormandPrince;
    s.method.tolerance = tolerance;
    s.method.step = 0.13;
    Simulation run(s);
    run.advance_to(2.0);
    EXPECT_LT((run.state().q - exact).norm(), 300.0 * tolerance);
    // Steps are only the times at which the run is read.
    s.method.step = 0.5;
    Simulation other(s);
    other.advance_to(2.0);
    EXPECT_LT((run.state().q - other.state().q).norm(), 1e-12);
  }
}

// Balls of clay in a row, the first one moving: after k of them have collided all move at v/k.
TEST(Sticking, AChainGathersBallByBall) {
  for (const IntegratorChoice& choice : kIntegrators) {
    if (choice.order == 0) continue;
    for (const auto& impacts : kImpacts) {
      RunSetup s = clay({disc("d0", {0, 0}, {3.0, 0}, 0.1, 1.0)});
      for (int i = 1; i < 8; ++i)
        s.scene.bodies.push_back(disc(fmt::format("d{}", i), {0.3 * i, 0}, {0, 0}, 0.1, 1.0));
      // Two touch from the start, of which the second one feels nothing before the first is hit.
      s.scene.bodies[7].position.x() = s.scene.bodies[6].position.x() + 0.2;
      s.method = {choice.id, impacts.id, ContactsId::kImpulse, 0.005};
      Simulation run(s);
      for (int k = 2; k <= 8; ++k) {
        while (run.impact_count() < k - 1 && run.time() < 3.0) run.step();
        for (int i = 0; i < 8; ++i) {
          const bool in = i < run.impact_count() + 1;
          ASSERT_NEAR(run.state().velocity(i).x(),
                      in ? 3.0 / (static_cast<double>(run.impact_count()) + 1) : 0.0, 1e-13)
              << choice.name << ", " << impacts.name << ", ball " << i;
        }
      }
      EXPECT_EQ(run.impact_count(), 7) << choice.name << ", " << impacts.name;
      EXPECT_EQ(run.joints().size(), 7U);
      EXPECT_NEAR(run.ledger().lost_to_sticking, 0.5 * 9.0 * (1.0 - 1.0 / 8.0), 1e-12);
      EXPECT_LT(std::abs(run.ledger().numerical_drift(run.totals().energy())), 1e-12);
    }
  }
}

// A lump is hit as one body: an elastic impact on the line of centres turns the whole of it back.
TEST(Sticking, ALumpIsHitAsOneBody) {
  RunSetup s = clay({disc("a", {0, 0}, {1.0, 0}, 0.1, 1.0), disc("b", {0.5, 0}, {-1.0, 0}, 0.1, 1.0),
                     disc("c", {-1.0, 0}, {2.0, 0}, 0.1, 1.0)});
  s.scene.materials.push_back({"steel", 1.0});
  s.scene.bodies[2].material = "steel";
  s.scene.pairs = {{"steel", "default", {"", 1.0}}};
  s.method.step = 0.01;
  Simulation run(s);
  run.advance_to(1.0);
  ASSERT_EQ(run.impact_count(), 2);
  EXPECT_EQ(run.joints().size(), 1U);
  EXPECT_NEAR(run.state().velocity(2).x(), -2.0 / 3.0, 1e-14);
  EXPECT_NEAR(run.state().velocity(0).x(), 4.0 / 3.0, 1e-14);
  EXPECT_NEAR(run.state().velocity(1).x(), 4.0 / 3.0, 1e-14);
}

// Two materials stick if one of them does, unless their pair has its own rule.
TEST(Sticking, IsAMatterOfBothSurfaces) {
  RunSetup s = clay({});
  s.scene.materials.push_back({"steel", 1.0});
  EXPECT_TRUE(combined_material(s.scene, "steel", "default").sticks);
  EXPECT_TRUE(combined_material(s.scene, "default", "steel").sticks);
  EXPECT_FALSE(combined_material(s.scene, "steel", "steel").sticks);
  s.scene.pairs = {{"steel", "default", {}}};
  EXPECT_FALSE(combined_material(s.scene, "steel", "default").sticks);
}

// --- what does not move

TEST(Sticking, ABodyStaysOnAFixedOne) {
  for (const auto& impacts : kImpacts) {
    RunSetup s =
        clay({wall("floor", {0, -0.5}, 10.0, 1.0, 0.0), box("box", {0, 0.5}, {1.0, -1.0}, 0.4, 0.2, 2.0),
              disc("ball", {-0.35, 2.0}, {1.0, 0.0}, 0.1, 1.0)});
    s.scene.bodies[1].angle = 0.5;
    s.scene.bodies[1].spin = 2.0;
    s.scene.forces.gravity = {0.0, -9.81};
    s.method = {IntegratorId::kRk4, impacts.id, ContactsId::kImpulse, 0.002};
    Simulation run(s);
    const double energy = run.totals().energy();
    run.advance_to(1.0);
    ASSERT_EQ(run.joints().size(), 2U) << impacts.name;
    const Eigen::Matrix3Xd q = run.state().q;
    run.advance_to(10.0);
    EXPECT_EQ(run.joints().size(), 2U);
    EXPECT_LT((run.state().q - q).norm(), 1e-13) << impacts.name;
    EXPECT_LT(run.state().v.norm(), 1e-13);
    // Where impacts are not located, what has sunk in is moved out.
    EXPECT_NEAR(energy + run.ledger().penetration_correction - run.totals().energy(),
                run.ledger().lost_to_sticking, 1e-12)
        << impacts.name;
    EXPECT_LT(run.ledger().momentum_drift(run.totals().momentum).norm(), 1e-11) << impacts.name;
  }
}

// A ball that rests on clay from the start is joined at the end of a step. Runs whose trajectories continue
// across steps rebuild them then, and the ball that falls onto the first one hits it at its time.
TEST(Sticking, WhatLiesThereIsJoinedToo) {
  for (const IntegratorId id : {IntegratorId::kRk4, IntegratorId::kAdaptiveDormandPrince}) {
    RunSetup s = clay({wall("floor", {0, -0.5}, 10.0, 1.0), disc("low", {0, 0.1}, {0, 0}, 0.1, 1.0),
                       disc("high", {0, 1.3}, {0, 0}, 0.1, 1.0), disc("far", {2, 3.1}, {0, 0}, 0.1, 1.0)});
    s.scene.forces.gravity = {0.0, -9.81};
    s.method.integrator = id;
    s.method.step = 0.01;
    Simulation run(s);
    std::vector<double> times;
    run.advance_to(1.0, [&] {
      for (const ImpactRecord& impact : run.last_impacts()) times.push_back(impact.time);
    });
    ASSERT_EQ(times.size(), 3U) << run.notices().text();
    EXPECT_LE(times[0], 0.02);
    EXPECT_NEAR(times[1], std::sqrt(2.0 * 1.0 / 9.81), 1e-3);  // the low one has sunk by gh²/2
    EXPECT_NEAR(times[2], std::sqrt(2.0 * 3.0 / 9.81), 1e-9);
    EXPECT_EQ(run.joints().size(), 3U);
    EXPECT_LT(run.state().v.norm(), 1e-13);
    EXPECT_LT(std::abs(run.ledger().numerical_drift(run.totals().energy())), 1e-9);
  }
}

// However far a step leads past the moment of the impact: bodies are joined where they touch.
TEST(Sticking, JoinsBodiesThatTouch) {
  for (const auto& impacts : kImpacts) {
    for (const ContactsId contacts : {ContactsId::kImpulse, ContactsId::kLasting}) {
      for (const double h : {1.0 / 60, 0.005, 0.001}) {
        // Two falling on what is fixed, and two lumps that meet in the air: a pair of balls and a ball.
        RunSetup s = clay(
            {wall("floor", {0, -0.5}, 10.0, 1.0, 0.0), disc("low", {0, 0.7}, {0, 0}, 0.1, 1.0),
             box("box", {1.0, 1.0}, {0, 0}, 0.2, 0.2, 1.0), disc("left", {-3.0, 9.0}, {2.3, 0}, 0.1, 1.0),
             disc("middle", {-2.5, 9.0}, {1.1, 0}, 0.1, 1.0), disc("right", {-1.7, 9.0}, {-0.7, 0}, 0.1, 2.0)});
        s.scene.bodies[2].angle = 0.3;
        s.scene.forces.gravity = {0.0, -9.81};
        s.method = {IntegratorId::kRk4, impacts.id, contacts, h};
        Simulation run(s);
        run.advance_to(0.8);
        const std::string of = fmt::format("{} {} {}", impacts.name, contacts == ContactsId::kLasting, h);
        ASSERT_EQ(run.joints().size(), 4U) << of;
        EXPECT_NEAR(run.state().position(1).y(), 0.1, 1e-12) << of;
        const double angle = run.state().q(2, 2);
        EXPECT_NEAR(run.state().position(2).y(), 0.1 * (std::cos(angle) + std::sin(angle)), 1e-12) << of;
        for (const auto& [a, b] : {std::pair(3, 4), std::pair(4, 5)})
          EXPECT_NEAR((run.state().position(a) - run.state().position(b)).norm(), 0.2, 1e-12) << of;
        // The lumps' common centre goes on as it did.
        const Vec2 centre =
            0.25 * (run.state().position(3) + run.state().position(4) + 2.0 * run.state().position(5));
        EXPECT_LT((centre - Vec2(-2.225 + 0.5 * 0.8, 9.0 - 0.5 * 9.81 * 0.64)).norm(), 1e-12) << of;
        EXPECT_LT(std::abs(run.ledger().numerical_drift(run.totals().energy())), 1e-9) << of;
      }
    }
  }
}

// What is put on a slope of clay stays there, also where it touches only to rounding, or falls a micrometre.
TEST(Sticking, WhatIsPutOnASlopeStays) {
  constexpr double kSlope = 0.5;
  const Vec2 up = turned_by(kSlope, Vec2::UnitY());
  for (const auto& impacts : kImpacts) {
    for (const ContactsId contacts : {ContactsId::kImpulse, ContactsId::kLasting}) {
      for (const double gap : {0.0, 1e-6}) {
        for (const bool round : {true, false}) {
          Body slope = wall("slope", -0.5 * up, 10.0, 1.0);
          slope.angle = kSlope;
          Body body = round ? disc("body", (0.1 + gap) * up, {0, 0}, 0.1, 1.0)
                            : box("body", (0.1 + gap) * up, {0, 0}, 0.3, 0.2);
          body.angle = kSlope;
          RunSetup s = clay({slope, body});
          s.scene.forces.gravity = {0.0, -9.81};
          s.method = {IntegratorId::kRk4, impacts.id, contacts, 0.005};
          Simulation run(s);
          run.advance_to(1.0);
          const std::string of =
              fmt::format("{} {} {} {}", impacts.name, contacts == ContactsId::kLasting, gap, round);
          EXPECT_EQ(run.joints().size(), 1U) << of;
          EXPECT_LT((run.state().position(1) - 0.1 * up).norm(), 2e-4) << of;
          EXPECT_LT(run.state().v.cwiseAbs().maxCoeff(), 1e-12) << of;
        }
      }
    }
  }
}

TEST(Sticking, ABodyGoesWithADrivenOne) {
  for (const auto& impacts : kImpacts) {
    RunSetup s = clay({wall("table", {0, -0.5}, 4.0, 1.0), disc("ball", {0.3, 0.6}, {0.4, 0}, 0.1, 0.7)});
    s.scene.bodies[0].fixed = false;
    s.scene.bodies[0].drive = Drive{{0.1, 0.0}, {0.0, 0.05}, 9.0, 0.4};
    s.scene.forces.gravity = {0.0, -9.81};
    s.method = {IntegratorId::kRk4, impacts.id, ContactsId::kImpulse, 1.0 / 1024};
    Simulation run(s);
    run.advance_to(1.0);
    ASSERT_EQ(run.joints().size(), 1U);
    const Vec2 place = run.state().position(1) - run.state().position(0);
    run.advance_to(5.0, [&] {
      ASSERT_LT((run.state().position(1) - run.state().position(0) - place).norm(), 2e-15) << run.time();
      ASSERT_LT((run.state().velocity(1) - run.state().velocity(0)).norm(), 2e-15) << run.time();
    });
    EXPECT_GT(std::abs(run.ledger().put_in_by_drives), 0.01);
    EXPECT_LT(std::abs(run.ledger().numerical_drift(run.totals().energy())), 1e-8) << impacts.name;
    EXPECT_LT(run.ledger().momentum_drift(run.totals().momentum).norm(), 1e-8) << impacts.name;
  }
}

// A point that sticks off the centre of a box turns with it; its own angle has no effect.
TEST(Sticking, APointGoesRoundWithWhatItHit) {
  RunSetup s =
      clay({box("box", {0, 0}, {0, 0}, 1.0, 0.2, 1.0), disc("point", {0.4, 1.0}, {0, -2.0}, 0.0, 0.5)});
  s.method.step = 0.002;
  Simulation run(s);
  run.advance_to(3.0);
  ASSERT_EQ(run.joints().size(), 1U);
  const double reduced = 1.0 * 0.5 / 1.5;
  const double spin = -reduced * 0.4 * 2.0 / ((1.0 + 0.04) / 12.0 + reduced * (0.16 + 0.01));
  EXPECT_NEAR(run.state().v(2, 0), spin, 1e-12);
  EXPECT_LT((place_of(run.state(), 1, 0).head<2>() - Vec2(0.4, 0.1)).norm(), 1e-14);
}

// --- runs

TEST(Sticking, CopiesGoTheirOwnWaysAndARestartIsUnjoined) {
  for (const IntegratorId id : {IntegratorId::kRk4, IntegratorId::kAdaptiveDormandPrince}) {
    RunSetup s = lumps();
    s.method.integrator = id;
    s.method.step = 0.01;
    Simulation run(s);
    ASSERT_TRUE(test::step_to_impact(run, 1));
    Simulation copy = run;
    run.advance_to(2.0);
    EXPECT_EQ(copy.joints().size(), 1U);
    EXPECT_EQ(run.joints().size(), 2U);
    copy.advance_to(2.0);
    EXPECT_TRUE(test::same_bytes(run.state(), copy.state()));
    Simulation again(s);
    EXPECT_TRUE(again.joints().empty());
    again.advance_to(2.0);
    EXPECT_TRUE(test::same_bytes(run.state(), again.state()));
  }
}

// Welds are the run's own state: its model stays, and a run that is restored from its state has them too.
TEST(Sticking, TheModelStays) {
  RunSetup s = lumps();
  s.method.step = 0.01;
  Simulation run(s);
  const auto compiled = run.compiled();
  ASSERT_TRUE(test::step_to_impact(run, 1));
  EXPECT_EQ(run.compiled(), compiled);
  const ImpactRecord& impact = run.last_impacts().back();
  EXPECT_TRUE(run.welded().are_one(impact.a, impact.b));
  EXPECT_TRUE(compiled->model.shapes.can_collide(impact.a, impact.b));
  const Simulation restored(compiled, run.run_state());
  EXPECT_TRUE(restored.welded().are_one(impact.a, impact.b));
  EXPECT_EQ(restored.joints().size(), run.joints().size());
}

// Bodies added later, or another method, leave the joined bodies joined.
TEST(Sticking, OutlastsEdits) {
  RunSetup s = lumps();
  s.method.step = 0.01;
  Simulation run(s);
  ASSERT_TRUE(test::step_to_impact(run, 2));
  const Eigen::Vector3d place = place_of(run.state(), 1, 0);
  run.apply({Add<Body>{disc("late", {0.0, 1.5}, {0, -3.0}, 0.1, 0.2)}});
  run.set_method({IntegratorId::kAdaptiveDormandPrince, ImpactsId::kLocated, ContactsId::kImpulse, 0.02});
  run.advance_to(run.time() + 2.0);
  EXPECT_EQ(run.joints().size(), 3U);
  EXPECT_LT((place_of(run.state(), 1, 0) - place).norm(), 1e-14);
  EXPECT_LT(std::abs(run.ledger().numerical_drift(run.totals().energy())), 1e-7);
}

// All bodies advanced together, with every part of the model: the same motion.
TEST(Sticking, TrimmedAndUntrimmedRunsAgree) {
  RunSetup s = lumps();
  s.scene.bodies.push_back(disc("alone", {3.0, 3.0}, {0.1, 0.0}));
  s.method.step = 1.0 / 512;
  Simulation trimmed(s);
  Simulation whole(s, all_needs());
  trimmed.advance_to(2.0);
  whole.advance_to(2.0);
  EXPECT_EQ(whole.joints().size(), 2U);
  EXPECT_LT((trimmed.state().q - whole.state().q).norm(), 1e-9);
}

}  // namespace
}  // namespace carom
