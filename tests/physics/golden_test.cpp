#include <bit>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <string>
#include <string_view>

#include "physics/motion/integrators.h"
#include "physics/preset/preset.h"
#include "physics/world/simulation.h"
#include "tests/physics/preset_files.h"

// The bytes of every preset's run under every method: final state, impacts, ledger and notices, as hashes in
// golden.txt. A change that is to keep results keeps them all. One that is not calls
//   CAROM_WRITE_GOLDEN=1 build/release/bin/carom_physics_tests --gtest_filter='*Golden*'
// and says in its commit which lines of golden.txt are others, and why.
namespace carom {
namespace {

namespace fs = std::filesystem;

constexpr double kMostTime = 0.5;  // s
constexpr int kMostSteps = 200;

// Fowler, Noll and Vo's hash, 64 bits, FNV-1a.
class Hash {
 public:
  void add(double value) {
    auto bits = std::bit_cast<std::uint64_t>(value);
    for (int k = 0; k < 8; ++k, bits >>= 8) add_byte(static_cast<unsigned char>(bits & 0xFFU));
  }
  void add(std::string_view text) {
    for (const char c : text) add_byte(static_cast<unsigned char>(c));
  }
  template <class Matrix>
  void add_all(const Matrix& m) {
    for (Eigen::Index i = 0; i < m.size(); ++i) add(m.data()[i]);
  }
  [[nodiscard]] std::string text() const { return fmt::format("{:016x}", hash_); }

 private:
  void add_byte(unsigned char byte) { hash_ = (hash_ ^ byte) * 0x100000001B3U; }
  std::uint64_t hash_ = 0xCBF29CE484222325U;
};

// What the machine's mathematical functions give, which no standard fixes to the last bit.
std::string hash_of_functions() {
  Hash hash;
  for (int k = 1; k <= 2000; ++k) {
    const double x = 0.0137 * k;
    for (const double y : {std::sin(x), std::cos(x), std::sin(1e3 * x), std::atan2(x, 2.0), std::hypot(x, 1.1),
                           std::exp(-x), std::log(x), std::pow(x, 0.2), std::cbrt(x)}) {
      hash.add(y);
    }
  }
  return hash.text();
}

std::string hash_of_run(const Scene& scene) {
  Simulation run(scene);
  Hash hash;
  const double h = scene.method.step;
  const double until = std::min({scene.duration, kMostTime, kMostSteps * h});
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
  for (double Ledger::*entry : Ledger::energies()) hash.add(ledger.*entry);
  for (const double x : {run.totals().energy(), ledger.momentum_to_walls.x(), ledger.momentum_to_walls.y(),
                         static_cast<double>(run.impact_count()), static_cast<double>(run.evaluations())}) {
    hash.add(x);
  }
  hash.add(run.status());
  return hash.text();
}

// Name and method to hash, of one preset.
std::map<std::string, std::string> hashes_of(const fs::path& file) {
  std::map<std::string, std::string> hashes;
  Scene scene = read_preset(file);
  for (const IntegratorChoice& integrator : kIntegrators) {
    if (why_not(scene, integrator.id)) continue;
    for (const auto& impacts : kImpacts) {
      for (const auto& contacts : kContacts) {
        scene.method.integrator = integrator.id;
        scene.method.impacts = impacts.id;
        scene.method.contacts = contacts.id;
        hashes[fmt::format("{} {} {} {}", file.stem().string(), integrator.name, impacts.name, contacts.name)] =
            hash_of_run(scene);
      }
    }
  }
  return hashes;
}

const fs::path kFile = fs::path(CAROM_GOLDEN_FILE);
const char* const kFunctions = "functions";

std::map<std::string, std::string> golden() {
  std::map<std::string, std::string> all;
  std::ifstream in(kFile);
  for (std::string line; std::getline(in, line);) {
    const std::size_t space = line.rfind(' ');
    if (space != std::string::npos) all[line.substr(0, space)] = line.substr(space + 1);
  }
  return all;
}

class Golden : public testing::TestWithParam<fs::path> {};

TEST_P(Golden, RunsKeepTheirBytes) {
  std::map<std::string, std::string> all = golden();
  const std::map<std::string, std::string> now = hashes_of(GetParam());
  if (std::getenv("CAROM_WRITE_GOLDEN") != nullptr) {
    const std::string own = GetParam().stem().string() + " ";
    std::erase_if(all, [&](const auto& entry) { return entry.first.starts_with(own); });
    all.insert(now.begin(), now.end());
    all[kFunctions] = hash_of_functions();
    std::ofstream out(kFile);
    for (const auto& [name, hash] : all) out << name << ' ' << hash << '\n';
    return;
  }
  if (all[kFunctions] != hash_of_functions())
    GTEST_SKIP() << "sin, exp and the like differ in their last bits here";
  for (const auto& [name, hash] : now) EXPECT_EQ(all[name], hash) << name;
}

INSTANTIATE_TEST_SUITE_P(Presets, Golden, testing::ValuesIn(test::preset_files()), test::preset_test_name);

}  // namespace
}  // namespace carom
