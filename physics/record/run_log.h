#pragma once

#include <vector>

#include "physics/world/edit.h"
#include "physics/world/run_setup.h"

namespace carom {

// All that a run is made of: where it started, and what was done to it, in order. Whole steps from there give
// the same bytes again.
struct RunLog {
  RunSetup start;
  std::vector<Edit> edits;
};

}  // namespace carom
