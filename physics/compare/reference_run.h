#pragma once

#include <cstdint>
#include <limits>
#include <stop_token>
#include <vector>

#include "physics/compare/impact_matcher.h"
#include "physics/compare/reference.h"
#include "physics/observe/observables.h"
#include "physics/run/run_setup.h"
#include "physics/run/simulation.h"

namespace carom {

// Error of a run against its reference. Velocities and spins of bodies with an impact in one of the two runs
// only are left out; NaN if nothing is left to compare.
struct RunError {
  double position = std::numeric_limits<double>::quiet_NaN();  // m, now: the largest over the moving bodies
  double velocity = std::numeric_limits<double>::quiet_NaN();  // m/s
  double angle = std::numeric_limits<double>::quiet_NaN();     // m, times the turning_radius()
  double spin = std::numeric_limits<double>::quiet_NaN();      // m/s, likewise
  double energy = std::numeric_limits<double>::quiet_NaN();    // J
  double largest_position = 0.0;                               // m, so far, at the ends of steps
  double largest_angle = 0.0;                                  // m, likewise
  double impact_time = 0.0;                                    // s, largest of the matched impacts
  std::int64_t matched = 0;                                    // impacts
  std::int64_t unmatched = 0;
  double uncertainty = 0.0;  // m, of the reference itself, in positions and angles
  bool of_itself = false;    // the run uses the reference's own method: its errors mean nothing
};

// The reference of a run, which is advanced along with it to the end of each of its steps. A second run
// beside it estimates the error of the reference. For a refined reference it is less refined (tolerance 100
// times as large, steps twice as long). For exact flight it is a neighbour displaced by kDisplaced of the
// scene's length, whose distance is scaled down to that of rounding while it is small.
class ReferenceRun {
 public:
  static constexpr double kDisplaced = 1e-12;
  // Steps of the run for which an impact waits for its partner.
  static constexpr int kPatience = 20;

  // For a run of this setup, without its edits: they come when the run has had them.
  ReferenceRun(const RunSetup& run, ReferenceId reference);

  void interrupt_on(const std::stop_token& stop) {
    fine_.interrupt_on(stop);
    check_.interrupt_on(stop);
  }
  // Applies an edit of the run to the reference too.
  void edit(const RunEdit& edit);
  // Call after each step of the run, or after a part of one, from which it does not go on.
  void follow(const Simulation& run);

  // At the run's present time.
  [[nodiscard]] ReferenceReading reading() const { return {fine_.state(), energy_, awaiting_}; }
  [[nodiscard]] const RunError& error() const { return error_; }
  [[nodiscard]] ReferenceId id() const { return id_; }

 private:
  void compare(const Simulation& run);
  void take_methods();

  RunSetup setup_;
  ReferenceId id_;
  Simulation fine_;
  Simulation check_;
  double length_ = 0.0;  // m
  double size_ = 0.0;    // m, of the smallest moving body
  double energy_ = 0.0;  // J, of fine_
  std::vector<MovingBody> moving_;
  std::vector<std::uint8_t> awaiting_;  // by body
  ImpactMatcher matcher_{ImpactMatcher::Partners::kNearest};
  RunError error_;
};

}  // namespace carom
