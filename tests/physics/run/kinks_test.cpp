#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <string>
#include <vector>

#include "physics/math/vectors.h"
#include "physics/run/simulation.h"
#include "physics/scene/polygon.h"
#include "tests/support/fine_step.h"
#include "tests/support/scenes.h"

// A box that slides from a table up a ramp, whose own corner is at the foot: it hits the ramp's face, as it
// hits a half-plane, and not that corner.
namespace carom {
namespace {

constexpr double kG = 9.81;

enum class Ground { kHalfPlanes, kBoxes, kCompound };

RunSetup at_the_foot(Ground ground, double slope, double side, double start) {
  const Vec2 along(std::cos(slope), std::sin(slope));
  const Vec2 ramp = 1.5 * along - 0.15 * crossed(along);
  std::vector<Body> bodies;
  if (ground == Ground::kHalfPlanes) {
    bodies = {test::fixed("table", Wall{}, {0.0, 0.0}), test::fixed("ramp", Wall{}, {0.0, 0.0})};
    bodies[1].angle = side * slope;
  } else if (ground == Ground::kBoxes) {
    bodies = {test::wall("table", {-2.0 * side, -0.25}, 4.0, 0.5),
              test::wall("ramp", {side * ramp.x(), ramp.y()}, 3.0, 0.3, side * slope)};
  } else {
    const Compound both{{{Box{4.0, 0.5}, {-2.0 * side, -0.25}, 0.0, ""},
                         {Box{3.0, 0.3}, {side * ramp.x(), ramp.y()}, side * slope, ""}}};
    // Its origin is its centre of mass.
    const Vec2 centre = (2.0 * Vec2(-2.0 * side, -0.25) + 0.9 * Vec2(side * ramp.x(), ramp.y())) / 2.9;
    bodies = {test::fixed("table", both, centre)};
  }
  bodies.push_back(test::box("box", {side * start, 0.1}, {0.87 * side, 0.0}, 0.4, 0.2));
  RunSetup s = test::setup_with(std::move(bodies), 0.0, 0.0);
  s.scene.forces.gravity = {0.0, -kG};
  return s;
}

TEST(Kinks, ABoxRunsUpARamp) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  for (const double slope : {1.0 * kDegree, 8.0 * kDegree, 25.0 * kDegree, 40.0 * kDegree}) {
    for (const double side : {1.0, -1.0}) {
      for (const double start : {-0.3, -0.351, -0.4027}) {
        for (const double h : {1.0 / 60.0, 0.01, 0.005}) {
          const auto end = [&](Ground ground) {
            RunSetup s = at_the_foot(ground, slope, side, start);
            s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, h};
            Simulation run(s);
            run.advance_to((-0.2 - start) / 0.87 + 0.05, [] {});
            const BodyIndex box{static_cast<int>(run.state().size()) - 1};
            return Eigen::Vector3d(run.state().v.col(box));
          };
          const Eigen::Vector3d expected = end(Ground::kHalfPlanes);
          for (const Ground ground : {Ground::kBoxes, Ground::kCompound}) {
            EXPECT_LT((end(ground) - expected).norm(), 3e-5)
                << slope << ' ' << side << ' ' << start << ' ' << h << ' ' << static_cast<int>(ground);
          }
        }
      }
    }
  }
}

struct AtSteepRamp {
  double slope, width, height, speed, friction;  // degrees, m, m/s
};
RunSetup at_a_steep_ramp(const AtSteepRamp& c, double step) {
  const double slope = c.slope * std::numbers::pi / 180.0;
  RunSetup s = test::setup_with(
      {test::wall("table", {-1.5, -0.1}, 3.0, 0.2),
       test::wall("ramp", turned_by(slope, Vec2(0.75, -0.1)), 1.5, 0.2, slope),
       test::box("box", {-0.2 - 0.5 * c.width, 0.5 * c.height}, {c.speed, 0.0}, c.width, c.height)},
      0.0, c.friction);
  s.scene.forces.gravity = {0.0, -kG};
  s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, step};
  return s;
}

// The front corner of a box that meets a steep ramp jams between ramp and table while the box turns about it,
// or slides up the ramp until the rear corner lands.
TEST(Kinks, ABoxTurnsAtTheFootOfASteepRamp) {
  for (const AtSteepRamp& c :
       {AtSteepRamp{50.0, 0.227, 0.138, 0.773, 0.0}, AtSteepRamp{50.0, 0.265, 0.237, 1.277, 0.3},
        AtSteepRamp{50.0, 0.165, 0.174, 0.705, 0.0}, AtSteepRamp{60.0, 0.292, 0.254, 1.951, 0.3},
        AtSteepRamp{70.0, 0.146, 0.2, 1.794, 0.1}, AtSteepRamp{70.0, 0.189, 0.191, 1.719, 0.1}}) {
    const auto at = [&](double h) { return at_a_steep_ramp(c, h); };
    for (const double step : {1.0 / 60.0, 1.0 / 120.0, 1.0 / 240.0})
      EXPECT_LT(test::off_from_fine_step(at, 0.5, step), 1e-5) << c.slope << ' ' << c.speed << ' ' << step;
  }
}

