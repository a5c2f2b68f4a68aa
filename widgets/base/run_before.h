#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "physics/record/recorder.h"
#include "physics/scene/scene.h"

namespace carom {

// The run that the last new start left, or the rest of the present one that was cut off, to be shown pale
// beside it. Its moments are shown by the time since its start.
struct RunBefore {
  std::shared_ptr<const Recorder> recorder;
  std::shared_ptr<const std::vector<Body>> bodies;  // as it was left
  double start = 0.0;                               // s, by its clock
  double from = 0.0;                                // s, likewise: the present run has what came earlier too
  std::uint64_t begin = 0;                          // fingerprint_of_start() of its start
  bool lost = false;                                // its last values say nothing about the present run's
};

}  // namespace carom
