#include "physics/study/study.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "physics/check/measure_run.h"
#include "physics/compare/chaos.h"
#include "physics/compare/comparison.h"
#include "physics/compare/reference.h"
#include "physics/dynamics/integrators/integrators.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/study/study_table.h"
#include "tests/support/body_literal.h"
#include "tests/support/scenes.h"
#include "tests/support/source_folder.h"

namespace carom {
namespace {

using namespace test::literals;

using test::disc;
using test::wall;

// --- fitted orders

std::vector<ErrorAtStep> errors_of(const auto& error) {
  std::vector<ErrorAtStep> out;
  for (double h = 0.1; h > 5e-4; h *= 0.5) out.push_back({h, error(h)});
  return out;
}

TEST(OrderFit, FindsAPower) {
  const OrderFit fit = fit_order(errors_of([](double h) { return 3.0 * std::pow(h, 4.0); }), 1e-18, 1.0);
  ASSERT_EQ(fit.kind, OrderFit::Kind::kOrder);
  EXPECT_NEAR(fit.order, 4.0, 1e-12);
  EXPECT_NEAR(fit.uncertainty, 0.0, 1e-12);
  EXPECT_EQ(fit.points, 8);
  EXPECT_NEAR(fit.to, 0.1, 1e-15);
  EXPECT_NEAR(fit.from, 0.1 / 128.0, 1e-15);
}

TEST(OrderFit, LeavesOutWhatIsNearRoundingOrTooLarge) {
  const auto error = [](double h) { return h > 0.04 ? 0.6 : std::max(h * h * h, 1e-8); };
  const OrderFit fit = fit_order(errors_of(error), 2e-9, 0.5);
  EXPECT_NEAR(fit.order, 3.0, 1e-9);
  EXPECT_EQ(fit.points, 3);  // those with 2e-7 < h³ < 0.5: 0.025, 0.0125, 0.00625
}

TEST(OrderFit, LeavesOutStepsTooCoarseForTheOrderToShow) {
  const OrderFit fit = fit_order(errors_of([](double h) { return h + 40.0 * h * h; }), 1e-16, 10.0);
  EXPECT_LT(fit.to, 0.1);
  EXPECT_NEAR(fit.from, 0.1 / 128.0, 1e-15);
  EXPECT_LT(fit.order, 1.45);
}

TEST(OrderFit, TakesAllOfScatteredErrors) {
  int k = 0;
  const OrderFit fit =
      fit_order(errors_of([&k](double h) { return h * (++k % 2 == 0 ? 3.0 : 1.0); }), 1e-16, 10.0);
  EXPECT_EQ(fit.points, 8);
  EXPECT_NEAR(fit.order, 1.0, 0.3);
  EXPECT_GT(fit.uncertainty, 0.05);
}

TEST(OrderFit, RoundingAtEveryStepIsExact) {
  const OrderFit fit = fit_order(errors_of([](double h) { return 1e-15 / h; }), 2e-15, 1.0);
  EXPECT_EQ(fit.kind, OrderFit::Kind::kExact);
  EXPECT_EQ(text_of(fit), "exact here");
}

TEST(OrderFit, FewerThanThreeErrorsHaveNoOrder) {
  const OrderFit fit = fit_order(errors_of([](double h) { return h > 0.03 ? h : 1.0; }), 1e-16, 0.5);
  EXPECT_EQ(fit.kind, OrderFit::Kind::kNone);
  EXPECT_EQ(text_of(fit), "no order");
  EXPECT_EQ(fit_order({}, 1e-16, 1.0).kind, OrderFit::Kind::kNone);
}

// --- matched impacts

RunSummary recorded(std::vector<TimedImpact> impacts, double x, double v) {
  RunSummary run;
  run.state.resize(3);
  run.state.q.setZero();
  run.state.v.setZero();
  run.state.q(0, 1) = x;
  run.state.v(0, 1) = v;
  run.state.q(0, 2) = 2.0 * x;
  run.impacts = std::move(impacts);
  run.energy = x;
  return run;
}

const std::vector<MovingBody> kMoving = {{1, 0.1}, {2, 0.5}};

TEST(Compare, PairsTheKthImpactsOfAPair) {
  const auto reference =
      recorded({{0.5, 0_b, 1_b}, {0.6, 0_b, 2_b}, {1.5, 0_b, 1_b}, {3.0, 0_b, 1_b}}, 1.0, 1.0);
  const auto run = recorded({{0.51, 0_b, 1_b}, {0.597, 0_b, 2_b}, {1.46, 0_b, 1_b}, {3.2, 0_b, 1_b}}, 1.1, 0.7);
  const Comparison c = compare(run, reference, kMoving, 2.0);
  EXPECT_EQ(c.matched, 3);
  EXPECT_EQ(c.unmatched, 0);
  EXPECT_NEAR(c.impact_time_error, 0.04, 1e-12);
  EXPECT_NEAR(c.position_error, 0.2, 1e-12);  // of body 2, the worst
  EXPECT_NEAR(c.velocity_error, 0.3, 1e-12);
  EXPECT_NEAR(c.energy_error, 0.1, 1e-12);
}

// In metres, as the point of a body that its angle moves most.
TEST(Compare, TellsAnglesAndSpinsApart) {
  const auto reference = recorded({}, 1.0, 1.0);
  auto run = reference;
  run.state.q(2, 1) = -0.03;
  run.state.q(2, 2) = 0.02;
  run.state.v(2, 1) = 0.4;
  Comparison c = compare(run, reference, kMoving, 2.0);
  EXPECT_EQ(c.position_error, 0.0);
  EXPECT_EQ(c.velocity_error, 0.0);
  EXPECT_NEAR(c.angle_error, 0.5 * 0.02, 1e-15);
  EXPECT_NEAR(c.spin_error, 0.1 * 0.4, 1e-15);
  run.state.q(2, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isinf(compare(run, reference, kMoving, 2.0).angle_error));
}

TEST(Compare, AnglesCountAtTheOutline) {
  Body box = disc("box", Vec2::Zero(), Vec2::Zero());
  box.shape = Box{0.6, 0.8};
  Body point = disc("point", Vec2::Zero(), Vec2::Zero());
  point.inertia = 0.0;
  const auto moving = moving_bodies({disc("disc", Vec2::Zero(), Vec2::Zero(), 0.3), box, point});
  ASSERT_EQ(moving.size(), 3U);
  EXPECT_EQ(moving[0].radius, 0.3);
  EXPECT_NEAR(moving[1].radius, 0.5, 1e-15);
  EXPECT_EQ(moving[2].radius, 0.0) << "it doesn't turn";
}

TEST(Compare, LeavesOutVelocitiesWithinAnImpactsWindow) {
  const auto reference = recorded({{1.99, 0_b, 2_b}}, 1.0, 1.0);
  auto run = recorded({{2.01, 0_b, 2_b}}, 1.1, 0.7);
  run.state.v(0, 2) = 5.0;
  const Comparison c = compare(run, reference, kMoving, 2.0);
  EXPECT_EQ(c.left_out, 1);
  EXPECT_EQ(c.matched, 1);
  EXPECT_NEAR(c.impact_time_error, 0.02, 1e-12);
  EXPECT_NEAR(c.position_error, 0.2, 1e-12) << "places don't jump: body 2 counts, though it waits";
  EXPECT_NEAR(c.velocity_error, 0.3, 1e-12) << "of body 1 alone";
  EXPECT_TRUE(std::isnan(c.energy_error));
}

TEST(Compare, CountsImpactsWithoutAPartner) {
  const auto reference = recorded({{0.5, 0_b, 1_b}, {0.6, 0_b, 1_b}, {0.7, 1_b, 2_b}}, 1.0, 1.0);
  const auto run = recorded({{0.5, 0_b, 1_b}, {0.9, 0_b, 2_b}, {1.0, 0_b, 2_b}}, 1.0, 1.0);
  const Comparison c = compare(run, reference, kMoving, 2.0);
  EXPECT_EQ(c.matched, 1);
  EXPECT_EQ(c.unmatched, 4);
  EXPECT_EQ(c.impact_time_error, 0.0);
}

TEST(PlanTime, KeepsAwayFromImpacts) {
  EXPECT_EQ(plan_time({}, 2.0), 2.0);
  EXPECT_EQ(plan_time({{1.2, 0_b, 1_b}}, 2.0), 2.0);
  // Just before an impact that comes after the end, the widest gap of the last quarter is taken.
  EXPECT_NEAR(plan_time({{1.6, 0_b, 1_b}, {1.9, 0_b, 1_b}, {2.001, 0_b, 1_b}}, 2.0), 1.705, 1e-12);
  EXPECT_NEAR(plan_time({{1.0, 0_b, 1_b}, {1.9, 0_b, 1_b}, {2.001, 0_b, 1_b}}, 2.0), 1.5, 1e-12);
}

// --- neighbours

Method located(IntegratorId id, double step) {
  Method m;
  m.integrator = id;
  m.impacts = ImpactsId::kLocated;
  m.step = step;
  return m;
}

// A ball between two fixed discs on the line of their centres: an unstable periodic orbit. With the distance L
// that its centre goes and the sum a of the radii, neighbours part by 1 + L/a + √((L/a)² + 2L/a) a flight (the
// curvature of a front of neighbours, κ ↦ κ/(1 + Lκ) + 2/a, at its fixed point grows by 1 + Lκ).
TEST(Chaos, ExponentOfABallBetweenTwoDiscs) {
  Preset s = test::preset_with({disc("left", {-1.0, 0.0}, Vec2::Zero(), 0.5),
                                disc("right", {1.0, 0.0}, Vec2::Zero(), 0.5),
                                disc("ball", {0.0, 0.0}, {1.0, 0.0}, 0.1)});
  s.scene.bodies[0].fixed = s.scene.bodies[1].fixed = true;
  constexpr double kA = 0.6;
  constexpr double kL = 2.0 - 2.0 * kA;
  const double factor = 1.0 + kL / kA + std::sqrt(kL / kA * kL / kA + 2.0 * kL / kA);
  const double exponent = std::log(factor) / kL;  // at 1 m/s
  const Chaos c = follow_neighbours(setup_of(s), located(IntegratorId::kRk4, 0.01), 30.0, 1);
  EXPECT_NEAR(c.exponent, exponent, 0.05 * exponent);
  // Rounding of the length, some 0.5 m, grows to 1e-3 of 0.1 m.
  const double expected = std::log(kVisible * 0.1 / (2.2e-16 * c.length)) / exponent;
  EXPECT_NEAR(c.horizon, expected, 0.15 * expected);
  EXPECT_NEAR(std::log(c.growth_at(8.0) / c.growth_at(4.0)), 4.0 * exponent, 0.15 * 4.0 * exponent);
}

TEST(Chaos, AFallingBallHasNone) {
  Preset s =
      test::preset_with({wall("floor", {0.0, -0.5}, 4.0, 1.0), disc("ball", {0.0, 1.0}, {0.1, 0.0})}, 0.9);
  s.scene.forces.gravity = {0.0, -9.81};
  const Chaos c = follow_neighbours(setup_of(s), located(IntegratorId::kRk4, 0.01), 2.0, 1);
  EXPECT_EQ(c.exponent, 0.0);
  EXPECT_TRUE(std::isinf(c.horizon));
  EXPECT_LT(c.growth_at(2.0), 30.0);
  EXPECT_EQ(c.followed, 2.0);
  EXPECT_NEAR(c.size, 0.1, 1e-15);
}

TEST(Chaos, IsTheSameWithAnyNumberOfThreads) {
  const Preset s = test::preset_with({disc("a", {-1.0, 0.0}, {1.0, 0.0}), disc("b", {1.0, 0.05}, {-1.0, 0.0})});
  const Method m = located(IntegratorId::kRk4, 0.01);
  EXPECT_EQ(follow_neighbours(setup_of(s), m, 3.0, 1).growth, follow_neighbours(setup_of(s), m, 3.0, 4).growth);
}

// --- reference and study

// A disc on a spring, x'' = -25 x, with and without the wall at x = 0 that it meets at its fastest.
Preset spring_scene() {
  Preset s = test::preset_with({disc("disc", {1.0, 0.0}, Vec2::Zero())});
  s.scene.forces.springs.push_back({"", "disc", "", Vec2::Zero(), 25.0, 0.0, 0.0, SpringActs::kBoth});
  s.method = located(IntegratorId::kRk4, 0.05);
  s.duration = 3.0;
  return s;
}

TEST(Reference, ItsOwnErrorIsHonest) {
  const Preset s = spring_scene();
  const Chaos chaos = follow_neighbours(setup_of(s), study_reference_method(setup_of(s)), 3.0, 1);
  const Reference r = make_reference(setup_of(s), chaos, 3.0, 3.3);
  EXPECT_TRUE(r.converged);
  EXPECT_FALSE(r.exact);
  EXPECT_GT(r.halvings, 1);
  EXPECT_LT(r.position_error, 1e-12);
  EXPECT_NEAR(r.run.state.q(0, 0), std::cos(5.0 * 3.0), 30.0 * r.position_error + 1e-14);
}

TEST(Reference, IsExactFlightWhereThatIsAllowed) {
  Preset s = spring_scene();
  EXPECT_NE(study_reference_method(setup_of(s)).integrator, IntegratorId::kExactFlight);
  s.scene.forces.springs.clear();
  EXPECT_EQ(study_reference_method(setup_of(s)).integrator, IntegratorId::kExactFlight);
  EXPECT_EQ(study_reference_method(setup_of(s)).impacts, ImpactsId::kLocated);
}

// Contact forces are found for a whole step or a part of one: not even exact flight is free of it.
TEST(Reference, IsRefinedWhereContactsLast) {
  Preset s = read_preset(test::preset_file("friction/slide-to-roll.json"));
  constexpr double kRolls = 0.52;  // s: just after the slip has ended
  const Chaos chaos = follow_neighbours(setup_of(s), study_reference_method(setup_of(s)), kRolls, 1);
  const Reference r = make_reference(setup_of(s), chaos, kRolls, kRolls);
  EXPECT_EQ(r.method.integrator, IntegratorId::kExactFlight);
  EXPECT_FALSE(r.exact);
  EXPECT_GT(r.halvings, 0);
  EXPECT_LT(r.position_error, 1e-9);
  const std::vector<StatedFigure> figures = check_stated_figures(s, r.method, kRolls);
  EXPECT_FALSE(figures.empty());
  for (const StatedFigure& f : figures) EXPECT_LT(f.difference, 1e-9) << f.text;
  s.method.contacts = ContactsId::kImpulse;
  EXPECT_TRUE(make_reference(setup_of(s), chaos, kRolls, kRolls).exact);
}

// A torque that rises for 2 s turns a disc where it is: the angle is τ(t²/2 - t + 2/3)/I at t >= 2 s.
Preset flywheel() {
  Preset s = test::preset_with({disc("wheel", {0.0, 0.0}, Vec2::Zero(), 0.5, 2.0)});
  s.scene.forces.applied.push_back({"wheel", Vec2::Zero(), 0.5, 0.0, 2.0, std::nullopt});
  s.method = located(IntegratorId::kRk4, 0.02);
  s.duration = 3.0;
  return s;
}

// Neither the position nor the first pair of runs tells that the reference is right.
TEST(Reference, IsRefinedUntilAnglesAgree) {
  Preset s = flywheel();
  s.scene.bodies[0].spin = 40.0;
  const Chaos chaos = follow_neighbours(setup_of(s), study_reference_method(setup_of(s)), 3.0, 1);
  EXPECT_NEAR(chaos.arc, 0.5 * (40.0 * 3.0 + 0.5 * (4.5 - 3.0 + 2.0 / 3.0) / 0.25), 1e-9);
  EXPECT_NEAR(chaos.largest_rim_speed, 0.5 * (40.0 + 0.5 * 2.0 / 0.25), 1e-9);
  const Reference r = make_reference(setup_of(s), chaos, 3.0, 3.3);
  EXPECT_TRUE(r.converged);
  EXPECT_EQ(r.position_error, 0.0);
  EXPECT_LT(r.angle_error, 1e-10);
  EXPECT_NEAR(r.run.state.q(2, 0), 120.0 + 0.5 * (4.5 - 3.0 + 2.0 / 3.0) / 0.25, 1e-11);
}

StudyOptions quick() {
  StudyOptions o;
  o.steps = {0.08, 0.04, 0.02, 0.01, 0.005, 0.0025};
  o.tolerances = {1e-5, 1e-8};
  o.repeats = 1;
  o.threads = 2;
  return o;
}

const StudyGroup& group_of(const std::vector<StudyGroup>& groups, IntegratorId integrator, ImpactsId impacts) {
  for (const StudyGroup& g : groups) {
    if (g.integrator == integrator && g.impacts == impacts) return g;
  }
  throw std::out_of_range("no such group");
}

TEST(Study, ShowsWhatLocatedImpactsAreWorth) {
  const Preset s = read_preset(test::preset_file("numerical-methods/drag-projectile.json"));
  const StudyTable table = run_study(s, "drag-projectile", quick());
  ASSERT_EQ(table.rows.size(), plan_methods(s, quick()).size());
  const auto groups = groups_of(table);
  for (const IntegratorChoice& integrator : kIntegrators) {
    if (integrator.adaptive || integrator.order == 0) continue;
    const StudyGroup& located_ones = group_of(groups, integrator.id, ImpactsId::kLocated);
    EXPECT_NEAR(located_ones.fit.order, integrator.order, 0.15) << integrator.label;
    const StudyGroup& late = group_of(groups, integrator.id, ImpactsId::kStepEnd);
    EXPECT_LT(late.fit.order, 1.6) << integrator.label;
    EXPECT_GT(late.rows.back().position_error, 1e-3) << integrator.label;
  }
  EXPECT_LT(group_of(groups, IntegratorId::kRk4, ImpactsId::kLocated).rows.back().position_error, 1e-10);
  EXPECT_EQ(table.facts.time, 2.0);
  EXPECT_NE(table.facts.stated.find("own figures"), std::string::npos);
  EXPECT_TRUE(std::isinf(table.facts.horizon));
  // The Eulers' disc may come to rest at a coarse step; no run may blow up.
  for (const StudyRow& row : table.rows) EXPECT_FALSE(row.status.starts_with("blew up")) << row.status;
}

TEST(Study, SaysExactHereWhereAMethodIs) {
  const Preset s = read_preset(test::preset_file("bounces/bouncing-ball.json"));
  const StudyTable table = run_study(s, "bouncing-ball", quick());
  EXPECT_LT(table.facts.time, 4.06);  // before the ball comes to rest
  for (const StudyGroup& g : groups_of(table)) {
    const IntegratorChoice& integrator = choice_of(kIntegrators, g.integrator);
    const bool exact = integrator.exact_under_gravity && g.impacts == ImpactsId::kLocated;
    EXPECT_EQ(g.fit.kind == OrderFit::Kind::kExact, exact) << integrator.label;
    if (integrator.order == 0) {
      EXPECT_EQ(g.rows.size(), 1U);
    }
  }
}

// Nothing of the flywheel moves but its angle. Explicit Euler's spin is behind by hα/2 from the torque's rise,
// and its angle by h(ω + ∫α dt)/2 = hω: 0.08 rad at h = 20 ms.
TEST(Study, SaysThatAFlywheelsAngleIsWrong) {
  const StudyTable table = run_study(flywheel(), "flywheel", quick());
  const auto groups = groups_of(table);
  for (const StudyGroup& g : groups) {
    const IntegratorChoice& integrator = choice_of(kIntegrators, g.integrator);
    for (const StudyRow& row : g.rows) EXPECT_EQ(row.position_error, 0.0);
    EXPECT_EQ(g.fit.kind, OrderFit::Kind::kExact);
    if (integrator.id == IntegratorId::kExplicitEuler) {
      ASSERT_EQ(g.verdict().kind, OrderFit::Kind::kOrder) << integrator.label;
      EXPECT_TRUE(g.is_of_angle());
      EXPECT_NEAR(g.verdict().order, 1.0, 0.05) << integrator.label;
    } else if (integrator.order >= 4) {
      EXPECT_EQ(g.verdict().kind, OrderFit::Kind::kExact) << integrator.label;
    }
  }
  const StudyGroup& euler = group_of(groups, IntegratorId::kExplicitEuler, ImpactsId::kLocated);
  EXPECT_NEAR(euler.rows[2].angle_error, 0.5 * 0.02 * 4.0, 5e-4);  // at the rim
  EXPECT_NEAR(euler.rows[2].spin_error, 0.5 * 0.02 * 2.0 / 2.0, 1e-10);
  const std::string text = study_text(table);
  EXPECT_NE(text.find("order 1.00 ± 0.00 in angle (positions are exact)"), std::string::npos) << text;
  const std::vector<std::string> csv = study_csv(table);
  EXPECT_NE(csv[0].find("angle error [m],spin error [m/s],"), std::string::npos);
  EXPECT_NE(csv[1].find(",exact but for angles,"), std::string::npos) << csv[1];
}

// A disc slides and then rolls. Where the slip ends within a step the mean of its friction acts for all of it,
// and the position is off by up to μ g h²/8; the rest is exact, but for the Eulers' own error.
TEST(Study, FindsTheOrderWithRestingContacts) {
  const Preset s = read_preset(test::preset_file("friction/slide-to-roll.json"));
  const double slowing = s.scene.materials[0].kinetic_friction * 9.81;  // m/s²
  StudyOptions options = quick();
  options.until = 0.55;  // just after the slip has ended
  const StudyTable table = run_study(s, "slide-to-roll", options);
  const auto groups = groups_of(table);
  for (const StudyGroup& g : groups) {
    const IntegratorChoice& integrator = choice_of(kIntegrators, g.integrator);
    ASSERT_EQ(g.rows.size(), options.steps.size()) << integrator.label;
    EXPECT_EQ(g.rows.front().step_or_tolerance(), options.steps.front()) << integrator.label;
    if (!integrator.exact_under_gravity) {
      EXPECT_NEAR(g.fit.order, 1.0, 0.05) << integrator.label;
      continue;
    }
    for (const StudyRow& r : g.rows) {
      EXPECT_LT(r.position_error, slowing * r.method.step * r.method.step / 8.0 + 1e-10) << integrator.label;
    }
  }
  const std::vector<Method> without = plan_methods(spring_scene(), quick());
  for (const Method& m : without) EXPECT_EQ(m.contacts, ContactsId::kImpulse);
}

TEST(Study, SaysWhenARunBlewUp) {
  StudyOptions o = quick();
  o.integrators = {IntegratorId::kExplicitEuler};
  o.steps = {0.5, 0.001};
  Preset s = spring_scene();
  s.duration = 20.0;
  const StudyTable table = run_study(s, "spring", o);
  for (const StudyGroup& g : groups_of(table)) {
    EXPECT_TRUE(g.rows[0].status.starts_with("blew up")) << g.rows[0].status;
    EXPECT_TRUE(std::isnan(g.rows[0].position_error));
    EXPECT_TRUE(std::isnan(g.rows[0].wall_time));
    EXPECT_EQ(g.rows[1].status, "ok");
  }
}

std::string refusal(const auto& action) {
  try {
    action();
  } catch (const SceneError& error) {
    return error.what();
  }
  return "nothing was refused";
}

TEST(Study, RefusesExactFlightByNameWhereItCannotBe) {
  StudyOptions o = quick();
  for (const Method& m : plan_methods(spring_scene(), o)) EXPECT_NE(m.integrator, IntegratorId::kExactFlight);
  o.integrators = {IntegratorId::kExactFlight};
  EXPECT_NE(refusal([&] { (void)plan_methods(spring_scene(), o); }).find("spring"), std::string::npos);
}

// A gas of hard discs is chaotic: it is compared well before its horizon, and the text says so.
TEST(Study, OfAGasKeepsBeforeItsHorizon) {
  Preset s = test::preset_with(test::room(1.0, 0.2));
  GridGenerator g;
  g.columns = g.rows = 4;
  g.origin = {-0.6, -0.6};
  g.spacing = {0.4, 0.4};
  g.jitter = 0.02;
  g.radius_min = g.radius_max = 0.08;
  g.speed_max = 1.0;
  s.scene.generators.push_back(g);
  s.method = located(IntegratorId::kRk4, 0.01);
  s.duration = 30.0;
  StudyOptions o = quick();
  o.integrators = {IntegratorId::kRk4, IntegratorId::kExactFlight};
  const StudyTable table = run_study(s, "gas", o);
  EXPECT_GT(table.facts.exponent, 0.5);
  EXPECT_LT(table.facts.horizon, 30.0);
  EXPECT_LT(table.facts.time, 0.51 * table.facts.horizon);
  EXPECT_LT(table.facts.growth, 500.0);
  const std::string text = study_text(table);
  EXPECT_NE(text.find("CHAOTIC"), std::string::npos);
  EXPECT_EQ(group_of(groups_of(table), IntegratorId::kRk4, ImpactsId::kLocated).fit.kind,
            OrderFit::Kind::kExact);
  o.until = 30.0;
  o.integrators = {IntegratorId::kRk4};
  o.impacts = {ImpactsId::kLocated};
  const StudyTable late = run_study(s, "gas", o);
  EXPECT_EQ(late.facts.time, 30.0);
  EXPECT_NE(late.facts.remarks.find("WARNING"), std::string::npos);
}

}  // namespace
}  // namespace carom
