#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/world/simulation.h"

namespace carom {

// What the impacts of a run add up to, fed after each of its steps.
class ImpactTally {
 public:
  // Counts the impacts of this pair of bodies from now on.
  void watch(int a, int b);
  void add(std::span<const ImpactRecord> impacts, const MassProperties& mass);

  [[nodiscard]] std::int64_t between(int a, int b) const;              // of a watched pair; else 0
  [[nodiscard]] std::int64_t with_walls() const { return walls_; }     // one of the two is fixed or driven
  [[nodiscard]] std::int64_t mutual() const { return mutual_; }        // neither of the two is
  [[nodiscard]] double wall_impulse() const { return wall_impulse_; }  // N s, sum of normal impulses on walls

 private:
  struct Pair {
    int a;  // < b
    int b;
    std::int64_t count;
  };
  std::vector<Pair> pairs_;
  std::int64_t walls_ = 0;
  std::int64_t mutual_ = 0;
  double wall_impulse_ = 0.0;
};

}  // namespace carom
