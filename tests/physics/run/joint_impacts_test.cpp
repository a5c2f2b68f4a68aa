#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/run/run_setup.h"
#include "tests/support/scenes.h"

// Impacts of joined bodies, and strings.
namespace carom {
namespace {

using test::disc;
using test::joint_between;
using test::setup_with;

constexpr double kGravity = 9.81;

Joint joint(JointKind kind, const std::string& body, const Vec2& anchor) {
  Joint l;
  l.kind = kind;
  l.body = body;
  l.anchor = anchor;
  return l;
}

void expect_closed_ledger(const Simulation& run, double energy, double momentum) {
  EXPECT_LT(std::abs(run.ledger().numerical_drift(run.totals().energy())), energy);
  EXPECT_LT(run.ledger().momentum_drift(run.totals().momentum).norm(), momentum);
}

// A bob on a rod at the angle α from the normal responds along the normal with the mass m/sin²α.
TEST(JointImpacts, DiscHitsABob) {
  for (const auto& impacts : kImpacts) {
    for (const double alpha : {0.5 * std::numbers::pi, 1.2, 0.4}) {
      const double e = 0.7;
      const double m_a = 0.8;
      const double m_b = 1.3;
      RunSetup s =
          setup_with({disc("a", {-0.2001, 0}, {1.0, 0}, 0.1, m_a), disc("b", {0, 0}, {0, 0}, 0.1, m_b)}, e);
      s.scene.joints = {joint(JointKind::kRod, "b", {std::cos(alpha), std::sin(alpha)})};
      s.method = {IntegratorId::kRk4, impacts.id, ContactsId::kImpulse, 0.001};
      Simulation run(s);
      run.step();
      ASSERT_EQ(run.impact_count(), 1) << alpha;
      const double sine = std::sin(alpha);
      const double k = 1.0 / m_a + sine * sine / m_b;
      const double j = (1.0 + e) / k;
      EXPECT_NEAR(run.last_impacts()[0].normal_impulse, j, 1e-13);
      EXPECT_NEAR(run.state().velocity(0).x(), 1.0 - j / m_a, 1e-13);
      const double along = j * sine / m_b;  // perpendicular to the rod
      EXPECT_NEAR(run.state().velocity(1).norm(), along, 1e-8);
      EXPECT_NEAR(run.ledger().lost_to_restitution, 0.5 * (1.0 - e * e) / k, 1e-13);
      expect_closed_ledger(run, 1e-12, 1e-12);
      EXPECT_GT(run.ledger().momentum_from_forces.norm(), alpha > 1.5 ? -1.0 : 0.1);
    }
  }
}

// A disc hits the end of a dumbbell along its rod: the two discs respond as one body.
TEST(JointImpacts, DumbbellAnswersAsOne) {
  RunSetup s = setup_with({disc("a", {-0.25, 0}, {2.0, 0}, 0.1, 1.0), disc("b", {0, 0}, {0, 0}, 0.1, 2.0),
                           disc("c", {1, 0}, {0, 0}, 0.1, 3.0)});
  s.scene.joints = {joint_between(JointKind::kRod, "b", "c")};
  s.method.step = 0.1;
  Simulation run(s);
  run.advance_to(0.1);
  ASSERT_EQ(run.impact_count(), 1);
  EXPECT_NEAR(run.state().velocity(0).x(), 2.0 * (1.0 - 5.0) / 6.0, 1e-14);
  EXPECT_NEAR(run.state().velocity(1).x(), 4.0 / 6.0, 1e-14);
  EXPECT_NEAR(run.state().velocity(2).x(), 4.0 / 6.0, 1e-14);
  expect_closed_ledger(run, 1e-14, 1e-14);
}

// k balls in, k balls out, with pairwise impacts.
TEST(JointImpacts, HungCradle) {
  for (const IntegratorId id : {IntegratorId::kRk4, IntegratorId::kAdaptiveDormandPrince}) {
    for (int k = 1; k <= 4; ++k) {
      RunSetup s = setup_with({});
      s.scene.forces.gravity = {0.0, -kGravity};
      const double angle = 0.5;
      for (int i = 0; i < 5; ++i) {
        const Vec2 top(0.2 * i, 1.0);
        const double aside = i < k ? angle : 0.0;
        s.scene.bodies.push_back(
            disc("d" + std::to_string(i), top - Vec2(std::sin(aside), std::cos(aside)), {0, 0}, 0.1, 0.7));
        s.scene.joints.push_back(joint(JointKind::kRod, "d" + std::to_string(i), top));
      }
      s.method.integrator = id;
      s.method.step = 0.001;
      s.method.tolerance = 1e-12;
      Simulation run(s);
      run.advance_to(1.0);
      ASSERT_GE(run.impact_count(), k * (5 - k)) << k;
      const double energy = k * 0.7 * kGravity * (1.0 - std::cos(angle));
      for (int i = 0; i < 5; ++i) {
        const Vec2 v = run.state().velocity(i);
        const double height = run.state().position(i).y();
        const double own = 0.5 * 0.7 * v.squaredNorm() + 0.7 * kGravity * height;
        const double expected = i >= 5 - k ? energy / k : 0.0;
        EXPECT_NEAR(own, expected, 1e-9) << "k = " << k << ", ball " << i;
        if (i < 5 - k) {
          EXPECT_LT(v.norm(), 1e-4) << "k = " << k << ", ball " << i;
        }
      }
      expect_closed_ledger(run, 1e-9, 1e-6);
    }
  }
}

// Chains fly and hit each other: they gain no energy or momentum, with restitution and friction, under either
// method of impacts. Without gravity the only drift is the integrator's.
TEST(JointImpacts, RandomChainsKeepTheLaws) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    std::mt19937_64 random(seed);
    const auto between_numbers = [&](double low, double high) {
      return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
    };
    const double friction = seed % 2 == 0 ? 0.4 : 0.0;
    RunSetup s = setup_with({}, seed % 3 == 0 ? 1.0 : 0.6, friction);
    for (int c = 0; c < 2; ++c) {
      const Vec2 drift(c == 0 ? 1.0 : -1.0, 0.0);
      for (int i = 0; i < 3; ++i) {
        const std::string name = fmt::format("c{}-{}", c, i);
        s.scene.bodies.push_back(disc(name,
                                      Vec2(c == 0 ? -0.4 : 0.4, 0.5 * i - 0.5 + between_numbers(-0.1, 0.1)),
                                      drift, between_numbers(0.1, 0.2), between_numbers(0.2, 2.0)));
        if (i == 0) continue;
        s.scene.joints.push_back(joint_between(seed % 5 == 0 ? JointKind::kString : JointKind::kRod, name,
                                               fmt::format("c{}-{}", c, i - 1)));
        s.scene.joints.back().point = {between_numbers(-0.1, 0.1), between_numbers(-0.1, 0.1)};
      }
    }
    s.method = {IntegratorId::kDormandPrince, ImpactsId::kLocated, ContactsId::kImpulse, 1.0 / 512};
    Simulation run(s);
    run.advance_to(1.0);
    EXPECT_GT(run.impact_count(), 0) << "seed " << seed;
    EXPECT_LT(std::abs(run.ledger().numerical_drift(run.totals().energy())), 1e-8) << "seed " << seed;
    EXPECT_LT(run.ledger().momentum_drift(run.totals().momentum).norm(), 1e-9) << "seed " << seed;
    EXPECT_GE(run.ledger().lost_to_restitution, -1e-14) << "seed " << seed;
    EXPECT_GE(run.ledger().lost_to_joints, 0.0) << "seed " << seed;
  }
}

