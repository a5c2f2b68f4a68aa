#include "physics/world/frame.h"

namespace carom {

void append_samples(const Simulation& simulation, std::vector<Sample>& samples) {
  for (const ImpactRecord& impact : simulation.last_impacts()) {
    if (!impact.watched) continue;
    samples.push_back({impact.time, impact.before});
    samples.push_back({impact.time, impact.after});
  }
  samples.push_back({simulation.time(), simulation.totals()});
}

}  // namespace carom
