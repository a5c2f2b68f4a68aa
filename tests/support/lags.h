#pragma once

#include "physics/record/frame.h"
#include "physics/step/run_clock.h"

namespace carom::test {

// Whether this run, of several side by side, has a step ahead that does not pass the first one: to rounding, as
// the runs themselves see it.
inline bool lags(const Frame& run, const Frame& first) {
  return run.time + run.method.step <= first.time + kSameMoment * run.method.step;
}

}  // namespace carom::test