// Pinned discs always penetrate and don't collide.
TEST(JointImpacts, PinnedBodiesDontCollide) {
  for (const auto& impacts : kImpacts) {
    RunSetup s = setup_with({disc("a", {0, 0}, {0, 0}, 0.3), disc("b", {0.3, 0}, {0, 0}, 0.3)});
    s.scene.bodies[1].spin = 2.0;
    s.scene.joints = {joint_between(JointKind::kPin, "b", "a")};
    s.scene.joints[0].anchor = {0.3, 0.0};
    s.method.impacts = impacts.id;
    Simulation run(s);
    run.advance_to(1.0);
    EXPECT_EQ(run.impact_count(), 0);
    EXPECT_NEAR((run.state().position(0) - run.state().position(1)).norm(), 0.3, 1e-14);
  }
}

// A joined body that is pushed out of a penetration stays on its joints, and the ledger has the energy of
// that.
TEST(JointImpacts, PenetrationsPartAlongTheJoints) {
  RunSetup s = setup_with({disc("a", {0, 0}, {0, 0}, 0.2), disc("b", {0.3, -0.1}, {0, 0}, 0.2)}, 0.5);
  s.scene.forces.gravity = {0.0, -kGravity};
  s.scene.joints = {joint(JointKind::kRod, "a", {0, 1})};
  s.method = {IntegratorId::kRk4, ImpactsId::kStepEnd, ContactsId::kImpulse, 1e-4};
  Simulation run(s);
  for (int i = 0; i < 300; ++i) {
    run.step();
    ASSERT_NEAR((run.state().position(0) - Vec2(0, 1)).norm(), 1.0, 1e-14);
  }
  EXPECT_GT((run.state().position(0) - run.state().position(1)).norm(), 0.399);
  expect_closed_ledger(run, 1e-9, 1e-3);
}

