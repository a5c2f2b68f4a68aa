#include <algorithm>
#include <gtest/gtest.h>

#include "physics/model/compiled_scene.h"
#include "physics/preset/preset_file.h"
#include "physics/run/run_state.h"
#include "physics/run/simulation.h"
#include "tests/support/preset_files.h"
#include "tests/support/scenes.h"

// What a scene does not need is absent from its model.
namespace carom {
namespace {

// Whether the model has anything of a part.
bool has_any(const CompiledScene& compiled, Part part) {
  const Model& m = compiled.model;
  switch (part) {
    case Part::kRotation:
    case Part::kFriction:
    case Part::kSticking:
      return !m.smooth_discs;
    case Part::kDrag:
      return m.forces.linear_drag != 0.0 || m.forces.quadratic_drag != 0.0;
    case Part::kSprings:
      return !m.forces.springs.empty() || !m.forces.outside.empty() || !m.forces.between.empty();
    case Part::kAttraction:
      return m.forces.attraction.has_value();
    case Part::kAppliedForces:
      return !m.forces.applied.empty() || !m.forces.applied_to.empty();
    case Part::kSwitching:
      return !m.forces.switching.empty() || m.forces.one_sided;
    case Part::kDrives:
      return !m.drives.of.empty();
    case Part::kJoints:
      return !m.joint_terms.all.empty();
    case Part::kRestingContacts:
      return compiled.needs.has(part);
  }
  return true;
}

TEST(Model, HasNothingOfAPartThatIsNotNeeded) {
  for (const auto& file : test::preset_files()) {
    const Scene scene = read_preset(file).scene;
    const Needs needs = needs_of(scene);
    const auto compiled = compile(scene, needs);
    const bool any_turns = needs.has(Part::kRotation) || needs.has(Part::kFriction) ||
                           needs.has(Part::kSticking) || needs.has(Part::kJoints) ||
                           needs.has(Part::kSwitching);
    EXPECT_EQ(compiled->model.smooth_discs, !any_turns) << file;
    for (const PartEntry& entry : part_entries()) {
      const bool alone =
          entry.part == Part::kRotation || entry.part == Part::kFriction || entry.part == Part::kSticking;
      if (needs.has(entry.part) || (alone && any_turns)) continue;
      EXPECT_FALSE(has_any(*compiled, entry.part)) << file << ": " << entry.noun;
    }
  }
}

TEST(Model, HasEachPartThatIsNeeded) {
  std::vector<Scene> scenes;
  for (const auto& file : test::preset_files()) scenes.push_back(read_preset(file).scene);
  scenes.push_back(test::scene_with({test::disc("a", {0, 0}, {0, 0}), test::disc("b", {3, 0}, {0, 0})}));
  scenes.back().forces.attraction = Attraction{};
  for (const PartEntry& entry : part_entries()) {
    bool seen = false;
    for (const Scene& scene : scenes) {
      const Needs needs = needs_of(scene);
      if (!needs.has(entry.part)) continue;
      seen = true;
      EXPECT_TRUE(has_any(*compile(scene, needs), entry.part)) << entry.noun;
    }
    EXPECT_TRUE(seen) << entry.noun;
  }
}

// Also those that were added since: a force that no part asks for would be read, shown and never felt.
TEST(Model, EachForceThatASceneHasOnceActs) {
  const auto end_of = [](const Scene& scene) {
    Method method;
    method.step = 0.01;
    Simulation run(RunSetup{.scene = scene, .method = method});
    for (int i = 0; i < 50; ++i) run.step();
    return run.state().position(0);
  };
  const Scene none = test::scene_with({test::disc("a", {0, 0}, {1, 0}), test::disc("b", {3, 1}, {0, 0})});
  CommonForces names;
  each_common_force(names, [&](const CommonForce& force, const auto&...) {
    Scene scene = none;
    each_common_force(scene.forces, [&](const CommonForce& other, auto& own, const auto&...) {
      if (other.name != force.name) return;
      if constexpr (requires { own.emplace(); }) {
        own.emplace();
      } else {
        own = 1.0;
      }
    });
    const Needs needs = needs_of(scene);
    EXPECT_TRUE(std::any_of(part_entries().begin(), part_entries().end(), [&](const PartEntry& entry) {
      return entry.varies && needs.has(entry.part);
    })) << force.name;
    EXPECT_GT((end_of(scene) - end_of(none)).norm(), 1e-3) << force.name;
  });
}

// A part that is left out makes no memory, and one that is in does: resting contacts are there only where the
// method asks for them and the scene needs them.
TEST(Model, ContactsRestOnlyWhereTheyAreNeeded) {
  int resting = 0;
  for (const auto& file : test::preset_files()) {
    Preset preset = read_preset(file);
    preset.method.contacts = ContactsId::kLasting;
    Simulation run(setup_of(preset));
    for (int i = 0; i < 3; ++i) run.step();
    const bool rests = !run.run_state().contacts.forces.empty();
    resting += rests ? 1 : 0;
    EXPECT_TRUE(run.needs().has(Part::kRestingContacts) || !rests) << file;
  }
  EXPECT_GT(resting, 3);
}

}  // namespace
}  // namespace carom
