#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <stop_token>
#include <string_view>
#include <vector>

#include "physics/compare/impact_matcher.h"
#include "physics/observe/observables.h"
#include "physics/scene/facts.h"
#include "physics/world/edit.h"
#include "physics/world/simulation.h"

namespace carom {

// What a run is compared with.
enum class ReferenceId { kNone, kExactFlight, kRefined };

// The best that the scene allows: exact flight, else a refined run.
[[nodiscard]] ReferenceId usual_reference(const RunSetup& setup);
// Why a scene has no such reference, as "allowed: ..." would follow; nothing if it has.
[[nodiscard]] std::optional<std::string> why_not(const RunSetup& setup, ReferenceId reference);

// The method of the reference for a run under `method`, impacts at their own time. A refined run: the adaptive
// integrator at kFineTolerance; where contacts last, which hang on the step, the fifth order at an eighth of
// it.
inline constexpr double kFineTolerance = 1e-12;  // m and m/s
inline constexpr int kFineSteps = 8;
[[nodiscard]] Method reference_for(const RunSetup& setup, const Method& method, ReferenceId reference);

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
class Companion {
 public:
  static constexpr double kDisplaced = 1e-12;
  // Steps of the run for which an impact waits for its partner.
  static constexpr int kPatience = 20;

  // Of a run of `start` under the scene's method.
  Companion(const RunSetup& start, ReferenceId reference);

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
  ImpactMatcher matcher_;
  RunError error_;
};

}  // namespace carom
