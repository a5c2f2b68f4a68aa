#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numbers>
#include <string>
#include <vector>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/math/vectors.h"
#include "physics/run/run_setup.h"
#include "physics/run/simulation.h"
#include "tests/support/scenes.h"

// Impacts of one moment: their books, their order where it decides, and their notices.
namespace carom {
namespace {

using test::disc;

// Six balls meet a seventh in its middle, and their neighbours at the same moment: that is no reason to lower
// e.
TEST(ImpactsOfAMoment, BallsFromAllSidesReboundWithTheirOwnRestitution) {
  for (int turn = 0; turn < 12; ++turn) {
    RunSetup s = test::setup_with({});
    const Vec2 middle(0.37 * turn - 2.0, 1.3 - 0.29 * turn);
    for (int i = 0; i < 6; ++i) {
      const Vec2 out = turned_by(0.41 * turn + i * std::numbers::pi / 3.0, Vec2::UnitX());
      s.scene.bodies.push_back(disc(fmt::format("b{}", i), middle + out, -out));
    }
    s.scene.bodies.push_back(disc("middle", middle, {0.0, 0.0}));
    s.method.step = 0.001;
    Simulation run(s);
    run.advance_to(1.0);
    EXPECT_EQ(run.notices().text(), "ok") << turn;
    for (int i = 0; i < 6; ++i) EXPECT_NEAR(run.state().velocity(i).norm(), 1.0, 1e-9) << turn;
    EXPECT_NEAR(run.state().velocity(6).norm(), 0.0, 1e-9) << turn;
  }
}

// A spinning disc falls into a rough V: in this impact each wall takes more than there is, and the other one
// gives it back; no loss is negative.
TEST(ImpactsOfAMoment, NoLossIsNegative) {
  for (const double friction : {0.2, 0.5, 1.0}) {
    for (const double spin : {-25.0, -5.0, 5.0, 25.0}) {
      RunSetup s = test::setup_with({}, 1.0, friction);
      const double side = std::numbers::pi / 4.0;
      s.scene.bodies = {test::fixed("right", Wall{}, {0.0, 0.0}), test::fixed("left", Wall{}, {0.0, 0.0}),
                        disc("disc", {0.0, 0.1 * std::numbers::sqrt2 + 0.015}, {0.0, -1.0})};
      s.scene.bodies[0].angle = side;
      s.scene.bodies[1].angle = -side;
      s.scene.bodies[2].spin = spin;
      s.method.step = 0.01;
      Simulation run(s);
      const double before = run.totals().energy();
      while (run.impact_count() == 0) run.step();
      for (const ImpactRecord& impact : run.last_impacts()) {
        EXPECT_GE(impact.lost_to_restitution, -1e-15 * before);
        EXPECT_GE(impact.lost_to_friction, 0.0);
      }
      EXPECT_LE(run.ledger().lost_to_restitution + run.ledger().lost_to_friction, before);
      EXPECT_NEAR(run.ledger().numerical_drift(run.totals().energy()), 0.0, 1e-13 * before);
    }
  }
}

// Of surfaces that return slip the order of the bodies decides, in the same way wherever the impact is found.
TEST(ImpactsOfAMoment, TheOrderThatDecidesIsThatOfTheFile) {
  std::vector<double> spins;
  for (const auto& impacts : kImpacts) {
    RunSetup s = test::setup_with({}, 0.9, 0.5);
    s.scene.materials[0].tangential_restitution = 1.0;
    const double side = std::numbers::pi / 4.0;
    s.scene.bodies = {test::fixed("right", Wall{}, {0.0, 0.0}), test::fixed("left", Wall{}, {0.0, 0.0}),
                      disc("disc", {0.0, 0.1 * std::numbers::sqrt2 + 0.015}, {0.0, -1.0})};
    s.scene.bodies[0].angle = side;
    s.scene.bodies[1].angle = -side;
    s.method = {IntegratorId::kRk4, impacts.id, ContactsId::kImpulse, 0.001};
    Simulation run(s);
    run.advance_to(0.018);
    spins.push_back(run.state().v(2, 2));
  }
  EXPECT_GT(std::abs(spins[0]), 1.0);
  EXPECT_NEAR(spins[0], spins[1], 0.5);
}

// With the law of simultaneous impacts a row of any spacing is one row, wherever the impact is found.
TEST(ImpactsOfAMoment, ARowThatRoundingPartsIsOne) {
  for (const double diameter : {0.2, 0.25, 0.3}) {
    for (const auto& impacts : kImpacts) {
      for (const ContactsId contacts : {ContactsId::kImpulse, ContactsId::kLasting}) {
        RunSetup s = test::setup_with({});
        for (int i = 0; i < 9; ++i) {
          s.scene.bodies.push_back(disc(fmt::format("b{}", i), {diameter * i - (i == 0 ? 0.015 : 0.0), 0.0},
                                        {i == 0 ? 1.0 : 0.0, 0.0}));
          s.scene.bodies.back().shape = Disc{0.5 * diameter};
        }
        s.scene.several_impacts = SeveralImpactsId::kSimultaneous;
        s.method = {IntegratorId::kRk4, impacts.id, contacts, 0.001};
        Simulation run(s);
        run.advance_to(0.03);
        // Its velocity turned about the common one that a plastic impact would leave, 1/9 m/s.
        EXPECT_NEAR(run.state().v(0, 0), 2.0 / 9.0 - 1.0, 1e-9) << diameter << " " << impacts.name;
      }
    }
  }
}

// The law of simultaneous impacts knows nothing of returned slip: a row of such discs is hit pair by pair, with
// a notice, and two discs alone without one.
TEST(ImpactsOfAMoment, ReturnedSlipIsKeptWhereAllTouchesCount) {
  for (const auto& impacts : kImpacts) {
    for (const int others : {1, 2}) {
      RunSetup s = test::setup_with({disc("cue", {-0.25, 0.03}, {1.0, 0.0})}, 0.9, 0.5);
      s.scene.bodies[0].spin = 5.0;
      for (int i = 0; i < others; ++i)
        s.scene.bodies.push_back(disc(fmt::format("b{}", i), {0.2 * i, 0.0}, {0.0, 0.0}));
      s.scene.materials[0].tangential_restitution = 1.0;
      s.scene.several_impacts = SeveralImpactsId::kSimultaneous;
      s.method = {IntegratorId::kRk4, impacts.id, ContactsId::kImpulse, 0.001};
      Simulation run(s);
      run.advance_to(0.2);
      EXPECT_NE(run.state().v(2, 1), 0.0) << impacts.name;
      const bool notes = run.notices().text().find("in the order of the bodies") != std::string::npos;
      EXPECT_EQ(notes, others > 1) << impacts.name << run.notices().text();
    }
  }
}

}  // namespace
}  // namespace carom
