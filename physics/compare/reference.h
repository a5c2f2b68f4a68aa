#pragma once

#include <optional>
#include <string>

#include "physics/compare/chaos.h"
#include "physics/compare/comparison.h"
#include "physics/run/run_setup.h"
#include "physics/scene/facts.h"

namespace carom {

// The reference of a run.
enum class ReferenceId { kNone, kExactFlight, kRefined };

// The best reference of the scene: exact flight, else a refined run.
[[nodiscard]] ReferenceId usual_reference(const RunSetup& setup);
// Why a scene can't have this reference, to follow "allowed: ..."; nothing if it can.
[[nodiscard]] std::optional<std::string> why_not(const RunSetup& setup, ReferenceId reference);

// A reference beside a run that is under way and that of a study have impacts at their own time. They choose
// the integrator by different questions. A study repeats its reference with ever shorter steps until two runs
// agree, so it knows an error that depends on the step: where contacts last, which are solved once a step, it
// keeps exact flight between them. Beside a run there is one chance, and the finest that keeps up; its error is
// that from a second run with coarser steps, and exact flight has none: it is taken only where nothing depends
// on the step.
//
// The method of the reference beside a run under `method`. A refined run uses the adaptive integrator at
// kFineTolerance; with resting contacts the fifth order at an eighth of the step.
inline constexpr double kFineTolerance = 1e-12;  // m and m/s
inline constexpr int kFineSteps = 8;
[[nodiscard]] Method live_reference_method(const RunSetup& setup, const Method& method, ReferenceId reference);

// The method of a study's reference (see make_reference): exact flight if bodies that fly allow it, else the
// fifth order, with the scene's own step.
[[nodiscard]] Method study_reference_method(const RunSetup& setup);

// The reference of a study's runs, and its uncertainty.
struct Reference {
  RunSummary run;
  Method method;
  bool exact = false;      // exact flight without resting contacts
  bool converged = false;  // the last two refinements agree within rounding
  int halvings = 0;        // of the first step, in the run that is used
  // Exact flight: rounding times growth. A refined run: its difference from the run with twice the step.
  double position_error = 0.0;  // m
  double velocity_error = 0.0;  // m/s
  double angle_error = 0.0;     // m, times the turning_radius()
  double spin_error = 0.0;      // m/s, likewise
  double energy_error = 0.0;    // J
  // Dimensionless: the larger of the position error over the scene's length and the angle error over its length
  // or its longest arc.
  double relative_error = 0.0;

  void set_errors(double to) {
    position_error = velocity_error = angle_error = spin_error = energy_error = relative_error = to;
  }
};

// The state of the scene at `time` and its impacts up to `until`. If that depends on the step, the step is
// halved until two runs differ by less than 1e-13 (see relative_error), or the difference has stopped falling,
// or the next run would take more than kMostReferenceWork steps of a body. The reference is the finer run of
// the pair with the least difference.
inline constexpr double kMostReferenceWork = 2e7;
[[nodiscard]] Reference make_reference(const RunSetup& setup, const Chaos& chaos, double time, double until,
                                       const std::stop_token& stop = {});

// The kinetic energy in J above which a run of the scene has blown up.
[[nodiscard]] double blown_up_above(const Chaos& chaos);

}  // namespace carom