// --- strings

// A ball falls beside its string's anchor until the string is taut: its velocity along the string is lost.
TEST(Strings, TautImpulseIsLocatedAndRecorded) {
  const double m = 0.6;
  const double x = 0.5;
  const double length = 1.3;
  const double y = -std::sqrt(length * length - x * x);
  const double time = std::sqrt(-2.0 * y / kGravity);
  const double speed = kGravity * time;
  const double radial = speed * -y / length;
  for (const IntegratorChoice& choice : kIntegrators) {
    if (choice.order < 2) continue;
    for (const auto& impacts : kImpacts) {
      RunSetup s = setup_with({disc("d", {x, 0}, {0, 0}, 0.1, m)});
      s.scene.forces.gravity = {0.0, -kGravity};
      s.scene.joints = {joint(JointKind::kString, "d", {0, 0})};
      s.scene.joints[0].length = length;
      s.method = {choice.id, impacts.id, ContactsId::kImpulse, 0.01};
      Simulation run(s);
      run.advance_to(0.45);
      EXPECT_EQ(run.ledger().lost_to_joints, 0.0) << choice.name;
      EXPECT_NEAR(run.state().position(0).y(), -0.5 * kGravity * 0.45 * 0.45, 1e-13);
      run.advance_to(0.7);
      EXPECT_NEAR(run.ledger().lost_to_joints, 0.5 * m * radial * radial, 1e-12) << choice.name;
      EXPECT_NEAR(run.state().position(0).norm(), length, 1e-14) << choice.name;
      // The ledger also has the momentum of the anchor's taut impulse.
      expect_closed_ledger(run, choice.order > 2 ? 1e-7 : 1e-3, choice.order > 2 ? 1e-6 : 1e-2);
    }
  }
}

