#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "physics/collision/pair_contact.h"
#include "physics/observe/observables.h"
#include "physics/run/run_setup.h"
#include "tests/support/compounds.h"
#include "tests/support/draws.h"
#include "tests/support/impacts.h"
#include "tests/support/scenes.h"

// Complete runs of bodies of several convex parts: compounds and concave polygons.
namespace carom {
namespace {

using test::Draws;
using test::gas_of_compounds;
using test::ground;
using test::half_planes;
using test::placed;
using test::several;
using test::shaped;

// A box of 0.8 × 0.4 m in other ways.
std::vector<Shape> forms_of_one_box() {
  return {Box{0.8, 0.4}, Compound{{placed(Box{0.4, 0.4}, {-0.2, 0.0}), placed(Box{0.4, 0.4}, {0.2, 0.0})}},
          Compound{{placed(Box{0.4, 0.4}, {5.0, 1.0}),
                    placed(Polygon{{{0, 0}, {0.4, 0}, {0.4, 0.4}, {0, 0.4}}}, {5.4, 1.0})}}};
}

const Method kFlight{IntegratorId::kExactFlight, ImpactsId::kLocated, ContactsId::kImpulse, 0.01};
const Method kRk4{IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kImpulse, 0.01};
const Method kStepEnd{IntegratorId::kVelocityVerlet, ImpactsId::kStepEnd, ContactsId::kImpulse, 0.002};

TEST(CompoundBodies, TwoSquaresMoveAsOneRectangle) {
  for (const Method& method : {kFlight, kRk4}) {
    std::vector<Eigen::Vector3d> places;
    std::vector<std::int64_t> impacts;
    for (const Shape& shape : forms_of_one_box()) {
      std::vector<Body> bodies = half_planes(1.5);
      Body body = shaped("body", shape, {0.1, 0.2}, 0.4);
      body.velocity = {0.7, 1.3};
      body.spin = 0.9;
      bodies.push_back(body);
      RunSetup s = test::setup_with(bodies, 1.0, 0.2);
      s.scene.forces.gravity = {0.0, -2.0};
      s.method = method;
      Simulation run(s);
      while (run.impact_count() < 20) run.step();
      places.push_back(run.state().q.col(4));
      impacts.push_back(run.impact_count());
    }
    for (std::size_t k = 1; k < places.size(); ++k) {
      EXPECT_EQ(impacts[k], impacts[0]);
      // Rounding grows about threefold from impact to impact.
      EXPECT_NEAR((places[k] - places[0]).cwiseAbs().maxCoeff(), 0.0, 1e-7) << k;
    }
  }
}

// Where rounding does not grow: between two floors, without friction.
TEST(CompoundBodies, TwoSquaresBounceFlatAsOneRectangle) {
  std::vector<Eigen::Vector3d> places;
  for (const Shape& shape : forms_of_one_box()) {
    Body body = shaped("body", shape, {0.0, 0.1});
    body.velocity = {0.3, 1.1};
    RunSetup s =
        test::setup_with({ground("floor", {0.0, -0.7}, 0.0), ground("ceiling", {0.0, 0.7}, M_PI), body});
    s.method = kFlight;
    Simulation run(s);
    while (run.impact_count() < 20) run.step();
    run.advance_to(20.0);
    places.push_back(run.state().q.col(2));
  }
  for (const Eigen::Vector3d& place : places) {
    EXPECT_NEAR((place - places[0]).cwiseAbs().maxCoeff(), 0.0, 1e-13);
    EXPECT_NEAR(place[2], 0.0, 1e-13);
  }
}

TEST(CompoundBodies, ThatLandFlatDoNotTurn) {
  for (const Method& method : {kFlight, kRk4, kStepEnd}) {
    for (const double angle : {0.0, 0.3}) {
      for (const Shape& shape : forms_of_one_box()) {
        Body body = shaped("body", shape, turned_by(angle, {0.0, 1.2}), angle);
        RunSetup s = test::setup_with({ground("floor", {0.0, 0.0}, angle), body}, 0.7, 0.5);
        s.scene.forces.gravity = turned_by(angle, {0.0, -9.81});
        s.method = method;
        Simulation run(s);
        double fastest = 0.0;
        run.advance_to(3.0, [&] { fastest = std::max(fastest, std::abs(run.state().v(2, 1))); });
        EXPECT_GE(run.impact_count(), 3);
        EXPECT_LE(fastest, 1e-13);
      }
    }
  }
}

// A table lands on both legs at once: as a box of the same mass and inertia, on the middle of the stretch.
TEST(CompoundBodies, LegsOfATableLandTogether) {
  const Compound table{{placed(Box{1.0, 0.1}, {0.0, 0.45}), placed(Box{0.1, 0.4}, {-0.4, 0.2}),
                        placed(Box{0.1, 0.4}, {0.4, 0.2})}};
  const double height = -centre_of(table).y();
  Body body = shaped("table", table, {0.0, 1.0 - height});
  RunSetup s = test::setup_with({ground("floor", {0.0, 0.0}, 0.0), body}, 0.5, 0.3);
  s.scene.forces.gravity = {0.0, -9.81};
  s.method = kFlight;
  Simulation run(s);
  while (run.impact_count() == 0) run.step();
  EXPECT_EQ(run.impact_count(), 1);
  EXPECT_NEAR(run.last_impacts().front().time, std::sqrt(2.0 / 9.81), 1e-13);
  EXPECT_NEAR(run.last_impacts().front().point.x(), 0.0, 1e-14);
  EXPECT_EQ(run.state().v(2, 1), 0.0);
}

// Elastic and smooth: the ball and the free cup around it keep their energy and both momenta.
TEST(CompoundBodies, ABallInAFreeCupKeepsEnergyAndMomenta) {
  const Polygon u{{{0, 0}, {3, 0}, {3, 2}, {2.5, 2}, {2.5, 0.5}, {0.5, 0.5}, {0.5, 2}, {0, 2}}};
  Compound box{{placed(u, {0.0, 0.0}), placed(Box{3.0, 0.2}, {0.0, 1.4})}};
  Body cup = shaped("cup", box, {0.0, 0.0}, 0.2);
  cup.spin = 0.3;
  Body ball = test::disc("ball", {0.0, 0.3}, {1.3, 0.4}, 0.15, 0.3);
  RunSetup s = test::setup_with({cup, ball});
  s.method = kFlight;
  Simulation run(s);
  const Totals before = run.totals();
  ASSERT_TRUE(test::step_to_impact(run, 1000, [&] { run.step(); }));
  const Totals after = run.totals();
  EXPECT_NEAR(after.energy() / before.energy(), 1.0, 1e-12);
  EXPECT_NEAR((after.momentum - before.momentum).norm(), 0.0, 1e-12);
  EXPECT_NEAR(after.angular_momentum, before.angular_momentum, 1e-12);
  EXPECT_EQ(run.notices().text(), "ok");
  // Still inside.
  EXPECT_LT((run.state().position(1) - run.state().position(0)).norm(), 2.0);
}

TEST(CompoundBodies, GasKeepsEnergyAndNothingPenetrates) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    RunSetup s = test::setup_with(gas_of_compounds(seed));
    s.method = kFlight;
    Simulation run(s);
    const double before = run.totals().energy();
    ASSERT_TRUE(test::step_to_impact(run, 2000, [&] { run.step(); }));
    EXPECT_NEAR(run.totals().energy() / before, 1.0, 1e-12);
    EXPECT_NEAR(run.ledger().momentum_drift(run.totals().momentum).norm(), 0.0, 1e-10);
    EXPECT_EQ(run.notices().text(), "ok");
    for (BodyIndex a{0}; a < run.state().size(); ++a) {
      for (BodyIndex b{a + 1}; b < run.state().size(); ++b) {
        if (!run.shapes().can_collide(a, b)) continue;
        EXPECT_GT(contact_between(run.shapes(), a, run.state().q.col(a), b, run.state().q.col(b)).gap, -1e-12);
      }
    }
  }
}

