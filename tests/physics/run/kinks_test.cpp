#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <string>
#include <vector>

#include "physics/math/vectors.h"
#include "physics/run/simulation.h"
#include "tests/support/scenes.h"

// A box that slides from a table up a ramp, whose own corner is at the foot: it hits the ramp's face, as it
// hits a half-plane, and not that corner.
namespace carom {
namespace {

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
  s.scene.forces.gravity = {0.0, -9.81};
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

}  // namespace
}  // namespace carom
