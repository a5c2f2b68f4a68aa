#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "physics/world/simulation.h"

namespace carom {

// When two bodies met, a < b.
struct TimedImpact {
  double time = 0.0;  // s
  int a = 0;
  int b = 0;
};

// One run as a comparison needs it: the state at one moment, and all impacts until some time later.
struct RunSummary {
  State state;
  double energy = 0.0;  // J
  std::int64_t steps = 0;
  std::int64_t impact_count = 0;
  std::int64_t evaluations = 0;
  std::int64_t rejected_steps = 0;
  // In the order of time, also after the moment. None where contacts last: it hangs on the step whether a
  // landing is an impact or a contact takes it up, so that impacts of two runs are no partners there.
  std::vector<TimedImpact> impacts;
  double largest_kinetic = 0.0;  // J, at the ends of the steps
  double resting_since = -1.0;   // s; as in Notices
  double blew_up_at = -1.0;      // s: from here on the numbers mean nothing and the run was ended; < 0: never
  std::string status = "ok";
};

// A run whose kinetic energy passes this, or any number of it stops being finite, is ended: it has blown up.
[[nodiscard]] RunSummary run_and_summarize(const RunSetup& setup, const Method& method, double time,
                                           double until, double blown_up_above,
                                           const std::stop_token& stop = {});

// Indices of the bodies that anything can move.
[[nodiscard]] std::vector<int> moving_bodies(const std::vector<Body>& bodies);

// How far a run is from the reference at one moment. NaN where there is nothing to compare.
struct Comparison {
  // Largest distance over the compared bodies, of their centres in m and of the centres' velocities in m/s.
  double position_error = std::numeric_limits<double>::quiet_NaN();
  double velocity_error = std::numeric_limits<double>::quiet_NaN();
  double energy_error = std::numeric_limits<double>::quiet_NaN();       // J, of the whole scene
  double impact_time_error = std::numeric_limits<double>::quiet_NaN();  // s, largest over the matched impacts
  std::int64_t matched = 0;    // impacts up to the moment, in either run, that have their partner in the other
  std::int64_t unmatched = 0;  // those that have none
  std::int64_t left_out = 0;   // bodies that are not compared
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

// The error of a run of one method at one step.
struct ErrorAtStep {
  double step = 0.0;   // s, > 0; or a tolerance
  double error = 0.0;  // in whatever unit, >= 0; NaN: none
};

// The slope p of ln(error) over ln(step): error ~ step^p.
struct OrderFit {
  enum class Kind {
    kOrder,  // a number
    kExact,  // every error is rounding: the method is exact here and has no order
    kNone    // fewer than three errors to fit
  };
  Kind kind = Kind::kNone;
  double order = 0.0;        // dimensionless
  double uncertainty = 0.0;  // one standard error of the slope, from the scatter about the line
  double from = 0.0;         // the range of steps that it was fitted on
  double to = 0.0;
  int points = 0;
};

// Errors count for a fit from this multiple of the rounding floor on, and a method is exact up to that one.
inline constexpr double kFittedAboveFloor = 100.0;
inline constexpr double kExactBelowFloor = 1000.0;

// Least squares over the errors between kFittedAboveFloor * floor and `largest`, beyond which they say nothing.
// Steps too coarse for the order to show are left out: as many as it takes for the rest to lie on one line, to
// a twentieth of the error, but no more than half of them. Where that is not enough, as with the scattered
// errors of impacts at the step's end, all are taken. kExact if no error is above kExactBelowFloor * floor.
[[nodiscard]] OrderFit fit_order(std::span<const ErrorAtStep> errors, double floor, double largest);

// "4.01 ± 0.02", "exact here" or "no order".
[[nodiscard]] std::string text_of(const OrderFit& fit);

}  // namespace carom
