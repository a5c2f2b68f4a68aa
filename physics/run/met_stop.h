#pragma once

#include <cstddef>

namespace carom {

// A moment of a run at which a stop is met, within one of its steps or at that step's end.
struct MetStop {
  std::size_t stop = 0;     // its index in the list that is watched
  double time = 0.0;        // s
  double step_start = 0.0;  // s, of the run's own step
  double part = 0.0;  // s: a step of this length leads from there to the moment; 0: the run's own step does
};

}  // namespace carom
