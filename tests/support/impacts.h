#pragma once

#include <cstdint>

#include "physics/run/simulation.h"

namespace carom::test {

// Calls step() until there have been `count` impacts. False if none comes in a hundred thousand steps on end.
template <class Step>
[[nodiscard]] bool step_to_impact(const Simulation& run, std::int64_t count, const Step& step) {
  int waited = 0;
  for (std::int64_t seen = run.impact_count(); seen < count && waited < 100'000; ++waited) {
    step();
    if (run.impact_count() != seen) waited = -1;
    seen = run.impact_count();
  }
  return run.impact_count() >= count;
}
[[nodiscard]] inline bool step_to_impact(Simulation& run, std::int64_t count) {
  return step_to_impact(run, count, [&] { run.step(); });
}

}  // namespace carom::test
