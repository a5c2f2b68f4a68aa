#include "physics/measure/impact_tally.h"

#include <algorithm>

namespace carom {

void ImpactTally::watch(int a, int b) {
  if (!watches(a, b)) pairs_.push_back({std::min(a, b), std::max(a, b), 0});
}

bool ImpactTally::watches(int a, int b) const {
  return std::any_of(pairs_.begin(), pairs_.end(),
                     [&](const Pair& p) { return p.a == std::min(a, b) && p.b == std::max(a, b); });
}

void ImpactTally::add(const Simulation& simulation) {
  for (const ImpactRecord& impact : simulation.last_impacts()) add(impact, simulation.mass());
  happened(simulation.impact_count());
}

void ImpactTally::add(const ImpactRecord& impact, const MassProperties& mass) {
  ++counted_;
  for (Pair& p : pairs_) {
    if (std::min(impact.a, impact.b) == p.a && std::max(impact.a, impact.b) == p.b) ++p.count;
  }
  if (mass.inverse_mass[impact.a] > 0.0 && mass.inverse_mass[impact.b] > 0.0) {
    ++mutual_;
  } else {
    ++walls_;
    wall_impulse_ += impact.normal_impulse;
  }
}

double ImpactTally::between(int a, int b) const {
  if (a > b) std::swap(a, b);
  for (const Pair& p : pairs_) {
    if (p.a == a && p.b == b) return known(static_cast<double>(p.count));
  }
  return 0.0;
}

}  // namespace carom
