#include <filesystem>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <map>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/scene/facts.h"
#include "tests/support/preset_files.h"
#include "tests/support/random_scene.h"
#include "tests/support/scenes.h"

// A part of the model is dropped only where it stays idle: the trimmed run is the untrimmed one.
namespace carom {
namespace {

using test::same_bytes;

struct Part {
  const char* name;
  bool Needs::*field;
};
constexpr Part kParts[] = {{"rotation", &Needs::rotation},
                           {"friction", &Needs::friction},
                           {"smooth forces", &Needs::smooth_forces},
                           {"velocity forces", &Needs::velocity_forces},
                           {"coupled forces", &Needs::coupled_forces},
                           {"links", &Needs::links},
                           {"drives", &Needs::drives},
                           {"switching", &Needs::switching},
                           {"lasting contacts", &Needs::lasting_contacts}};

// m: the largest coordinate of a moving body, at least.
double scale_of(const Simulation& run) {
  return std::max(1e-3, run.state().q.topRows<2>().cwiseAbs().maxCoeff());
}

void expect_same(const Preset& preset, double until, const std::string& what, bool held) {
  Simulation trimmed(setup_of(preset));
  trimmed.advance_to(until);
  // Held contacts jitter, and rounding decides their impacts.
  if (trimmed.notices().text() != "ok" && !held) return;
  for (const Part& part : kParts) {
    Needs needs = needs_of(preset.scene);
    if (needs.*part.field) continue;
    needs.*part.field = true;
    if (needs == all_needs()) continue;
    Simulation run(setup_of(preset), needs);
    run.advance_to(until);
    EXPECT_TRUE(same_bytes(run.state(), trimmed.state())) << what << ", with " << part.name;
    EXPECT_EQ(run.impact_count(), trimmed.impact_count()) << what << ", with " << part.name;
  }
  Simulation all(setup_of(preset), all_needs());
  all.advance_to(until);
  EXPECT_EQ(all.impact_count(), trimmed.impact_count()) << what;
  const double scale = scale_of(trimmed);
  const double speed = std::max(scale, trimmed.state().v.topRows<2>().cwiseAbs().maxCoeff());
  EXPECT_LT((all.state().q - trimmed.state().q).topRows<2>().cwiseAbs().maxCoeff(), 1e-9 * scale) << what;
  EXPECT_LT((all.state().v - trimmed.state().v).topRows<2>().cwiseAbs().maxCoeff(), 1e-9 * speed) << what;
  EXPECT_LT((all.state().q - trimmed.state().q).row(2).cwiseAbs().maxCoeff(), 1e-7) << what;
}

// s: how long presets are compared whose neighbours part exponentially, or whose bodies are many: untrimmed,
// all bodies step together.
const std::map<std::string, double> kUntil = {{"ball-in-a-box", 5.0},    {"billiard-break", 0.6},
                                              {"falling-rod", 0.5},      {"gas", 0.3},
                                              {"granular-cooling", 0.1}, {"pile", 0.1},
                                              {"sinai-billiard", 1.5},   {"moving-piston", 2.0},
                                              {"vibrating-table", 3.0},  {"inelastic-collapse", 1.8},
                                              {"dominoes", 0.2},         {"pile-at-rest", 0.2},
                                              {"domino-alone", 0.5},     {"rocking-block", 0.5},
                                              {"stacked-boxes", 0.5}};

TEST(Trimmed, PresetsMoveAsUntrimmed) {
  int presets = 0;
  for (const std::filesystem::path& file : test::preset_files()) {
    ++presets;
    const Preset preset = read_preset(file);
    const std::string name = file.stem().string();
    const auto until = kUntil.find(name);
    expect_same(preset, until == kUntil.end() ? preset.duration : std::min(until->second, preset.duration),
                name, true);
  }
  EXPECT_GT(presets, 20);
}

// Random scenes for a short time. Untrimmed, an impact or a switch ends the step of all bodies, so what is
// compared is either free of such sub-steps or has steps so short that they don't show.
TEST(Trimmed, RandomScenesMoveAsUntrimmed) {
  for (std::uint64_t seed = 1001; seed <= 1060; ++seed) {
    Preset preset = test::random_scene(seed).preset;
    const double step = preset.method.step;
    const bool whole_steps = !needs_of(preset.scene).switching;
    for (const IntegratorChoice& integrator : kIntegrators) {
      if (why_not(preset.scene, integrator.id) || integrator.adaptive) continue;
      const bool fine = integrator.order == 0 || integrator.order == 5;
      for (const auto& impacts : kImpacts) {
        if (!fine && (impacts.id == ImpactsId::kLocated || !whole_steps)) continue;
        preset.method.integrator = integrator.id;
        preset.method.impacts = impacts.id;
        preset.method.step = integrator.order == 5 ? step / 16.0 : step;
        expect_same(preset, 12.0 * step, fmt::format("seed {}, {}, {}", seed, integrator.name, impacts.name),
                    false);
      }
    }
  }
}

}  // namespace
}  // namespace carom
