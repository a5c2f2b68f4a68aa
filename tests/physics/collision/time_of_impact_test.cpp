#include "physics/collision/time_of_impact.h"

#include <gtest/gtest.h>
#include <random>

#include "physics/collision/contact.h"
#include "physics/collision/pair_contact.h"
#include "physics/dynamics/integrators/integrators.h"
#include "physics/model/compiled_scene.h"
#include "physics/run/run_setup.h"
#include "tests/support/body_literal.h"
#include "tests/support/scenes.h"

namespace carom {
namespace {

using namespace test::literals;

using test::disc;
using test::setup_with;
using test::wall;

double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
}

TEST(BracketedRoot, ToTheLastBit) {
  const auto check = [](auto f, double a, double b, double root) {
    int calls = 0;
    const auto counted = [&](double t) {
      ++calls;
      return f(t);
    };
    const double x = bracketed_root(counted, a, f(a), b, f(b));
    EXPECT_NEAR(x, root, 4e-16 * std::abs(root) + 1e-300) << calls;
    EXPECT_GE(f(x), 0.0);
    EXPECT_LT(calls, 120);
  };
  check([](double t) { return 2.0 - t * t; }, 0.0, 2.0, std::sqrt(2.0));
  check([](double t) { return 1.0 - t; }, 0.0, 3.0, 1.0);
  check([](double t) { return std::cos(t); }, 0.0, 3.0, 1.5707963267948966);
  check([](double t) { return 1e-9 - t * t * t; }, 0.0, 1.0, 1e-3);
  check([](double t) { return t < 0.3 ? 1e-8 : -1.0; }, 0.0, 1.0, 0.3);
  check([](double t) { return t < 0.3 ? 1.0 : -1e-12; }, 0.0, 1.0, 0.3);
  check([](double t) { return 1.0 - t; }, 0.0, 1.0, 1.0);
}

struct BodyRates {
  const ForceField& field;
  BodyIndex body;
  void operator()(double t, const Motion& y, Motion& k) const { field.external_rate(body, t, y, k); }
};

// One flight of two bodies over [0, h] under gravity, by an integrator's own map, as a gap function.
struct Flight {
  std::vector<Body> bodies;
  Forces forces;
  double h;

