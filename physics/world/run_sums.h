#pragma once

#include <cstdint>

#include "physics/world/impact_counts.h"
#include "physics/world/ledger.h"
#include "physics/world/notices.h"

namespace carom {

// What a run has added up since it began.
struct RunSums {
  std::int64_t impact_count = 0;
  ImpactCounts impact_counts;
  Ledger ledger;               // without the work of the smooth forces, which the motions carry
  double gravity_since = 0.0;  // s: ledger.momentum_from_gravity holds what came before
  double peak_kinetic = 0.0;   // J: the most up to now
  int energy_doubts = 0;       // see World::check_energy()
  Notices notices;
};

}  // namespace carom
