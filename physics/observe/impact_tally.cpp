#include "physics/observe/impact_tally.h"

namespace carom {

void ImpactTally::begin(const Simulation& simulation) {
  ImpactCounts counts = simulation.impact_counts();
  for (const ImpactCounts::Pair& p : counts_.pairs)
    counts.watch(p.a, p.b, simulation.impact_count() == 0 ? 0 : ImpactCounts::kNotKnown);
  counts_ = std::move(counts);
  happened(simulation.impact_count());
}

void ImpactTally::add(const Simulation& simulation) {
  for (const ImpactRecord& impact : simulation.last_impacts()) add(impact, simulation.mass());
  happened(simulation.impact_count());
}

double ImpactTally::between(int a, int b) const {
  const ImpactCounts::Pair* pair = counts_.find(a, b);
  return pair != nullptr && pair->known() ? known(static_cast<double>(pair->count))
                                          : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace carom
