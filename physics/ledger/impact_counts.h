#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "physics/dynamics/state.h"
#include "physics/model/mass.h"
#include "physics/scene/limits.h"

namespace carom {

// Sums over the impacts of a run.
struct ImpactCounts {
  struct Pair {
    BodyIndex a;  // < b
    BodyIndex b;
    std::int64_t count = 0;
    [[nodiscard]] bool known() const { return count >= 0; }
  };
  static constexpr std::size_t kMostPairs = 2 * kMostCurvesInAll;
  // Count of a pair that is watched from the middle of a run: so far below 0 that it stays negative.
  static constexpr std::int64_t kNotKnown = -4'000'000'000'000'000;

  std::int64_t counted = 0;   // impacts included in the sums
  std::int64_t walls = 0;     // with static and kinematic bodies
  std::int64_t mutual = 0;    // of two free bodies
  double wall_impulse = 0.0;  // N s, sum of the normal impulses
  std::vector<Pair> pairs;    // the watched pairs, at most kMostPairs

  [[nodiscard]] const Pair* find(BodyIndex a, BodyIndex b) const {
    for (const Pair& p : pairs) {
      if (p.a == std::min(a, b) && p.b == std::max(a, b)) return &p;
    }
    return nullptr;
  }
  // Watches a pair of bodies that has had `count` impacts. Watching it again changes nothing.
  void watch(BodyIndex a, BodyIndex b, std::int64_t count) {
    if (find(a, b) == nullptr) pairs.push_back({std::min(a, b), std::max(a, b), count});
  }
  void add(BodyIndex a, BodyIndex b, double normal_impulse, const MassProperties& mass) {
    ++counted;
    for (Pair& p : pairs) {
      if (std::min(a, b) == p.a && std::max(a, b) == p.b) ++p.count;
    }
    if (mass.inverse_mass[a] > 0.0 && mass.inverse_mass[b] > 0.0) {
      ++mutual;
    } else {
      ++walls;
      wall_impulse += normal_impulse;
    }
  }
};

}  // namespace carom
