#include <filesystem>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <map>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/scene/facts.h"
#include "tests/support/effort.h"
#include "tests/support/preset_files.h"
#include "tests/support/random_scene.h"
#include "tests/support/scenes.h"

// A part of the model is dropped only where it stays idle: the trimmed run is the untrimmed one.
namespace carom {
namespace {

// m: the largest coordinate of a moving body, at least.
double scale_of(const Simulation& run) {
  return std::max(1e-3, run.state().q.topRows<2>().cwiseAbs().maxCoeff());
}

// That of the same run under another model, to 1e-9 of what moves.
void expect_same_motion(const Simulation& run, const Simulation& trimmed, const std::string& what) {
  EXPECT_EQ(run.impact_count(), trimmed.impact_count()) << what;
  const double scale = scale_of(trimmed);
  const double speed = std::max(scale, trimmed.state().v.topRows<2>().cwiseAbs().maxCoeff());
  const Eigen::Matrix3Xd q = run.state().q - trimmed.state().q;
  EXPECT_LT(q.topRows<2>().cwiseAbs().maxCoeff(), 1e-9 * scale) << what;
  EXPECT_LT((run.state().v - trimmed.state().v).topRows<2>().cwiseAbs().maxCoeff(), 1e-9 * speed) << what;
  EXPECT_LT(q.row(2).cwiseAbs().maxCoeff(), 1e-7) << what;
}

// Whether the untrimmed program did other work for the same motion: it evaluated forces more often.
bool expect_same(const Preset& preset, double until, const std::string& what, bool held) {
  Simulation trimmed(setup_of(preset));
  trimmed.advance_to(until);
  // Held contacts jitter, and rounding decides their impacts.
  if (trimmed.notices().text() != "ok" && !held) return true;
  for (const PartEntry& part : part_entries()) {
    Needs needs = needs_of(preset.scene);
    if (needs.has(part.part)) continue;
    needs.set(part.part);
    Simulation run(setup_of(preset), needs);
    run.advance_to(until);
    expect_same_motion(run, trimmed, fmt::format("{}, with {}", what, part.noun));
  }
  Simulation all(setup_of(preset), all_needs());
  all.advance_to(until);
  expect_same_motion(all, trimmed, what);
  return all.evaluations() != trimmed.evaluations();
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
  int others = 0;
  const double share = test::by_effort(0.2, 1.0, 1.0);  // of the time
  for (const std::filesystem::path& file : test::preset_files()) {
    ++presets;
    const Preset preset = read_preset(file);
    const std::string name = file.stem().string();
    const auto until = kUntil.find(name);
    const double most = until == kUntil.end() ? preset.duration : std::min(until->second, preset.duration);
    others += expect_same(preset, share * most, name, true);
  }
  EXPECT_GT(presets, 20);
  // Of one body that is integrated anyway the untrimmed program evaluates as often.
  EXPECT_GT(others, presets / 2);
}

// Random scenes for a short time. Untrimmed, an impact or a switch ends the step of all bodies, so what is
// compared is either free of such sub-steps or has steps so short that they don't show.
TEST(Trimmed, RandomScenesMoveAsUntrimmed) {
  for (std::uint64_t seed = 1001; seed <= 1060; ++seed) {
    Preset preset = test::random_scene(seed).preset;
    const double step = preset.method.step;
    const bool whole_steps = !needs_of(preset.scene).has(Part::kSwitching) && !facts_of(preset.scene).timed;
    for (const IntegratorChoice& integrator : kIntegrators) {
      if (why_not(preset.scene, integrator.id) || integrator.adaptive) continue;
      const bool fine = integrator.order == 0 || integrator.order == 5;
      for (const auto& impacts : kImpacts) {
        if (!fine && (impacts.id == ImpactsId::kLocated || !whole_steps)) continue;
        preset.method.integrator = integrator.id;
        preset.method.impacts = impacts.id;
        preset.method.step = integrator.order == 5 ? step / 16.0 : step;
        (void)expect_same(preset, 12.0 * step,
                          fmt::format("seed {}, {}, {}", seed, integrator.name, impacts.name), false);
      }
    }
  }
}

}  // namespace
}  // namespace carom
