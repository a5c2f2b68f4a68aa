#include "physics/record/sampler.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>

namespace carom {
namespace {

Ledger without_quadratures(const Reading& reading) {
  Ledger ledger = reading.ledger;
  ledger.add(-1.0, ledger_of_quadratures(reading.state));
  return ledger;
}

}  // namespace

void keep_curves(Rows& rows, const std::vector<Curve>& wanted) {
  std::vector<Curve> kept;
  std::vector<std::size_t> columns;
  std::size_t width = 0;
  for (const Curve& curve : *rows.curves) {
    const std::size_t end = width + (curve.x ? 2 : 1);
    const bool is_kept = std::find(wanted.begin(), wanted.end(), curve) != wanted.end();
    if (is_kept) kept.push_back(curve);
    for (; width < end; ++width) {
      if (is_kept) columns.push_back(width);
    }
  }
  if (kept.size() == rows.curves->size()) return;
  std::vector<double> values;
  values.reserve(rows.size() * columns.size());
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (const std::size_t column : columns) values.push_back(rows.values[row * width + column]);
  }
  rows.curves = std::make_shared<const std::vector<Curve>>(std::move(kept));
  rows.values = std::move(values);
}

Sampler::Sampler(std::vector<Curve> curves, const std::vector<Curve>& later) {
  for (const std::vector<Curve>* all : {&std::as_const(curves), &later}) {
    for (const Curve& curve : *all) {
      if (curve.y.bodies.size() == 2) tally_.watch(curve.y.bodies[0], curve.y.bodies[1]);
      if (curve.x && curve.x->bodies.size() == 2) tally_.watch(curve.x->bodies[0], curve.x->bodies[1]);
    }
  }
  set_curves(std::move(curves));
}

void Sampler::begin(const Simulation& simulation) {
  rows_.from_the_start = true;
  tally_.begin(simulation);
  look(simulation);
  take_speeds(simulation);
}

void Sampler::after_edit(const Simulation& simulation, const RunEdit& edit) {
  if (reference_run_) reference_run_->edit(edit);
  look(simulation);
}

void Sampler::look(const Simulation& simulation) {
  mass_ = 0.0;
  for (int i = 0; i < simulation.state().size(); ++i) {
    if (simulation.mass().inverse_mass[i] > 0.0) mass_ += simulation.mass().mass[i];
  }
  Reading now = reading_of(simulation, tally_);
  std::optional<ReferenceReading> reference;
  if (reference_run_) now.reference = &reference.emplace(reference_run_->reading());
  append(now);
  remember(now);
}

void Sampler::after_step(const Simulation& simulation) {
  const std::vector<Jump>& jumps = simulation.last_jumps();
  const std::vector<ImpactRecord>& impacts = simulation.last_impacts();
  Reading end = reading_of(simulation, tally_);
  if (!jumps.empty()) {
    Ledger smooth = without_quadratures(end);  // the step's changes other than jumps
    smooth.add(-1.0, ledger_);
    for (const Jump& jump : jumps) smooth.add(-1.0, jump.change);
    Ledger jumped = ledger_;
    for (std::size_t i = 0; i < jumps.size(); ++i) {
      const Jump& jump = jumps[i];
      const double share = end.time > time_ ? (jump.time - time_) / (end.time - time_) : 1.0;
      for (const State* state : {&jump.before, &jump.after}) {
        if (state == &jump.after) {
          jumped.add(1.0, jump.change);
          tally_.add(impacts[i], simulation.mass());
          ++impacts_;
        }
        Reading at{*state,
                   tally_,
                   jump.time,
                   impacts_,
                   simulation.totals_of(*state),
                   jumped,
                   energy_drift_ + share * (end.energy_drift - energy_drift_),
                   momentum_drift_ + share * (end.momentum_drift - momentum_drift_),
                   std::lerp(angular_momentum_drift_, end.angular_momentum_drift, share),
                   end.mass,
                   end.shapes,
                   end.welded,
                   end.contacts,
                   end.contacts_known};
        at.ledger.add(share, smooth);
        at.ledger.add(1.0, ledger_of_quadratures(*state));
        append(at);
      }
    }
  }
  for (std::size_t i = jumps.size(); i < impacts.size(); ++i) tally_.add(impacts[i], simulation.mass());
  tally_.happened(simulation.impact_count());
  for (const ImpactRecord& impact : impacts) {
    scales_.impulse = std::max(scales_.impulse, impact.normal_impulse);
  }
  std::optional<ReferenceReading> reference;
  if (reference_run_) {
    reference_run_->follow(simulation);
    end.reference = &reference.emplace(reference_run_->reading());
  }
  append(end);
  remember(end);
  if (is_moment(simulation.steps())) take_speeds(simulation);
}