// A stick of two surfaces: only one end is rough.
TEST(CompoundBodies, EachShapeMayHaveASurfaceOfItsOwn) {
  Compound stick{{placed(Box{0.4, 0.1}, {-0.2, 0.0}), placed(Box{0.4, 0.1}, {0.2, 0.0})}};
  stick.shapes[1].material = "soft";
  for (const double side : {-1.0, 1.0}) {
    Body body = shaped("stick", stick, {0.0, 0.0});
    Body ball = test::disc("ball", {side * 0.2, 0.5}, {0.0, -1.0}, 0.1, 1.0);
    RunSetup s = test::setup_with({body, ball});
    s.scene.materials.push_back({"soft", 0.0, 0.0, 0.0, 0.0});
    s.method = kFlight;
    Simulation run(s);
    while (run.impact_count() == 0) run.step();
    const ImpactRecord& hit = run.last_impacts().front();
    EXPECT_EQ(hit.lost_to_restitution > 1e-3, side > 0.0);
  }
}

// What stands on two parts rests there, and a ball comes to rest in a cup.
TEST(CompoundBodies, RestOnSeveralParts) {
  for (const ImpactsId impacts : {ImpactsId::kLocated, ImpactsId::kStepEnd}) {
    const Polygon u{{{0, 0}, {1.2, 0}, {1.2, 0.8}, {1.0, 0.8}, {1.0, 0.2}, {0.2, 0.2}, {0.2, 0.8}, {0, 0.8}}};
    Body arch = shaped("arch", u, {0.0, 0.0}, M_PI);
    // Its centre of mass, over the feet.
    const double centre = moments_of(u.vertices, 0.0).centroid.y();
    arch.position.y() = 0.8 - centre;
    Body cup = shaped("cup", u, {3.0, centre});
    Body ball = test::disc("ball", {3.1, 0.7}, {0.3, 0.0}, 0.15, 0.2);
    RunSetup s = test::setup_with({ground("floor", {0.0, 0.0}, 0.0), arch, cup, ball}, 0.3, 0.4);
    s.scene.forces.gravity = {0.0, -9.81};
    s.method = {IntegratorId::kRk4, impacts, ContactsId::kLasting, 1.0 / 120.0};
    Simulation run(s);
    const Eigen::Vector3d arch_at = run.state().q.col(1);
    run.advance_to(4.0);
    EXPECT_NEAR((run.state().q.col(1) - arch_at).cwiseAbs().maxCoeff(), 0.0, 1e-9);
    EXPECT_NEAR(run.state().position(3).y(), 0.2 + 0.15, 1e-6);
    EXPECT_LT(std::abs(run.state().position(3).x() - run.state().position(2).x()), 0.4);
    EXPECT_NEAR(run.state().q(2, 2), 0.0, 1e-9);
    double load = 0.0;
    for (const ContactForce& f : run.contact_forces()) {
      if (f.a == 0 && f.b == 1) load += f.normal_force;
    }
    EXPECT_NEAR(load, mass_of(arch) * 9.81, 1e-6);
  }
}