// Linear forces that are not found for one set of contacts may have grown beyond all bounds: the next set does
// not begin with them.
TEST(Kinks, ForcesThatAreNotFoundAreTakenBack) {
  for (const AtSteepRamp& c :
       {AtSteepRamp{50.0, 0.121, 0.279, 1.738, 0.3}, AtSteepRamp{50.0, 0.109, 0.12, 1.036, 0.1},
        AtSteepRamp{60.0, 0.129, 0.245, 1.505, 0.1}, AtSteepRamp{50.0, 0.102, 0.295, 1.136, 0.1}}) {
    for (const double step : {1.0 / 60.0, 1.0 / 240.0}) {
      Simulation run(at_a_steep_ramp(c, step));
      run.advance_to(0.5);
      EXPECT_EQ(run.status(), "ok") << c.slope << ' ' << c.speed << ' ' << step;
      EXPECT_LT(std::abs(run.ledger().numerical_drift(run.totals().energy())), 2e-3);
    }
  }
}

// A capsule tips over the end of a table, lands flat on the ramp beyond it, rattles to rest there and slides
// on.
TEST(Kinks, ACapsuleTipsAndLandsBeyondThem) {
  struct Case {
    double slope, length, speed;  // degrees, m, m/s
  };
  for (const Case& c :
       {Case{0.5, 0.294, 1.973}, Case{1.0, 0.161, 1.63}, Case{1.0, 0.183, 0.997}, Case{2.0, 0.209, 1.954}}) {
    const auto at = [&](double h) {
      const double slope = -c.slope * std::numbers::pi / 180.0;
      Body capsule = test::box("capsule", {-0.3 - 0.5 * c.length, 0.05}, {c.speed, 0.0}, c.length, 0.1);
      capsule.shape = Polygon{{{-0.5 * c.length, 0.0}, {0.5 * c.length, 0.0}}, 0.05};
      RunSetup s =
          test::setup_with({test::wall("table", {-1.0, -0.15}, 2.0, 0.3),
                            test::wall("ramp", turned_by(slope, Vec2(1.0, -0.15)), 2.0, 0.3, slope), capsule},
                           0.0, 0.0);
      s.scene.forces.gravity = {0.0, -kG};
      s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, h};
      return s;
    };
    for (const double step : {1.0 / 60.0, 1.0 / 120.0, 1.0 / 240.0}) {
      EXPECT_LT(test::off_from_fine_step(at, 0.6, step), 1e-5) << c.slope << ' ' << c.speed << ' ' << step;
      Simulation run(at(step));
      run.advance_to(0.6);
      EXPECT_LT(std::abs(run.ledger().penetration_correction), 1e-9)
          << c.slope << ' ' << c.speed << ' ' << step;
      // As much as bounces that are too slow to follow would have lost.
      EXPECT_LT(std::abs(run.ledger().numerical_drift(run.totals().energy())), 3e-5) << c.slope << ' ' << step;
    }
  }
}

// Whose corners rebound at the foot of a shallow ramp by turns: each of them lands though the other's impact
// changes when, and none sinks in.
TEST(Kinks, CornersThatReboundByTurnsLand) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  for (const double restitution : {0.3, 0.5, 0.8}) {
    for (const double slope : {0.5 * kDegree, 1.0 * kDegree, 3.0 * kDegree}) {
      for (const double h : {0.0088, 0.004, 0.001}) {
        RunSetup s = at_the_foot(Ground::kBoxes, slope, 1.0, -0.42);
        s.scene.materials[0].restitution = restitution;
        s.scene.bodies.back().velocity.x() = 1.022;
        s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, h};
        Simulation run(s);
        run.advance_to(0.9, [] {});
        EXPECT_LT(std::abs(run.ledger().penetration_correction), 1e-12)
            << restitution << ' ' << slope << ' ' << h;
        const double closing = 1.022 * std::sin(slope);
        EXPECT_LT(run.ledger().lost_to_restitution, 0.5 * closing * closing) << restitution << ' ' << h;
      }
    }
  }
}

// How fast a disc goes that rolls, or slides, from a level table over its end down a slope, after `until` s: it
// turns about the corner in between.
double speed_down(double radius, double speed, double start, double slope, double inertia, double until) {
  // From its energy as it turns; the time that takes by Simpson's rule.
  const auto speed_at = [&](double angle) {
    return std::sqrt(speed * speed + 2.0 / inertia * kG * radius * (1.0 - std::cos(angle)));
  };
  constexpr int kParts = 8;
  double turns = 0.0;
  for (int k = 0; k <= kParts; ++k) {
    const double weight = k == 0 || k == kParts ? 1.0 : k % 2 == 1 ? 4.0 : 2.0;
    turns += weight * slope * radius / (3.0 * kParts) / speed_at(k * slope / kParts);
  }
  const double left = until + start / speed - turns;
  return speed_at(slope) + left * kG * std::sin(slope) / inertia;
}

