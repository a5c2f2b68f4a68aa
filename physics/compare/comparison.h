#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "physics/run/simulation.h"

namespace carom {

// Time of an impact of two bodies, a < b.
struct TimedImpact {
  double time = 0.0;  // s
  BodyIndex a;
  BodyIndex b;
};

// A run reduced for a comparison: the state at one moment, and all impacts until some time later.
struct RunSummary {
  State state;
  double energy = 0.0;  // J
  std::int64_t steps = 0;
  std::int64_t impact_count = 0;
  std::int64_t evaluations = 0;
  std::int64_t rejected_steps = 0;
  // In the order of time, also after the moment. None with resting contacts: the step decides whether a
  // landing is an impact or a contact absorbs it, so that impacts of two runs can't be matched.
  std::vector<TimedImpact> impacts;
  double largest_kinetic = 0.0;  // J, at the ends of the steps
  double resting_since = -1.0;   // s; as in Notices
  double blew_up_at = -1.0;  // s: the numbers are meaningless from here on and the run was ended; < 0: never
  std::string status = "ok";
};

// A run ends as blown up if its kinetic energy exceeds `blown_up_above` (J) or any of its numbers is not
// finite.
[[nodiscard]] RunSummary run_and_summarize(const RunSetup& setup, const Method& method, double time,
                                           double until, double blown_up_above,
                                           const std::stop_token& stop = {});

// A body that can move freely.
struct MovingBody {
  int index = 0;
  double radius = 0.0;  // m: its turning_radius()
};
[[nodiscard]] std::vector<MovingBody> moving_bodies(const std::vector<Body>& bodies);

// Difference of a run from the reference at one moment. NaN if there is nothing to compare.
struct Comparison {
  // Largest distance over the compared bodies, of their centres in m and of the centres' velocities in m/s.
  double position_error = std::numeric_limits<double>::quiet_NaN();
  double velocity_error = std::numeric_limits<double>::quiet_NaN();
  // Likewise of angles (m) and spins (m/s), times the body's turning_radius(): of the point of its outline that
  // they move most.
  double angle_error = std::numeric_limits<double>::quiet_NaN();
  double spin_error = std::numeric_limits<double>::quiet_NaN();
  double energy_error = std::numeric_limits<double>::quiet_NaN();       // J, of the whole scene
  double impact_time_error = std::numeric_limits<double>::quiet_NaN();  // s, largest over the matched impacts
  std::int64_t matched = 0;    // impacts up to the moment, in either run, that have a partner in the other
  std::int64_t unmatched = 0;  // those without a partner
  std::int64_t left_out = 0;   // bodies whose velocities are not compared
};

// Errors of a state against the reference's, over the bodies of `moving`. For velocities and spins those that
// wait for an impact are left out, and then so is the energy. Infinite if one of the two has blown up.
// `awaiting` is 1 for bodies whose impact has happened in one run only, or empty.
[[nodiscard]] Comparison compare_states(const State& run, double run_energy, const State& reference,
                                        double reference_energy, std::span<const MovingBody> moving,
                                        std::span<const std::uint8_t> awaiting);

// Compares the states at `time` and the impacts up to then, in order (see ImpactMatcher). If a partner comes
// after `time`, the velocities and spins of the two bodies are left out.
[[nodiscard]] Comparison compare(const RunSummary& run, const RunSummary& reference,
                                 std::span<const MovingBody> moving, double time);

// The error of a run of one method at one step.
struct ErrorAtStep {
  double step = 0.0;   // s, > 0; or a tolerance
  double error = 0.0;  // in any unit, >= 0; NaN: none
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
  double from = 0.0;         // the range of the fitted steps
  double to = 0.0;
  int points = 0;
};

// As multiples of the rounding floor: errors count for a fit above the first, and a method is exact up to the
// second.
inline constexpr double kFittedAboveFloor = 100.0;
inline constexpr double kExactBelowFloor = 1000.0;

// Least squares over the errors between kFittedAboveFloor * floor and `largest`, beyond which they mean
// nothing. Steps too coarse to show the order are left out until the rest lies on one line, to a twentieth of
// the error, but at most half of them. If that is not enough, as with the scattered errors of impacts at the
// step's end, all are used. kExact if no error is above kExactBelowFloor * floor.
[[nodiscard]] OrderFit fit_order(std::span<const ErrorAtStep> errors, double floor, double largest);

// "4.01 ± 0.02", "exact here" or "no order".
[[nodiscard]] std::string text_of(const OrderFit& fit);

}  // namespace carom