  [[nodiscard]] std::shared_ptr<const Model> compiled() const {
    Scene scene = test::scene_with(bodies);
    scene.forces = forces;
    const Needs needs = needs_of(scene);
    const auto all = compile(std::move(scene), needs);
    return {all, &all->model};
  }
  [[nodiscard]] auto sampler(IntegratorId id) const {
    return [this, id, g = geometry(bodies), field = ForceField(compiled())](double t) {
      const auto flown = [&](BodyIndex body) -> Eigen::Vector3d {
        const Motion from = initial_motion(bodies[body]);
        if (bodies[body].fixed) return from.head<3>();
        Stages<Motion> stages;
        Motion to = Motion::Zero();
        integrator_step(id, BodyRates{field, body}, 0.0, from, t, stages, to);
        return to.head<3>();
      };
      const Eigen::Vector3d qa = flown(0_b);
      const Eigen::Vector3d qb = flown(1_b);
      const Contact c = contact_between(g, 0_b, qa, 1_b, qb);
      return GapSample{c.gap, c.normal, (qb - qa).head<2>()};
    };
  }
};

// Random flights against dense sampling: an overlap that sampling sees is found, at or before its first sample,
// and what is found closes the gap there for the first time.
TEST(FirstContact, RandomFlightsAgainstDenseSampling) {
  std::mt19937_64 random(11);
  int hits = 0;
  int passes = 0;
  for (int n = 0; n < 4000; ++n) {
    Flight f;
    f.h = uniform(random, 0.01, 2.0);
    // A box does not fall; gravity bends the disc's path alone. Two discs: the first is fixed half of the time.
    const Vec2 at(uniform(random, -3.0, 3.0), uniform(random, -3.0, 3.0));
    const Vec2 v(uniform(random, -6.0, 6.0), uniform(random, -6.0, 6.0));
    f.bodies = {n % 2 == 0 ? wall("a", {0, 0}, uniform(random, 0.05, 2.0), uniform(random, 0.05, 2.0),
                                  uniform(random, 0.0, 3.0))
                           : disc("a", {0, 0}, {0, 0}, uniform(random, 0.05, 1.0)),
                disc("b", at, v, uniform(random, 0.01, 0.5))};
    f.bodies[0].fixed = n % 4 != 3;
    f.forces.gravity = {0.0, -9.81};
    const IntegratorId id = kIntegrators[static_cast<std::size_t>(n % 3)].id;
    const auto sample = f.sampler(id);
    const GapSample first = sample(0.0);
    if (first.gap <= 1e-12) continue;
    const double curvature = 2.0 * 9.81 * (f.bodies[0].fixed ? 1.0 : 2.0);
    const auto found = first_contact(sample, 0.0, first, f.h, sample(f.h), curvature, 1e-14);

    constexpr int kSamples = 2000;
    double sampled = -1.0;
    for (int i = 1; i <= kSamples && sampled < 0.0; ++i) {
      if (sample(f.h * i / kSamples).gap < -1e-13) sampled = f.h * i / kSamples;
    }
    if (sampled >= 0.0) {
      ++hits;
      ASSERT_TRUE(found.has_value()) << n;
      ASSERT_LE(*found, sampled) << n;
      if (sampled - *found > 1.001 * f.h / kSamples) {
        // Earlier than sampling saw: then the gap was closed between two samples.
        ASSERT_LT(sample(*found).gap, 1e-12);
      }
    } else {
      ++passes;
    }
    if (found) {
      ASSERT_NEAR(sample(*found).gap, 0.0, 1e-12) << n;
      for (int i = 0; i < 200; ++i) ASSERT_GE(sample(*found * i / 200).gap, -1e-12) << n;
    }
  }
  EXPECT_GT(hits, 300);
  EXPECT_GT(passes, 500);
}

TEST(FirstContact, GrazingIsNeitherMissedNorInvented) {
  for (const double depth : {1e-6, 1e-9, 1e-12}) {
    for (const double sign : {-1.0, 1.0}) {
      // Past a fixed disc on a straight line, and over a floor at the lowest point of a parabola.
      RunSetup straight =
          setup_with({disc("a", {0, 0}, {0, 0}, 0.25), disc("b", {-1.0, 0.5 - sign * depth}, {3.0, 0}, 0.25)});
      straight.scene.bodies[0].fixed = true;
      straight.method.step = 1.0;
      Simulation one(straight);
      one.step();
      EXPECT_EQ(one.impact_count(), sign > 0.0 ? 1 : 0) << depth;

      // y = 0.25 - sign·depth + (t - 1/2)²/2 above a floor: gravity points up.
      RunSetup bent = setup_with({wall("floor", {0, -0.5}, 9.0, 1.0),
                                  disc("b", {-1.0, 0.25 - sign * depth + 0.125}, {2.0, -0.5}, 0.25)});
      bent.scene.forces.gravity = {0.0, 1.0};
      bent.method.step = 1.0;
      Simulation two(bent);
      two.step();
      EXPECT_EQ(two.impact_count(), sign > 0.0 ? 1 : 0) << depth;
    }
  }
}

TEST(FirstContact, CornerHit) {
  // Straight down on the corner of a box: contact at 45° above the corner, known in closed form.
  const double r = 0.2;
  RunSetup s = setup_with({wall("box", {-0.5, -0.5}, 1.0, 1.0), disc("d", {0.1, 1.0}, {0.0, -1.0}, r)});
  s.method.step = 2.0;
  Simulation run(s);
  run.step();
  ASSERT_GE(run.last_impacts().size(), 1U);
  const ImpactRecord& hit = run.last_impacts()[0];
  EXPECT_NEAR(hit.time, 1.0 - std::sqrt(r * r - 0.01), 1e-14);
  EXPECT_NEAR((hit.normal - Vec2(0.5, std::sqrt(0.75))).norm(), 0.0, 1e-13);
  EXPECT_NEAR(hit.point.norm(), 0.0, 1e-13);
}

TEST(FirstContact, SeveralImpactsInOneStep) {
  // A disc between two walls for 1000 crossings in one step: the exact unfolding says where it ends.
  RunSetup s = setup_with(
      {wall("left", {-1.5, 0}, 1.0, 1.0), wall("right", {1.5, 0}, 1.0, 1.0), disc("d", {0, 0}, {1800.0, 0})});
  s.method.step = 1.0;
  Simulation run(s);
  run.step();
  EXPECT_EQ(run.impact_count(), 1000);
  EXPECT_NEAR(run.state().position(2).x(), 0.0, 1e-9);
  EXPECT_EQ(run.state().velocity(2).x(), 1800.0);
  for (std::size_t i = 0; i < run.last_impacts().size(); ++i) {
    EXPECT_NEAR(run.last_impacts()[i].time, (0.5 + static_cast<double>(i)) / 1000.0, 1e-12);
  }
}

}  // namespace
}  // namespace carom
