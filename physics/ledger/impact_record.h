#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "physics/dynamics/state.h"
#include "physics/ledger/ledger.h"
#include "physics/math/vectors.h"

namespace carom {

// One impact of a run in the log. Bodies are indices into Simulation::bodies(), a < b. The normal points from
// a to b, and the impulse acts on b. Times in s, points in m, impulses in N s, energies in J.
struct ImpactRecord {
  double time = 0.0;
  BodyIndex a;
  BodyIndex b;
  Vec2 point = Vec2::Zero();
  Vec2 normal = Vec2::UnitX();
  double normal_impulse = 0.0;
  double tangential_impulse = 0.0;
  double closing_speed = 0.0;  // m/s, > 0; any sign where simultaneous impacts drive a pair together
  double lost_to_restitution = 0.0;
  double lost_to_friction = 0.0;
  double lost_to_sticking = 0.0;
};

// J: the kinetic energy that the impact took in all.
[[nodiscard]] inline double lost_energy(const ImpactRecord& impact) {
  return impact.lost_to_restitution + impact.lost_to_friction + impact.lost_to_sticking;
}

// State before and after one recorded impact, and its ledger entry.
struct Jump {
  double time = 0.0;
  State before;
  State after;
  Ledger change;
};

// The impacts of the last step.
struct ImpactLog {
  // The first impacts of a step record a jump each, at the cost of two evaluations of the whole state:
  // kMostJumps for few bodies, fewer for many, at least kLeastJumps.
  static constexpr std::size_t kMostJumps = 64;
  static constexpr std::size_t kLeastJumps = 4;
  static constexpr std::size_t kMostJumpedMotions = 8192;

  std::vector<ImpactRecord> records;  // in the order of time
  std::vector<Jump> jumps;            // of the first records, one each
  bool records_jumps = false;

  [[nodiscard]] bool wants_jump(std::size_t bodies) const {
    return records_jumps && jumps.size() < std::clamp(kMostJumpedMotions / std::max<std::size_t>(bodies, 1),
                                                      kLeastJumps, kMostJumps);
  }
  void clear() {
    records.clear();
    jumps.clear();
  }
};

}  // namespace carom
