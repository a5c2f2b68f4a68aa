#pragma once

#include <cstdint>
#include <limits>
#include <stop_token>
#include <vector>

#include "physics/compare/impact_matcher.h"
#include "physics/compare/reference.h"
#include "physics/observe/observables.h"
#include "physics/world/edit.h"
#include "physics/world/simulation.h"

namespace carom {

// How far a run is from its reference. Bodies that wait for one run's impact in the other are left out; what
// leaves nothing to compare is NaN.
struct RunError {
  double position = std::numeric_limits<double>::quiet_NaN();  // m, now: the largest over the moving bodies
  double velocity = std::numeric_limits<double>::quiet_NaN();  // m/s
  double energy = std::numeric_limits<double>::quiet_NaN();    // J
  double largest_position = 0.0;                               // m, so far at the ends of steps
  double impact_time = 0.0;                                    // s, largest of the matched impacts
  std::int64_t matched = 0;                                    // impacts
  std::int64_t unmatched = 0;
  double uncertainty = 0.0;  // m, the reference's own
  bool of_itself = false;    // the run goes by the reference's own method: its errors tell nothing
};

// The reference of a run, which goes along with it: at the end of each of the run's steps it is there too.
// Beside it goes a second run, whose distance tells what the reference may be wrong by: of a refined one, the
// same less refined (tolerance 100 times as large, steps twice as long); of exact flight, a neighbour displaced
// by kDisplaced of the scene's length, whose distance is scaled down to that of rounding while it is small.
class ReferenceRun {
 public:
  static constexpr double kDisplaced = 1e-12;
  // Steps of the run for which an impact waits for its partner.
  static constexpr int kPatience = 20;

  // Of a run of `start` under the scene's method.
  ReferenceRun(const RunSetup& start, ReferenceId reference);

  void interrupt_on(const std::stop_token& stop) {
    fine_.interrupt_on(stop);
    check_.interrupt_on(stop);
  }
  // Does to itself what was done to the run.
  void edit(const Edit& edit);
  // After each step of the run.
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
  std::vector<int> moving_;
  std::vector<std::uint8_t> awaiting_;  // by body
  ImpactMatcher matcher_{ImpactMatcher::Partners::kNearest};
  RunError error_;
};

}  // namespace carom
