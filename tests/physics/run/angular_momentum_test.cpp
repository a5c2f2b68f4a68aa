#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/ledger/ledger_entries.h"
#include "physics/math/vectors.h"
#include "physics/preset/preset_file.h"
#include "tests/support/preset_files.h"
#include "tests/support/resumed_run.h"
#include "tests/support/scenes.h"

// The balance of angular momentum about the origin, against closed forms.
namespace carom {
namespace {

using test::disc;
using test::setup_with;
using test::wall;

constexpr double kGravity = 9.81;  // m/s²

Method method_of(IntegratorId integrator, double step = 0.01, ImpactsId impacts = ImpactsId::kLocated,
                 ContactsId contacts = ContactsId::kImpulse) {
  Method m;
  m.integrator = integrator;
  m.step = step;
  m.impacts = impacts;
  m.contacts = contacts;
  return m;
}

Simulation run_of(RunSetup setup, const Method& method, double until) {
  setup.method = method;
  Simulation run(setup);
  run.advance_to(until);
  return run;
}

double drift(const Simulation& run) {
  return run.ledger().angular_momentum_drift(run.totals().angular_momentum);
}

// kg m²/s: the sum of the entries' absolute values, the scale of rounding.
double turnover(const Simulation& run) {
  const Ledger ledger = run.ledger();
  double sum = 0.0;
  for (const MomentumEntry& entry : kMomentumEntries) sum += std::abs(ledger.*entry.angular);
  return sum;
}

Body box(const std::string& name, Vec2 position, double width, double height, Vec2 velocity = Vec2::Zero()) {
  Body b = disc(name, position, velocity);
  b.shape = Box{width, height};
  return b;
}

RunSetup projectile() {
  RunSetup s = setup_with({wall("floor", {3.0, -0.5}, 20.0, 1.0), disc("ball", {3.0, 1.1}, {0.7, 0.0})}, 0.8);
  s.scene.forces.gravity = {0.0, -kGravity};
  return s;
}

// x = 3 + 0.7 t whatever the floor does. Gravity turns with -m g ∫x dt, each bounce with x j.
TEST(AngularMomentum, OfAProjectileThatBouncesAwayFromTheOrigin) {
  for (const IntegratorChoice& integrator : kIntegrators) {
    if (!integrator.exact_under_gravity) continue;
    RunSetup setup = projectile();
    setup.method = method_of(integrator.id);
    Simulation run(setup);
    double to_floor = 0.0;
    run.advance_to(1.5, [&] {
      for (const ImpactRecord& i : run.last_impacts()) to_floor -= (3.0 + 0.7 * i.time) * i.normal_impulse;
    });
    const Ledger ledger = run.ledger();
    ASSERT_GE(run.impact_count(), 2);
    EXPECT_NEAR(ledger.initial_angular_momentum, -1.1 * 0.7, 1e-15);
    EXPECT_NEAR(ledger.angular_momentum_from_gravity, -kGravity * (3.0 * 1.5 + 0.7 * 1.5 * 1.5 / 2.0), 1e-11);
    EXPECT_NEAR(ledger.angular_momentum_to_walls, to_floor, 1e-11);
    EXPECT_EQ(ledger.angular_momentum_from_forces, 0.0);
    EXPECT_EQ(ledger.angular_momentum_from_user, 0.0);
    EXPECT_LT(std::abs(drift(run)), 1e-13 * turnover(run)) << integrator.label;
  }
}

// Between the ends of steps trajectories run on: the balance is that of the moment.
TEST(AngularMomentum, ClosesAtEveryStep) {
  for (const ImpactsId impacts : {ImpactsId::kLocated, ImpactsId::kStepEnd}) {
    RunSetup setup = projectile();
    setup.scene.bodies.push_back(disc("other", {3.4, 2.0}, {-0.3, 0.0}, 0.2, 3.0));
    setup.scene.bodies.back().spin = 5.0;
    setup.scene.materials = {{"default", 0.8, 0.0, 0.4, 0.4}};
    setup.method = method_of(IntegratorId::kExactFlight, 0.003, impacts);
    if (impacts == ImpactsId::kStepEnd) setup.method.integrator = IntegratorId::kRk4;
    Simulation run(setup);
    double pushed = 0.0;  // out of penetrations
    run.advance_to(2.0, [&] {
      if (impacts == ImpactsId::kLocated) {
        EXPECT_LT(std::abs(drift(run)), 1e-12 * turnover(run)) << run.time();
      }
      pushed = drift(run);
    });
    EXPECT_GT(run.impact_count(), 3);
    EXPECT_LT(std::abs(pushed), 0.01 * turnover(run));
  }
}

// Semi-implicit Euler keeps the balance to rounding, explicit Euler to its order: it is off by m h² v × g a
// step.
TEST(AngularMomentum, DriftIsTheMethods) {
  RunSetup setup = setup_with({disc("ball", {3.0, 1.0}, {0.7, 2.0})});
  setup.scene.forces.gravity = {0.0, -kGravity};
  const auto drift_of = [&](IntegratorId id, double h) { return drift(run_of(setup, method_of(id, h), 1.0)); };
  EXPECT_LT(std::abs(drift_of(IntegratorId::kSemiImplicitEuler, 0.01)), 1e-12);
  for (const double h : {0.02, 0.01, 0.005})
    EXPECT_NEAR(drift_of(IntegratorId::kExplicitEuler, h), -h * 0.7 * kGravity, 1e-11) << h;
}

// Nothing from outside acts: all impacts together leave it what it was.
TEST(AngularMomentum, IsKeptByImpactsOfFreeBodies) {
  for (const ImpactsId impacts : {ImpactsId::kLocated, ImpactsId::kStepEnd}) {
    for (const double friction : {0.0, 0.5}) {
      RunSetup setup = setup_with({box("a", {2.0, 1.0}, 0.4, 0.2, {1.0, 0.0}), box("b", {3.0, 1.15}, 0.3, 0.3)},
                                  0.7, friction);
      setup.scene.bodies[0].spin = 2.0;
      const Simulation run = run_of(setup, method_of(IntegratorId::kRk4, 0.01, impacts), 1.5);
      ASSERT_GT(run.impact_count(), 0);
      const Ledger ledger = run.ledger();
      EXPECT_EQ(ledger.expected_angular_momentum(), ledger.initial_angular_momentum);
      if (impacts == ImpactsId::kLocated) {
        EXPECT_LT(std::abs(drift(run)), 1e-14);
      }
    }
  }
}

TEST(AngularMomentum, OfAFlywheelUnderATorque) {
  RunSetup setup = setup_with({disc("wheel", {1.0, 2.0}, Vec2::Zero(), 0.5, 2.0)});
  setup.scene.forces.applied.push_back({"wheel", Vec2::Zero(), 3.0, 0.25, 0.5, std::nullopt});
  for (const IntegratorId id : {IntegratorId::kRk4, IntegratorId::kDormandPrince}) {
    const Simulation run = run_of(setup, method_of(id), 2.0);
    EXPECT_NEAR(run.ledger().angular_momentum_from_forces, 3.0 * (0.25 + 1.25), 1e-12);
    EXPECT_NEAR(run.totals().angular_momentum, 3.0 * (0.25 + 1.25), 1e-12);
  }
}

// A constant force turns about the origin as its body moves: quadratic in time, and exact in exact flight.
TEST(AngularMomentum, OfAConstantForceAndTorque) {
  RunSetup setup = setup_with({disc("puck", {1.0, 2.0}, {0.5, -0.25}, 0.5, 2.0)});
  setup.scene.forces.gravity = {0.0, -kGravity};
  setup.scene.forces.applied.push_back({"puck", {4.0, -1.0}, 3.0, 0.0, 0.0, std::nullopt});
  constexpr double kT = 1.5;
  // ∫x dt with x'' = 2, y'' = -0.5 - g.
  const double x = 1.0 * kT + 0.5 * kT * kT / 2.0 + 2.0 * kT * kT * kT / 6.0;
  const double y = 2.0 * kT - 0.25 * kT * kT / 2.0 - (0.5 + kGravity) * kT * kT * kT / 6.0;
  for (const IntegratorId id : {IntegratorId::kExactFlight, IntegratorId::kRk4, IntegratorId::kDormandPrince}) {
    const Simulation run = run_of(setup, method_of(id, 0.1), kT);
    EXPECT_NEAR(run.ledger().angular_momentum_from_forces, x * -1.0 - y * 4.0 + 3.0 * kT, 1e-11);
    EXPECT_NEAR(run.ledger().angular_momentum_from_gravity, -2.0 * kGravity * x, 1e-11);
    EXPECT_LT(std::abs(drift(run)), 1e-11) << choice_of(kIntegrators, id).label;
  }
}

// A force that acts between two bodies gives nothing.
TEST(AngularMomentum, IsKeptByAttractionAndSprings) {
  RunSetup setup =
      setup_with({disc("sun", {2.0, 0.0}, {0.0, -0.1}, 0.1, 10.0), disc("planet", {3.0, 0.0}, {0.0, 3.0}, 0.05),
                  disc("moon", {3.0, 1.0}, {0.5, 0.0}, 0.05)});
  setup.scene.forces.attraction = Attraction{1.0, 0.1};
  setup.scene.forces.springs.push_back({"", "planet", "moon", Vec2::Zero(), 20.0, 1.0, 0.5, SpringActs::kBoth});
  const Simulation run = run_of(setup, method_of(IntegratorId::kRk4, 0.0005), 1.0);
  EXPECT_EQ(run.ledger().expected_angular_momentum(), run.ledger().initial_angular_momentum);
  EXPECT_LT(std::abs(drift(run)), 1e-9);
}

// Rods and springs to one point give the torque of that point: where × the momentum they gave.
TEST(AngularMomentum, OfAPendulum) {
  const Vec2 anchor(1.0, 2.0);
  for (const bool spring : {false, true}) {
    RunSetup setup = setup_with({disc("bob", {1.6, 1.2}, {0.2, 0.0}, 0.1, 2.0)});
    setup.scene.forces.gravity = {0.0, -kGravity};
    if (spring) {
      setup.scene.forces.springs.push_back({"", "bob", "", anchor, 50.0, 0.5, 1.0, SpringActs::kBoth});
    } else {
      Joint rod;
      rod.body = "bob";
      rod.anchor = anchor;
      setup.scene.joints = {rod};
    }
    const Simulation run = run_of(setup, method_of(IntegratorId::kRk4, 0.001), 1.7);
    const Ledger ledger = run.ledger();
    EXPECT_NEAR(ledger.angular_momentum_from_forces, cross(anchor, ledger.momentum_from_forces), 1e-9);
    EXPECT_GT(std::abs(ledger.angular_momentum_from_forces), 1.0);
    EXPECT_LT(std::abs(drift(run)), 1e-9) << spring;
  }
}

// A weld to the plane takes torques too: the body stays where it is.
TEST(AngularMomentum, OfAWeldThatTakesATorque) {
  RunSetup setup = setup_with({box("sign", {2.0, 1.0}, 0.5, 0.2)});
  setup.scene.forces.gravity = {0.0, -kGravity};
  setup.scene.forces.applied.push_back({"sign", Vec2::Zero(), 3.0, 0.0, 0.0, std::nullopt});
  Joint weld;
  weld.kind = JointKind::kWeld;
  weld.body = "sign";
  weld.point = Vec2(-0.25, 0.0);
  weld.anchor = Vec2(1.75, 1.0);
  setup.scene.joints = {weld};
  const Simulation run = run_of(setup, method_of(IntegratorId::kRk4), 1.0);
  EXPECT_NEAR(run.ledger().angular_momentum_from_gravity, -2.0 * kGravity, 1e-12);
  EXPECT_NEAR(run.ledger().angular_momentum_from_forces, 2.0 * kGravity, 1e-12);
  EXPECT_LT(std::abs(drift(run)), 1e-12);
}

// Linear drag on a body in plane flight: L falls as e^(-bt/m), and drag took the difference.
TEST(AngularMomentum, OfDrag) {
  RunSetup setup = setup_with({disc("puck", {1.0, 2.0}, {3.0, -0.25}, 0.1, 2.0)});
  setup.scene.forces.linear_drag = 0.5;
  const Simulation run = run_of(setup, method_of(IntegratorId::kRk4), 2.0);
  const double first = 2.0 * cross(Vec2(1.0, 2.0), Vec2(3.0, -0.25));
  EXPECT_NEAR(run.ledger().angular_momentum_from_forces, first * (std::exp(-0.5) - 1.0), 1e-9);
  EXPECT_LT(std::abs(drift(run)), 1e-9);
}

// A box at rest: what gravity gives goes to the floor.
TEST(AngularMomentum, OfABoxThatRests) {
  RunSetup setup =
      setup_with({wall("floor", {3.0, -0.5}, 20.0, 1.0), box("box", {3.0, 0.1}, 0.4, 0.2)}, 0.0, 0.5);
  setup.scene.forces.gravity = {0.0, -kGravity};
  const Simulation run =
      run_of(setup, method_of(IntegratorId::kRk4, 0.01, ImpactsId::kLocated, ContactsId::kLasting), 1.0);
  EXPECT_NEAR(run.ledger().angular_momentum_from_gravity, -3.0 * kGravity, 1e-9);
  EXPECT_NEAR(run.ledger().angular_momentum_to_walls, -3.0 * kGravity, 1e-9);
  EXPECT_LT(std::abs(drift(run)), 1e-11);
}

// Friction and rolling resistance give to the floor what they take: a disc slides, rolls and slows down. What
// is left is of the order of the step, if the contact stays where it was at the step's start.
TEST(AngularMomentum, OfADiscThatRollsAwayFromTheOrigin) {
  const auto drift_at = [](double h) {
    RunSetup setup =
        setup_with({wall("floor", {3.0, -0.5}, 20.0, 1.0), disc("disc", {3.0, 0.1}, {2.0, 0.0})}, 0.0, 0.3);
    setup.scene.materials[0].rolling_resistance = 0.05;
    setup.scene.forces.gravity = {0.0, -kGravity};
    const Simulation run =
        run_of(setup, method_of(IntegratorId::kRk4, h, ImpactsId::kLocated, ContactsId::kLasting), 1.0);
    EXPECT_GT(run.ledger().lost_to_rolling, 0.1);
    return std::abs(drift(run));
  };
  // The weight times half of a step's way, a step.
  EXPECT_LT(drift_at(0.01), 0.5 * kGravity * 2.0 * 0.01);
  EXPECT_LT(drift_at(0.001), 0.5 * kGravity * 2.0 * 0.001);
}

// A point-like body doesn't turn: what friction would turn it with counts as given to walls.
TEST(AngularMomentum, OfPointLikeBodies) {
  RunSetup setup = setup_with({wall("floor", {3.0, -0.5}, 20.0, 1.0), disc("a", {3.0, 0.4}, {1.0, -1.0}),
                               disc("b", {3.6, 0.1}, {0.0, 0.5})},
                              0.8, 0.4);
  setup.scene.bodies[1].inertia = setup.scene.bodies[2].inertia = 0.0;
  const Simulation run = run_of(setup, method_of(IntegratorId::kRk4), 1.0);
  EXPECT_GE(run.impact_count(), 2);
  EXPECT_LT(std::abs(drift(run)), 1e-14);
}

TEST(AngularMomentum, OfABodyThatTheUserAdds) {
  RunSetup setup = projectile();
  setup.method = method_of(IntegratorId::kExactFlight);
  Simulation run(setup);
  run.advance_to(0.305);
  run.apply({Add<Body>{disc("new", {5.0, 1.0}, {0.0, 2.0}, 0.1, 3.0)}});
  run.advance_to(1.0);
  EXPECT_NEAR(run.ledger().angular_momentum_from_user, 5.0 * 3.0 * 2.0, 1e-13);
  EXPECT_LT(std::abs(drift(run)), 1e-12 * turnover(run));
}

// Every preset's balance closes as well as its momentum's, but for what pushes and the method's order leave.
TEST(AngularMomentum, OfEveryPresetInExactFlight) {
  for (const auto& file : test::preset_files()) {
    Preset preset = read_preset(file);
    if (why_not(preset.scene, IntegratorId::kExactFlight)) continue;
    preset.method.integrator = IntegratorId::kExactFlight;
    preset.method.impacts = ImpactsId::kLocated;
    preset.method.contacts = ContactsId::kImpulse;
    Simulation run(setup_of(preset));
    run.advance_to(run.time() + std::min(preset.duration, 100 * preset.method.step));
    if (run.ledger().penetration_correction != 0.0) continue;
    EXPECT_LT(std::abs(drift(run)), 1e-10 * (turnover(run) + 1.0)) << file;
  }
}

// A block slides down a smooth wedge that the floor carries: both accelerate, and the wedge's contacts push it
// in different directions.
TEST(AngularMomentum, OfABlockOnAFreeWedge) {
  constexpr double kSlope = std::numbers::pi / 6.0;
  for (const IntegratorChoice& integrator : kIntegrators) {
    if (integrator.adaptive) continue;
    for (const double step : {1.0 / 60.0, 0.005}) {
      Body wedge = disc("wedge", {0.4, 0.4 * std::tan(kSlope)}, {0.0, 0.0}, 0.1, 2.0);
      wedge.shape = Polygon{
          {{-0.4, -0.4 * std::tan(kSlope)}, {0.8, -0.4 * std::tan(kSlope)}, {-0.4, 0.8 * std::tan(kSlope)}}};
      Body block = box("block", turned_by(-kSlope, {0.0, 0.1}) + Vec2(0.3, 0.9 * std::tan(kSlope)), 0.2, 0.2);
      block.angle = -kSlope;
      RunSetup setup = setup_with({wall("floor", {0.0, -0.5}, 20.0, 1.0), wedge, block}, 0.0);
      setup.scene.forces.gravity = {0.0, -kGravity};
      const Simulation run =
          run_of(setup, method_of(integrator.id, step, ImpactsId::kLocated, ContactsId::kLasting), 0.3);
      EXPECT_GT(run.state().velocity(2).x(), 0.5) << integrator.name;
      EXPECT_NEAR(drift(run), 0.0, 1e-12) << integrator.name << ", h = " << step;
    }
  }
}

// Two boxes, one on the other, slide down a ramp as one with g (sin a - mu cos a). Friction between them turns
// the upper one by mu N h/2, which its corners' normal forces hold: N/2 (1 ± mu h/w). A force on a corner that
// stays behind where the bodies were is off by v dt/w.
TEST(AngularMomentum, OfAStackThatSlides) {
  constexpr double kWidth = 0.2;
  constexpr double kHeight = 0.1;
  for (const IntegratorId integrator : {IntegratorId::kRk4, IntegratorId::kVelocityVerlet}) {
    for (const double angle : {0.0, -0.35}) {
      const auto turned = [angle](const Vec2& v) { return turned_by(angle, v); };
      const double friction = angle == 0.0 ? 0.0 : 0.2;
      const Vec2 along = turned({1.0, 0.0});
      std::vector<Body> bodies = {wall("floor", turned({0.0, -0.5}), 60.0, 1.0, angle),
                                  box("lower", turned({0.0, 0.05}), 0.4, 0.1, along),
                                  box("upper", turned({0.0, 0.15}), kWidth, kHeight, along)};
      for (std::size_t i = 1; i < bodies.size(); ++i) bodies[i].angle = angle;
      bodies[1].mass = 2.0;
      RunSetup setup = setup_with(bodies, 0.0, friction);
      setup.scene.forces.gravity = {0.0, -kGravity};
      setup.method = method_of(integrator, 0.005, ImpactsId::kLocated, ContactsId::kLasting);
      Simulation run(setup);
      for (int step = 1; step <= 100; ++step) {
        run.advance_to(0.005 * step);
        ASSERT_LT(std::abs(drift(run)), 1e-13 * turnover(run)) << step << " angle " << angle;
        const double weight = kGravity * std::cos(angle);
        std::vector<double> on_upper;
        for (const ContactForce& f : run.contact_forces()) {
          if (f.a == 1 && f.b == 2) on_upper.push_back(f.normal_force);
        }
        ASSERT_EQ(on_upper.size(), 2U);
        std::sort(on_upper.begin(), on_upper.end());
        const double shift = friction * kHeight / kWidth;
        EXPECT_NEAR(on_upper[0], 0.5 * weight * (1.0 - shift), 1e-8) << step << " angle " << angle;
        EXPECT_NEAR(on_upper[1], 0.5 * weight * (1.0 + shift), 1e-8) << step << " angle " << angle;
      }
    }
  }
}

// --- saved runs

// The text of a saved run as programs wrote it before there was a balance of angular momentum.
std::string without_angular_momentum(const std::string& text) {
  auto json = nlohmann::ordered_json::parse(text);
  auto& state = json["state"];
  for (const MomentumEntry& entry : kMomentumEntries) state["ledger"].erase(std::string(entry.angular_key));
  return json.dump();
}

TEST(AngularMomentum, BalanceOfAnOlderFileBeginsWhereItWasSaved) {
  for (const ContactsId contacts : {ContactsId::kImpulse, ContactsId::kLasting}) {
    Preset preset = test::preset_with({});
    preset.scene = projectile().scene;
    preset.scene.bodies.push_back(disc("other", {3.4, 2.0}, {-0.3, 0.0}, 0.2, 3.0));
    preset.method = method_of(IntegratorId::kRk4, 0.01, ImpactsId::kLocated, contacts);
    Simulation whole(setup_of(preset));
    whole.advance_to(0.345);
    const std::string text = write_preset(saved_preset(preset, whole));
    Simulation old(setup_of(parse_preset(without_angular_momentum(text), "old")));
    EXPECT_EQ(old.status(), whole.status());
    EXPECT_TRUE(old.state().q == whole.state().q);
    EXPECT_LT(std::abs(drift(old)), 1e-13);
    const double since = whole.totals().angular_momentum;
    for (Simulation* run : {&whole, &old}) run->advance_to(1.2);
    EXPECT_LT((old.state().q - whole.state().q).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT((old.state().v - whole.state().v).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT(std::abs(drift(old) - drift(whole)), 1e-12 * turnover(whole));
    EXPECT_NE(old.totals().angular_momentum, since);
    // Read anew, all is there.
    const Simulation again(setup_of(test::saved_and_read(preset, whole)));
    EXPECT_EQ(drift(again), drift(whole));
  }
}

}  // namespace
}  // namespace carom
