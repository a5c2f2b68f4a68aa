#include "physics/compare/reference_run.h"

#include <algorithm>
#include <cmath>

#include "physics/compare/chaos.h"
#include "physics/compare/comparison.h"
#include "physics/model/needs.h"
#include "physics/run/run_setup.h"

namespace carom {
namespace {

RunSetup with_method(RunSetup setup, const Method& method) {
  setup.method = method;
  return setup;
}

RunSetup without_edits(RunSetup setup) {
  setup.edits.clear();
  return setup;
}

// Advances a reference to where the run is after a step of it, or after a part of one.
template <class AfterStep>
void advance(Simulation& reference, const Simulation& run, const AfterStep& after_step) {
  constexpr double kRounding = 8.0 * std::numeric_limits<double>::epsilon();
  const double h = run.method().step;
  const double same = std::max(kSameMoment * h, kRounding * run.time());
  if (std::abs(run.time() - reference.time() - h) > same) return reference.advance_to(run.time(), after_step);
  const auto steps = static_cast<long>(whole_steps(h, reference.method().step));
  for (long i = 0; i < steps; ++i) {
    reference.step();
    after_step();
  }
}

RunSetup beside(const RunSetup& start, const Method& method) {
  RunSetup setup = with_method(start, method);
  if (method.integrator != IntegratorId::kExactFlight) return setup;
  const std::vector<Body> bodies = all_bodies(setup.scene);
  const double length = reach(Simulation(setup).state(), bodies, moving_bodies(bodies));
  return displaced(setup, ReferenceRun::kDisplaced * length);
}

Method less_refined(Method reference, bool lasts) {
  if (reference.integrator == IntegratorId::kExactFlight) return reference;
  if (lasts) {
    reference.step *= 2.0;
  } else {
    reference.tolerance *= 100.0;
  }
  return reference;
}

}  // namespace

ReferenceRun::ReferenceRun(const RunSetup& run, ReferenceId reference)
    : setup_(without_edits(run)),
      id_(reference),
      fine_(with_method(setup_, live_reference_method(setup_, setup_.method, reference))),
      check_(
          beside(setup_, less_refined(fine_.method(), contacts_last(setup_.method, needs_of(setup_.scene))))),
      moving_(moving_bodies(fine_.bodies())),
      awaiting_(fine_.bodies().size(), 0) {
  length_ = reach(fine_.state(), fine_.bodies(), moving_);
  size_ = smallest(fine_.bodies(), moving_, length_);
  energy_ = fine_.totals().energy();
  error_.position = error_.velocity = error_.angle = error_.spin = error_.energy = 0.0;
}

void ReferenceRun::edit(const RunEdit& edit) {
  if (const auto* method = std::get_if<Method>(&edit.what)) {
    setup_.method = *method;
  } else {
    const auto& edits = std::get<SceneEdits>(edit.what);
    if (edits.empty()) return;
    apply_edits(setup_.scene, edits);
    fine_.apply(edits);
    check_.apply(edits);
    moving_ = moving_bodies(fine_.bodies());
    matcher_.give_all_up();  // bodies may have other places in the list
    awaiting_.assign(fine_.bodies().size(), 0);
    length_ = std::fmax(length_, reach(fine_.state(), fine_.bodies(), moving_));
    size_ = smallest(fine_.bodies(), moving_, length_);
    energy_ = fine_.totals().energy();
  }
  take_methods();  // contacts may rest now
}

void ReferenceRun::take_methods() {
  const Method fine = live_reference_method(setup_, setup_.method, id_);
  const Method check = less_refined(fine, contacts_last(setup_.method, needs_of(setup_.scene)));
  if (!(fine == fine_.method())) fine_.set_method(fine);
  if (!(check == check_.method())) check_.set_method(check);
}

void ReferenceRun::follow(const Simulation& run) {
  const bool match = !contacts_last(run.method(), run.needs());  // otherwise a landing need not be an impact
  advance(fine_, run, [&] {
    if (!match) return;
    for (const ImpactRecord& impact : fine_.last_impacts()) {
      matcher_.add(ImpactMatcher::From::kReference, impact.a, impact.b, impact.time);
    }
  });
  advance(check_, run, [] {});
  if (match) {
    for (const ImpactRecord& impact : run.last_impacts()) {
      matcher_.add(ImpactMatcher::From::kRun, impact.a, impact.b, impact.time);
    }
    matcher_.give_up(run.time() - kPatience * run.method().step);
  } else {
    matcher_.give_all_up();
  }
  compare(run);
}

void ReferenceRun::compare(const Simulation& run) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (fine_.lost() || check_.lost()) {
    error_.position = error_.velocity = error_.angle = error_.spin = error_.energy = error_.uncertainty = kNone;
    return;
  }
  const State& theirs = fine_.state();
  energy_ = fine_.totals().energy();
  matcher_.mark(awaiting_);
  const Comparison now =
      compare_states(run.state(), run.totals().energy(), theirs, energy_, moving_, awaiting_);
  error_.position = now.position_error;
  error_.velocity = now.velocity_error;
  error_.angle = now.angle_error;
  error_.spin = now.spin_error;
  error_.energy = now.energy_error;
  error_.largest_position = std::fmax(error_.largest_position, error_.position);
  error_.largest_angle = std::fmax(error_.largest_angle, error_.angle);
  error_.impact_time = matcher_.largest_difference();
  error_.matched = matcher_.matched();
  error_.unmatched = matcher_.unmatched();
  error_.of_itself = run.method() == fine_.method();

  constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
  const Comparison beside = compare_states(check_.state(), energy_, theirs, energy_, moving_, {});
  const double parted = std::fmax(beside.position_error, beside.angle_error);
  const bool like_rounding =
      fine_.method().integrator == IntegratorId::kExactFlight && parted < kVisible * size_;
  error_.uncertainty = std::fmax(like_rounding ? parted * kEpsilon / kDisplaced : parted, kEpsilon * length_);
}

}  // namespace carom
