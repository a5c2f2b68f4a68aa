#include <functional>
#include <gtest/gtest.h>
#include <map>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/preset/preset.h"
#include "physics/scene/facts.h"
#include "tests/support/resumed_run.h"
#include "tests/support/scenes.h"

// What must be kept of a run, kind by kind, in a file and in memory; and edits of runs before and after.
namespace carom {
namespace {

using test::all_of;
using test::disc;
using test::kept_and_restored;
using test::parting;
using test::preset_with;
using test::saved_and_read;
using test::unexplained;
using test::wall;

Joint string_to(const std::string& body, const Vec2& anchor, double length) {
  Joint joint;
  joint.kind = JointKind::kString;
  joint.body = body;
  joint.anchor = anchor;
  joint.length = length;
  return joint;
}

Body kinematic(Body body, const Drive& drive) {
  body.fixed = false;
  body.drive = drive;
  return body;
}

// A scene of each kind, whose characteristic event is at about 0.5 s.
std::map<std::string, Preset> scenes() {
  std::map<std::string, Preset> all;
  const auto floor = [] { return wall("floor", {0, -0.5}, 20.0, 1.0); };
  const auto falling = [&](Preset s) {
    s.scene.forces.gravity = {0.0, -9.81};
    return s;
  };
  all["piston"] = preset_with({kinematic(wall("piston", {-1, 0}, 0.2, 2.0), {.velocity = {0.5, 0.1}}),
                               disc("ball", {0, 0}, {-1, 0.05}), wall("end", {1.5, 0}, 0.2, 2.0)});
  all["table"] = falling(preset_with(
      {kinematic(wall("table", {0, -0.5}, 4.0, 1.0),
                 {.velocity = Vec2::Zero(), .amplitude = {0.0, 0.05}, .angular_frequency = 12.0, .phase = 0.3}),
       disc("ball", {0, 0.5}, {0.1, 0})},
      0.7, 0.3));
  {
    Preset s = falling(preset_with({floor(), disc("a", {0, 0.5}, {0, 0}), disc("b", {1, 0.5}, {0, 0}),
                                    disc("c", {2, 0.5}, {0, 0}), disc("d", {3, 0.5}, {0.2, 0})},
                                   0.5, 0.2));
    s.scene.forces.applied = {{"a", {3.0, 5.0}, 0.02, 0.3, 0.4, 0.9},  // rising at 0.5 s
                              {"b", {1.0, 12.0}, 0.0, 0.7, 0.0, {}},   // not yet
                              {"c", {0.0, 9.0}, 0.1, 0.1, 0.1, 0.4},   // over
                              {"d", {0.0, 3.0}, 0.0, 0.0, 0.0, 0.6}};  // full
    all["timed forces"] = s;
  }
  {
    Preset s = falling(preset_with({floor(), disc("a", {0, 1}, {1, 0}), disc("b", {1, 0.9}, {-1, 0}),
                                    disc("c", {0.4, 3.0}, {0, 0}, 0.15)}));
    s.scene.materials[0].sticks = true;
    all["sticking"] = s;
  }
  {
    Preset s = falling(preset_with({disc("taut", {1.0, 0.0}, {0, 0}), disc("slack", {2.3, 0.0}, {0.4, 1.0}),
                                    disc("hit", {1.2, -1.1}, {-0.3, 1.5})}));
    s.scene.joints = {string_to("taut", {0.0, 0.0}, 1.0), string_to("slack", {2.0, 0.0}, 1.0)};
    all["strings"] = s;
  }
  {
    Preset s = preset_with(
        {disc("a", {0, 0}, {1.2, 0.1}), disc("b", {1, 0}, {-1, 0}), disc("c", {0, 2}, {0.3, -1.0})}, 0.8);
    s.scene.forces.springs = {{"push", "a", "b", Vec2::Zero(), 40.0, 0.5, 0.8, SpringActs::kPush},
                              {"pull", "b", "", {1.0, 0.3}, 30.0, 0.2, 0.3, SpringActs::kPull},
                              {"short", "c", "", {0.0, 0.0}, 25.0, 1.0, 1.5, SpringActs::kWhileShort},
                              {"both", "c", "a", Vec2::Zero(), 3.0, 0.0, 1.0, SpringActs::kBoth}};
    all["springs"] = s;
  }
  {
    Preset s = preset_with(
        {disc("a", {-1, 0}, {0, 0.6}), disc("b", {1, 0}, {0, -0.6}), disc("c", {0, 1.4}, {0.2, 0})}, 0.9);
    s.scene.forces.attraction = Attraction{2.0, 0.05};
    s.scene.forces.linear_drag = 0.1;
    all["attraction and drag"] = s;
  }
  {
    Preset s = falling(preset_with({floor(), disc("bob", {1, 2}, {0, 0}), disc("end", {1.6, 2}, {0, 0}, 0.08),
                                    disc("third", {2.0, 2.0}, {0, 0}, 0.05)},
                                   0.6, 0.1));
    Joint rod;
    rod.body = "bob";
    rod.anchor = {0, 2};
    Joint pin;
    pin.kind = JointKind::kPin;
    pin.body = "end";
    pin.point = {-0.6, 0.0};
    pin.to = "bob";
    Joint weld;
    weld.kind = JointKind::kWeld;
    weld.body = "third";
    weld.to = "end";
    weld.anchor = {0.4, 0.0};
    s.scene.joints = {rod, pin, weld};
    all["links"] = s;
  }
  {
    Preset s = falling(preset_with({floor()}, 0.3, 0.5));
    for (int i = 0; i < 6; ++i) {
      Body box = disc("box-" + std::to_string(i), {0.02 * i, 0.2 + 0.41 * i}, {0, 0});
      box.shape = Box{0.4, 0.4};
      s.scene.bodies.push_back(box);
    }
    all["stack"] = s;
  }
  {
    Preset s = falling(preset_with({floor()}, 0.6, 0.2));
    s.scene.generators = {{.name = "g",
                           .columns = 4,
                           .rows = 3,
                           .origin = {0, 0.3},
                           .spacing = {0.3, 0.3},
                           .jitter = 0.03,
                           .speed_max = 1.0}};
    all["generator"] = s;
  }
  {
    Preset s = falling(preset_with({floor(), disc("a", {0, 0.3}, {0, 0})}, 0.5));
    all["coming to rest"] = s;
  }
  {
    Preset s = preset_with({}, 1.0);
    for (int i = 0; i < 5; ++i)
      s.scene.bodies.push_back(disc("ball-" + std::to_string(i), {0.2 * i, 0}, {0, 0}));
    s.scene.bodies[0].position.x() = -1.0;
    s.scene.bodies[0].velocity.x() = 2.0;
    s.scene.several_impacts = SeveralImpactsId::kSimultaneous;
    all["at once"] = s;
  }
  {
    Preset s = falling(
        preset_with({wall("slope", {0, -0.5}, 20.0, 1.0, -0.2), disc("a", {0, 0.2}, {1, 0})}, 1.0, 0.4));
    s.scene.bodies[1].shape = Box{0.3, 0.1};
    s.scene.impact_law = ImpactLawId::kNewton;
    all["gains"] = s;
  }
  {
    Preset s = preset_with(
        {disc("a", {0, 0}, {0, 0}, 0.3), disc("b", {0.2, 0.1}, {0, 0}, 0.3), disc("c", {3, 0}, {-1, 0})});
    all["overlap"] = s;
  }
  for (auto& [name, s] : all) s.title = name;
  return all;
}

// Calls check(scene, name) for every scene under every method that it allows.
void for_all(const std::function<void(const Preset&, const std::string&)>& check) {
  for (auto [name, s] : scenes()) {
    for (const IntegratorChoice& integrator : kIntegrators) {
      // Strings chatter under methods of low order.
      if (why_not(s.scene, integrator.id) || (name == "strings" && integrator.order < 4)) continue;
      for (const auto& impacts : kImpacts) {
        for (const auto& contacts : kContacts) {
          s.method = {integrator.id, impacts.id, contacts.id, 0.01, 1e-9};
          // Corners that rest by impacts alone take minutes.
          if (name == "stack" && impacts.id == ImpactsId::kLocated && contacts.id == ContactsId::kImpulse)
            continue;
          check(s, name + ", " + std::string(integrator.name) + ", " + std::string(impacts.name) + ", " +
                       std::string(contacts.name));
        }
      }
    }
  }
}

constexpr double kRounding = 1e-9;

TEST(RunState, EveryKindOfSceneGoesOn) {
  for_all([](const Preset& s, const std::string& what) {
    Simulation whole(setup_of(s));
    whole.advance_to(0.5);
    Simulation restored = kept_and_restored(whole);
    const Preset saved = saved_and_read(s, whole);
    Simulation resumed(setup_of(saved));
    EXPECT_EQ(parting(all_of(s, whole), all_of(s, restored)), "") << what << ", at once";
    EXPECT_EQ(test::difference(whole, resumed, kRounding), "") << what << ", at once";
    for (Simulation* run : {&whole, &restored, &resumed}) run->advance_to(1.2);
    EXPECT_EQ(parting(all_of(s, whole), all_of(s, restored)), "") << what;
    EXPECT_EQ(unexplained(whole, resumed, saved), "") << what;
  });
}

TEST(RunState, SavedAtTheStartBetweenStepsAndTwiceInARow) {
  for_all([](const Preset& s, const std::string& what) {
    Simulation whole(setup_of(s));
    Simulation resumed(setup_of(saved_and_read(s, whole)));
    whole.advance_to(0.3137);
    resumed.advance_to(0.3137);
    resumed = Simulation(setup_of(saved_and_read(s, resumed)));
    const Preset saved = saved_and_read(s, resumed);
    resumed = Simulation(setup_of(saved));
    whole.advance_to(0.6);
    resumed.advance_to(0.6);
    EXPECT_EQ(unexplained(whole, resumed, saved), "") << what;
  });
}

// The same as if it had been chosen at the time of saving.
TEST(RunState, AnotherMethodTakesOver) {
  for_all([](const Preset& s, const std::string& what) {
    Simulation whole(setup_of(s));
    whole.advance_to(0.5);
    // Corners that rest by impacts alone take minutes.
    const ContactsId contacts = s.title == "stack" ? ContactsId::kLasting : ContactsId::kImpulse;
    for (const Method& next :
         {Method{IntegratorId::kRk4, ImpactsId::kLocated, contacts, 0.007},
          Method{IntegratorId::kAdaptiveDormandPrince, ImpactsId::kLocated, contacts, 0.01, 1e-7},
          Method{IntegratorId::kDormandPrince, ImpactsId::kStepEnd, ContactsId::kLasting, 0.01}}) {
      Preset saved = saved_and_read(s, whole);
      saved.method = next;
      Simulation resumed(setup_of(saved));
      Simulation changed = whole;
      if (!(next == s.method)) changed.set_method(next);
      changed.advance_to(0.8);
      resumed.advance_to(0.8);
      // Steps that the adaptive method chooses anew differ by its own error.
      if (test::difference(changed, resumed, 1e-9).empty()) continue;
      if (next.integrator == IntegratorId::kAdaptiveDormandPrince && !test::keeps_its_tolerance(changed, saved))
        continue;
      EXPECT_EQ(unexplained(changed, resumed, saved), "") << what << " -> " << next.step;
    }
  });
}

TEST(RunState, BodiesPutInAndMethodsChangedBeforeAndAfter) {
  for_all([](const Preset& s, const std::string& what) {
    Simulation whole(setup_of(s));
    whole.advance_to(0.2);
    whole.apply({Add<Body>{disc("first", {0.3, 1.5}, {0, -1}, 0.12)}});
    whole.advance_to(0.4);
    Method method = s.method;
    method.step = 0.008;
    whole.set_method(method);
    whole.advance_to(0.5);
    Simulation restored = kept_and_restored(whole);
    const Preset saved = saved_and_read(s, whole);
    Simulation resumed(setup_of(saved));
    for (Simulation* run : {&whole, &restored, &resumed}) {
      run->advance_to(0.6);
      run->apply({Add<Body>{disc("second", {-0.4, 2.0}, {0.1, -2}, 0.09)}});
      run->advance_to(0.7);
      run->set_method(s.method);
      run->advance_to(0.9);
    }
    EXPECT_EQ(parting(all_of(s, whole), all_of(s, restored)), "") << what;
    EXPECT_EQ(unexplained(whole, resumed, saved), "") << what;
  });
}

// The scenes above reach their events.
TEST(RunState, TheScenesHaveTheirMoments) {
  const auto all = scenes();
  const auto at = [&](const std::string& name, ContactsId contacts = ContactsId::kImpulse) {
    Preset s = all.at(name);
    s.method = {IntegratorId::kRk4, ImpactsId::kLocated, contacts, 0.01, 1e-9};
    Simulation run(setup_of(s));
    run.advance_to(0.5);
    return run;
  };
  EXPECT_GT(at("sticking").joints().size(), 0U);
  EXPECT_TRUE(at("strings").is_taut(JointIndex{0}));
  EXPECT_FALSE(at("strings").is_taut(JointIndex{1}));
  EXPECT_GT(at("stack", ContactsId::kLasting).contact_forces().size(), 4U);
  EXPECT_GE(at("coming to rest").impact_count(), 1);
  EXPECT_GE(at("at once").impact_count(), 1);
  const RunState springs = at("springs").run_state();
  EXPECT_NE(springs.trajectories.engaged, std::vector<std::uint8_t>(4, 1));
  const auto phases = at("timed forces").run_state().trajectories.phase;
  EXPECT_EQ(std::vector<int>(phases.begin(), phases.end()), (std::vector<int>{1, 0, 3, 2}));
}

}  // namespace
}  // namespace carom
