#include "physics/compare/reference.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/compare/comparison.h"
#include "physics/model/needs.h"
#include "physics/run/run_setup.h"
#include "physics/scene/facts.h"

namespace carom {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kAgreement = 1e-13;  // of the length
constexpr int kMostHalvings = 16;
// Of the scene's step: then no row of a study is the reference itself.
constexpr double kOffTheRows = 0.7;

// A run that blew up says nothing about later times.
bool ended_before(const RunSummary& run, double time) { return run.blew_up_at >= 0.0 && run.blew_up_at < time; }

}  // namespace

std::optional<std::string> why_not(const RunSetup& setup, ReferenceId reference) {
  if (reference != ReferenceId::kExactFlight) return std::nullopt;
  if (contacts_last(setup.method, needs_of(setup.scene))) return "a refined run, as contacts last here";
  return why_not(setup.scene, IntegratorId::kExactFlight);
}

ReferenceId usual_reference(const RunSetup& setup) {
  return why_not(setup, ReferenceId::kExactFlight) ? ReferenceId::kRefined : ReferenceId::kExactFlight;
}

Method live_reference_method(const RunSetup& setup, const Method& method, ReferenceId reference) {
  Method best = method;
  best.impacts = ImpactsId::kLocated;
  if (contacts_last(method, needs_of(setup.scene))) {
    best.integrator = IntegratorId::kDormandPrince;
    best.step = method.step / kFineSteps;
  } else if (reference == ReferenceId::kExactFlight) {
    best.integrator = IntegratorId::kExactFlight;
  } else {
    best.integrator = IntegratorId::kAdaptiveDormandPrince;
    best.tolerance = kFineTolerance;
  }
  return best;
}

Method study_reference_method(const RunSetup& setup) {
  Method method = setup.method;
  method.impacts = ImpactsId::kLocated;
  method.integrator = why_not(setup.scene, IntegratorId::kExactFlight) ? IntegratorId::kDormandPrince
                                                                       : IntegratorId::kExactFlight;
  return method;
}

double blown_up_above(const Chaos& chaos) {
  constexpr double kBeyondAnyReason = 1e4;
  return chaos.largest_kinetic > 0.0 ? kBeyondAnyReason * chaos.largest_kinetic
                                     : std::numeric_limits<double>::max();
}

Reference make_reference(const RunSetup& setup, const Chaos& chaos, double time, double until,
                         const std::stop_token& stop) {
  const std::vector<Body> bodies = all_bodies(setup.scene);
  const std::vector<MovingBody> moving = moving_bodies(bodies);
  const double limit = blown_up_above(chaos);
  Reference best;
  best.method = study_reference_method(setup);
  best.method.step *= kOffTheRows;
  const bool lasts = contacts_last(best.method, needs_of(setup.scene));
  if (best.method.integrator == IntegratorId::kExactFlight && !lasts) {
    best.exact = true;
    best.run = run_and_summarize(setup, best.method, time, until, limit, stop);
    best.converged = !ended_before(best.run, time);
    if (!best.converged) {
      best.set_errors(std::numeric_limits<double>::infinity());
      return best;
    }
    best.relative_error = kEpsilon * chaos.growth_at(time);
    best.position_error = best.relative_error * chaos.length;
    best.velocity_error = best.relative_error * chaos.largest_speed;
    best.angle_error = best.relative_error * chaos.largest_arc();
    best.spin_error = best.relative_error * std::max(chaos.largest_speed, chaos.largest_rim_speed);
    best.energy_error = kEpsilon * std::max(chaos.largest_kinetic, std::abs(best.run.energy));
    return best;
  }

  Method method = best.method;
  RunSummary coarser = run_and_summarize(setup, method, time, until, limit, stop);
  best.run = coarser;
  best.set_errors(std::numeric_limits<double>::infinity());
  constexpr double kRounding = 1e4;  // rounding errors that the steps of a run may add up to
  const double enough = std::max(kAgreement, kRounding * kEpsilon * chaos.growth_at(time));
  int no_better = 0;
  for (int halvings = 1; halvings <= kMostHalvings; ++halvings) {
    // A difference may fail to fall by chance, but hardly if it is rounding.
    if (no_better >= (best.relative_error <= enough ? 1 : 2)) break;
    method.step *= 0.5;
    const double work = until / method.step * static_cast<double>(moving.size());
    if (method.step < kLeastStep || (work > kMostReferenceWork && halvings > 1)) break;
    RunSummary run = run_and_summarize(setup, method, time, until, limit, stop);
    if (ended_before(run, time) || ended_before(coarser, time)) {
      coarser = std::move(run);
      ++no_better;
      continue;
    }
    const Comparison c = compare(coarser, run, moving, time);
    const double off = std::fmax(c.position_error / chaos.length, c.angle_error / chaos.largest_arc());
    coarser = run;
    // Falling by about order 1/2 or better; NaN, where nothing is left to compare, is not falling.
    no_better = off < 0.75 * best.relative_error ? 0 : no_better + 1;
    if (off < best.relative_error) {
      best.run = std::move(run);
      best.method = method;
      best.halvings = halvings;
      best.position_error = c.position_error;
      best.velocity_error = c.velocity_error;
      best.angle_error = c.angle_error;
      best.spin_error = c.spin_error;
      best.energy_error = c.energy_error;
      best.relative_error = off;
    }
    if (off <= kAgreement) break;
  }
  best.converged = best.relative_error <= enough;
  return best;
}

}  // namespace carom
