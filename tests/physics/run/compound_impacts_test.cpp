#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

#include "physics/run/run_setup.h"
#include "tests/support/compounds.h"
#include "tests/support/scenes.h"

// Impacts of several shapes of one body at one moment, and at a point that several shapes share.
namespace carom {
namespace {

using test::placed;

constexpr double kStep = 0.005;

std::vector<Method> methods() {
  return {{IntegratorId::kExactFlight, ImpactsId::kLocated, ContactsId::kImpulse, kStep},
          {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, kStep},
          {IntegratorId::kRk4, ImpactsId::kStepEnd, ContactsId::kLasting, kStep},
          {IntegratorId::kVelocityVerlet, ImpactsId::kStepEnd, ContactsId::kImpulse, kStep}};
}

PlacedShape of(const std::string& material, PlacedShape shape) {
  shape.material = material;
  return shape;
}

Body compound(const std::string& name, std::vector<PlacedShape> shapes, const Vec2& position, bool swapped) {
  if (swapped) std::reverse(shapes.begin(), shapes.end());
  Body b = test::disc(name, position, {0.0, 0.0});
  b.shape = Compound{std::move(shapes)};
  b.mass.reset();
  b.density = 1.0;
  return b;
}

Body fixed_compound(const std::string& name, std::vector<PlacedShape> shapes, const Vec2& position,
                    bool swapped) {
  Body b = compound(name, std::move(shapes), position, swapped);
  b.density.reset();
  b.fixed = true;
  return b;
}

void add_material(RunSetup& s, const std::string& name, double restitution) {
  s.scene.materials.push_back(s.scene.materials.front());
  s.scene.materials.back().name = name;
  s.scene.materials.back().restitution = restitution;
}

// A ball that comes into a corner and meets both of its walls at one moment goes back as it came, as from two
// bodies.
TEST(CompoundImpacts, ACornerOfTwoWallsSendsABallBack) {
  const double first = M_PI / 12.0;
  const double second = first + 4.0 * M_PI / 9.0;
  const Vec2 along(std::cos(0.5 * (first + second)), std::sin(0.5 * (first + second)));
  const Vec2 touching = 0.1 / std::sin(0.5 * (second - first)) * along;
  const Vec2 v(-1.2, -1.6);
  for (const bool swapped : {false, true}) {
    for (const Method& method : methods()) {
      std::vector<PlacedShape> walls;
      for (const double angle : {first, second})
        walls.push_back(placed(Wall{3.0}, 1.5 * Vec2(std::cos(angle), std::sin(angle)), angle));
      const Vec2 middle = 0.5 * (walls[0].position + walls[1].position);
      RunSetup s = test::setup_with(
          {fixed_compound("corner", walls, middle, swapped), test::disc("ball", touching - 0.2 * v, v, 0.1)},
          1.0);
      s.method = method;
      Simulation run(s);
      run.advance_to(0.3);
      EXPECT_LT((run.state().velocity(1) + v).norm(), 1e-12) << swapped << " " << run.status();
    }
  }
}

// A ball that meets both discs of a free dumb-bell at one moment: 0 <= u' + e u ⊥ j >= 0 for both, solved with
// mpmath from the masses and the places.
TEST(CompoundImpacts, ABallMeetsBothEndsOfADumbBell) {
  constexpr double kBall = 0.15, kLeft = 0.2, kRight = 0.3, kApart = 0.55;  // m
  const double d1 = kLeft + kBall, d2 = kRight + kBall;
  const double x = (d1 * d1 - d2 * d2 + kApart * kApart) / (2.0 * kApart);
  const Vec2 ball(-0.25 + x, std::sqrt(d1 * d1 - x * x));
  const double share = kRight * kRight / (kLeft * kLeft + kRight * kRight);
  for (const bool swapped : {false, true}) {
    for (const Method& method : methods()) {
      if (method.impacts == ImpactsId::kStepEnd) continue;  // where the discs overlap, normals have turned
      const std::vector<PlacedShape> ends = {placed(Disc{kLeft}, {-0.25, 0.0}),
                                             placed(Disc{kRight}, {-0.25 + kApart, 0.0})};
      RunSetup s = test::setup_with({compound("bell", ends, {-0.25 + share * kApart, 0.0}, swapped),
                                     test::disc("ball", ball + Vec2(0.0, 0.2), {0.0, -1.0}, kBall, 0.2)},
                                    1.0);
      s.method = method;
      Simulation run(s);
      run.advance_to(0.25);
      EXPECT_NEAR(run.state().velocity(0).x(), 0.07925067560578378, 1e-12) << swapped;
      EXPECT_NEAR(run.state().velocity(0).y(), -0.6079294616320584, 1e-12) << swapped;
      EXPECT_NEAR(run.state().v(2, 0), 0.8440342558544601, 1e-12) << swapped;
    }
  }
}

// Two round feet of one body, with e = 0.3 and 0.9, that land on one floor: each rebounds by its own law, u_1'
// = 0.6 m/s and u_2' = 1.8 m/s at ±0.45 m.
TEST(CompoundImpacts, RoundFeetLandTogetherEachWithItsOwnSurface) {
  constexpr double kFoot = 0.1, kSide = 0.45;  // m
  const double feet = 2.0 * M_PI * kFoot * kFoot, plank = 0.1;
  const double height = (plank * 0.3 + feet * 0.1) / (plank + feet);
  for (const bool swapped : {false, true}) {
    for (const Method& method : methods()) {
      const std::vector<PlacedShape> shapes = {placed(Box{1.0, 0.1}, {0.0, 0.3}),
                                               of("dull", placed(Disc{kFoot}, {-kSide, 0.1})),
                                               of("lively", placed(Disc{kFoot}, {kSide, 0.1}))};
      RunSetup s = test::setup_with(
          {test::fixed("floor", Wall{}, {0.0, 0.0}), compound("table", shapes, {0.0, height + 0.3}, swapped)},
          1.0);
      add_material(s, "dull", 0.3);
      add_material(s, "lively", 0.9);
      s.scene.bodies[1].velocity = {0.0, -2.0};
      s.method = method;
      Simulation run(s);
      run.advance_to(0.17);
      EXPECT_NEAR(run.state().velocity(1).y(), 1.2, 1e-12) << swapped;
      EXPECT_NEAR(run.state().v(2, 1), 0.6 / kSide, 1e-12) << swapped;
    }
  }
}

// At a point that shapes of different surfaces share, on their seam or where they overlap, the less elastic one
// counts; of one body or of several, in any order.
TEST(CompoundImpacts, WhereSurfacesMeetTheLessElasticOneCounts) {
  for (const double overlap : {0.0, 0.4}) {
    for (const bool swapped : {false, true}) {
      for (const bool one_body : {true, false}) {
        for (const Method& method : methods()) {
          const Vec2 middle(0.5 - 0.5 * overlap, 0.0);
          const std::vector<PlacedShape> halves = {of("dull", placed(Box{1.0, 0.2}, -middle)),
                                                   of("lively", placed(Box{1.0, 0.2}, middle))};
          std::vector<Body> bodies;
          if (one_body) {
            bodies.push_back(fixed_compound("floor", halves, {0.0, -0.1}, swapped));
          } else {
            for (const PlacedShape& half : halves) {
              bodies.push_back(
                  test::fixed(half.material, shape_of(half.shape), half.position + Vec2(0.0, -0.1)));
              bodies.back().material = half.material;
            }
            if (swapped) std::swap(bodies[0], bodies[1]);
          }
          bodies.push_back(test::disc("ball", {0.0, 0.5}, {0.0, -2.0}, 0.1));
          RunSetup s = test::setup_with(bodies, 1.0);
          add_material(s, "dull", 0.3);
          add_material(s, "lively", 0.9);
          s.method = method;
          Simulation run(s);
          run.advance_to(0.3);
          const Vec2 v = run.state().velocity(static_cast<int>(bodies.size()) - 1);
          EXPECT_NEAR(v.y(), 0.6, 1e-12) << overlap << " " << swapped << " " << one_body;
          EXPECT_NEAR(v.x(), 0.0, 1e-12) << overlap << " " << swapped << " " << one_body;
        }
      }
    }
  }
}

}  // namespace
}  // namespace carom
