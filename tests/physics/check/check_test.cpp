#include "physics/check/check.h"

#include <atomic>
#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>

#include "physics/check/measure_run.h"
#include "physics/math/parallel.h"
#include "physics/preset/preset.h"
#include "physics/scene/validate.h"
#include "tests/support/scenes.h"

namespace carom {
namespace {

using Reduction = Expectation::Reduction;
using test::disc;
using test::preset_with;
using test::room;
using test::wall;

Expectation expect(const std::string& observable, Reduction reduction, std::vector<std::string> bodies = {}) {
  Expectation e;
  e.observable = observable;
  e.reduction = reduction;
  e.bodies = std::move(bodies);
  return e;
}

Expectation at(const std::string& observable, double time, std::vector<std::string> bodies = {}) {
  Expectation e = expect(observable, Reduction::kAt, std::move(bodies));
  e.time = time;
  return e;
}

Expectation after_impact(const std::string& observable, int impact, std::vector<std::string> bodies = {}) {
  Expectation e = expect(observable, Reduction::kAtImpact, std::move(bodies));
  e.impact = impact;
  return e;
}

Sweep sweep(const std::string& place, std::vector<double> values, Sweep::Reduction reduction) {
  Sweep s;
  s.place = place;
  s.values = std::move(values);
  s.reduction = reduction;
  return s;
}

// A disc of 2 kg that falls from y = 0 for two seconds with g = 10 m/s², nothing below it.
Preset fall() {
  Preset s = preset_with({disc("ball", {0, 0}, {3, 0}, 0.1, 2.0)});
  s.scene.forces.gravity = {0, -10};
  s.duration = 2.0;
  s.method.step = 0.01;
  return s;
}

double measured(const Preset& s, const Expectation& e) { return measure_run(s, {e})[0]; }

TEST(MeasureRun, MomentsOnAndBetweenSteps) {
  const Preset s = fall();
  for (const double t : {0.0, 0.01, 0.0137, 1.0, 1.2345, 2.0, 2.5}) {
    EXPECT_NEAR(measured(s, at("y", t, {"ball"})), -5.0 * t * t, 1e-12) << t;
    EXPECT_NEAR(measured(s, at("time", t)), t, 1e-14) << t;
  }
  EXPECT_NEAR(measured(s, expect("y", Reduction::kFinal, {"ball"})), -20.0, 1e-12);
  Expectation e = expect("y", Reduction::kFinal, {"ball"});
  e.until = 0.705;
  EXPECT_NEAR(measured(s, e), -5.0 * 0.705 * 0.705, 1e-12);
}

TEST(MeasureRun, ReductionsOverTime) {
  const Preset s = fall();
  Expectation e = expect("velocity_y", Reduction::kFit, {"ball"});
  EXPECT_NEAR(measured(s, e), -10.0, 1e-12);
  e.reduction = Reduction::kMaximum;
  EXPECT_EQ(measured(s, e), 0.0);
  e.from = 0.5;
  EXPECT_NEAR(measured(s, e), -5.0, 1e-12);
  e.reduction = Reduction::kMinimum;
  e.until = 1.5;
  EXPECT_NEAR(measured(s, e), -15.0, 1e-12);
  e.reduction = Reduction::kMean;
  EXPECT_NEAR(measured(s, e), -10.0, 1e-12);
  // 101 readings from 0.5 s to 1.5 s, of which those before 0.755 s lie above -7.55.
  e.reduction = Reduction::kCount;
  e.above = -7.55;
  EXPECT_NEAR(measured(s, e), 26.0 / 101.0, 1e-14);
  e.from = e.until.emplace(1.0);
  e.reduction = Reduction::kFit;
  EXPECT_TRUE(std::isnan(measured(s, e)));  // one reading has no slope
}

// The part of a run before it is lost has extremes, but they are not the run's.
TEST(MeasureRun, OfALostRunNothingIsMeasuredButWhatWasDone) {
  Preset s = test::preset_with({test::disc("a", {1, 0}, {0, 0})});
  Spring spring;
  spring.body = "a";
  spring.stiffness = 1e6;
  s.scene.forces.springs = {spring};
  s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kImpulse, 0.005};
  s.duration = 1.0;
  std::vector<Expectation> expectations;
  for (const Reduction reduction :
       {Reduction::kMaximum, Reduction::kMean, Reduction::kCount, Reduction::kFinal}) {
    Expectation e;
    e.observable = "x";
    e.bodies = {"a"};
    e.reduction = reduction;
    if (reduction == Reduction::kCount) e.above = 0.0;
    expectations.push_back(e);
  }
  for (const double value : measure_run(s, expectations)) EXPECT_TRUE(std::isnan(value)) << value;
}

// Impacts far from the last copy of the run, and a step with several of them.
TEST(MeasureRun, ImpactsAreReachedFromCopies) {
  Preset s =
      preset_with({wall("left", {-1.5, 0}, 1, 1), wall("right", {1.5, 0}, 1, 1), disc("ball", {0, 0}, {1, 0})});
  s.duration = 20.0;
  s.method.step = 0.003;
  for (const double step : {0.003, 0.9, 5.0}) {
    s.method.step = step;
    for (int n = 1; n <= 10; ++n) {
      const double time = 0.9 + 1.8 * (n - 1);
      EXPECT_NEAR(measured(s, after_impact("time", n)), time, 1e-12);
      EXPECT_NEAR(measured(s, after_impact("x", n, {"ball"})), n % 2 == 1 ? 0.9 : -0.9, 1e-12);
      EXPECT_EQ(measured(s, after_impact("velocity_x", n, {"ball"})), n % 2 == 1 ? -1.0 : 1.0);
      EXPECT_EQ(measured(s, after_impact("wall_impacts", n)), n);
    }
    EXPECT_TRUE(std::isnan(measured(s, after_impact("time", 12))));
    Expectation e = after_impact("time", 3);
    e.until = 4.0;
    EXPECT_TRUE(std::isnan(measured(s, e)));
  }
}

TEST(MeasureRun, ManyExpectationsOfOneRunDontDisturbOneAnother) {
  Preset s = preset_with(room(1.0, 0.5), 0.9, 0.2);
  s.scene.bodies.push_back(disc("a", {-0.5, 0.1}, {3, 1}));
  s.scene.bodies.push_back(disc("b", {0.5, -0.1}, {-1, 2}));
  s.duration = 3.0;
  std::vector<Expectation> all = {at("x", 1.2345, {"a"}),
                                  after_impact("speed", 7, {"b"}),
                                  at("x", 0.777, {"b"}),
                                  expect("kinetic_energy", Reduction::kMean),
                                  after_impact("time", 4),
                                  expect("y", Reduction::kFinal, {"a"}),
                                  expect("fastest", Reduction::kMaximum)};
  const std::vector<double> together = measure_run(s, all);
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(measured(s, all[i]), together[i]) << i;
}

TEST(MeasureRun, ABodyThatIsNotThereIsRefused) {
  EXPECT_THROW((void)measure_run(fall(), {at("x", 1.0, {"nobody"})}), SceneError);
}

TEST(Observables, OfBodiesAndTheLedger) {
  Preset s = preset_with({disc("a", {-1, 0}, {2, 0}, 0.1, 1.0), disc("b", {1, 0.0}, {-1, 0}, 0.1, 2.5),
                          wall("w", {-3.6, 0}, 1, 1)},
                         0.6);
  s.scene.bodies[1].spin = 4.0;
  s.duration = 3.0;
  EXPECT_EQ(measured(s, at("distance", 0, {"a", "b"})), 2.0);
  EXPECT_NEAR(measured(s, at("body_kinetic_energy", 0, {"b"})), 1.25 + 0.5 * 0.5 * 2.5 * 0.01 * 16.0, 1e-14);
  EXPECT_EQ(measured(s, at("body_kinetic_energy", 0, {"w"})), 0.0);
  EXPECT_NEAR(measured(s, at("direction", 0, {"b"})), std::acos(-1.0), 1e-15);
  EXPECT_NEAR(measured(s, at("momentum", 0)), 0.5, 1e-15);
  // They meet at 0.6 s with v = -10/7 and 13/35, then a reaches the wall.
  EXPECT_EQ(measured(s, at("impacts_between", 0.5, {"a", "b"})), 0.0);
  EXPECT_EQ(measured(s, at("impacts_between", 1.0, {"b", "a"})), 1.0);
  EXPECT_EQ(measured(s, at("impacts_between", 1.0, {"a", "w"})), 0.0);
  EXPECT_NEAR(measured(s, at("lost_to_restitution", 1.0)), 72.0 / 35.0, 1e-12);
  const Expectation end = expect("wall_impulse", Reduction::kFinal);
  EXPECT_NEAR(measured(s, end), 1.6 * 10.0 / 7.0, 1e-12);
  EXPECT_EQ(measured(s, expect("wall_impacts", Reduction::kFinal)), 1.0);
  EXPECT_EQ(measured(s, expect("mutual_impacts", Reduction::kFinal)), 1.0);
  EXPECT_NEAR(measured(s, expect("numerical_drift", Reduction::kFinal)), 0.0, 1e-14);
}

TEST(ParallelFor, DoesEachOnceAndThrowsTheFirstError) {
  std::vector<std::atomic<int>> done(100);
  parallel_for(100, 4, [&](int i) { ++done[static_cast<std::size_t>(i)]; });
  for (const auto& d : done) EXPECT_EQ(d, 1);
  parallel_for(0, 4, [](int) { FAIL(); });
  try {
    parallel_for(50, 3, [](int i) {
      if (i % 20 == 7) throw std::runtime_error(std::to_string(i));
    });
    ADD_FAILURE() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "7");
  }
}

