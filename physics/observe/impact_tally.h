#pragma once

#include <cstdint>
#include <limits>

#include "physics/world/impact_counts.h"
#include "physics/world/simulation.h"

namespace carom {

// What the impacts of a run add up to, from the moment begin() and fed after each of its steps. Where a step
// had more impacts than it logs (kMostLogged) the sums are not known, and the numbers that show
// them are NaN from there on; so is the number of a pair which a run that was saved on its way has not counted.
class ImpactTally {
 public:
  // Before begin(): counts the impacts of this pair of bodies too.
  void watch(int a, int b) { counts_.watch(a, b, 0); }
  [[nodiscard]] bool watches(int a, int b) const { return counts_.find(a, b) != nullptr; }
  // From what the run has counted up to now.
  void begin(const Simulation& simulation);
  void add(const Simulation& simulation);
  // The same piece by piece: one impact, and then how many there were so far.
  void add(const ImpactRecord& impact, const MassProperties& mass) {
    counts_.add(impact.a, impact.b, impact.normal_impulse, mass);
  }
  void happened(std::int64_t impacts) { happened_ = impacts; }

  [[nodiscard]] double between(int a, int b) const;  // of a watched pair; else NaN
  // With fixed and kinematic bodies, and of two free ones.
  [[nodiscard]] double with_walls() const { return known(static_cast<double>(counts_.walls)); }
  [[nodiscard]] double mutual() const { return known(static_cast<double>(counts_.mutual)); }
  [[nodiscard]] double wall_impulse() const {
    return known(counts_.wall_impulse);
  }  // N s, sum of the normal ones

 private:
  [[nodiscard]] double known(double value) const {
    return counts_.counted >= happened_ ? value : std::numeric_limits<double>::quiet_NaN();
  }

  ImpactCounts counts_;
  std::int64_t happened_ = 0;
};

}  // namespace carom
