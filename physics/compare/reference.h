#pragma once

#include <optional>
#include <string>

#include "physics/compare/chaos.h"
#include "physics/compare/comparison.h"
#include "physics/scene/facts.h"
#include "physics/world/run_setup.h"

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

// The method of a study's reference, which is run again with the step halved (see make_reference): exact flight
// where the scene allows it, else the fifth order; the step is the scene's own.
[[nodiscard]] Method reference_method(const RunSetup& setup);

// What the runs of a study are compared with, and how far it may be trusted.
struct Reference {
  RunSummary run;
  Method method;
  bool exact = false;      // exact flight, without contacts that last
  bool converged = false;  // the last two refinements agree as far as rounding lets them
  int halvings = 0;        // of the first step, in the run that is used
  // Exact flight: rounding times growth. A refined run: its difference to the one of twice the step.
  double position_error = 0.0;  // m
  double velocity_error = 0.0;  // m/s
  double energy_error = 0.0;    // J
};

// The state of the scene at `time` and its impacts up to `until`. Where that depends on the step it is halved
// until two runs differ by less than 1e-13 of the scene's length, or the difference has stopped to fall, or the
// next run would take more than kMostReferenceWork steps of a body; the finer run of the pair with the least
// difference is the reference.
inline constexpr double kMostReferenceWork = 2e7;
[[nodiscard]] Reference make_reference(const RunSetup& setup, const Chaos& chaos, double time, double until,
                                       const std::stop_token& stop = {});

// The kinetic energy in J beyond which a run of the scene has blown up.
[[nodiscard]] double blown_up_above(const Chaos& chaos);

}  // namespace carom