// A disc rolls over the seams inside one body, and a box slides over them, as over one piece.
TEST(CompoundBodies, SeamsWithinABodyAreSmooth) {
  Compound tiles;
  for (int k = 0; k < 6; ++k) tiles.shapes.push_back(placed(Box{0.5, 0.2}, {0.5 * k, 0.0}));
  Body floor = shaped("floor", tiles, {0.0, -0.1});
  floor.density.reset();
  floor.fixed = true;
  for (const ImpactsId impacts : {ImpactsId::kLocated, ImpactsId::kStepEnd}) {
    Body box = shaped("box", Box{0.2, 0.2}, {-1.2, 0.1});
    box.velocity = {1.0, 0.0};
    Body ball = test::disc("ball", {-0.6, 0.1}, {1.1, 0.0}, 0.1, 1.0);
    RunSetup s = test::setup_with({floor, box, ball}, 0.5);
    s.scene.forces.gravity = {0.0, -9.81};
    s.method = {IntegratorId::kRk4, impacts, ContactsId::kLasting, 1.0 / 120.0};
    Simulation run(s);
    run.advance_to(1.5);
    EXPECT_NEAR(run.state().v(0, 1), 1.0, 1e-9);
    EXPECT_NEAR(run.state().v(0, 2), 1.1, 1e-9);
    EXPECT_NEAR(run.state().q(0, 1), 0.3, 1e-9);
    EXPECT_NEAR(run.state().q(1, 1), 0.1, 1e-9);
    EXPECT_EQ(run.impact_count(), 0);
  }
}

