#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "physics/math/vectors.h"
#include "physics/run/run_setup.h"
#include "tests/support/scenes.h"

// Hits without rebound on bodies that stand on others: what they pass on, to the floor in the end, is in the
// log of impacts, too.
namespace carom {
namespace {

struct Scene {
  std::string name;
  std::vector<Body> bodies;  // over the floor y = 0
  int floor_hits;            // how many bodies hit the floor
  double mass = 0.0;         // kg: what falls and is stopped, by `way` m; 0: some goes on
  double way = 0.0;
};

const std::vector<Scene>& scenes() {
  const Vec2 still = Vec2::Zero();
  static const std::vector<Scene> all{
      {"ball on a box",
       {test::box("box", {0.0, 0.1}, still, 0.4, 0.2), test::disc("ball", {0.0, 0.8}, still)},
       1,
       1.0,
       0.5},
      {"ball on two balls",
       {test::disc("left", {-0.1, 0.1}, still), test::disc("right", {0.1, 0.1}, still),
        test::disc("ball", {0.0, 0.8}, still)},
       2},
      {"beam on two pillars",
       {test::box("left", {-0.3, 0.2}, still, 0.1, 0.4), test::box("right", {0.3, 0.2}, still, 0.1, 0.4),
        test::box("beam", {0.0, 0.7}, still, 0.8, 0.1)},
       2,
       1.0,
       0.25},
      {"two boxes that fall as a stack",
       {test::box("low", {0.0, 0.3}, still, 0.4, 0.2), test::box("top", {0.0, 0.5}, still, 0.4, 0.2)},
       1,
       2.0,
       0.2},
  };
  return all;
}

RunSetup setup(const Scene& scene, double friction, double step, double turn) {
  RunSetup s = test::setup_with(scene.bodies, 0.0, friction);
  s.scene.bodies.push_back(test::fixed("floor", Wall{}, {0.0, 0.0}));
  for (Body& body : s.scene.bodies) {
    body.position = turned_by(turn, body.position);
    body.angle = turn;
  }
  s.scene.forces.gravity = turned_by(turn, {0.0, -9.81});
  s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, step};
  return s;
}

// What is in the log of a run for half a second.
struct Logged {
  double lost = 0.0;             // J
  Vec2 to_floor = Vec2::Zero();  // N s
  int floor_hits = 0;
};

Logged logged(Simulation& run, BodyIndex floor) {
  Logged all;
  run.watch_impacts(true);
  while (run.time() < 0.5) {
    run.step();
    const std::vector<ImpactRecord>& records = run.last_impacts();
    EXPECT_EQ(run.last_jumps().size(), records.size());
    for (std::size_t k = 0; k < records.size(); ++k) {
      const ImpactRecord& record = records[k];
      all.lost += lost_energy(record);
      EXPECT_NEAR(run.last_jumps()[k].time, record.time, 1e-15);
      if (record.b != floor) continue;
      all.to_floor +=
          record.normal_impulse * record.normal + record.tangential_impulse * crossed(record.normal);
      ++all.floor_hits;
    }
  }
  return all;
}

TEST(ImpactsPassedOn, TheLogHasAllThatIsLostAndReachesTheFloor) {
  for (const Scene& scene : scenes()) {
    for (const double friction : {0.0, 0.3}) {
      for (const double step : {1.0 / 60.0, 1.0 / 120.0, 1.0 / 480.0}) {
        for (const double turn : {0.0, 0.7, -2.0}) {
          SCOPED_TRACE(testing::Message()
                       << scene.name << ", mu = " << friction << ", h = " << step << ", turned by " << turn);
          Simulation run(setup(scene, friction, step, turn));
          const Logged all = logged(run, BodyIndex{static_cast<int>(scene.bodies.size())});
          const Ledger ledger = run.ledger();
          // Friction of what slides on afterwards is none of the impacts'.
          EXPECT_GE(all.lost, ledger.lost_to_restitution - 1e-9);
          EXPECT_LE(all.lost, ledger.lost_to_restitution + ledger.lost_to_friction + 1e-9);
          EXPECT_GE(all.floor_hits, scene.floor_hits);
          if (scene.mass == 0.0) continue;
          const Vec2 down = turned_by(turn, {0.0, -1.0});
          EXPECT_NEAR(all.to_floor.dot(down), scene.mass * std::sqrt(2.0 * 9.81 * scene.way), 1e-9);
        }
      }
    }
  }
}

}  // namespace
}  // namespace carom