// A ball on a string, pushed at its lowest point to v² between 2gL and 5gL, leaves its circle where
// sin φ = (v² - 2gL)/(3gL) above the horizontal: there its speed is √(gL sin φ), and a parabola follows.
TEST(Strings, GoesSlackWhereTheTensionEnds) {
  const double length = 0.8;
  const double v = std::sqrt(3.5 * kGravity * length);
  const double sine = 1.5 / 3.0;
  const double across = -std::sqrt(kGravity * length * sine) * sine;  // m/s, on the parabola
  for (const IntegratorChoice& choice : kIntegrators) {
    if (choice.order < 4) continue;
    std::vector<double> errors;
    for (const double h : {0.002, 0.0005}) {
      RunSetup s = setup_with({disc("d", {0, -length}, {v, 0}, 0.1, 0.4)});
      s.scene.forces.gravity = {0.0, -kGravity};
      s.scene.joints = {joint(JointKind::kString, "d", {0, 0})};
      s.method.integrator = choice.id;
      s.method.step = h;
      Simulation run(s);
      run.advance_to(0.75);
      EXPECT_LT(run.state().position(0).norm(), length - 1e-4) << choice.name;
      EXPECT_EQ(run.ledger().lost_to_joints, 0.0);
      errors.push_back(std::abs(run.state().velocity(0).x() - across));
      run.advance_to(2.0);
      EXPECT_GT(run.ledger().lost_to_joints, 0.01);  // a second taut impulse
      EXPECT_LT(run.state().position(0).norm(), length + 1e-14);
    }
    EXPECT_LT(errors[0], 1e-4) << choice.name;
    if (!choice.adaptive) {
      EXPECT_GT(errors[0] / errors[1], 100.0) << choice.name;
    }
  }
}

// Two bodies thrown apart on a string continue together along it: ½ μ u² is lost, momentum stays.
TEST(Strings, JoinTwoBodies) {
  for (const auto& impacts : kImpacts) {
    RunSetup s = setup_with({disc("a", {0, 0}, {-1.0, 0}, 0.1, 1.0), disc("b", {1, 0}, {2.0, 0}, 0.1, 2.0)});
    s.scene.joints = {joint_between(JointKind::kString, "a", "b")};
    s.scene.joints[0].length = 2.0;
    s.method.impacts = impacts.id;
    s.method.step = 0.01;
    Simulation run(s);
    run.advance_to(1.0);
    EXPECT_NEAR(run.state().velocity(0).x(), 1.0, 1e-13);
    EXPECT_NEAR(run.state().velocity(1).x(), 1.0, 1e-13);
    EXPECT_NEAR(run.ledger().lost_to_joints, 0.5 * (2.0 / 3.0) * 9.0, 1e-13);
    EXPECT_NEAR(run.state().position(0).x(), -1.0 / 3.0 + 2.0 / 3.0, 1e-12);
    expect_closed_ledger(run, 1e-12, 1e-13);
  }
}

// Hit from below, a hanging ball flies up as if it were free; hit from above, its string supports it.
TEST(Strings, OnlyPullInAnImpact) {
  for (const double side : {-1.0, 1.0}) {
    RunSetup s = setup_with(
        {disc("hung", {0, 0}, {0, 0}, 0.1, 1.0), disc("d", {0, 0.3 * side}, {0, -2.0 * side}, 0.1, 1.0)});
    s.scene.joints = {joint(JointKind::kString, "hung", {0, 1.0})};
    s.method.step = 0.01;
    Simulation run(s);
    run.advance_to(0.1);
    ASSERT_EQ(run.impact_count(), 1);
    EXPECT_NEAR(run.state().velocity(0).y(), side < 0.0 ? 2.0 : 0.0, 1e-14);
    EXPECT_NEAR(run.state().velocity(1).y(), side < 0.0 ? 0.0 : 2.0, 1e-14);
    expect_closed_ledger(run, 1e-14, 1e-14);
  }
}

// A ball that hangs at rest stays there, and its string stays taut.
TEST(Strings, HoldWhatHangs) {
  RunSetup s = setup_with({disc("d", {0.3, -0.4}, {0, 0}, 0.1, 2.0), disc("e", {0.3, -0.9}, {0, 0}, 0.1, 1.0)});
  s.scene.forces.gravity = {0.0, -kGravity};
  s.scene.joints = {joint(JointKind::kString, "d", {0.3, 0.0}), joint_between(JointKind::kString, "e", "d")};
  s.method.step = 0.01;
  Simulation run(s);
  run.advance_to(10.0);
  EXPECT_LT((run.state().position(0) - Vec2(0.3, -0.4)).norm(), 1e-14);
  EXPECT_LT((run.state().position(1) - Vec2(0.3, -0.9)).norm(), 1e-14);
  EXPECT_EQ(run.ledger().lost_to_joints, 0.0);
}

}  // namespace
}  // namespace carom