// Two flush parts of the floor overlap by half: the end of one lies hidden in the other.
TEST(CompoundBodies, OverlappingFlushPartsDoNotCatch) {
  const Compound tops{{placed(Box{2.0, 0.2}, {-0.5, 0.0}), placed(Box{2.0, 0.2}, {0.5, 0.0})}};
  Body floor = shaped("floor", tops, {0.0, -0.1});
  floor.density.reset();
  floor.fixed = true;
  for (const ImpactsId impacts : {ImpactsId::kLocated, ImpactsId::kStepEnd}) {
    for (const double e : {0.0, 0.5}) {
      Body box = shaped("box", Box{0.2, 0.2}, {-1.2, 0.1});
      box.velocity = {1.0, 0.0};
      Body ball = test::disc("ball", {-0.7, 0.1}, {1.1, 0.0}, 0.1, 1.0);
      RunSetup s = test::setup_with({floor, box, ball}, e);
      s.scene.forces.gravity = {0.0, -9.81};
      s.method = {IntegratorId::kRk4, impacts, ContactsId::kLasting, 1.0 / 120.0};
      Simulation run(s);
      run.advance_to(1.8);
      EXPECT_NEAR(run.state().v(0, 1), 1.0, 1e-9);
      EXPECT_NEAR(run.state().v(0, 2), 1.1, 1e-9);
      EXPECT_NEAR(run.state().v(2, 1), 0.0, 1e-9);
    }
  }
}

TEST(CompoundBodies, LandFlatOverASeamWhereImpactsAreSimultaneous) {
  for (const double x : {0.0, 0.15}) {
    for (const double vx : {0.0, 0.5}) {
      Compound tiles{{placed(Box{1.0, 0.2}, {-0.5, 0.0}), placed(Box{1.0, 0.2}, {0.5, 0.0})}};
      Body floor = shaped("floor", tiles, {0.0, -0.1});
      floor.density.reset();
      floor.fixed = true;
      Body body = shaped(
          "body", Compound{{placed(Box{0.25, 0.2}, {-0.125, 0.0}), placed(Box{0.25, 0.2}, {0.125, 0.0})}},
          {x, 0.5});
      body.velocity = {vx, 0.0};
      RunSetup s = test::setup_with({floor, body});
      s.scene.several_impacts = SeveralImpactsId::kSimultaneous;
      s.scene.forces.gravity = {0.0, -9.81};
      s.method = kFlight;
      Simulation run(s);
      double fastest = 0.0;
      run.advance_to(std::abs(vx) > 0.0 ? 1.0 : 3.0,
                     [&] { fastest = std::max(fastest, std::abs(run.state().v(2, 1))); });
      EXPECT_LT(fastest, 1e-8);
      EXPECT_NEAR(run.state().v(0, 1), vx, 1e-9);
      EXPECT_EQ(run.notices().text(), "ok");
    }
  }
}

// Impacts at the step's end: the deepest of several parts may be one whose edge another part continues.
TEST(CompoundBodies, AFloorOfSeveralShapesHoldsAsOneOfSeveralBodies) {
  for (const double step : {1.0 / 120.0, 1.0 / 60.0}) {
    std::vector<Eigen::Vector3d> ends;
    for (const bool one_body : {false, true}) {
      std::vector<Body> bodies;
      Compound tiles;
      for (int k = 0; k < 6; ++k) {
        if (one_body) {
          tiles.shapes.push_back(placed(Box{0.5, 1.0}, {0.5 * k, 0.0}));
        } else {
          bodies.push_back(test::wall(fmt::format("tile-{}", k), {-1.25 + 0.5 * k, -0.5}, 0.5, 1.0));
        }
      }
      if (one_body) {
        bodies.push_back(shaped("floor", tiles, {0.0, -0.5}));
        bodies.back().density.reset();
        bodies.back().fixed = true;
      }
      bodies.push_back(shaped("box", Box{0.3, 0.2}, {0.1, 0.5}));
      bodies.back().velocity = {0.7, 0.0};
      RunSetup s = test::setup_with(bodies, 0.0);
      s.scene.forces.gravity = {0.0, -9.81};
      s.method = {IntegratorId::kVelocityVerlet, ImpactsId::kStepEnd, ContactsId::kImpulse, step};
      Simulation run(s);
      run.advance_to(1.5);
      ends.emplace_back(run.state().q.col(run.state().size() - 1));
    }
    EXPECT_NEAR(ends[1].x(), 1.15, 1e-9) << "nothing stops it";
    EXPECT_GT(ends[1].y(), 0.09);
    EXPECT_NEAR((ends[1] - ends[0]).head<1>().norm(), 0.0, 1e-9);
  }
}