// The fall in t s with other gravities: y = -g t²/2.
TEST(Check, SettingsAndSweeps) {
  Preset s = fall();
  Expectation e = at("y", 1.0, {"ball"});
  e.settings = {{"/gravity/1", -4.0}, {"/bodies/0/position/1", 7.0}};
  e.value = 5.0;
  e.tolerance = 1e-12;
  s.expect = {e};
  EXPECT_TRUE(check_expectations(s)[0].good);
  s.expect[0].value = 5.1;
  EXPECT_FALSE(check_expectations(s)[0].good);
  EXPECT_NEAR(check_expectations(s)[0].error, -0.1, 1e-12);

  const auto reduced = [&](const std::string& place, std::vector<double> values, Sweep::Reduction reduction) {
    Preset swept = fall();
    Expectation x = at("y", 1.0, {"ball"});
    x.over = sweep(place, std::move(values), reduction);
    swept.expect = {x};
    return check_expectations(swept)[0];
  };
  EXPECT_NEAR(reduced("/gravity/1", {2, 4, 12}, Sweep::Reduction::kMean).measured, 3.0, 1e-12);
  EXPECT_NEAR(reduced("/gravity/1", {2, 4, 12}, Sweep::Reduction::kMaximum).measured, 6.0, 1e-12);
  EXPECT_NEAR(reduced("/gravity/1", {4, 2, 12}, Sweep::Reduction::kMinimum).measured, 1.0, 1e-12);
  EXPECT_NEAR(reduced("/gravity/1", {2, 4, 12}, Sweep::Reduction::kExponent).measured, 1.0, 1e-12);
  // No logarithm of a height below the ground.
  EXPECT_TRUE(std::isnan(reduced("/method/step", {0.1, 0.2}, Sweep::Reduction::kExponent).measured));
  EXPECT_EQ(reduced("/gravity/1", {2, 4, 12}, Sweep::Reduction::kMean).unit, "m");
  EXPECT_EQ(reduced("/gravity/1", {2, 4, 12}, Sweep::Reduction::kExponent).unit, "1");
  EXPECT_EQ(reduced("/gravity/1", {2, 4, 12}, Sweep::Reduction::kWhereMaximum).unit, "");
  // The largest at an end of the sweep.
  EXPECT_EQ(reduced("/gravity/1", {2, 4, 12}, Sweep::Reduction::kWhereMaximum).measured, 12.0);
  EXPECT_EQ(reduced("/gravity/1", {2, 4, 12}, Sweep::Reduction::kWhereMinimum).measured, 2.0);
}

