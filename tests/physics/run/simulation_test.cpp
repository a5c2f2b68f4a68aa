#include "physics/run/simulation.h"

#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <random>

#include "physics/collision/pair_contact.h"
#include "physics/dynamics/integrators/integrators.h"
#include "physics/observe/observables.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "tests/support/impacts.h"
#include "tests/support/scenes.h"
#include "tests/support/source_folder.h"

namespace carom {
namespace {

using test::disc;
using test::preset_with;
using test::room;
using test::same_bytes;
using test::wall;

Preset preset(const std::string& file) { return read_preset(test::preset_file(file)); }

double observed(const Simulation& s, std::string_view name) {
  return find_observable(name)->value(reading_of(s, {}), {});
}

Preset gas(double restitution, double friction) {
  std::vector<Body> bodies = room(1.0, 0.5);
  std::mt19937_64 random(5);
  const auto draw = [&] { return static_cast<double>(random() >> 11) * 0x1p-52 - 1.0; };
  for (int i = 0; i < 9; ++i) {
    bodies.push_back(disc(fmt::format("d{}", i), {-0.6 + 0.6 * (i % 3), -0.6 + 0.6 * (i / 3)}, {draw(), draw()},
                          0.1 + 0.01 * i, 1.0 + 0.2 * i));
  }
  return preset_with(std::move(bodies), restitution, friction);
}

TEST(RunClock, CountsWholeSteps) {
  EXPECT_EQ(whole_steps(0.25, 0.1), 2.0);
  EXPECT_EQ(whole_steps(-0.25, 0.1), -3.0);
  EXPECT_LT(0.3 / 0.1, 3.0);  // by rounding
  EXPECT_EQ(whole_steps(0.3, 0.1), 3.0);
  EXPECT_EQ(whole_steps(-0.3, 0.1), -3.0);
}

TEST(Gas, HundredThousandElasticImpacts) {
  Simulation run(setup_of(gas(1.0, 0.0)));
  const Totals start = run.totals();
  double momentum_scale = 0.0;
  for (int i = 0; i < run.state().size(); ++i) {
    if (run.mass().inverse_mass[i] > 0.0) momentum_scale += run.mass().mass[i] * run.state().velocity(i).norm();
  }
  double to_walls = 0.0;
  ASSERT_TRUE(test::step_to_impact(run, 100'000, [&] {
    run.step(0.05);
    for (const ImpactRecord& r : run.last_impacts())
      to_walls += run.shapes().fixed[r.a] != 0 ? r.normal_impulse : 0.0;
  }));
  EXPECT_NEAR(run.totals().kinetic() / start.kinetic(), 1.0, 1e-12);
  const Vec2 all = run.totals().momentum + run.ledger().momentum_to_walls;
  EXPECT_LT((all - start.momentum).norm(), 1e-12 * (momentum_scale + to_walls));
  EXPECT_LT(std::abs(run.ledger().lost_to_restitution), 1e-12 * start.kinetic());
  EXPECT_LT(observed(run, "rightmost_x"), 1.0 + 1e-12);
  EXPECT_GT(observed(run, "leftmost_x"), -1.0 - 1e-12);
  EXPECT_LT(observed(run, "highest_y"), 1.0 + 1e-12);
  EXPECT_GT(observed(run, "lowest_y"), -1.0 - 1e-12);
  EXPECT_EQ(run.notices().text(), "ok");
}

TEST(Simulation, ThousandRadiiAStepStayInTheRoom) {
  for (const IntegratorChoice& choice : kIntegrators) {
    for (const double thickness : {1.0, 1e-6}) {
      for (const Vec2& gravity : {Vec2(0.0, 0.0), Vec2(0.0, -9.81)}) {
        std::vector<Body> bodies = room(1.0, thickness);
        const double h = 0.01;
        bodies.push_back(disc("d", {0.1, 0.2}, Vec2(0.8, 0.6) * 1000.0 * 0.02 / h, 0.02));
        Preset s = preset_with(std::move(bodies));
        s.scene.forces.gravity = gravity;
        s.method = {choice.id, ImpactsId::kLocated, ContactsId::kImpulse, h};
        Simulation run(setup_of(s));
        for (int i = 0; i < 1000; ++i) {
          run.step();
          ASSERT_LT(run.state().position(4).cwiseAbs().maxCoeff(), 0.98 + 1e-9)
              << choice.name << thickness << i;
        }
        EXPECT_GT(run.impact_count(), 5000);
      }
    }
  }
}

TEST(Ledger, DriftIsNothingWhereTheMethodIsExact) {
  Preset s = preset("bounces/bouncing-ball.json");
  Simulation run(setup_of(s));
  run.advance_to(3.9);  // before the ball rests
  EXPECT_GT(run.impact_count(), 10);
  EXPECT_LT(std::abs(run.ledger().numerical_drift(run.totals().energy())), 1e-12 * run.ledger().initial);
  EXPECT_GT(run.ledger().lost_to_restitution, 0.9 * 0.5 * 9.81);
}

TEST(Ledger, DragDriftFallsWithTheFourthPower) {
  Preset s = preset("numerical-methods/drag-projectile.json");
  const auto drift = [&](double h) {
    s.method.step = h;
    Simulation run(setup_of(s));
    run.advance_to(2.0);
    EXPECT_GT(run.ledger().lost_to_drag, 1.0);
    return std::abs(run.ledger().numerical_drift(run.totals().energy()));
  };
  const double coarse = drift(1.0 / 64);
  const double fine = drift(1.0 / 256);
  EXPECT_LT(coarse, 1e-5);
  EXPECT_GT(coarse / fine, 100.0);
}

TEST(Ledger, LossesAddUp) {
  for (const ImpactsId impacts : {ImpactsId::kLocated, ImpactsId::kStepEnd}) {
    Preset s = gas(0.9, 0.3);
    s.method.impacts = impacts;
    Simulation run(setup_of(s));
    double restitution = 0.0;
    double friction = 0.0;
    for (int i = 0; i < 1000; ++i) {
      run.step();
      for (const ImpactRecord& r : run.last_impacts()) {
        EXPECT_GE(r.lost_to_restitution, -1e-15);
        EXPECT_GE(r.lost_to_friction, -1e-15);
        restitution += r.lost_to_restitution;
        friction += r.lost_to_friction;
      }
    }
    EXPECT_GT(friction, 0.0);
    EXPECT_NEAR(run.ledger().lost_to_restitution, restitution, 1e-12);
    EXPECT_NEAR(run.ledger().lost_to_friction, friction, 1e-12);
    EXPECT_NEAR(run.totals().energy(), run.ledger().initial - restitution - friction, 1e-12);
  }
}

TEST(Ledger, BodiesOfTheUserBringTheirEnergy) {
  Preset s = gas(0.9, 0.3);
  s.scene.forces.gravity = {0.0, -9.81};
  Simulation run(setup_of(s));
  run.advance_to(0.5);
  const double drift = run.ledger().numerical_drift(run.totals().energy());
  const Body body = disc("new", {0.05, 0.9}, {1.0, 2.0}, 0.02, 3.0);
  run.apply({Add<Body>{body}});
  EXPECT_NEAR(run.ledger().put_in_by_user, 0.5 * 3.0 * 5.0 + 3.0 * 9.81 * 0.9, 1e-12);
  EXPECT_NEAR(run.ledger().numerical_drift(run.totals().energy()), drift, 1e-12);
  run.advance_to(0.6);
  EXPECT_EQ(run.state().size(), static_cast<int>(run.bodies().size()));
}

TEST(Simulation, SameBytesTwiceAndCopiesGoSeparateWays) {
  for (const ImpactsId impacts : {ImpactsId::kLocated, ImpactsId::kStepEnd}) {
    Preset s = gas(0.95, 0.2);
    s.scene.forces.quadratic_drag = 0.01;
    s.method.impacts = impacts;
    Simulation one(setup_of(s));
    Simulation two(setup_of(s));
    two.watch_impacts(true);
    one.advance_to(1.0);
    Simulation copy = one;
    copy.set_method({IntegratorId::kExplicitEuler, ImpactsId::kStepEnd, ContactsId::kImpulse, 0.01});
    copy.advance_to(2.0);
    one.advance_to(2.0);
    two.advance_to(2.0);
    EXPECT_TRUE(same_bytes(one.state(), two.state()));
    EXPECT_FALSE(same_bytes(one.state(), copy.state()));
    EXPECT_EQ(one.ledger().lost_to_friction, two.ledger().lost_to_friction);
  }
}

TEST(Zeno, BouncingBallComesToRestWithANotice) {
  Preset s = preset("bounces/bouncing-ball.json");
  const double rest = std::sqrt(2.0 / 9.81) * 9.0;
  for (const IntegratorChoice& choice : kIntegrators) {
    s.method.integrator = choice.id;
    Simulation run(setup_of(s));
    run.advance_to(2.0 * rest);
    if (choice.order < 4) continue;  // Euler's own bounces need not die out; the test must not hang
    EXPECT_NEAR(run.notices().resting_since, rest, 1e-3);
    EXPECT_NE(run.notices().text().find("Zeno"), std::string::npos);
    EXPECT_EQ(run.notices().text().find('\n'), std::string::npos);
    EXPECT_LT(run.state().velocity(1).norm(), 1e-3);
    EXPECT_NEAR(run.state().position(1).y(), 0.1, 1e-3);
    EXPECT_LT(run.impact_count(), 5000);
  }
}

TEST(Zeno, ElasticBallNeverRests) {
  Preset s = preset("bounces/bouncing-ball.json");
  s.scene.materials[0].restitution = 1.0;
  Simulation run(setup_of(s));
  run.advance_to(20.0);
  EXPECT_EQ(run.notices().text(), "ok");
  EXPECT_NEAR(run.totals().energy() / run.ledger().initial, 1.0, 1e-12);
}

TEST(Overlap, PartsWithoutABurstOfSpeed) {
  for (const ImpactsId impacts : {ImpactsId::kLocated, ImpactsId::kStepEnd}) {
    Preset s = preset_with({wall("box", {0, 0}, 2.0, 1.0), disc("in the wall", {0, 0.5}, {0, 0}),
                            disc("in the other", {0.05, 0.6}, {0, 0}), disc("inside", {0.7, 0.1}, {0, 0}),
                            disc("one", {5, 5}, {0, 0}), disc("same place", {5, 5}, {0, 0}),
                            disc("centre of box", {-0.5, 0.0}, {0, 0})},
                           0.5, 0.3);
    s.method.impacts = impacts;
    Simulation run(setup_of(s));
    for (int i = 0; i < 300; ++i) {
      run.step();
      ASSERT_TRUE(run.state().q.allFinite());
    }
    EXPECT_LT(run.state().v.cwiseAbs().maxCoeff(), 1e-15);
    for (BodyIndex a{0}; a < run.state().size(); ++a) {
      for (BodyIndex b{a + 1}; b < run.state().size(); ++b) {
        const Contact c = contact_between(run.shapes(), a, run.state().q.col(a), b, run.state().q.col(b));
        EXPECT_GT(c.gap, -1e-9) << run.bodies()[a].name << ", " << run.bodies()[b].name;
      }
    }
    EXPECT_EQ(run.impact_count(), 0);
  }
}

TEST(Pile, NoDiscGoesThroughAWall) {
  Preset s = preset("piles/pile.json");
  for (const IntegratorId id : {IntegratorId::kSemiImplicitEuler, IntegratorId::kRk4}) {
    s.method.integrator = id;
    Simulation run(setup_of(s));
    double worst = 0.0;
    run.advance_to(20.0, [&] {
      worst = std::max({worst, -3.0 - observed(run, "leftmost_x"), observed(run, "rightmost_x") - 3.0,
                        -observed(run, "lowest_y")});
    });
    EXPECT_LT(worst, 0.06);
    EXPECT_LT(observed(run, "highest_y"), 1.1);
  }
}

// A settling pile has repeated inelastic collapses; located impacts must cope with them.
TEST(Pile, LocatedImpactsGetThrough) {
  Preset s = preset("piles/pile.json");
  s.method.impacts = ImpactsId::kLocated;
  s.method.integrator = IntegratorId::kRk4;
  s.scene.generators[0].columns = 10;
  s.scene.generators[0].rows = 5;
  Simulation run(setup_of(s));
  run.advance_to(3.0);
  EXPECT_LT(run.impact_count(), 500'000);
  EXPECT_NE(run.notices().text().find("Zeno"), std::string::npos);
  EXPECT_LT(-observed(run, "lowest_y"), 0.06);
  EXPECT_LT(observed(run, "rightmost_x"), 3.06);
}

TEST(Simulation, RemaindersKeepTheGridOfTime) {
  Simulation run(setup_of(preset_with({disc("d", {0, 0}, {1, 0})})));
  run.advance_to(1.0);
  EXPECT_EQ(run.time(), 1.0);
  EXPECT_EQ(run.steps(), 200);
  run.advance_to(1.0123);
  EXPECT_NEAR(run.time(), 1.0123, 1e-15);
  EXPECT_EQ(run.steps(), 203);
}

}  // namespace
}  // namespace carom
