#include "physics/record/impact_theory.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "physics/record/jump_moment.h"
#include "physics/run/simulation.h"
#include "tests/support/body_literal.h"
#include "tests/support/scenes.h"

// What closed laws say about impacts, against textbook figures and against runs.
namespace carom {
namespace {

using namespace test::literals;

using test::disc;
using test::scene_with;
using test::wall;

constexpr double kRounding = 1e-12;

// The first moment with impacts of a run of this scene.
std::shared_ptr<const JumpMoment> first_moment(Scene scene) {
  RunSetup setup;
  setup.scene = std::move(scene);
  setup.method.step = 0.01;
  constexpr double kEnd = 10.0;  // s
  return first_jump_moment(setup, kEnd, [] { return true; });
}

void expect_theory(const Scene& scene) {
  const auto moment = first_moment(scene);
  ASSERT_NE(moment, nullptr);
  const ImpactTheory theory = theory_of(*moment);
  ASSERT_EQ(theory.why_not, NoTheory::kNone);
  EXPECT_GT((moment->after().v - moment->before().v).norm(), 0.1) << "there is something to tell";
  EXPECT_LT((theory.v - moment->after().v).norm(), kRounding * moment->before().v.norm());
}

NoTheory why_not(const Scene& scene) {
  const auto moment = first_moment(scene);
  return moment == nullptr ? NoTheory::kNone : theory_of(*moment).why_not;
}

// A square that turns, dropped on a corner beside its centre.
Scene turned_square(double friction, double slip, double spin = 0.0) {
  Body square = disc("square", {0.0, 0.3}, {slip, -2.0});
  square.shape = Box{0.2, 0.2};
  square.angle = 0.3;
  square.spin = spin;
  return scene_with({square, wall("floor", {0.0, -0.5}, 8.0, 1.0)}, 0.6, friction);
}

// v' = (m_1 v_1 + m_2 v_2 ± e m (v_2 - v_1)) / (m_1 + m_2).
TEST(ImpactTheory, HeadOnWithUnequalMasses) {
  const auto moment = first_moment(scene_with(
      {disc("light", {-0.6, 0.0}, {2.0, 0.0}), disc("heavy", {0.6, 0.0}, {-1.0, 0.0}, 0.1, 2.5)}, 0.6));
  ASSERT_NE(moment, nullptr);
  EXPECT_EQ(moment->bodies(), (std::vector<BodyIndex>{0_b, 1_b}));
  EXPECT_NEAR(moment->time(), 1.0 / 3.0, 1e-9);
  const ImpactTheory theory = theory_of(*moment);
  ASSERT_EQ(theory.why_not, NoTheory::kNone);
  const double p = 2.0 - 2.5;
  for (const Eigen::Matrix3Xd& v : {theory.v, moment->after().v}) {
    EXPECT_NEAR(v(0, 0), (p - 0.6 * 2.5 * 3.0) / 3.5, kRounding);
    EXPECT_NEAR(v(0, 1), (p + 0.6 * 1.0 * 3.0) / 3.5, kRounding);
    EXPECT_EQ(v(1, 0), 0.0);
  }
}

// Of a disc on a floor slip ends if μ (1 + e) |u_n| is more than a third of it: K_tt = 3/m.
TEST(ImpactTheory, AGlancingDiscWithFriction) {
  for (const double slip : {0.5, 6.0}) {
    const Scene scene =
        scene_with({disc("ball", {0.0, 0.3}, {slip, -2.0}), wall("floor", {0.0, -0.5}, 20.0, 1.0)}, 0.5, 0.3);
    expect_theory(scene);
    const auto moment = first_moment(scene);
    const double j_t = -std::min(slip / 3.0, 0.3 * 1.5 * 2.0);
    const Eigen::Matrix3Xd v = theory_of(*moment).v;
    EXPECT_NEAR(v(0, 0), slip + j_t, kRounding);
    EXPECT_NEAR(v(1, 0), 0.5 * 2.0, kRounding);
    EXPECT_NEAR(v(2, 0), j_t * 0.1 / (0.5 * 0.1 * 0.1), 10.0 * kRounding);
  }
}

TEST(ImpactTheory, TwoDiscsOffCentreWithFriction) {
  Body spinning = disc("a", {-0.5, 0.05}, {3.0, 0.0}, 0.1, 1.0);
  spinning.spin = 12.0;
  expect_theory(scene_with({spinning, disc("b", {0.3, -0.06}, {-1.0, 0.2}, 0.15, 2.0)}, 0.7, 0.2));
}

TEST(ImpactTheory, ASuperballTurnsItsSlipBack) {
  Scene scene =
      scene_with({disc("ball", {0.0, 0.3}, {1.0, -2.0}), wall("floor", {0.0, -0.5}, 8.0, 1.0)}, 1.0, 2.0);
  scene.materials.front().tangential_restitution = 0.8;
  expect_theory(scene);
}

TEST(ImpactTheory, ASquareOnACorner) {
  expect_theory(turned_square(0.0, 1.0));
  expect_theory(turned_square(0.1, 6.0, -3.0));
  EXPECT_EQ(why_not(turned_square(0.5, 0.5)), NoTheory::kSlipStops);
  Scene newton = turned_square(0.9, 0.5);
  newton.impact_law = ImpactLawId::kNewton;
  expect_theory(newton);
}

// A disc between two that touch neither each other: v' of the hitting one is -0.2 v at e = 1.
TEST(ImpactTheory, SeveralAtOnce) {
  const double x = 0.2 * std::sqrt(3.0) / 2.0;
  for (const double e : {1.0, 0.5}) {
    const Scene scene = scene_with({disc("hits", {-1.0, 0.0}, {1.0, 0.0}), disc("upper", {x, 0.1}, {0.0, 0.0}),
                                    disc("lower", {x, -0.1}, {0.0, 0.0})},
                                   e);
    expect_theory(scene);
    EXPECT_EQ(first_moment(scene)->records.size(), 2U);
    EXPECT_NEAR(theory_of(*first_moment(scene)).v(0, 0), 1.0 - (1.0 + e) * 0.6, 1e-9);
  }
}

// Pair by pair, the last of a row of balls takes all of the velocity.
TEST(ImpactTheory, ARowOfBalls) {
  std::vector<Body> balls{disc("0", {-1.0, 0.0}, {1.0, 0.0})};
  for (int i = 1; i < 4; ++i) balls.push_back(disc(std::to_string(i), {0.2 * i, 0.0}, {0.0, 0.0}));
  const auto moment = first_moment(scene_with(balls));
  ASSERT_NE(moment, nullptr);
  EXPECT_EQ(moment->bodies().size(), 4U);
  const ImpactTheory theory = theory_of(*moment);
  ASSERT_EQ(theory.why_not, NoTheory::kNone);
  EXPECT_NEAR(theory.v(0, 3), 1.0, kRounding);
  EXPECT_LT((theory.v - moment->after().v).norm(), kRounding);
}

TEST(ImpactTheory, BodiesThatStick) {
  Scene scene =
      scene_with({disc("a", {-0.5, 0.06}, {2.0, 0.0}), disc("b", {0.5, -0.06}, {-1.0, 0.3}, 0.15, 2.0)});
  scene.materials.front().sticks = true;
  expect_theory(scene);
}

TEST(ImpactTheory, SaysWhyThereIsNone) {
  Scene jointed = scene_with({disc("a", {-0.5, 0.0}, {2.0, 0.0}), disc("b", {0.5, 0.0}, {0.0, 0.0}),
                              disc("c", {0.5, 0.6}, {0.0, 0.0})});
  Joint rod;
  rod.body = "b";
  rod.to = "c";
  jointed.joints.push_back(rod);
  EXPECT_EQ(why_not(jointed), NoTheory::kJoints);
  const double x = 0.2 * std::sqrt(3.0) / 2.0;
  EXPECT_EQ(why_not(scene_with({disc("hits", {-1.0, 0.0}, {1.0, 0.0}), disc("upper", {x, 0.1}, {0.0, 0.0}),
                                disc("lower", {x, -0.1}, {0.0, 0.0})},
                               1.0, 0.2)),
            NoTheory::kFrictionAtOnce);
}

}  // namespace
}  // namespace carom