// The height y = t - 5 t² is a parabola in the run's duration, largest at 0.1 s.
TEST(Check, ParabolasAreFoundBetweenTheValues) {
  Preset s = fall();
  s.scene.bodies[0].velocity = {0, 1};
  s.method.step = 0.001;
  Expectation e = expect("y", Reduction::kFinal, {"ball"});
  e.over = sweep("/duration", {0.01, 0.07, 0.12, 0.3}, Sweep::Reduction::kWhereMaximum);
  s.expect = {e};
  EXPECT_NEAR(check_expectations(s)[0].measured, 0.1, 1e-9);
  s.scene.forces.gravity = {0, 10};
  s.scene.bodies[0].velocity = {0, -1};
  s.expect[0].over->reduction = Sweep::Reduction::kWhereMinimum;
  EXPECT_NEAR(check_expectations(s)[0].measured, 0.1, 1e-9);
}

TEST(Check, SameSettingsShareARunAndThreadsDontMatter) {
  Preset s = preset_with(room(1.0, 0.5), 0.9, 0.2);
  s.scene.generators.resize(1);
  GridGenerator& g = s.scene.generators[0];
  g.columns = g.rows = 3;
  g.origin = {-0.6, -0.6};
  g.spacing = {0.6, 0.6};
  g.speed_max = 2.0;
  s.duration = 1.0;
  Expectation e = expect("kinetic_energy", Reduction::kFinal);
  e.over = sweep("/generators/0/seed", {1, 2, 3, 4, 5}, Sweep::Reduction::kMean);
  s.expect = {e, e, expect("impacts", Reduction::kFinal), expect("time", Reduction::kFinal)};
  s.expect[1].observable = "impacts";
  const ExpectationCheck check(s);
  EXPECT_EQ(check.runs(), 6);
  const std::vector<Outcome> alone = check_expectations(s, 1);
  const std::vector<Outcome> crowd = check_expectations(s, 5);
  for (std::size_t i = 0; i < alone.size(); ++i) EXPECT_EQ(alone[i].measured, crowd[i].measured);
  EXPECT_NE(alone[0].measured, 0.0);
  EXPECT_EQ(alone[3].measured, 1.0);
}

