#include "physics/world/frame.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "physics/world/thinning.h"
#include "tests/physics/scenes.h"

namespace carom {
namespace {

using test::disc;
using test::room;

// Drag, e < 1 and friction: every entry of the samples grows.
Scene lossy() {
  std::vector<Body> bodies = room(1.0, 0.5);
  bodies.push_back(disc("a", {-0.5, 0.1}, {3.0, 1.0}));
  bodies.push_back(disc("b", {0.5, -0.1}, {-2.0, 2.0}));
  Scene s = test::scene(std::move(bodies), 0.8, 0.3);
  s.forces.quadratic_drag = 0.05;
  s.forces.gravity = {0.0, -1.0};
  s.method.step = 0.02;
  return s;
}

std::vector<Sample> run(const Scene& scene, double time, std::vector<ImpactRecord>* impacts = nullptr) {
  Simulation simulation(scene);
  simulation.watch_impacts(true);
  std::vector<Sample> samples = {sample_of(simulation)};
  simulation.advance_to(time, [&] {
    append_samples(simulation, samples);
    if (impacts != nullptr) {
      impacts->insert(impacts->end(), simulation.last_impacts().begin(), simulation.last_impacts().end());
    }
  });
  return samples;
}

TEST(Samples, CloseTheLedgerAtEachStep) {
  const Scene scene = lossy();
  const std::vector<Sample> samples = run(scene, 2.0);
  const Sample& first = samples.front();
  EXPECT_EQ(first.lost_in_flight, 0.0);
  EXPECT_EQ(first.drift, 0.0);
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const Sample& s = samples[i];
    if (i + 1 < samples.size() && samples[i + 1].time == s.time) continue;  // before an impact
    if (samples[i - 1].time == s.time) continue;                            // after an impact
    EXPECT_NEAR(s.totals.energy(),
                first.totals.energy() - s.lost_to_restitution - s.lost_to_friction - s.lost_in_flight +
                    s.put_in + s.drift,
                1e-12);
  }
  EXPECT_GT(samples.back().lost_to_restitution, 0.1);
  EXPECT_GT(samples.back().lost_to_friction, 0.01);
  EXPECT_GT(samples.back().lost_in_flight, 0.1);
}

TEST(Samples, LossesJumpAtTheImpactsAlone) {
  std::vector<ImpactRecord> impacts;
  const std::vector<Sample> samples = run(lossy(), 2.0, &impacts);
  ASSERT_GT(impacts.size(), 5U);
  std::size_t jumps = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const double restitution = samples[i].lost_to_restitution - samples[i - 1].lost_to_restitution;
    const double friction = samples[i].lost_to_friction - samples[i - 1].lost_to_friction;
    const auto impact = std::find_if(impacts.begin(), impacts.end(), [&](const ImpactRecord& r) {
      return samples[i].time == r.time && samples[i - 1].time == r.time;
    });
    if (impact == impacts.end()) {
      EXPECT_NEAR(restitution, 0.0, 1e-12) << samples[i].time;
      EXPECT_NEAR(friction, 0.0, 1e-12);
    } else {
      ++jumps;
      EXPECT_NEAR(restitution, impact->lost_to_restitution, 1e-12);
      EXPECT_NEAR(friction, impact->lost_to_friction, 1e-12);
    }
  }
  EXPECT_EQ(jumps, impacts.size());
}

TEST(Thinning, LeavesAFewAlone) {
  std::vector<Sample> samples(1000);
  std::vector<ImpactRecord> impacts(1000);
  EXPECT_TRUE(thin(samples));
  EXPECT_TRUE(thin(impacts));
  EXPECT_EQ(samples.size(), 1000U);
  EXPECT_EQ(impacts.size(), 1000U);
}

}  // namespace
}  // namespace carom
