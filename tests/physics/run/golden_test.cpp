#include "tests/support/golden.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "physics/compare/chaos.h"
#include "physics/dynamics/integrators/integrators.h"
#include "physics/ledger/ledger_entries.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/run/simulation.h"
#include "physics/scene/facts.h"
#include "tests/support/preset_files.h"
#include "tests/support/source_folder.h"

// Results of every preset under every method: final state, impacts, contact forces, ledger and notices, as
// hashes in golden.txt. A change that keeps results must keep them all. A change of results calls
//   CAROM_WRITE_GOLDEN=1 build/release/bin/carom_physics_tests --gtest_filter='*Golden*'
// and its commit says which lines of golden.txt change, and why.
//
// Beside each hash stand the time up to which the run follows from its start whatever the rounding, and a few
// sums over the state then: they are compared to 1e-9 where sin, exp and the like are rounded differently.
namespace carom {
namespace {

namespace fs = std::filesystem;

constexpr double kMostTime = 0.5;  // s
constexpr int kMostSteps = 200;
// m: displacements of neighbours, a large one that shows growth, and some of rounding; and m, rad, m/s, rad/s:
// where all stay nearer than this, what rounding has grown to stays far below the tolerance.
constexpr std::array kDisplacements = {1e-12, 1e-15, -1e-15, 3e-16, -3e-16};
constexpr double kNear = 1e-8;
constexpr double kTolerance = 1e-9;

double end_of(const Preset& preset) {
  return std::min({preset.duration, kMostTime, kMostSteps * preset.method.step});
}

std::string hash_of_run(const Preset& preset) {
  Simulation run(setup_of(preset));
  test::Hash hash;
  run.advance_to(run.time() + end_of(preset), [&] {
    for (const ImpactRecord& i : run.last_impacts()) {
      for (const double x : {i.time, static_cast<double>(i.a), static_cast<double>(i.b), i.normal_impulse,
                             i.tangential_impulse, i.lost_to_restitution, i.lost_to_friction}) {
        hash.add(x);
      }
    }
    for (const ContactForce& f : run.contact_forces()) {
      for (const double x : {static_cast<double>(f.a), static_cast<double>(f.b), f.point.x(), f.point.y(),
                             f.normal_force, f.tangential_force, f.rolling_moment}) {
        hash.add(x);
      }
    }
  });
  hash.add_all(run.state().q);
  hash.add_all(run.state().v);
  const Ledger ledger = run.ledger();
  for (const EnergyEntry& entry : kEnergyEntries) hash.add(ledger.*entry.value);
  for (const MomentumEntry& entry : kMomentumEntries) {
    hash.add_all(ledger.*entry.value);
    hash.add(ledger.*entry.angular);
  }
  for (const double x : {run.totals().energy(), static_cast<double>(run.impact_count()),
                         static_cast<double>(run.evaluations())}) {
    hash.add(x);
  }
  hash.add(run.status());
  return hash.text();
}

// s: up to here runs from places that differ by kDisplacements stay within kNear.
double predictable_time(const Preset& preset) {
  const RunSetup setup = setup_of(preset);
  Simulation run(setup);
  std::vector<Simulation> neighbours;
  for (const double displacement : kDisplacements) neighbours.emplace_back(displaced(setup, displacement));
  const double end = run.time() + end_of(preset);
  double time = run.time();
  bool near = true;
  run.advance_to(end, [&] {
    for (Simulation& neighbour : neighbours) {
      if (!near) return;
      neighbour.advance_to(run.time());
      const State& a = run.state();
      const State& b = neighbour.state();
      near = !neighbour.lost() && a.size() == b.size() && (a.q - b.q).cwiseAbs().maxCoeff() < kNear &&
             (a.v - b.v).cwiseAbs().maxCoeff() < kNear;
    }
    if (near) time = run.time();
  });
  return time;
}

// Sums over a state, each entry with a weight of its own, and the energy.
std::array<double, 3> sums_at(Simulation& run, double time) {
  run.advance_to(time);
  const auto sum = [](const Eigen::Matrix3Xd& x) {
    double total = 0.0;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const auto weight = static_cast<std::uint32_t>(i + 1) * 2654435761U;
      total += (0.5 + weight * 0x1p-32) * x.data()[i];
    }
    return total;
  };
  return {sum(run.state().q), sum(run.state().v), run.totals().energy()};
}

std::string loose_of_run(const Preset& preset) {
  const double time = predictable_time(preset);
  Simulation run(setup_of(preset));
  const auto [position, velocity, energy] = sums_at(run, time);
  return fmt::format("{} {} {} {}", time, position, velocity, energy);
}

void expect_loosely(const std::string& name, const RunSetup& setup, const std::string& loose) {
  std::istringstream in(loose);
  double time = -1.0;
  std::array<double, 3> kept{};
  in >> time >> kept[0] >> kept[1] >> kept[2];
  ASSERT_TRUE(in) << name << ": " << loose;
  Simulation run(setup);
  const std::array<double, 3> now = sums_at(run, time);
  for (std::size_t i = 0; i < kept.size(); ++i)
    EXPECT_NEAR(now[i], kept[i], kTolerance * (1.0 + std::abs(kept[i])))
        << name << ", sum " << i << " at " << time;
}

// The preset under each method that it allows, by both names.
std::map<std::string, Preset> runs_of(const fs::path& file) {
  std::map<std::string, Preset> runs;
  Preset preset = read_preset(file);
  for (const IntegratorChoice& integrator : kIntegrators) {
    if (why_not(preset.scene, integrator.id)) continue;
    for (const auto& impacts : kImpacts) {
      for (const auto& contacts : kContacts) {
        preset.method.integrator = integrator.id;
        preset.method.impacts = impacts.id;
        preset.method.contacts = contacts.id;
        runs[fmt::format("{} {} {} {}", file.stem().string(), integrator.name, impacts.name, contacts.name)] =
            preset;
      }
    }
  }
  return runs;
}

fs::path golden_file() { return test::source("tests/physics/run/golden.txt"); }

class Golden : public testing::TestWithParam<fs::path> {};

TEST_P(Golden, RunsKeepTheirBytes) {
  const std::map<std::string, Preset> runs = runs_of(GetParam());
  std::map<std::string, std::string> hashes;
  for (const auto& [name, preset] : runs) hashes[name] = hash_of_run(preset);
  test::expect_golden(
      golden_file(), GetParam().stem().string(), hashes,
      [&](const std::string& name) { return loose_of_run(runs.at(name)); },
      [&](const std::string& name, const std::string& loose) {
        expect_loosely(name, setup_of(runs.at(name)), loose);
      });
}

// What is compared where mathematical functions round differently does not hang on rounding.
TEST_P(Golden, LooseResultsHoldForANeighbour) {
  const std::map<std::string, test::Golden> kept = test::read_golden(golden_file());
  for (const auto& [name, preset] : runs_of(GetParam())) {
    if (preset.method != read_preset(GetParam()).method) continue;
    expect_loosely(name, displaced(setup_of(preset), 5e-16), kept.at(name).loose);
  }
}

INSTANTIATE_TEST_SUITE_P(Presets, Golden, testing::ValuesIn(test::preset_files()), test::preset_test_name);

}  // namespace
}  // namespace carom
