#include "tests/support/golden.h"

#include <filesystem>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <map>
#include <string>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/scene/facts.h"
#include "physics/world/ledger_entries.h"
#include "physics/world/simulation.h"
#include "tests/support/preset_files.h"

// Results of every preset under every method: final state, impacts, ledger and notices, as hashes in
// golden.txt. A change that keeps results must keep them all. A change of results calls
//   CAROM_WRITE_GOLDEN=1 build/release/bin/carom_physics_tests --gtest_filter='*Golden*'
// and its commit says which lines of golden.txt change, and why.
namespace carom {
namespace {

namespace fs = std::filesystem;

constexpr double kMostTime = 0.5;  // s
constexpr int kMostSteps = 200;

std::string hash_of_run(const Preset& preset) {
  Simulation run(setup_of(preset));
  test::Hash hash;
  const double h = preset.method.step;
  const double until = std::min({preset.duration, kMostTime, kMostSteps * h});
  run.advance_to(run.time() + until, [&] {
    for (const ImpactRecord& i : run.last_impacts()) {
      for (const double x : {i.time, static_cast<double>(i.a), static_cast<double>(i.b), i.normal_impulse,
                             i.tangential_impulse, i.lost_to_restitution, i.lost_to_friction}) {
        hash.add(x);
      }
    }
  });
  hash.add_all(run.state().q);
  hash.add_all(run.state().v);
  const Ledger ledger = run.ledger();
  for (const EnergyEntry& entry : kEnergyEntries) hash.add(ledger.*entry.value);
  for (const double x : {run.totals().energy(), ledger.momentum_to_walls.x(), ledger.momentum_to_walls.y(),
                         static_cast<double>(run.impact_count()), static_cast<double>(run.evaluations())}) {
    hash.add(x);
  }
  hash.add(run.status());
  return hash.text();
}

// Hashes of one preset by name and method.
std::map<std::string, std::string> hashes_of(const fs::path& file) {
  std::map<std::string, std::string> hashes;
  Preset preset = read_preset(file);
  for (const IntegratorChoice& integrator : kIntegrators) {
    if (why_not(preset.scene, integrator.id)) continue;
    for (const auto& impacts : kImpacts) {
      for (const auto& contacts : kContacts) {
        preset.method.integrator = integrator.id;
        preset.method.impacts = impacts.id;
        preset.method.contacts = contacts.id;
        hashes[fmt::format("{} {} {} {}", file.stem().string(), integrator.name, impacts.name, contacts.name)] =
            hash_of_run(preset);
      }
    }
  }
  return hashes;
}

class Golden : public testing::TestWithParam<fs::path> {};

TEST_P(Golden, RunsKeepTheirBytes) {
  test::expect_golden(CAROM_GOLDEN_FILE, GetParam().stem().string(), hashes_of(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Presets, Golden, testing::ValuesIn(test::preset_files()), test::preset_test_name);

}  // namespace
}  // namespace carom
