#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "physics/compare/run_summary.h"

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

// The errors of a state beside the reference's, over the bodies of `moving` that no impact waits for; the other
// ones are left out, and so is the energy where there are any. Infinite where one of the two has blown up.
// `awaiting` is 1 for the bodies that one does wait for, or empty.
[[nodiscard]] Comparison compare_states(const State& run, double run_energy, const State& reference,
                                        double reference_energy, std::span<const int> moving,
                                        std::span<const std::uint8_t> awaiting);

// Compares the states at `time` and the impacts up to then, in order (see ImpactMatcher). A partner may come
// after `time`: the two bodies are left out then.
[[nodiscard]] Comparison compare(const RunSummary& run, const RunSummary& reference,
                                 std::span<const int> moving, double time);

}  // namespace carom