TEST(Check, ASettingThatTheSceneDoesNotAllowIsNamed) {
  Preset s = fall();
  s.expect = {at("x", 1.0, {"ball"}), at("x", 1.0, {"ball"})};
  s.expect[1].settings = {{"/bodies/0/mass", -1.0}};
  try {
    (void)check_expectations(s);
    ADD_FAILURE() << "accepted";
  } catch (const SceneError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.rfind("/expect/1: ", 0), 0U) << message;
    EXPECT_NE(message.find("/bodies/0/mass: -1 is not allowed"), std::string::npos) << message;
  }
}

TEST(Check, ExpectationsInWords) {
  const Preset s = fall();
  Expectation e = expect("speed", Reduction::kMaximum, {"ball"});
  e.from = 1.0;
  e.settings = {{"/bodies/0/mass", 2.0}, {"/gravity/1", -1.5}};
  EXPECT_EQ(text_of(e, s), "maximum of speed of ball from 1 s, with mass of ball = 2, gravity/1 = -1.5");
  e = after_impact("time", 3);
  e.over = sweep("/generators/0/seed", {4, 1, 9}, Sweep::Reduction::kMean);
  EXPECT_EQ(text_of(e, s), "time at impact 3; mean over generators/0/seed = 1...9");
}

}  // namespace
}  // namespace carom
