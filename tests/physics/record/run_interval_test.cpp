#include "physics/record/run_interval.h"

#include <gtest/gtest.h>

#include "physics/record/interval_theory.h"
#include "tests/support/scenes.h"

// A run at two moments, and what closed laws say about the time between.
namespace carom {
namespace {

using test::disc;
using test::scene_with;
using test::wall;

constexpr double kRounding = 1e-12;
const auto kAlways = [] { return true; };

RunSetup setup_of(Scene scene, Vec2 gravity = Vec2::Zero()) {
  RunSetup setup;
  setup.scene = std::move(scene);
  setup.scene.forces.gravity = gravity;
  setup.method.step = 0.01;
  return setup;
}

// They meet at a third of a second.
Scene head_on(double e = 0.6) {
  return scene_with({disc("light", {-0.6, 0.0}, {2.0, 0.0}), disc("heavy", {0.6, 0.0}, {-1.0, 0.0}, 0.1, 2.5),
                     disc("far", {0.0, 5.0}, {1.0, 0.5})},
                    e);
}

RunInterval between(const RunSetup& setup, double from, double to) {
  return run_interval(setup, {}, from, to, kAlways).value();
}

TEST(RunInterval, IsTheRunAtBothMoments) {
  const RunInterval found = between(setup_of(head_on()), 0.105, 0.5);
  EXPECT_NEAR(found.before.position(0).x(), -0.6 + 2.0 * 0.105, kRounding) << "between two steps";
  EXPECT_NEAR(found.after.v(0, 0), (-0.5 - 0.6 * 2.5 * 3.0) / 3.5, kRounding);
  EXPECT_EQ(found.touched, (std::vector<bool>{true, true, false}));
  EXPECT_FALSE(found.edited);
}

TEST(RunInterval, ImpactsOfTheFirstAndTheLastStepBelongWhereTheyAre) {
  const RunSetup setup = setup_of(head_on());
  EXPECT_FALSE(between(setup, 0.1, 0.332).touched[0]) << "just before the impact, in its step";
  EXPECT_FALSE(between(setup, 0.335, 0.5).touched[0]) << "just after it";
  EXPECT_TRUE(between(setup, 0.332, 0.335).touched[0]);
}

TEST(RunInterval, FromAKeyFrameHasTheSameBytes) {
  const RunSetup setup = setup_of(head_on());
  Simulation run(setup);
  KeyFrames key_frames;
  const Sampler sampler(std::vector<Curve>{});
  key_frames.take(run, sampler, 0.0);
  for (int i = 0; i < 2000; ++i) {
    run.step();
    key_frames.take(run, sampler, 0.0);
  }
  ASSERT_GT(key_frames.all().size(), 2U);
  const auto found = run_interval(setup, key_frames.all(), 12.0, 19.0, kAlways);
  const RunInterval whole = between(setup, 12.0, 19.0);
  EXPECT_TRUE(test::same_bytes(found->before, whole.before));
  EXPECT_TRUE(test::same_bytes(found->after, whole.after));
  EXPECT_FALSE(run_interval(setup, {}, 0.1, 0.2, [] { return false; }).has_value());
}

TEST(IntervalTheory, MomentumThroughAnImpactAndFreeFlight) {
  const RunInterval found = between(setup_of(head_on()), 0.1, 0.6);
  const IntervalTheory theory = theory_of(found);
  EXPECT_EQ(theory.no_velocity, (std::vector<NoIntervalLaw>{NoIntervalLaw::kTouches, NoIntervalLaw::kTouches,
                                                            NoIntervalLaw::kNone}));
  EXPECT_EQ(theory.no_momentum, NoIntervalLaw::kNone);
  EXPECT_NEAR(theory.momentum.x(), 2.0 - 2.5 + 1.0, kRounding);
  EXPECT_EQ(theory.no_angular, NoIntervalLaw::kNone);
  EXPECT_NEAR(theory.angular, -5.0, kRounding);
  EXPECT_EQ(theory.no_kinetic, NoIntervalLaw::kLosses);
  EXPECT_EQ(theory_of(between(setup_of(head_on(1.0)), 0.1, 0.6)).no_kinetic, NoIntervalLaw::kNone);
  EXPECT_EQ(theory_of(between(setup_of(head_on()), 0.4, 0.6)).no_kinetic, NoIntervalLaw::kNone)
      << "nothing is lost after it";
}

// All sums against a run that integrates gravity exactly, through an elastic impact.
TEST(IntervalTheory, GravityAloneActsFromOutside) {
  RunSetup setup = setup_of(head_on(1.0), {0.5, -9.81});
  setup.method.integrator = IntegratorId::kRk4;
  const RunInterval found = between(setup, 0.1, 0.6);
  const IntervalTheory theory = theory_of(found);
  ASSERT_EQ(theory.no_momentum, NoIntervalLaw::kNone);
  ASSERT_EQ(theory.no_kinetic, NoIntervalLaw::kNone);
  Vec2 momentum = Vec2::Zero();
  double angular = 0.0;
  double kinetic = 0.0;
  const MassProperties& mass = found.compiled->model.mass;
  for (int i = 0; i < 3; ++i) {
    const Vec2 v = found.after.velocity(i);
    const Vec2 x = found.after.position(i);
    momentum += mass.mass[i] * v;
    angular += mass.mass[i] * (x.x() * v.y() - x.y() * v.x());
    kinetic += 0.5 * mass.mass[i] * v.squaredNorm();
  }
  EXPECT_NEAR((theory.momentum - momentum).norm(), 0.0, 1e-11);
  EXPECT_NEAR(theory.angular, angular, 1e-10);
  EXPECT_NEAR(theory.kinetic, kinetic, 1e-10);
  EXPECT_NEAR(theory.v(1, 2), found.after.v(1, 2), 1e-11);
}

TEST(IntervalTheory, ASpringBesideAPointEndsTheLawOfAngularMomentum) {
  Scene scene = scene_with({disc("wheel", {0.0, 0.0}, {0.3, 0.1}), disc("point", {1.0, 0.3}, {0.0, 0.2}, 0.0)});
  Spring spring;
  spring.body = "wheel";
  spring.point = Vec2(0.05, 0.0);
  spring.to = "point";
  scene.forces.springs = {spring};
  EXPECT_EQ(theory_of(between(setup_of(scene), 0.0, 0.3)).no_angular, NoIntervalLaw::kNone);
  scene.forces.springs[0].anchor = Vec2(0.0, 0.3);
  const IntervalTheory theory = theory_of(between(setup_of(scene), 0.0, 0.3));
  EXPECT_EQ(theory.no_momentum, NoIntervalLaw::kNone);
  EXPECT_EQ(theory.no_angular, NoIntervalLaw::kForces);
}

TEST(IntervalTheory, WallsEndTheLawOfMomentum) {
  const RunSetup setup =
      setup_of(scene_with({disc("ball", {0.0, 0.3}, {0.0, -2.0}), wall("floor", {0.0, -0.5}, 8.0, 1.0)}));
  const IntervalTheory theory = theory_of(between(setup, 0.0, 0.3));
  EXPECT_EQ(theory.no_momentum, NoIntervalLaw::kWalls);
  EXPECT_EQ(theory.no_angular, NoIntervalLaw::kWalls);
  EXPECT_EQ(theory.no_kinetic, NoIntervalLaw::kNone) << "a wall at rest does no work";
  EXPECT_NEAR(theory.kinetic, 2.0, kRounding);
  RunSetup falls = setup;
  falls.scene.forces.gravity = Vec2(0.0, -9.81);
  EXPECT_EQ(theory_of(between(falls, 0.0, 0.3)).no_kinetic, NoIntervalLaw::kWalls);
  EXPECT_EQ(theory_of(between(falls, 0.0, 0.05)).no_momentum, NoIntervalLaw::kNone) << "before it lands";
}

TEST(IntervalTheory, JointsAndForcesActOnTheirBodiesAlone) {
  RunSetup setup = setup_of(head_on(1.0));
  Joint rod;
  rod.body = "heavy";
  rod.to = "far";
  setup.scene.joints.push_back(rod);
  IntervalTheory theory = theory_of(between(setup, 0.0, 0.2));
  EXPECT_EQ(theory.no_velocity,
            (std::vector<NoIntervalLaw>{NoIntervalLaw::kNone, NoIntervalLaw::kJoints, NoIntervalLaw::kJoints}));
  EXPECT_EQ(theory.no_momentum, NoIntervalLaw::kNone) << "within the system";
  EXPECT_EQ(theory.no_kinetic, NoIntervalLaw::kJoints);
  setup.scene.joints.front().to.clear();
  EXPECT_EQ(theory_of(between(setup, 0.0, 0.2)).no_momentum, NoIntervalLaw::kJoints) << "to the plane";
  setup.scene.joints.clear();
  setup.scene.forces.linear_drag = 0.1;
  theory = theory_of(between(setup, 0.0, 0.2));
  EXPECT_EQ(theory.no_velocity[2], NoIntervalLaw::kForces);
  EXPECT_EQ(theory.no_momentum, NoIntervalLaw::kForces);
}

TEST(IntervalTheory, BodiesThatStuckAreJoined) {
  Scene scene = head_on();
  scene.materials.front().sticks = true;
  const RunSetup setup = setup_of(scene);
  const IntervalTheory theory = theory_of(between(setup, 0.5, 0.6));
  EXPECT_EQ(theory.no_velocity[0], NoIntervalLaw::kJoints);
  EXPECT_EQ(theory.no_momentum, NoIntervalLaw::kNone);
}

TEST(IntervalTheory, AnEditOfTheSceneEndsAllLaws) {
  RunSetup setup = setup_of(head_on());
  SceneEdits edits;
  edits.emplace_back(Add<Body>{disc("new", {3.0, 3.0}, {0.0, 1.0})});
  setup.edits.push_back({.time = 0.3, .what = edits});
  EXPECT_EQ(theory_of(between(setup, 0.1, 0.6)).no_momentum, NoIntervalLaw::kEdits);
  EXPECT_EQ(theory_of(between(setup, 0.4, 0.6)).no_momentum, NoIntervalLaw::kNone);
}

}  // namespace
}  // namespace carom
