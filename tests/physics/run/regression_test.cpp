// Cases that once failed.
#include <gtest/gtest.h>
#include <limits>

#include "physics/check/check.h"
#include "physics/collision/time_of_impact.h"
#include "physics/dynamics/integrators/integrators.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "tests/support/scenes.h"

namespace carom {
namespace {

using test::disc;
using test::preset_with;
using test::wall;

// The secant from a tiny f(b) rounds to b itself; the search must continue and not fall back to a.
TEST(Regression, RootBesideTheEndOfTheBracketIsFound) {
  const double end = 0.005;
  for (const double below : {-1e-16, -1e-17, -1e-18, -1e-20, -1e-30}) {
    const auto f = [&](double t) { return t < end ? (end - t) * 200.0 : below; };
    const double root = bracketed_root(f, 0.0, f(0.0), end, f(end));
    EXPECT_GT(root, 0.999 * end) << below;
    EXPECT_LT(root, end) << below;
  }
}

// The energies of an impact resolved at the end of a located step are those of that time.
TEST(Regression, TotalsOfADeferredImpactAreOfItsOwnMoment) {
  Preset s = preset_with({wall("floor", {0.0, -0.5}, 4.0, 1.0), disc("ball", {0.0, 0.1}, {0.0, 0.0})}, 0.5);
  s.scene.forces.gravity = {0.0, -9.81};
  Simulation run(setup_of(s));
  run.watch_impacts(true);
  run.step();
  run.step();
  ASSERT_EQ(run.last_impacts().size(), 1U);
  EXPECT_NEAR(run.totals_of(run.last_jumps()[0].before).kinetic(), 0.5 * std::pow(9.81 * 0.005, 2), 1e-12);
  EXPECT_NEAR(run.totals_of(run.last_jumps()[0].after).kinetic(), 0.0, 1e-12);
}

// A small disc wholly inside a large one: the contact lies beyond its centre, so its arm is negative.
TEST(Regression, DeepOverlapKeepsAngularMomentum) {
  Preset s = preset_with(
      {disc("large", {0.0, 0.0}, {0.0, 0.0}, 1.0, 3.0), disc("small", {0.5, 0.0}, {-1.0, 0.7}, 0.1)}, 0.5, 0.4);
  s.scene.bodies[1].spin = 3.0;
  Simulation run(setup_of(s));
  run.watch_impacts(true);
  run.step();
  ASSERT_EQ(run.impact_count(), 1);
  const ImpactRecord& impact = run.last_impacts()[0];
  EXPECT_NE(impact.tangential_impulse, 0.0);
  const Jump& jump = run.last_jumps()[0];
  EXPECT_NEAR(run.totals_of(jump.after).angular_momentum, run.totals_of(jump.before).angular_momentum, 1e-14);
}

// Discs that touch and approach at t = 0: the value just after the first impact differs from that before it.
TEST(Regression, ExpectationAfterAnImpactAtTheStepsStart) {
  Preset s =
      preset_with({disc("a", {-0.125, 0.0}, {1.0, 0.0}, 0.125), disc("b", {0.125, 0.0}, {0.0, 0.0}, 0.125)});
  Expectation e;
  e.observable = "velocity_x";
  e.bodies = {"b"};
  e.reduction = Expectation::Reduction::kAtImpact;
  e.impact = 1;
  e.value = 1.0;
  s.expect = {e};
  EXPECT_TRUE(check_expectations(s)[0].good) << check_expectations(s)[0].measured;
}

// A disc at rest on a thin floor is hit from above: it must not pass through the floor.
TEST(Regression, RestingDiscStruckHardStaysOnAThinFloor) {
  for (const double restitution : {0.0, 0.5, 0.9}) {
    Preset s = preset_with({wall("floor", {0.0, -0.005}, 4.0, 0.01), disc("resting", {0.0, 0.1}, {0.0, 0.0}),
                            disc("hammer", {0.0, 100.4}, {0.0, -200.0}, 0.1, 50.0)},
                           restitution);
    s.scene.forces.gravity = {0.0, -9.81};
    Simulation run(setup_of(s));
    run.advance_to(1.0);
    EXPECT_GT(run.state().position(1).y(), 0.0) << restitution;
    EXPECT_GT(run.state().position(2).y(), 0.0) << restitution;
  }
}

// Semi-implicit Euler's path from a penetration closes again while its velocity still separates the bodies:
// no impact.
TEST(Regression, EveryImpactOfTheLogCloses) {
  Preset s = preset_with({wall("floor", {0.0, -0.5}, 4.0, 1.0), disc("d", {0.0, 0.0999}, {0.0, 0.5886})});
  s.scene.forces.gravity = {0.0, -9.81};
  s.method = {IntegratorId::kSemiImplicitEuler, ImpactsId::kLocated, ContactsId::kImpulse, 0.1};
  Simulation run(setup_of(s));
  run.advance_to(0.5, [&] {
    for (const ImpactRecord& r : run.last_impacts()) EXPECT_GT(r.closing_speed, 0.0) << r.time;
  });
}

// Two bumpers of one disc engage and disengage at the same times, to the last bit.
TEST(Regression, SpringsThatSwitchTogether) {
  Preset s = preset_with({disc("left", {-1.0, 0.0}, {1.0, 0.0}), disc("middle", {0.0, 0.0}, {0.0, 0.0}),
                          disc("right", {1.0, 0.0}, {-1.0, 0.0})});
  for (const char* side : {"left", "right"}) {
    Spring bumper;
    bumper.name = side;
    bumper.body = side;
    bumper.to = "middle";
    bumper.stiffness = 30.0;
    bumper.rest_length = 0.5;
    bumper.acts = SpringActs::kPush;
    s.scene.forces.springs.push_back(bumper);
  }
  for (const IntegratorId id : {IntegratorId::kRk4, IntegratorId::kDormandPrince}) {
    for (const ImpactsId impacts : {ImpactsId::kStepEnd, ImpactsId::kLocated}) {
      s.method = {id, impacts, ContactsId::kImpulse, 0.005};
      Simulation run(setup_of(s));
      run.advance_to(2.0);
      EXPECT_EQ(run.impact_count(), 0);
      EXPECT_NEAR(run.state().velocity(0).x(), -1.0, 1e-8);
      EXPECT_NEAR(run.state().velocity(1).x(), 0.0, 1e-12);
      EXPECT_NEAR(run.state().velocity(2).x(), 1.0, 1e-8);
    }
  }
}

// A body rebounds faster than its damped bumper pushes: the bumper disengages at the impact.
TEST(Regression, ImpactLetsABumperGo) {
  Preset s = preset_with({wall("wall", {1.5, 0.0}, 1.0, 1.0), disc("d", {0.6, 0.0}, {2.0, 0.0})});
  Spring bumper;
  bumper.body = "d";
  bumper.anchor = {1.5, 0.0};
  bumper.stiffness = 0.5;
  bumper.damping = 1.0;
  bumper.rest_length = 0.8;
  bumper.acts = SpringActs::kPush;
  s.scene.forces.springs = {bumper};
  for (const IntegratorChoice& choice : kIntegrators) {
    if (choice.order == 0) continue;
    s.method = {choice.id, ImpactsId::kLocated, ContactsId::kImpulse, 0.005};
    Simulation run(setup_of(s));
    double rebound = 0.0;
    run.advance_to(1.0, [&] {
      for (const ImpactRecord& r : run.last_impacts()) rebound = r.closing_speed;
    });
    EXPECT_EQ(run.impact_count(), 1) << choice.name;
    EXPECT_GT(rebound, 1.5) << choice.name;
    EXPECT_NEAR(run.state().velocity(1).x(), -rebound, 1e-14) << choice.name;
  }
}

TEST(Regression, MassesTooSmallForArithmeticAreRefused) {
  Preset s = preset_with({disc("a", {0.0, 0.0}, {0.0, 0.0}, 1e-200)});
  s.scene.bodies[0].mass.reset();
  EXPECT_THROW(validate(s), SceneError);
  s = preset_with({disc("a", {0.0, 0.0}, {0.0, 0.0}, 0.1, 1e-310)});
  EXPECT_THROW(validate(s), SceneError);
}

// Names and keys in a file cannot break or flood an error's line.
TEST(Regression, AwkwardNamesStayOnOneShortLine) {
  const std::string key = "a\\nb" + std::string(5000, 'x');
  const std::string body =
      R"({"name": ")" + key + R"(", "shape": {"type": "disc", "radius": 1}, "position": [0, 0]})";
  const std::string head = R"({"format": "carom-preset", "version": 1, "title": "t")";
  for (const std::string& text :
       {head + R"(, ")" + key + R"(": 1})", head + R"(, ")" + key + R"(": 1, ")" + key + R"(": 2})",
        head + R"(, "bodies": [)" + body + ", " + body + "]}", head + R"(, "plots": [")" + key + R"("]})",
        head + R"(, "forces": [{"type": ")" + key + R"("}]})"}) {
    try {
      (void)parse_preset(text, "file.json");
      FAIL() << "accepted";
    } catch (const SceneError& error) {
      const std::string what = error.what();
      EXPECT_EQ(what.find('\n'), std::string::npos) << what;
      EXPECT_LT(what.size(), 400U) << what;
      EXPECT_NE(what.find("allowed"), std::string::npos) << what;
    }
  }
}

// A body that rests by impacts is looked at once more at each step's end, and that may be the end of its force,
// or not, by rounding. The force went on for ever.
TEST(Regression, AForceEndsAtAStepsEnd) {
  for (const double clock : {0.0, 0.3, 0.6, 0.7}) {
    Preset s =
        test::preset_with({test::wall("floor", {0, -0.5}, 20.0, 1.0), test::disc("a", {0, 0.1}, {0, 0})}, 0.5);
    s.scene.bodies[1].mass = 1.0;
    s.scene.forces.gravity = {0.0, -9.81};
    s.scene.forces.applied = {{"a", {1.0, 0.0}, 0.0, 0.0, 0.0, clock + 0.3}};
    s.method = {IntegratorId::kAdaptiveDormandPrince, ImpactsId::kLocated, ContactsId::kImpulse, 0.01, 1e-9};
    s.saved = SavedRun{.time = clock};
    Simulation run(setup_of(s));
    run.advance_to(clock + 0.6);
    EXPECT_NEAR(run.state().v(0, 1), 0.3, 1e-12) << clock;
    EXPECT_NEAR(run.state().q(0, 1), 0.045 + 0.09, 1e-12) << clock;
  }
}

}  // namespace
}  // namespace carom
