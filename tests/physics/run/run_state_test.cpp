#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <limits>
#include <random>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/scene/facts.h"
#include "tests/support/effort.h"
#include "tests/support/preset_files.h"
#include "tests/support/random_scene.h"
#include "tests/support/resumed_run.h"

// A run that is kept and continued equals the uninterrupted run, every preset under every method, and random
// scenes: in memory to the last bit, through a file to 1e-9 as long as it follows from its start. The long
// tests run presets for their whole duration with their own steps, and 2000 scenes instead of 60.
namespace carom {
namespace {

namespace fs = std::filesystem;
using test::all_of;
using test::events_of;
using test::long_tests;
using test::parting;
using test::preset_files;
using test::saved_and_read;

enum class Kept { kInMemory, kInAFile };

// Runs without interruption until the time, or until so many impacts, with its steps; and beside it again, kept
// after each of `parts` but the last. The difference, or nothing.
std::string difference(const Preset& preset, Kept kept, int parts, std::int64_t most_impacts,
                       std::int64_t most_steps) {
  Simulation whole(setup_of(preset));
  const auto goes_on = [&](const Simulation& run) {
    return run.time() < preset.duration - 1e-9 * preset.method.step && run.impact_count() < most_impacts &&
           run.steps() < most_steps && !run.lost();
  };
  Simulation first = whole;
  while (goes_on(first)) first.step();
  const std::int64_t steps = first.steps();
  Simulation run = whole;
  Preset start;  // of the second part
  for (int part = 1; part <= parts; ++part) {
    while (run.steps() < steps * part / parts && !whole.lost()) {
      whole.step();
      run.step();
      if (kept == Kept::kInMemory) {
        if (events_of(run) != events_of(whole)) return fmt::format("impacts of step {}", run.steps());
        continue;
      }
      if (part == 1 || test::difference(whole, run, test::resumed_tolerance(preset.method)).empty()) continue;
      if (preset.method.integrator == IntegratorId::kAdaptiveDormandPrince &&
          !test::keeps_its_tolerance(whole, preset)) {
        return {};
      }
      return test::unexplained(whole, run, start);
    }
    if (part == parts || whole.lost()) break;
    if (kept == Kept::kInMemory) {
      run = test::kept_and_restored(run);
    } else {
      const Preset saved = saved_and_read(preset, run);
      if (part == 1) start = saved;
      run = Simulation(setup_of(saved));
    }
  }
  return kept == Kept::kInMemory ? parting(all_of(preset, whole), all_of(preset, run)) : "";
}

class PresetRunState : public testing::TestWithParam<fs::path> {};

TEST_P(PresetRunState, GoesOnUnderEveryMethod) {
  Preset preset = read_preset(GetParam());
  // A few steps over the whole duration.
  const std::int64_t steps = long_tests() ? std::numeric_limits<std::int64_t>::max() : 40;
  if (!long_tests()) preset.method.step = std::clamp(preset.duration / 40.0, preset.method.step, 0.05);
  for (const IntegratorChoice& integrator : kIntegrators) {
    if (why_not(preset.scene, integrator.id)) continue;
    for (const auto& impacts : kImpacts) {
      for (const auto& contacts : kContacts) {
        preset.method.integrator = integrator.id;
        preset.method.impacts = impacts.id;
        preset.method.contacts = contacts.id;
        for (const Kept kept : {Kept::kInMemory, Kept::kInAFile})
          EXPECT_EQ(difference(preset, kept, 2, long_tests() ? 5000 : 200, steps), "")
              << integrator.name << ", " << impacts.name << ", " << contacts.name << ", "
              << (kept == Kept::kInAFile ? "through a file" : "in memory");
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, PresetRunState, testing::ValuesIn(preset_files()), test::preset_test_name);

// A random scene that may have strings, rods that support bodies, and surfaces that stick.
Preset jointed_scene(std::uint64_t seed) {
  Preset preset = test::random_scene(seed).preset;
  std::mt19937_64 random(seed);
  const auto chance = [&](double p) { return static_cast<double>(random() >> 11) * 0x1p-53 < p; };
  Preset bare = preset;
  if (chance(0.3)) preset.scene.materials[0].sticks = true;
  if (chance(0.5)) {
    Body* last = nullptr;
    for (Body& body : preset.scene.bodies) {
      if (has_infinite_mass(body)) continue;
      if (last != nullptr && chance(0.5)) {
        Joint joint;
        joint.kind = chance(0.7) ? JointKind::kString : JointKind::kRod;
        joint.body = body.name;
        joint.to = last->name;
        if (joint.kind == JointKind::kRod) {
          body.velocity = last->velocity = Vec2::Zero();
        } else {
          joint.length = (body.position - last->position).norm() * (chance(0.3) ? 1.0 : 1.3);
        }
        preset.scene.joints.push_back(joint);
      }
      last = &body;
    }
  }
  if (!preset.scene.joints.empty() || preset.scene.materials[0].sticks)
    preset.scene.several_impacts = SeveralImpactsId::kPairwise;
  try {
    validate(preset);
  } catch (const SceneError&) {
    return bare;  // rods at moving bodies
  }
  return preset;
}

TEST(RunState, RandomScenesGoOn) {
  const std::uint64_t count = test::by_effort<std::uint64_t>(60, 60, 2000);
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    Preset preset = jointed_scene(seed);
    preset.method.integrator = kIntegrators[seed % std::size(kIntegrators)].id;
    if (why_not(preset.scene, preset.method.integrator))
      preset.method.integrator = IntegratorId::kAdaptiveDormandPrince;
    preset.method.impacts = seed / 7 % 3 == 0 ? ImpactsId::kStepEnd : ImpactsId::kLocated;
    preset.method.contacts = seed / 21 % 2 == 0 ? ContactsId::kImpulse : ContactsId::kLasting;
    EXPECT_EQ(difference(preset, Kept::kInMemory, 3, 1000, 1'000'000), "") << write_preset(preset);
    EXPECT_EQ(difference(preset, Kept::kInAFile, 3, 1000, 1'000'000), "") << write_preset(preset);
  }
}

}  // namespace
}  // namespace carom
