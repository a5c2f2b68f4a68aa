#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/run/simulation.h"
#include "tests/support/scenes.h"

// A table of flush tiles is one table, also for what tips, rolls and slides over its seams and its edge, and
// where a drive moves all of it.
namespace carom {
namespace {

constexpr double kG = 9.81;

struct Mover {
  std::string name;
  Shape shape;
  double height = 0.0;  // m, of its centre over the table
  double angle = 0.0;   // rad
  double speed = 0.0;   // m/s
  double friction = 0.0;
};

std::vector<Mover> movers() {
  const Polygon lower{{{-0.4 / 1.5, -0.1 / 1.5}, {0.2 / 1.5, -0.1 / 1.5}, {0.2 / 1.5, 0.2 / 1.5}}};
  const Polygon upper{{{-0.2 / 1.5, -0.2 / 1.5}, {0.4 / 1.5, 0.1 / 1.5}, {-0.2 / 1.5, 0.1 / 1.5}}};
  const Vec2 lower_at(0.1 / 1.5, -0.1 / 3.0);
  return {
      {"tilted box", Box{0.1, 0.4}, 0.05 * std::sin(0.05) + 0.2 * std::cos(0.05), -0.05, 2.4, 0.3},
      {"box that tips", Box{0.1, 0.4}, 0.2, 0.0, 2.4, 0.3},
      {"box", Box{0.4, 0.2}, 0.1, 0.0, 1.77, 0.0},
      {"rounded box", Polygon{{{-0.1, -0.05}, {0.1, -0.05}, {0.1, 0.05}, {-0.1, 0.05}}, 0.05}, 0.1, 0.0, 2.6,
       0.5},
      {"body on two discs", Compound{{{Disc{0.05}, {-0.1, 0.0}, 0.0, ""}, {Disc{0.05}, {0.1, 0.0}, 0.0, ""}}},
       0.05, 0.0, 1.6, 0.0},
      {"hexagon", Polygon{{{-0.1, -0.1}, {0.1, -0.1}, {0.2, 0.0}, {0.1, 0.1}, {-0.1, 0.1}, {-0.2, 0.0}}}, 0.1,
       0.0, 1.5, 0.0},
      {"box of triangles", Compound{{{lower, lower_at, 0.0, ""}, {upper, -lower_at, 0.0, ""}}}, 0.1, 0.0, 2.0,
       0.0},
  };
}

enum class Table { kOne, kTiles, kDrivenTiles };

// The position, the angle and the velocities of a mover once it has left the table, in the table's frame.
Eigen::Matrix<double, 6, 1> beyond(const Mover& mover, Table table, double start, double step,
                                   IntegratorId integrator = IntegratorId::kRk4) {
  const Vec2 drive = table == Table::kDrivenTiles ? Vec2(1.0, 0.2) : Vec2::Zero();
  std::vector<Body> bodies;
  if (table == Table::kOne) {
    bodies = {test::wall("table", {-2.0, -0.25}, 4.0, 0.5)};
  } else {
    bodies = {test::wall("last tile", {-0.065, -0.25}, 0.13, 0.5),
              test::wall("tile", {-0.285, -0.25}, 0.31, 0.5),
              test::wall("first tile", {-2.22, -0.25}, 3.56, 0.5)};
  }
  if (table == Table::kDrivenTiles) {
    for (Body& body : bodies) {
      body.fixed = false;
      body.mass.reset();
      body.drive = Drive{.velocity = drive};
    }
  }
  Body body = test::box("mover", {start, mover.height}, Vec2(mover.speed, 0.0) + drive, 1.0, 1.0);
  body.shape = mover.shape;
  body.angle = mover.angle;
  bodies.push_back(body);
  RunSetup s = test::setup_with(std::move(bodies), 0.0, mover.friction);
  s.scene.forces.gravity = {0.0, -kG};
  s.method = {integrator, ImpactsId::kLocated, ContactsId::kLasting, step};
  Simulation run(s);
  const double until = -start / mover.speed + 0.25;
  run.advance_to(until, [] {});
  const Eigen::Index last = run.state().size() - 1;
  Eigen::Matrix<double, 6, 1> end;
  end << run.state().q.col(last), run.state().v.col(last);
  end.head<2>() -= until * drive;
  end.segment<2>(3) -= drive;
  return end;
}

TEST(TiledTables, AreOneTable) {
  for (const Mover& mover : movers()) {
    for (const double start : {-0.25, -0.37}) {
      const auto expected = beyond(mover, Table::kOne, start, 0.0005);
      for (const auto& [step, within] :
           {std::pair(1.0 / 60.0, 1e-4), std::pair(0.008, 1e-5), std::pair(0.004, 1e-6)}) {
        for (const Table table : {Table::kOne, Table::kTiles, Table::kDrivenTiles}) {
          for (const IntegratorId integrator : {IntegratorId::kRk4, IntegratorId::kVelocityVerlet}) {
            EXPECT_LT((beyond(mover, table, start, step, integrator) - expected).norm(), within)
                << mover.name << " from " << start << ", h = " << step << ", table " << static_cast<int>(table)
                << ", " << static_cast<int>(integrator);
          }
        }
      }
    }
  }
}

// What lands turned over a seam lands as on one table.
TEST(TiledTables, ABoxLandsAsOnOneTable) {
  for (const double angle : {0.05, 0.3, 0.7}) {
    for (const double friction : {0.0, 0.3}) {
      for (const double restitution : {0.0, 0.3}) {
        for (const double start : {0.02, -0.07}) {
          for (const double step : {1.0 / 60.0, 1.0 / 120.0}) {
            const auto landed_on = [&](std::vector<Body> bodies) {
              const double lowest = 0.15 * std::sin(angle) + 0.1 * std::cos(angle);
              Body box = test::box("box", {start, lowest + 0.05}, {0.0, 0.0}, 0.3, 0.2);
              box.angle = angle;
              bodies.push_back(box);
              RunSetup s = test::setup_with(std::move(bodies), restitution, friction);
              s.scene.forces.gravity = {0.0, -kG};
              s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, step};
              Simulation run(s);
              run.advance_to(0.35, [] {});
              Eigen::Matrix<double, 6, 1> end;
              end << run.state().q.rightCols<1>(), run.state().v.rightCols<1>();
              return end;
            };
            const auto on_one = landed_on({test::wall("table", {0.0, -0.25}, 8.0, 0.5)});
            const auto on_two = landed_on(
                {test::wall("left", {-2.0, -0.25}, 4.0, 0.5), test::wall("right", {2.0, -0.25}, 4.0, 0.5)});
            EXPECT_LT((on_two - on_one).norm(), 1e-5)
                << angle << " rad, e = " << restitution << ", mu = " << friction << ", " << start
                << ", h = " << step;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace carom