// Dropped into a container, three hundred of them pile up and come to rest; no corner leaves it, and none lies
// in another.
TEST(CompoundBodies, ACrowdStaysInItsBox) {
  constexpr double kSunk = 1e-3;  // m
  Draws draws(3);
  std::vector<Body> bodies = test::room(6.0, 1.0);
  const std::vector<Shape> shapes = several();
  for (int i = 0; i < 300; ++i) {
    const int row = i / 17;
    Body b = shaped(fmt::format("b{}", i), shapes[static_cast<std::size_t>(i) % shapes.size()],
                    {-5.4 + 0.68 * (i % 17), -5.4 + 0.62 * row}, draws.angle());
    b.velocity = draws.in_square(0.5);
    bodies.push_back(b);
  }
  RunSetup s = test::setup_with(bodies, 0.2, 0.5);
  s.scene.forces.gravity = {0.0, -9.81};
  s.method = {IntegratorId::kRk4, ImpactsId::kStepEnd, ContactsId::kLasting, 1.0 / 60.0};
  Simulation run(s);
  const double before = run.totals().energy();
  run.advance_to(4.0);
  const Reading at_end = reading_of(run, {});
  const auto observed = [&](std::string_view name) { return find_observable(name)->value(at_end, {}); };
  for (const std::string_view edge : {"rightmost_x", "highest_y"})
    EXPECT_LT(observed(edge), 6.0 + kSunk) << edge;
  for (const std::string_view edge : {"leftmost_x", "lowest_y"})
    EXPECT_GT(observed(edge), -6.0 - kSunk) << edge;
  EXPECT_LT(observed("overlap"), kSunk);
  EXPECT_LT(run.totals().energy(), before);
  EXPECT_LT(run.totals().kinetic(), 1e-3 * (before - run.totals().energy()));
}

// Two feet of one body that land together, each with its own restitution, e = 0.2 at ±0.4 and ±0.2 to one side
// and 0.8 to the other: the outer end of the one and the inner end of the other rebound as their laws say, and
// nothing hangs on the order in the file.
TEST(CompoundBodies, FeetLandTogetherEachWithItsOwnSurface) {
  for (const bool swapped : {false, true}) {
    for (const double side : {1.0, -1.0}) {
      PlacedShape dull = placed(Box{0.2, 0.2}, {-0.3 * side, 0.0});
      PlacedShape lively = placed(Box{0.2, 0.2}, {0.3 * side, 0.0});
      dull.material = "dull";
      lively.material = "lively";
      if (swapped) std::swap(dull, lively);
      Body table = test::disc("table", {0.0, 0.2}, {0.0, -3.0});
      table.shape = Compound{{dull, lively, placed(Box{0.8, 0.1}, {0.0, 0.15})}};
      RunSetup s = test::setup_with({test::fixed("floor", Wall{}, {0.0, 0.0}), table}, 1.0);
      for (const auto& [name, restitution] : {std::pair("dull", 0.2), std::pair("lively", 0.8)}) {
        s.scene.materials.push_back(s.scene.materials.front());
        s.scene.materials.back().name = name;
        s.scene.materials.back().restitution = restitution;
      }
      s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, 0.005};
      Simulation run(s);
      run.advance_to(0.05);
      EXPECT_NEAR(run.state().v(2, 1), side * 3.0, 1e-12) << swapped;
      EXPECT_NEAR(run.state().velocity(1).y(), 0.6 * 3.0, 1e-12) << swapped;
    }
  }
}

// Two shapes of one body that run off a face at one moment, on the way to being lost once.
TEST(CompoundBodies, ABoxAndAnLOfTwoShapesPartWhole) {
  for (const double step : {1.0 / 60.0, 0.014, 0.01, 0.008, 0.005, 0.0025, 0.001}) {
    Body bracket = test::disc("bracket", {1.0, 0.4957389895097659}, {-3.0, 0.0});
    bracket.shape = Polygon{{{0.0, 0.0}, {0.4, 0.0}, {0.4, 0.1}, {0.1, 0.1}, {0.1, 0.4}, {0.0, 0.4}}};
    bracket.angle = 4.359459046489495;
    RunSetup s = test::setup_with({test::box("box", {0.0, 0.6}, {0.0, 0.0}, 0.4, 0.2), bracket}, 0.0);
    s.scene.bodies[0].angle = 0.803593347473631;
    s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, step};
    Simulation run(s);
    run.advance_to(1.0);
    EXPECT_EQ(run.status(), "ok") << step;
    EXPECT_NEAR(run.ledger().numerical_drift(run.totals().energy()), 0.0, 2e-5) << step;
    EXPECT_NEAR(run.ledger().angular_momentum_drift(run.totals().angular_momentum), 0.0, 1e-5) << step;
    EXPECT_NEAR(run.state().velocity(0).x(), -1.285053706, 1.5e-5) << step;  // of steps of 0.1 ms
  }
}

}  // namespace
}  // namespace carom
