#include "physics/run/stop_watch.h"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/math/roots.h"
#include "physics/step/coming_to_rest.h"
#include "physics/step/pair_motion.h"
#include "tests/support/fitted_order.h"
#include "tests/support/scenes.h"

// The moments at which runs stop, beside closed forms. Each is reached under three steps.
namespace carom {
namespace {

using test::disc;
using test::setup_with;
using test::wall;

constexpr double kG = 9.81;
constexpr auto kSteps = std::to_array<double>({0.04, 0.02, 0.01});

struct End {
  Simulation run;
  std::optional<std::size_t> stop;  // which of the sentences came
  std::vector<double> rows;         // s: the ends of steps that were told
};

End end_of(const RunSetup& setup, const std::vector<std::string>& sentences, double until = 100.0) {
  std::vector<Stop> stops;
  for (const std::string& sentence : sentences) stops.push_back(stop_of("stop", sentence));
  End end{Simulation(setup), std::nullopt, {}};
  StopWatch watch(stops, end.run);
  end.stop = watch.advance_to(end.run, until, [&] { end.rows.push_back(end.run.time()); });
  return end;
}

RunSetup with_step(RunSetup setup, double step, IntegratorId integrator = IntegratorId::kRk4) {
  setup.method.step = step;
  setup.method.integrator = integrator;
  return setup;
}

// A ball of radius 0.1 m, whose lowest point is `height` m above the floor.
RunSetup dropped(double height, double restitution) {
  RunSetup setup = setup_with(
      {wall("floor", {0.0, -0.5}, 10.0, 1.0), disc("ball", {0.0, 0.1 + height}, {0.0, 0.0})}, restitution);
  setup.scene.forces.gravity = {0.0, -kG};
  return setup;
}

// RK4 is exact on parabolas: what is left is rounding.
TEST(StopWatch, StopsAtTheNthBounce) {
  const double e = 0.8;
  const double fall = std::sqrt(2.0 / kG);  // s, from 1 m
  for (const double step : kSteps) {
    double bounce = fall;
    for (int n = 1; n <= 4; ++n) {
      SCOPED_TRACE(fmt::format("bounce {}, step {}", n, step));
      const std::string sentence = fmt::format("at the {}th impact of ball with a wall", n);
      const End end = end_of(with_step(dropped(1.0, e), step), {sentence});
      ASSERT_EQ(end.stop, 0U);
      EXPECT_NEAR(end.run.time(), bounce, 1e-13);
      EXPECT_NEAR(end.run.state().q(1, 1), 0.1, 1e-13);
      EXPECT_NEAR(end.run.state().v(1, 1), std::pow(e, n) * kG * fall, 1e-12);  // just after it
      EXPECT_EQ(end.run.impact_count(), n);
      EXPECT_EQ(end.rows.back(), end.run.time());
      bounce += 2.0 * std::pow(e, n) * fall;
    }
  }
}

TEST(StopWatch, CountsTheImpactsThatTheSentenceTells) {
  // A meets B at 0.4 s and gives it all its motion; B meets the wall at 0.8 s, A again at 1.2 s.
  const RunSetup setup = setup_with({disc("A", {-0.6, 0.0}, {1.0, 0.0}), disc("B", {0.0, 0.0}, {0.0, 0.0}),
                                     wall("wall", {1.0, 0.0}, 1.0, 4.0), wall("far", {-5.0, 0.0}, 1.0, 4.0)});
  const auto moment = [&](const std::string& sentence) {
    const End end = end_of(setup, {sentence}, 9.0);
    return end.stop ? end.run.time() : -1.0;
  };
  EXPECT_NEAR(moment("at every impact"), 0.4, 1e-12);
  EXPECT_NEAR(moment("at the 1st impact with a wall"), 0.8, 1e-12);
  EXPECT_NEAR(moment("at every impact of wall"), 0.8, 1e-12);
  EXPECT_NEAR(moment("at the 2nd impact of B"), 0.8, 1e-12);
  EXPECT_NEAR(moment("at the 2nd impact of A"), 1.2, 1e-12);
  EXPECT_NEAR(moment("at the 2nd impact of B with A"), 1.2, 1e-12);
  EXPECT_NEAR(moment("at the 2nd impact with A"), 1.2, 1e-12);
  EXPECT_NEAR(moment("at the 3rd impact"), 1.2, 1e-12);
  EXPECT_NEAR(moment("at the 1st impact of A with a wall"), 1.2 + 4.2, 1e-12);
  EXPECT_EQ(moment("at the 1st impact of A with wall"), -1.0);
  EXPECT_EQ(moment("at the 99th impact"), -1.0);
}

TEST(StopWatch, TheEarliestStopComes) {
  const RunSetup setup = dropped(1.0, 0.8);
  const std::string at_time = "at 0.3 s";
  const std::string at_impact = "at the 1st impact";  // 0.4515 s
  const std::string passes = "when ball passes y = 0.2 m";
  EXPECT_EQ(end_of(setup, {at_impact, at_time}).stop, 1U);
  EXPECT_EQ(end_of(setup, {at_impact, passes, "at 0.46 s"}).stop, 1U);
  EXPECT_EQ(end_of(setup, {"at 0.46 s", at_impact}).stop, 1U);
  EXPECT_EQ(end_of(setup, {at_time}).run.time(), 0.3);
  EXPECT_EQ(end_of(setup, {"at 0.30001 s"}).run.time(), 0.30001);
  EXPECT_EQ(end_of(setup, {at_impact}, 0.2).stop, std::nullopt);
  EXPECT_EQ(end_of(setup, {at_impact}, 0.2).run.time(), 0.2);
}

TEST(StopWatch, GoesOnPastAMoment) {
  Simulation run(dropped(1.0, 0.8));
  StopWatch watch({stop_of("", "at every impact"), stop_of("", "when ball passes y = 0.5 m")}, run);
  std::vector<std::size_t> came;
  for (int i = 0; i < 5; ++i) came.push_back(*watch.advance_to(run, 10.0, [] {}));
  EXPECT_EQ(came, (std::vector<std::size_t>{1, 0, 1, 1, 0}));
  EXPECT_EQ(run.impact_count(), 2);
}

TEST(StopWatch, PassesUnderConstantVelocityAndAcceleration) {
  RunSetup setup = setup_with({disc("A", {0.1, 0.0}, {0.7, 3.0})});
  setup.scene.forces.gravity = {0.0, -kG};
  const double up = (3.0 - std::sqrt(9.0 - 2.0 * kG * 0.3)) / kG;
  const double down = (3.0 + std::sqrt(9.0 - 2.0 * kG * 0.3)) / kG;
  const double slower = 0.7 * std::sqrt(3.0);  // of v_y, where the speed is 1.4 m/s
  const std::map<std::string, double> moments = {
      {"when A passes x = 0.4 m", 0.3 / 0.7},
      {"when A passes x = 0.4 m upwards", 0.3 / 0.7},
      {"when A passes y = 0.3 m", up},
      {"when A passes y = 0.3 m upwards", up},
      {"when A passes y = 0.3 m downwards", down},
      {"when A passes speed = 1.4 m/s downwards", (3.0 - slower) / kG},
      {"when A passes speed = 1.4 m/s upwards", (3.0 + slower) / kG},
  };
  for (const double step : kSteps) {
    for (const auto& [sentence, moment] : moments) {
      const End end = end_of(with_step(setup, step), {sentence}, 2.0);
      ASSERT_EQ(end.stop, 0U) << sentence;
      EXPECT_NEAR(end.run.time(), moment, 4e-15) << sentence << ", step " << step;
      EXPECT_NEAR(end.run.state().q(0, 0), 0.1 + 0.7 * moment, 1e-14);
    }
    EXPECT_EQ(end_of(with_step(setup, step), {"when A passes x = 0.4 m downwards"}, 2.0).stop, std::nullopt);
    EXPECT_EQ(end_of(with_step(setup, step), {"when A passes x = 0.1 m"}, 2.0).stop, std::nullopt);
  }
}

// There and back within one step, through a top and through a bounce.
TEST(StopWatch, PassesWithinAStep) {
  RunSetup thrown = setup_with({disc("A", {0.0, 0.0}, {0.0, 3.0})});
  thrown.scene.forces.gravity = {0.0, -kG};
  const double top = 3.0 / kG;
  thrown.method.step = 2.0 * top / 3.0;
  const double below = 1e-3;
  const std::string sentence = fmt::format("when A passes y = {} m", 0.5 * 3.0 * top - below);
  for (const char* const way : {"upwards", "downwards"}) {
    const double sign = way == std::string("upwards") ? -1.0 : 1.0;
    const End end = end_of(thrown, {fmt::format("{} {}", sentence, way)}, 1.0);
    EXPECT_EQ(end.stop, 0U);
    EXPECT_NEAR(end.run.time(), top + sign * std::sqrt(2.0 * below / kG), 1e-12) << way;
  }
  RunSetup bounces = dropped(1.0, 1.0);
  bounces.method.step = 0.3;
  const double fall = std::sqrt(2.0 / kG);
  EXPECT_NEAR(end_of(bounces, {"when ball passes y = 0.2 m"}).run.time(), std::sqrt(1.8 / kG), 1e-13);
  EXPECT_NEAR(end_of(bounces, {"when ball passes y = 0.2 m upwards"}).run.time(),
              2.0 * fall - std::sqrt(1.8 / kG), 1e-13);
}

// v² = vx² + (vy - g t)² turns back at its least within a step.
TEST(StopWatch, ASpeedTurnsWithinAStep) {
  for (const double across : {0.0, 0.7}) {
    RunSetup setup = setup_with({disc("A", {0.0, 0.0}, {across, 3.0})});
    setup.scene.forces.gravity = {0.0, -kG};
    const double speed = across + 0.01;
    const double off = std::sqrt(speed * speed - across * across) / kG;  // s, from the top
    const double top = 3.0 / kG;
    const double k = 0.5 * speed * speed;
    for (const double step : {2.0 * top / 3.0, 2.0 * top / 31.0}) {
      SCOPED_TRACE(fmt::format("across {}, step {}", across, step));
      const auto moment = [&](const std::string& sentence) {
        const End end = end_of(with_step(setup, step), {sentence}, 1.0);
        return end.stop ? end.run.time() : -1.0;
      };
      EXPECT_NEAR(moment(fmt::format("when A passes speed = {} m/s downwards", speed)), top - off, 1e-12);
      EXPECT_NEAR(moment(fmt::format("when A passes speed = {} m/s", speed)), top - off, 1e-12);
      EXPECT_NEAR(moment(fmt::format("when A passes speed = {} m/s upwards", speed)), top + off, 1e-12);
      EXPECT_NEAR(moment(fmt::format("when K falls below {} J", k)), top - off, 1e-12);
      if (across > 0.0) {
        EXPECT_EQ(moment(fmt::format("when A passes speed = {} m/s", across - 1e-9)), -1.0);
      }
    }
  }
}

// With 2 (K of both) = 0.13 + (3 - g t)² + (3.5 - g t)², which is 0.26 at g t = 3.2.
TEST(StopWatch, TheEnergyOfSeveralBodiesTurnsWithinAStep) {
  RunSetup setup = setup_with({disc("A", {0.0, 0.0}, {0.3, 3.0}), disc("B", {3.0, 0.0}, {-0.2, 3.5}),
                               wall("wall", {0.0, 9.0}, 1.0, 1.0)});
  setup.scene.forces.gravity = {0.0, -kG};
  const End end = end_of(with_step(setup, 2.0 * 3.25 / kG / 7.0), {"when K falls below 0.13 J"}, 1.0);
  ASSERT_EQ(end.stop, 0U);
  EXPECT_NEAR(end.run.time(), 3.2 / kG, 1e-12);
}

// Bounces turn the speed, too, at a corner that is not below it or above it.
TEST(StopWatch, AnImpactIsNoTurn) {
  const double fall = std::sqrt(2.0 / kG);
  const double fastest = kG * fall;
  for (const double step : {0.3, 0.04, 0.005}) {
    SCOPED_TRACE(step);
    const auto moment = [&](double restitution, const std::string& sentence) {
      const End end = end_of(with_step(dropped(1.0, restitution), step), {sentence}, 1.2);
      return end.stop ? end.run.time() : -1.0;
    };
    EXPECT_NEAR(moment(0.8, "when K falls below 0.0001 J"), 1.8 * fall - std::sqrt(2e-4) / kG, 1e-12);
    EXPECT_NEAR(moment(0.8, "when ball passes speed = 0.02 m/s downwards"), 1.8 * fall - 0.02 / kG, 1e-12);
    const std::string nearly = fmt::format("when ball passes speed = {} m/s", fastest - 0.01);
    EXPECT_NEAR(moment(1.0, nearly + " upwards"), fall - 0.01 / kG, 1e-12);
    EXPECT_NEAR(moment(1.0, nearly + " downwards"), fall + 0.01 / kG, 1e-12);
    EXPECT_EQ(moment(1.0, fmt::format("when ball passes speed = {} m/s", fastest + 1e-6)), -1.0);
  }
}

TEST(StopWatch, PassesAnAngle) {
  RunSetup setup = setup_with({disc("A", {0.0, 0.0}, {0.0, 0.0})});
  setup.scene.bodies[0].spin = -2.5;
  for (const double step : kSteps) {
    const End end = end_of(with_step(setup, step), {"when A passes angle = -3 rad"});
    EXPECT_NEAR(end.run.time(), 3.0 / 2.5, 1e-14);
  }
}

// The order of the method in `step` of a moment that is `exact`, from three steps.
double order_of(const RunSetup& setup, IntegratorId integrator, const std::string& sentence, double exact) {
  std::vector<double> errors;
  for (const double step : kSteps) {
    const End end = end_of(with_step(setup, step, integrator), {sentence});
    EXPECT_EQ(end.stop, 0U);
    errors.push_back(std::abs(end.run.time() - exact));
  }
  return test::fitted_order({kSteps.begin(), kSteps.end()}, errors);
}

const std::map<IntegratorId, double> kOrders = {{IntegratorId::kExplicitEuler, 1.0},
                                                {IntegratorId::kSemiImplicitEuler, 1.0},
                                                {IntegratorId::kVelocityVerlet, 2.0},
                                                {IntegratorId::kRk4, 4.0},
                                                {IntegratorId::kDormandPrince, 5.0}};

// Linear drag b: K = K₀ exp(−2 b t/m).
TEST(StopWatch, KineticEnergyFallsWithTheOrderOfTheMethod) {
  RunSetup setup = setup_with({disc("A", {0.0, 0.0}, {3.0, 0.0})});
  setup.scene.forces.linear_drag = 2.0;
  const double exact = std::log(4.5 / 0.7) / 4.0;
  for (const auto& [integrator, order] : kOrders)
    EXPECT_NEAR(order_of(setup, integrator, "when K falls below 0.7 J", exact), order, 0.25);
  const double rest = std::log(3.0 / kRestSpeed) / 2.0;
  for (const auto& [integrator, order] : kOrders)
    EXPECT_NEAR(order_of(setup, integrator, "when all is at rest", rest), order, 0.25);
}

// Thrown up, v = (v₀ + g/b) exp(-b t) - g/b: it turns back within a step.
TEST(StopWatch, ASpeedTurnsWithTheOrderOfTheMethod) {
  RunSetup setup = setup_with({disc("A", {0.0, 0.0}, {0.0, 3.0})});
  setup.scene.forces.gravity = {0.0, -kG};
  setup.scene.forces.linear_drag = 2.0;
  const double exact = std::log((3.0 + kG / 2.0) / (0.005 + kG / 2.0)) / 2.0;
  for (const auto& [integrator, order] : kOrders) {
    EXPECT_NEAR(order_of(setup, integrator, "when A passes speed = 0.005 m/s downwards", exact), order, 0.4)
        << static_cast<int>(integrator);
    EXPECT_NEAR(order_of(setup, integrator, "when K falls below 0.0000125 J", exact), order, 0.4)
        << static_cast<int>(integrator);
  }
}

// Two bodies on a spring under linear drag b: with γ = b/2m and Ω² = 2 k/m - γ² their speed is
// exp(-γ t) (cos Ω t - γ/Ω sin Ω t) m/s, which turns at nothing.
TEST(StopWatch, TheEnergyOfASpringTurnsWithTheOrderOfTheMethod) {
  RunSetup setup = setup_with({disc("A", {-1.0, 0.0}, {-1.0, 0.0}), disc("B", {1.0, 0.0}, {1.0, 0.0})});
  Spring spring;
  spring.body = "A";
  spring.to = "B";
  spring.stiffness = 12.5;
  spring.rest_length = 2.0;
  setup.scene.forces.springs = {spring};
  setup.scene.forces.linear_drag = 6.0;
  const auto above = [](double t) {
    return std::exp(-3.0 * t) * (std::cos(4.0 * t) - 0.75 * std::sin(4.0 * t)) - std::sqrt(1e-5);
  };
  const double exact = bracketed_root(above, 0.0, above(0.0), 0.4, above(0.4));
  for (const auto& [integrator, order] : kOrders) {
    EXPECT_NEAR(order_of(setup, integrator, "when K falls below 0.00001 J", exact), order, 0.4)
        << static_cast<int>(integrator);
  }
}

// A plate hung at its upper end, let go at 1 rad. With k = sin ½ and ω of small swings it comes to the angle θ
// after (K(k) − F(k, φ))/ω, where sin φ = sin(θ/2)/k.
TEST(StopWatch, PendulumPassesAnAngleWithTheOrderOfTheMethod) {
  Body plate = disc("plate", {0.0, 0.0}, {0.0, 0.0});
  plate.shape = Box{0.2, 1.0};
  plate.angle = 1.0;
  plate.position = Vec2(0.5 * std::sin(1.0), -0.5 * std::cos(1.0));
  RunSetup setup = setup_with({plate});
  setup.scene.forces.gravity = {0.0, -kG};
  Joint pin;
  pin.kind = JointKind::kPin;
  pin.body = "plate";
  pin.point = {0.0, 0.5};
  setup.scene.joints = {pin};
  const double inertia = (0.04 + 1.0) / 12.0 + 0.25;
  const double k = std::sin(0.5);
  const double phi = std::asin(std::sin(0.25) / k);
  const double exact = (std::comp_ellint_1(k) - std::ellint_1(k, phi)) / std::sqrt(kG * 0.5 / inertia);
  for (const auto& [integrator, order] : kOrders) {
    const double found = order_of(setup, integrator, "when plate passes angle = 0.5 rad", exact);
    EXPECT_NEAR(found, order, 0.4) << static_cast<int>(integrator);
  }
  // It swings to the other side; on the way K = m g l (cos θ - cos 1). Half a swing is symmetric, which gives
  // methods of odd order one more.
  const double back = std::asin(std::sin(0.5 * std::acos(std::cos(1.0) + 1e-4 / (0.5 * kG))) / k);
  const double other_side = (std::comp_ellint_1(k) + std::ellint_1(k, back)) / std::sqrt(kG * 0.5 / inertia);
  for (const auto& [integrator, order] : kOrders) {
    const double found = order_of(setup, integrator, "when K falls below 0.0001 J", other_side);
    EXPECT_GT(found, order - 0.4) << static_cast<int>(integrator);
  }
}

TEST(StopWatch, KineticEnergyFallsAtAnImpact) {
  for (const double step : kSteps) {
    const End end = end_of(with_step(dropped(1.0, 0.5), step), {"when K falls below 4 J"});
    EXPECT_NEAR(end.run.time(), std::sqrt(2.0 / kG), 1e-13);
    EXPECT_NEAR(end.run.totals().kinetic(), 0.25 * kG, 1e-12);
  }
}

// A block slides to a stop under friction; a ball's bounces die out.
TEST(StopWatch, AllComesToRest) {
  Body block = disc("block", {0.0, 0.1}, {1.0, 0.0});
  block.shape = Box{0.4, 0.2};
  RunSetup slides = setup_with({wall("floor", {0.0, -0.5}, 10.0, 1.0), block}, 0.0, 0.3);
  slides.scene.forces.gravity = {0.0, -kG};
  slides.method.contacts = ContactsId::kLasting;
  for (const double step : kSteps) {
    const End end = end_of(with_step(slides, step), {"when all is at rest"}, 3.0);
    ASSERT_EQ(end.stop, 0U);
    EXPECT_NEAR(end.run.time(), (1.0 - kRestSpeed) / (0.3 * kG), 1e-9) << step;
  }
  const double fall = std::sqrt(0.2 / kG);
  for (const ContactsId contacts : {ContactsId::kImpulse, ContactsId::kLasting}) {
    RunSetup bounces = dropped(0.1, 0.5);
    bounces.method.contacts = contacts;
    const End end = end_of(bounces, {"when all is at rest"}, 3.0);
    ASSERT_EQ(end.stop, 0U) << static_cast<int>(contacts);
    // Under lasting contacts it rests as soon as contact forces take over its bounces, which are left out.
    const double within = contacts == ContactsId::kImpulse ? 2e-6 : 2.0 * bounces.method.step;
    EXPECT_NEAR(end.run.time(), fall * (1.0 + 2.0), within) << static_cast<int>(contacts);  // Σ 2 eⁿ = 2
  }
}

// Who stands still for a moment, or from the beginning, does not come to rest.
TEST(StopWatch, TurningBackIsNoRest) {
  RunSetup thrown = setup_with({disc("A", {0.0, 0.0}, {0.0, 0.25 * kG})});
  thrown.scene.forces.gravity = {0.0, -kG};
  thrown.method.step = 0.125;  // it turns at the end of the second step
  EXPECT_EQ(end_of(thrown, {"when all is at rest"}, 1.0).stop, std::nullopt);
  RunSetup still = setup_with({disc("A", {0.0, 0.0}, {0.0, 0.0})});
  EXPECT_EQ(end_of(still, {"when all is at rest"}, 1.0).stop, std::nullopt);
}

// Under impacts at the step's end, too, and under every integrator that may.
TEST(StopWatch, ImpactsAtTheStepsEndStopThere) {
  RunSetup setup = with_step(dropped(1.0, 0.8), 0.02);
  setup.method.impacts = ImpactsId::kStepEnd;
  const End end = end_of(setup, {"at the 2nd impact"});
  ASSERT_EQ(end.stop, 0U);
  EXPECT_EQ(end.run.impact_count(), 2);
  EXPECT_NEAR(std::remainder(end.run.time(), 0.02), 0.0, 1e-12);
}

// The state there is that of a run that was told the moment beforehand.
TEST(StopWatch, StopsInATrueStateOfTheRun) {
  RunSetup setup = dropped(1.0, 0.8);
  setup.scene.bodies.push_back(disc("other", {3.0, 0.7}, {0.5, 0.0}));
  setup.scene.forces.quadratic_drag = 0.1;
  for (const char* const sentence :
       {"at the 3rd impact", "when ball passes y = 0.5 m", "when K falls below 2 J"}) {
    const End end = end_of(setup, {sentence});
    ASSERT_EQ(end.stop, 0U);
    Simulation told(setup);
    told.advance_to(end.run.time());
    EXPECT_NEAR((told.state().q - end.run.state().q).norm(), 0.0, 1e-14) << sentence;
    EXPECT_NEAR((told.state().v - end.run.state().v).norm(), 0.0, 1e-13) << sentence;
    EXPECT_EQ(told.impact_count(), end.run.impact_count());
    EXPECT_NEAR(end.run.ledger().numerical_drift(end.run.totals().energy()), 0.0, 1e-6);
  }
}

// A body that comes in later is waited for; without a stop that comes nothing changes by a bit.
TEST(StopWatch, WaitsForBodiesThatComeIn) {
  RunSetup setup = dropped(1.0, 0.8);
  setup.edits = {{0.5, 1, SceneEdits{Add<Body>{disc("late", {2.0, 5.0}, {0.0, 0.0})}}}};
  const End end = end_of(setup, {"when late passes y = 4 m"});
  ASSERT_EQ(end.stop, 0U);
  EXPECT_NEAR(end.run.time(), 0.5 + std::sqrt(2.0 / kG), 1e-12);
  Simulation plain(setup);
  plain.advance_to(2.0);
  const End watched =
      end_of(setup, {"when late passes y = 99 m", "at the 99th impact", "when all is at rest"}, 2.0);
  EXPECT_EQ(watched.stop, std::nullopt);
  EXPECT_TRUE(test::same_bytes(plain.state(), watched.run.state()));
}

}  // namespace
}  // namespace carom
