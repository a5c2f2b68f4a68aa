#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <string>

#include "physics/math/vectors.h"
#include "physics/run/run_setup.h"
#include "tests/support/scenes.h"

// Bodies that hop, rock and are hit on a floor of flush tiles.
namespace carom {
namespace {

// m: how far the lowest corner of a box of this size is over the floor y = 0.
double over_floor(const Simulation& run, int box, double width, double height) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const double x : {-0.5 * width, 0.5 * width}) {
    for (const double y : {-0.5 * height, 0.5 * height})
      lowest = std::min(lowest, turned_by(run.state().q(2, box), {x, y}).y());
  }
  return run.state().q(1, box) + lowest;
}

// A box is let go on one of its corners; the other one lands within millimetres of a seam, where it would
// sooner slip in beside a tile than sink into it.
TEST(TiledFloors, ABoxThatRocksBesideASeamStaysOnIt) {
  constexpr double kWidth = 0.288;   // m
  constexpr double kHeight = 0.072;  // m
  for (const double restitution : {0.0, 0.5, 0.8}) {
    for (const double tilt : {1e-3, 3e-3, 1e-2}) {
      for (const double beside : {2e-4, 5e-4, 8e-4, 1.2e-3, 3e-3}) {
        for (const double side : {1.0, -1.0}) {
          for (const double step : {1.0 / 60.0, 0.01, 0.005}) {
            RunSetup s = test::setup_with({}, restitution, 0.6);
            Body box = test::box("box", {0.0, 0.0}, {0.0, 0.0}, kWidth, kHeight, 1.7);
            box.angle = side * tilt;
            box.position.y() = 0.5 * (kWidth * std::sin(tilt) + kHeight * std::cos(tilt));
            // The corner in the air is on this side of the middle.
            const double seam = side * (0.5 * (kWidth * std::cos(tilt) - kHeight * std::sin(tilt)) - beside);
            s.scene.bodies = {test::wall("left", {seam - 0.5, -0.05}, 1.0, 0.1),
                              test::wall("right", {seam + 0.5, -0.05}, 1.0, 0.1), box};
            s.scene.forces.gravity = {0.0, -9.81};
            s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, step};
            SCOPED_TRACE(testing::Message() << "e = " << restitution << ", " << side * tilt << " rad, "
                                            << beside << " m, h = " << step);
            Simulation run(s);
            for (const double time : {0.02, 0.05, 0.1, 0.3}) {
              run.advance_to(time);
              EXPECT_GT(over_floor(run, 2, kWidth, kHeight), -1e-6) << time;
            }
            EXPECT_EQ(run.status(), "ok");
          }
        }
      }
    }
  }
}

// A pushed disc hits a box above its middle: one end of the box hops, the other one comes to rest at that
// moment, which is no collapse.
TEST(TiledFloors, AnEndThatComesToRestIsNoCollapse) {
  for (const double tile : {0.1, 0.3, 8.0}) {
    for (const double step : {1.0 / 60.0, 0.01, 0.005}) {
      RunSetup s = test::setup_with({test::disc("disc", {-0.246, 0.09}, {0.0, 0.0}, 0.09, 0.72),
                                     test::box("box", {0.0, 0.04}, {0.0, 0.0}, 0.26, 0.08, 1.36)},
                                    0.8, 0.1);
      for (double place = -4.0; place < 4.0; place += tile)
        s.scene.bodies.push_back(test::wall("tile at " + std::to_string(place), {place, -0.05}, tile, 0.1));
      s.scene.forces.gravity = {0.0, -9.81};
      AppliedForce push;
      push.body = "disc";
      push.force = {5.8, 0.0};
      push.rise = 0.5;
      s.scene.forces.applied.push_back(push);
      s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, step};
      Simulation run(s);
      run.advance_to(0.3);
      EXPECT_EQ(run.status(), "ok") << tile << " m, h = " << step;
    }
  }
}

// The front corner of a box is at the seam of two thin walls when a step ends. They have no sides that could
// tell along which normal the corner meets the second one: it was caught there.
TEST(TiledFloors, ABoxSlidesOverTheSeamOfThinWalls) {
  const auto after = [](double seam, double restitution, IntegratorId integrator, double step, double time) {
    RunSetup s = test::setup_with({}, restitution, 0.0);
    const auto wall = [](const std::string& name, double from, double to) {
      return test::fixed(name, Wall{to - from}, {0.5 * (from + to), 0.0});
    };
    s.scene.bodies = {wall("left", -1.0, seam), wall("right", seam, 4.0),
                      test::box("box", {0.3, 0.1}, {0.5, 0.0}, 0.3, 0.2)};
    s.scene.forces.gravity = {0.0, -9.81};
    s.method = {integrator, ImpactsId::kLocated, ContactsId::kLasting, step};
    Simulation run(s);
    run.advance_to(time);
    return (Eigen::Vector<double, 6>() << run.state().q.col(2), run.state().v.col(2)).finished();
  };
  for (const IntegratorId integrator :
       {IntegratorId::kRk4, IntegratorId::kVelocityVerlet, IntegratorId::kSemiImplicitEuler}) {
    for (const double restitution : {0.0, 0.3, 1.0}) {
      for (const double step : {1.0 / 60.0, 0.01, 1.0 / 120.0, 1.0 / 240.0, 1.0 / 960.0}) {
        for (const double time : {0.5, 1.0, 2.0}) {
          for (const double half : {0.15, -0.15}) {
            const Eigen::Vector<double, 6> end =
                after(0.3 + 0.5 * time + half, restitution, integrator, step, time + 0.25);
            const Eigen::Vector<double, 6> expected{0.3 + 0.5 * (time + 0.25), 0.1, 0.0, 0.5, 0.0, 0.0};
            EXPECT_LT((end - expected).cwiseAbs().maxCoeff(), 1e-9)
                << "e = " << restitution << ", h = " << step << ", " << time << " s, " << half << " m";
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace carom