void Sampler::take_speeds(const Simulation& simulation) {
  SpeedMoment& moment = rows_.moments.emplace_back();
  moment.step = simulation.steps();
  moment.time = simulation.time();
  for (int i = 0; i < simulation.state().size(); ++i) {
    if (simulation.mass().inverse_mass[i] > 0.0) {
      moment.speeds.push_back(static_cast<float>(simulation.state().velocity(i).norm()));
    }
  }
}

void Sampler::remember(const Reading& end) {
  time_ = end.time;
  impacts_ = end.impacts;
  ledger_ = without_quadratures(end);
  energy_drift_ = end.energy_drift;
  momentum_drift_ = end.momentum_drift;
  angular_momentum_drift_ = end.angular_momentum_drift;
}

void Sampler::append(const Reading& reading) {
  const double kinetic = reading.totals.kinetic();
  scales_.energy = std::max(scales_.energy, kinetic + std::abs(reading.totals.potential));
  scales_.momentum = std::max(scales_.momentum, std::sqrt(2.0 * mass_ * kinetic));
  rows_.times.push_back(reading.time);
  for (const Curve& curve : *rows_.curves) {
    rows_.values.push_back(curve.y.value(reading));
    if (curve.x) rows_.values.push_back(curve.x->value(reading));
  }
}

void Sampler::go_on(const Simulation& simulation, std::vector<Curve> curves, const std::stop_token& interrupt) {
  interrupt_on(interrupt);
  set_curves(std::move(curves));
  rows_.back_to = simulation.time();
  look(simulation);
  if (is_moment(simulation.steps())) take_speeds(simulation);
}

bool Sampler::can_read(const std::vector<Curve>& curves) const {
  const auto known = [this](const Quantity& q) {
    if (q.observable->is_error() && !reference_run_) return false;
    return q.bodies.size() != 2 || tally_.watches(q.bodies[0], q.bodies[1]);
  };
  return std::all_of(curves.begin(), curves.end(),
                     [&](const Curve& curve) { return known(curve.y) && (!curve.x || known(*curve.x)); });
}

void Sampler::set_curves(std::vector<Curve> curves) {
  rows_ = {.curves = std::make_shared<const std::vector<Curve>>(std::move(curves))};
}

Rows Sampler::take() {
  Rows rows = rows_;
  rows_.from_the_start = false;
  rows_.back_to.reset();
  rows_.times.clear();
  rows_.values.clear();
  rows_.moments.clear();
  return rows;
}

std::int64_t moment_stride(std::int64_t steps) {
  std::int64_t stride = 1;
  while (steps / stride >= kMostMoments) stride *= 2;
  return stride;
}

void SpeedRecord::clear() {
  now_.clear();
  masses_.clear();
  moments_.clear();
  ++version_;
}

void SpeedRecord::add(const SpeedMoment& moment) {
  if (!moments_.empty() && moment.step <= moments_.back().step) return;
  ++version_;
  moments_.push_back(moment);
  const std::int64_t stride = moment_stride(moment.step);
  std::erase_if(moments_, [stride](const SpeedMoment& m) { return m.step % stride != 0; });
}

void SpeedRecord::cut(double time) {
  std::erase_if(moments_, [time](const SpeedMoment& m) { return m.time >= time; });
  ++version_;
}

void SpeedRecord::set_now(const State& state, const std::vector<Body>& bodies) {
  now_.clear();
  masses_.clear();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (has_infinite_mass(bodies[i]) || static_cast<int>(i) >= state.size()) continue;
    now_.push_back(state.velocity(static_cast<int>(i)).norm());
    masses_.push_back(mass_of(bodies[i]));
  }
}

std::vector<double> SpeedRecord::between(double from, double to) const {
  std::vector<double> all;
  for (const SpeedMoment& m : moments_) {
    if (m.time >= from && m.time <= to) all.insert(all.end(), m.speeds.begin(), m.speeds.end());
  }
  return all;
}

}  // namespace carom
