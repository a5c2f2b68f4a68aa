#include "physics/world/frame.h"

namespace carom {

void append_samples(const Simulation& simulation, std::vector<Sample>& samples) {
  for (const Jump& jump : simulation.last_jumps()) {
    samples.push_back({jump.time, jump.before});
    samples.push_back({jump.time, jump.after});
  }
  samples.push_back({simulation.time(), simulation.totals()});
}

}  // namespace carom
