#include <cmath>
#include <gtest/gtest.h>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/scene/facts.h"
#include "physics/scene/validate.h"
#include "tests/support/draws.h"
#include "tests/support/effort.h"
#include "tests/support/preset_files.h"
#include "tests/support/random_edit.h"
#include "tests/support/random_scene.h"
#include "tests/support/resumed_run.h"
#include "tests/support/scenes.h"

// Edits of the scene of a run on its way: what they don't concern goes on, and what they bring is accounted
// for.
namespace carom {
namespace {

namespace fs = std::filesystem;
using test::disc;
using test::wall;

Scene with_ids(Scene scene) {
  give_ids(scene);
  return scene;
}

// The body of a name, as the document has it.
Body body_of(const Scene& scene, const std::string& name) {
  for (const Body& body : scene.bodies) {
    if (body.name == name) return body;
  }
  return {};
}

class PresetEdited : public testing::TestWithParam<fs::path> {};

// An edit that changes nothing leaves the run as it is, to rounding.
TEST_P(PresetEdited, GoesOnWhereNothingIsChanged) {
  Preset preset = read_preset(GetParam());
  preset.method.step = std::clamp(preset.duration / 40.0, preset.method.step, 0.05);
  give_ids(preset.scene);
  for (const ContactsId contacts : {ContactsId::kImpulse, ContactsId::kLasting}) {
    preset.method.contacts = contacts;
    Simulation whole(setup_of(preset));
    while (whole.steps() < 20 && whole.impact_count() < 200 && !whole.lost()) whole.step();
    if (whole.lost()) continue;
    const Preset start = test::saved_and_read(preset, whole);
    Simulation edited = whole;
    SceneEdits same = {SetLaws{preset.scene.impact_law, preset.scene.several_impacts}};
    for (const Body& body : preset.scene.bodies) same.push_back(Replace<Body>{body});
    edited.apply(same);
    EXPECT_EQ(edited.steps(), whole.steps());
    EXPECT_EQ(edited.time(), whole.time());
    EXPECT_NEAR(edited.ledger().put_in_by_user, 0.0, 1e-11 * std::max(1.0, whole.ledger().turnover()));
    for (int i = 0; i < 10 && !whole.lost(); ++i) {
      whole.step();
      edited.step();
      ASSERT_EQ(test::unexplained(whole, edited, start), "");
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, PresetEdited, testing::ValuesIn(test::preset_files()), test::preset_test_name);

// Random edits of random scenes: bodies that are not replaced stand and move as before, replaced ones too, and
// the ledger closes as well as before.
TEST(EditOfARun, KeepsMotionsAndTheLedger) {
  const int count = test::by_effort(50, 300, 3000);
  int made = 0;
  for (int k = 1; k <= count; ++k) {
    test::Draws draws(static_cast<std::uint64_t>(k));
    Preset preset = test::random_scene(static_cast<std::uint64_t>(k)).preset;
    give_ids(preset.scene);
    preset.method.integrator = kIntegrators[static_cast<std::size_t>(k) % std::size(kIntegrators)].id;
    if (why_not(preset.scene, preset.method.integrator)) preset.method.integrator = IntegratorId::kRk4;
    preset.method.impacts = draws.chance(0.3) ? ImpactsId::kStepEnd : ImpactsId::kLocated;
    preset.method.contacts = draws.chance(0.5) ? ContactsId::kImpulse : ContactsId::kLasting;
    Simulation run(setup_of(preset));
    for (int n = 0; n < 4; ++n) {
      run.advance_to(run.time() + 0.1);
      if (run.lost()) break;
      Preset with = preset;
      SceneEdits edits = {test::random_edit(with.scene, draws)};
      std::visit(
          [&](auto& edit) {
            if constexpr (requires { edit.at; }) edit.part.id.number = with.scene.ids_given + 1;
          },
          edits.front());
      try {
        apply_edits(with.scene, edits);
        validate(with);
        check_integrator("/method", with.scene, preset.method);
      } catch (const SceneError&) {
        continue;
      }
      preset = with;
      const Simulation before = run;
      run.apply(edits);
      ++made;
      const double scale = std::max(1.0, before.ledger().turnover());
      EXPECT_NEAR(run.ledger().numerical_drift(run.totals().energy()),
                  before.ledger().numerical_drift(before.totals().energy()), 1e-10 * scale);
      for (std::size_t i = 0; i < run.bodies().size(); ++i) {
        for (std::size_t j = 0; j < before.bodies().size(); ++j) {
          const Body& body = run.bodies()[i];
          if (body.id.number == 0 || body.id != before.bodies()[j].id) continue;
          const int now = static_cast<int>(i);
          const int then = static_cast<int>(j);
          // The joints of a scene are put right to rounding.
          EXPECT_LT((run.state().q.col(now) - before.state().q.col(then)).norm(), 1e-9) << write_preset(preset);
          if (!has_infinite_mass(body)) {
            EXPECT_LT((run.state().v.col(now) - before.state().v.col(then)).norm(),
                      1e-9 * (1.0 + before.state().v.col(then).norm()));
          }
        }
      }
    }
  }
  EXPECT_GT(made, count);
}

// An oscillator whose mass is changed swings on at the new frequency from where it is.
TEST(EditOfARun, ANewMassSwingsAtItsOwnFrequency) {
  RunSetup setup = test::setup_with({disc("bob", {1.0, 0.0}, {0.0, 0.0})});
  Spring& spring = setup.scene.forces.springs.emplace_back();
  spring.body = "bob";
  spring.stiffness = 4.0;
  setup.scene = with_ids(setup.scene);
  setup.method = {.integrator = IntegratorId::kRk4, .step = 1e-3};
  Simulation run(setup);
  run.advance_to(0.5);  // ω = 2
  Body heavy = body_of(setup.scene, "bob");
  heavy.mass = 16.0;
  const double energy = run.totals().energy();
  run.apply({Replace<Body>{heavy}});
  const double v = -2.0 * std::sin(1.0);
  EXPECT_NEAR(run.ledger().put_in_by_user, 0.5 * 15.0 * v * v, 1e-11);
  EXPECT_NEAR(run.totals().energy(), energy + 0.5 * 15.0 * v * v, 1e-11);
  run.advance_to(1.5);  // ω = 1/2 for 1 s
  EXPECT_NEAR(run.state().position(0).x(), std::cos(1.0) * std::cos(0.5) + v / 0.5 * std::sin(0.5), 1e-11);
}

// A floor that goes, a rod that goes, a drive that ends, a body that is let go.
TEST(EditOfARun, WhatHeldABodyLetsItGo) {
  Body table = wall("table", {0.0, -0.5}, 4.0, 1.0);
  Body lift = wall("lift", {5.0, 0.0}, 1.0, 0.2);
  lift.fixed = false;
  lift.drive = Drive{.amplitude = {0.0, 0.3}, .angular_frequency = 2.0};
  RunSetup setup = test::setup_with({table, disc("ball", {0.0, 0.1}, {0.0, 0.0}), lift,
                                     disc("bob", {-5.0, -1.0}, {2.0, 0.0}), wall("hung", {9.0, 0.0}, 0.3, 0.3)},
                                    0.0);
  Joint& rod = setup.scene.joints.emplace_back();
  rod.body = "bob";
  rod.anchor = {-5.0, 0.0};
  setup.scene.forces.gravity = {0.0, -9.81};
  setup.scene = with_ids(setup.scene);
  setup.method = {.integrator = IntegratorId::kRk4, .contacts = ContactsId::kLasting, .step = 1e-3};
  Simulation run(setup);
  run.advance_to(0.2);
  EXPECT_NEAR(run.state().position(1).y(), 0.1, 1e-12);
  const State at = run.state();
  Body free = body_of(setup.scene, "lift");
  free.drive.reset();
  Body fell = body_of(setup.scene, "hung");
  fell.fixed = false;
  run.apply({Remove<Body>{run.bodies()[0].id}, Remove<Joint>{run.joints()[0].id}, Replace<Body>{free},
             Replace<Body>{fell}});
  ASSERT_EQ(run.bodies().size(), 4U);
  EXPECT_TRUE(run.contact_forces().empty());
  constexpr double kFor = 0.3;
  run.advance_to(0.2 + kFor);
  const auto free_fall = [&](int was, int now, const Vec2& velocity) {
    const Vec2 expected = at.position(was) + kFor * velocity + Vec2(0.0, -0.5 * 9.81 * kFor * kFor);
    EXPECT_LT((run.state().position(now) - expected).norm(), 1e-12)
        << run.bodies()[static_cast<std::size_t>(now)].name;
  };
  free_fall(1, 0, Vec2::Zero());
  free_fall(2, 1, {0.0, 0.6 * std::cos(0.4)});
  free_fall(3, 2, at.velocity(3));
  free_fall(4, 3, Vec2::Zero());
}

// A welded pair that a run made goes with its bodies, whatever they are called, and not without one of them.
TEST(EditOfARun, WeldsOfTheRunFollowTheirBodies) {
  RunSetup setup = test::setup_with({disc("a", {-0.5, 0.0}, {1.0, 0.0}), disc("b", {0.5, 0.0}, {-0.5, 0.0})});
  setup.scene.materials[0].sticks = true;
  setup.scene = with_ids(setup.scene);
  Simulation run(setup);
  run.advance_to(0.6);
  ASSERT_EQ(run.joints().size(), 1U);
  Body renamed = body_of(setup.scene, "b");
  renamed.name = "c";
  run.apply({Replace<Body>{renamed}});
  ASSERT_EQ(run.joints().size(), 1U);
  run.advance_to(1.0);
  EXPECT_NEAR((run.state().position(0) - run.state().position(1)).norm(), 0.2, 1e-12);
  run.apply({Remove<Body>{renamed.id}});
  EXPECT_TRUE(run.joints().empty());
  run.advance_to(1.5);
  EXPECT_EQ(run.bodies().size(), 1U);
}

// A notice keeps to the bodies that it is about: under their new names and places, and without one that is
// gone.
TEST(EditOfARun, NoticesFollowTheirBodies) {
  Scene scene = test::scene_with({wall("floor", {0.0, -0.5}, 4.0, 1.0), disc("far", {1.5, 3.0}, {0.0, 0.0}),
                                  disc("ball", {0.0, 0.3}, {0.0, 0.0})},
                                 0.3);
  scene.forces.gravity = {0.0, -9.81};
  Simulation run({with_ids(std::move(scene)), {.integrator = IntegratorId::kRk4, .step = 0.01}, {}});
  run.advance_to(0.8);
  EXPECT_NE(run.status().find("(floor and ball)"), std::string::npos) << run.status();
  const auto body_now = [&](const std::string& name) {
    Scene now;
    now.bodies = run.bodies();
    return body_of(now, name);
  };
  run.apply({Remove<Body>{body_now("far").id}});
  EXPECT_NE(run.status().find("(floor and ball)"), std::string::npos) << run.status();
  Body renamed = body_now("ball");
  renamed.name = "marble";
  run.apply({Replace<Body>{renamed}});
  EXPECT_NE(run.status().find("(floor and marble)"), std::string::npos) << run.status();
  run.apply({Remove<Body>{body_now("floor").id}});
  EXPECT_EQ(run.status().find("marble"), std::string::npos) << run.status();
  EXPECT_NE(run.status(), "ok");
}

// Edits of a setup: a scene changes at its time, where a step ends, a method at the last end of a step that is
// not after.
TEST(EditOfARun, ComesAtItsTime) {
  RunSetup setup = test::setup_with({disc("a", {0.0, 0.0}, {1.0, 0.0})});
  setup.method.step = 0.1;
  const Method fine{.integrator = setup.method.integrator, .step = 0.01};
  setup.edits = {{0.0, 1, SceneEdits{Add<Body>{disc("first", {0.0, 1.0}, {0.0, 0.0})}}},
                 {0.25, 2, SceneEdits{Add<Body>{disc("second", {0.0, 2.0}, {1.0, 0.0})}}},
                 {0.45, 3, fine}};
  Simulation run(setup);
  run.advance_to(0.2);
  EXPECT_EQ(run.bodies().size(), 2U);
  run.advance_to(0.4);
  ASSERT_EQ(run.bodies().size(), 3U);
  EXPECT_NEAR(run.state().position(2).x(), 0.15, 1e-15);
  EXPECT_EQ(run.steps(), 5) << "to 0.1, 0.2, 0.25, 0.3 and 0.4 s";
  run.step();
  EXPECT_NEAR(run.time(), 0.41, 1e-15);
  EXPECT_EQ(run.method(), fine);
  EXPECT_EQ(run.edits_applied(), 3U);
  EXPECT_EQ(run.due(), nullptr);
}

// What comes in within a step flies from there: not from the step's end.
TEST(EditOfARun, AFallBeginsAtItsTimeAtAnyStep) {
  constexpr double kFrom = 0.3137;
  RunSetup setup = test::setup_with({disc("early", {5.0, 0.0}, {0.0, 0.0})});
  setup.scene.forces.gravity = {0.0, -9.81};
  setup.edits = {{kFrom, 1, SceneEdits{Add<Body>{disc("late", {0.0, 0.0}, {1.0, 2.0})}}}};
  for (const double step : {1.0 / 60.0, 0.01, 0.003}) {
    setup.method.step = step;
    Simulation run(setup);
    run.advance_to(1.0);
    const double t = 1.0 - kFrom;
    EXPECT_NEAR(run.state().position(1).x(), t, 1e-14) << step;
    EXPECT_NEAR(run.state().position(1).y(), 2.0 * t - 0.5 * 9.81 * t * t, 1e-14) << step;
    EXPECT_NEAR(run.state().position(0).y(), -0.5 * 9.81, 1e-13) << step;
    EXPECT_EQ(run.steps(), std::lround(std::ceil(1.0 / step - 1e-9)) + 1)
        << "one step is divided, the others stay";
  }
}

}  // namespace
}  // namespace carom
