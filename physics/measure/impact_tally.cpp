#include "physics/measure/impact_tally.h"

#include <algorithm>

namespace carom {

void ImpactTally::watch(int a, int b) {
  if (a > b) std::swap(a, b);
  const auto same = [&](const Pair& p) { return p.a == a && p.b == b; };
  if (std::none_of(pairs_.begin(), pairs_.end(), same)) pairs_.push_back({a, b, 0});
}

void ImpactTally::add(const Simulation& simulation) {
  const MassProperties& mass = simulation.mass();
  happened_ = simulation.impact_count();
  for (const ImpactRecord& i : simulation.last_impacts()) {
    ++counted_;
    for (Pair& p : pairs_) {
      if (std::min(i.a, i.b) == p.a && std::max(i.a, i.b) == p.b) ++p.count;
    }
    if (mass.inverse_mass[i.a] > 0.0 && mass.inverse_mass[i.b] > 0.0) {
      ++mutual_;
    } else {
      ++walls_;
      wall_impulse_ += i.normal_impulse;
    }
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
