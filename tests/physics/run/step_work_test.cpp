#include "physics/step/step_work.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <set>
#include <stop_token>

#include "physics/collision/broad_phase.h"
#include "physics/collision/time_of_impact.h"
#include "physics/dynamics/integrators/integrators.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/run/simulation.h"
#include "physics/scene/facts.h"
#include "physics/step/pair_list.h"
#include "tests/support/body_literal.h"
#include "tests/support/effort.h"
#include "tests/support/heap.h"
#include "tests/support/scenes.h"
#include "tests/support/source_folder.h"

// A step ends in every scene: its cost is bounded, and a run that reaches a bound reports it.
namespace carom {
namespace {

using namespace test::literals;

using test::disc;

// Scenes in which a step once took for ever, under every method that they allow.
TEST(StepWork, HardScenesEnd) {
  const int steps = test::by_effort(1, 4, 4);
  int scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(test::source("tests/physics/run/hard"))) {
    Preset s = read_preset(entry.path());
    ++scenes;
    for (const IntegratorChoice& integrator : kIntegrators) {
      if (why_not(s.scene, integrator.id)) continue;
      for (const ImpactsId impacts : {ImpactsId::kLocated, ImpactsId::kStepEnd}) {
        for (const ContactsId contacts : {ContactsId::kImpulse, ContactsId::kLasting}) {
          const double step = s.method.step;
          s.method = {.integrator = integrator.id, .impacts = impacts, .contacts = contacts, .step = step};
          Simulation run(setup_of(s));
          for (int k = 0; k < steps; ++k) run.step();
          EXPECT_TRUE(run.steps() == steps || run.lost()) << entry.path();
        }
      }
    }
  }
  EXPECT_GE(scenes, 10);
}

TEST(StepWork, TheRestIsReported) {
  Preset s = read_preset(test::source("tests/physics/run/hard") / "hang-strong-gravity.json");
  s.method.contacts = ContactsId::kImpulse;
  s.method.step = 0.2;
  Simulation run(setup_of(s));
  run.step();
  EXPECT_GE(run.notices().work_spent_since, 0.0);
  EXPECT_NE(run.status().find("exceeds the budget of a step"), std::string::npos);
}

// A box sinks into the floor inside a wide one, which covers the floor's surface there: no impact, wherever it
// is looked for.
TEST(StepWork, OverlapsUnderACoveredSurfaceCostLittle) {
  Preset s = test::preset_with({test::fixed("floor", Wall{}, {0, 0}), test::wall("table", {0, 0.5}, 16, 1),
                                test::box("box", {2.5, -0.05}, {0.1, -2}, 1.2, 0.3)});
  s.method = {.impacts = ImpactsId::kLocated, .contacts = ContactsId::kLasting, .step = 0.1};
  Simulation run(setup_of(s));
  run.step();
  EXPECT_LT(run.notices().work_spent_since, 0.0);
}

TEST(StepWork, BodiesAtOnePlaceAreLookedAtInPart) {
  RunSetup s = test::heap(50, 40);
  for (const ImpactsId impacts : {ImpactsId::kLocated, ImpactsId::kStepEnd}) {
    s.method = {.impacts = impacts, .step = 0.005};
    Simulation run(s);
    run.step();
    EXPECT_EQ(run.notices().pairs_cut_since, 0.0);
    EXPECT_NE(run.status().find("more pairs of bodies overlap"), std::string::npos);
  }
  Simulation few(test::heap(10, 10));
  few.step();
  EXPECT_LT(few.notices().pairs_cut_since, 0.0);
}

TEST(StepWork, AStepStopsWhereItIsAskedTo) {
  Simulation run(test::heap(40, 25, 1.0));
  std::stop_source stop;
  run.interrupt_on(stop.get_token());
  run.step();
  stop.request_stop();
  EXPECT_THROW(run.step(), StepInterrupted);
}

TEST(StepWork, SearchesEndAtTheirLimit) {
  // Two points slide along each other very closely: curvature bounds never separate them.
  int looks = 0;
  const auto sample = [&](double t) {
    ++looks;
    return GapSample{1e-12, Vec2::UnitY(), Vec2(t, 1e-12)};
  };
  SearchLimit limit{.looks = 100};
  EXPECT_FALSE(first_contact(sample, 0.0, sample(0.0), 1.0, sample(1.0), 1.0, 1e-15, limit));
  EXPECT_TRUE(limit.reached);
  EXPECT_EQ(looks, 102);
  // A known contact is still reported.
  const auto falls = [](double t) { return GapSample{0.5 - t, Vec2::UnitY(), Vec2(0.0, 0.5 - t)}; };
  SearchLimit none{.looks = 0};
  const auto found = first_contact(falls, 0.0, falls(0.0), 1.0, falls(1.0), 1e9, 1e-15, none);
  ASSERT_TRUE(found);
  EXPECT_NEAR(*found, 0.5, 1e-12);
}

// Fast flight through an empty plane ends only a few trajectories.
TEST(StepWork, FastBodiesCostNoMoreThanSlowOnes) {
  Preset s = test::preset_with({disc("a", {0, 0}, {1e12, 0}), disc("b", {5, 0}, {0, 1e12})});
  s.scene.bodies[1].shape = Box{0.2, 0.1};
  s.scene.bodies[1].spin = 1e9;
  s.method = {.integrator = IntegratorId::kExactFlight, .step = 0.005};
  Simulation run(setup_of(s));
  run.advance_to(0.05);
  EXPECT_NEAR(run.state().position(0).x(), 5e10, 0.05);
  EXPECT_LT(run.evaluations(), 1'000'000);
}

TEST(StepWork, ManySwitchesAreFollowedInPart) {
  // A chain of strings with flying beads: each taut impulse slackens others.
  Preset s = test::preset_with({});
  s.scene.forces.gravity = {0, -9.81};
  for (int i = 0; i <= 200; ++i) {
    s.scene.bodies.push_back(
        disc(fmt::format("b{}", i), {0.25 * i, 0}, {std::sin(7.0 * i), std::cos(5.0 * i)}, 0.05));
    if (i == 0) continue;
    Joint joint;
    joint.kind = JointKind::kString;
    joint.body = s.scene.bodies[static_cast<std::size_t>(i) - 1].name;
    joint.to = s.scene.bodies.back().name;
    joint.length = 0.26;
    s.scene.joints.push_back(joint);
  }
  s.method = {.integrator = IntegratorId::kRk4, .step = 0.005};
  Simulation run(setup_of(s));
  for (int k = 0; k < 10; ++k) run.step();
  EXPECT_EQ(run.steps(), 10);
}

TEST(PairList, FindsWhatItHas) {
  PairList list;
  std::set<std::pair<int, int>> resting;
  for (int round = 0; round < 2; ++round) {
    resting.clear();
    for (int i = 0; i < 500; ++i) {
      const BodyIndex a{(i * 37) % 61};
      const BodyIndex b{a + 1 + (i * 13) % 41};
      const bool rests = i % 5 == 0;
      list.add(a, b, rests);
      if (rests) resting.emplace(a, b);
    }
    std::set<std::pair<int, int>> seen;
    for (const WaitingPair& p : list.all()) {
      EXPECT_TRUE(seen.emplace(p.a, p.b).second);
      EXPECT_EQ(p.resting, resting.contains({p.a, p.b}));
      EXPECT_EQ(list.rests(p.a, p.b), p.resting);
    }
    EXPECT_FALSE(list.rests(100_b, 200_b));
    list.clear();
    EXPECT_FALSE(list.rests(0_b, 1_b));
  }
}

TEST(BroadPhase, KeepsSoManyPairsAtTheMost) {
  const std::vector<Bounds> bounds(2000, {{0.0, 0.0}, {1.0, 1.0}});
  const std::vector<std::uint8_t> fixed(2000, 0);
  BroadPhase broad_phase;
  EXPECT_EQ(broad_phase.pairs(bounds, fixed).size(), BroadPhase::most_pairs(2000));
  EXPECT_TRUE(broad_phase.cut());
  const std::vector<Bounds> few(bounds.begin(), bounds.begin() + 100);
  EXPECT_EQ(broad_phase.pairs(few, {fixed.begin(), fixed.begin() + 100}).size(), 100U * 99U / 2U);
  EXPECT_FALSE(broad_phase.cut());
}

}  // namespace
}  // namespace carom
