#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "physics/world/simulation.h"

namespace carom {

// What the impacts of a run add up to, fed after each of its steps. Where a step had more impacts than it logs
// (Simulation::kMostLogged) the sums are not known, and the numbers that show them are NaN from there on.
class ImpactTally {
 public:
  // Counts the impacts of this pair of bodies from now on.
  void watch(int a, int b);
  [[nodiscard]] bool watches(int a, int b) const;
  void add(const Simulation& simulation);
  // The same piece by piece: one impact, and then how many there were so far.
  void add(const ImpactRecord& impact, const MassProperties& mass);
  void happened(std::int64_t impacts) { happened_ = impacts; }

  [[nodiscard]] double between(int a, int b) const;  // of a watched pair; else 0
  // With fixed and driven bodies, and of two free ones.
  [[nodiscard]] double with_walls() const { return known(static_cast<double>(walls_)); }
  [[nodiscard]] double mutual() const { return known(static_cast<double>(mutual_)); }
  [[nodiscard]] double wall_impulse() const { return known(wall_impulse_); }  // N s, sum of the normal ones

 private:
  struct Pair {
    int a;  // < b
    int b;
    std::int64_t count;
  };
  [[nodiscard]] double known(double value) const {
    return counted_ >= happened_ ? value : std::numeric_limits<double>::quiet_NaN();
  }

  std::vector<Pair> pairs_;
  std::int64_t counted_ = 0;
  std::int64_t happened_ = 0;
  std::int64_t walls_ = 0;
  std::int64_t mutual_ = 0;
  double wall_impulse_ = 0.0;
};

}  // namespace carom