TEST(Kinks, ADiscRollsAndSlidesOverThem) {
  constexpr double kRadius = 0.1;
  constexpr double kSpeed = 0.48;
  constexpr double kStart = -0.168;
  constexpr double kUntil = 0.6;
  for (const double degrees : {0.02, 0.2, 1.0, 2.8, 6.0}) {
    const double slope = degrees * std::numbers::pi / 180.0;
    const Vec2 down(std::cos(slope), -std::sin(slope));
    for (const bool one_polygon : {false, true}) {
      for (const bool rolls : {true, false}) {
        for (const double h : {1.0 / 60.0, 0.0083, 0.004}) {
          std::vector<Body> bodies;
          if (one_polygon) {
            const Polygon ground{{{-4.0, 0.0}, {-4.0, -2.0}, {4.0 * down.x(), -2.0}, 4.0 * down, {0.0, 0.0}}};
            bodies = {test::fixed("ground", ground, moments_of(ground.vertices, 0.0).centroid)};
          } else {
            const Vec2 ramp = 1.5 * down - 0.15 * crossed(down);
            bodies = {test::wall("table", {-2.0, -0.25}, 4.0, 0.5), test::wall("ramp", ramp, 3.0, 0.3, -slope)};
          }
          bodies.push_back(test::disc("disc", {kStart, kRadius}, {kSpeed, 0.0}, kRadius));
          if (rolls) bodies.back().spin = -kSpeed / kRadius;
          RunSetup s = test::setup_with(std::move(bodies), 0.0, rolls ? 1.0 : 0.0);
          s.scene.forces.gravity = {0.0, -kG};
          s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, h};
          Simulation run(s);
          run.advance_to(kUntil, [] {});
          const auto v = run.state().v.rightCols<1>();
          const double expected = speed_down(kRadius, kSpeed, kStart, slope, rolls ? 1.5 : 1.0, kUntil);
          EXPECT_NEAR(v.head<2>().norm(), expected, 1e-7)
              << degrees << ' ' << one_polygon << ' ' << rolls << ' ' << h;
          EXPECT_NEAR(v[2], rolls ? -expected / kRadius : 0.0, 1e-6);
        }
      }
    }
  }
}

// A rough block slides up a kink whose two faces are parts of one body, as up one of two half-planes.
TEST(Kinks, ARoughBlockRunsUpOneOfOneBody) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  for (const double restitution : {0.0, 0.5}) {
    for (const double slope : {0.5 * kDegree, 5.0 * kDegree, 20.0 * kDegree}) {
      for (const double h : {1.0 / 60.0, 1.0 / 120.0}) {
        const auto end = [&](Ground ground) {
          RunSetup s = at_the_foot(ground, slope, 1.0, -0.25);
          s.scene.materials[0] = {"default", restitution, 0.0, 0.3, 0.3};
          s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, h};
          Simulation run(s);
          run.advance_to(0.3, [] {});
          EXPECT_LT(std::abs(run.ledger().penetration_correction), 1e-9);
          return Eigen::Vector3d(run.state().q.rightCols<1>());
        };
        EXPECT_LT((end(Ground::kCompound) - end(Ground::kHalfPlanes)).norm(), 1e-5)
            << restitution << ' ' << slope << ' ' << h;
      }
    }
  }
}

// The two wheels of a smooth cart go over the end of a table one after the other, without an impact.
TEST(Kinks, AWheeledCartRunsDown) {
  for (const auto& [slope, speed] : {std::pair(0.03, 0.6), std::pair(0.0873, 0.6), std::pair(0.17, 0.4)}) {
    const Vec2 down(std::cos(slope), -std::sin(slope));
    for (const double h : {1.0 / 60.0, 1.0 / 120.0}) {
      Body cart = test::box("cart", {-0.2, 0.0}, {speed, 0.0}, 0.3, 0.15);
      const Compound parts{{{Disc{0.05}, {-0.12, -0.05}, 0.0, ""},
                            {Disc{0.05}, {0.12, -0.05}, 0.0, ""},
                            {Box{0.3, 0.15}, {0.0, 0.025}, 0.0, ""}}};
      cart.shape = parts;
      cart.position.y() = 0.1 + centre_of(parts).y();
      cart.inertia = 0.01;
      RunSetup s =
          test::setup_with({test::wall("table", {-2.0, -0.25}, 4.0, 0.5),
                            test::wall("ramp", 1.5 * down - 0.15 * crossed(down), 3.0, 0.3, -slope), cart},
                           0.0, 0.0);
      s.scene.forces.gravity = {0.0, -kG};
      s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, h};
      Simulation run(s);
      run.advance_to(0.5, [] {});
      EXPECT_EQ(run.impact_count(), 0) << slope << ' ' << h;
      EXPECT_NEAR(run.totals().energy(), run.ledger().initial, 1e-7) << slope << ' ' << h;
    }
  }
}

}  // namespace
}  // namespace carom
