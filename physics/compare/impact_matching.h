#pragma once

#include <limits>
#include <span>

#include "physics/compare/recorded_run.h"

namespace carom {

// How far a run is from the reference at one moment. NaN where there is nothing to compare.
struct Comparison {
  // Largest distance over the compared bodies, of their centres in m and of the centres' velocities in m/s.
  double position_error = std::numeric_limits<double>::quiet_NaN();
  double velocity_error = std::numeric_limits<double>::quiet_NaN();
  double energy_error = std::numeric_limits<double>::quiet_NaN();       // J, of the whole scene
  double impact_time_error = std::numeric_limits<double>::quiet_NaN();  // s, largest over the matched impacts
  int matched = 0;    // impacts up to the moment, in either run, that have their partner in the other
  int unmatched = 0;  // those that have none
  int left_out = 0;   // bodies that are not compared
};

// Compares the states at `time` and the impacts up to then. The k-th impact of a pair of bodies in the run
// belongs to the k-th of that pair in the reference, which may come after `time` in one of the two. In the
// window between the two times of one impact the velocities differ by as much as the impact changes them,
// whatever the order of the method: a body that is within such a window at `time` is left out, and so is the
// energy.
[[nodiscard]] Comparison compare(const RecordedRun& run, const RecordedRun& reference,
                                 std::span<const int> moving, double time);

}  // namespace carom
