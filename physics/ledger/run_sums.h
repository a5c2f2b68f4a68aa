#pragma once

#include <cstdint>

#include "physics/ledger/impact_counts.h"
#include "physics/ledger/ledger.h"
#include "physics/ledger/notices.h"

namespace carom {

// Sums over a run since its start.
struct RunSums {
  std::int64_t impact_count = 0;
  ImpactCounts impact_counts;
  Ledger ledger;               // without the work of the smooth forces, a quadrature of the motions
  double gravity_since = 0.0;  // s: ledger.momentum_from_gravity covers the time before
  double peak_kinetic = 0.0;   // J: the largest so far
  int energy_doubts = 0;       // see World::check_energy()
  Notices notices;
};

}  // namespace carom
