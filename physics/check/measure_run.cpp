#include "physics/check/measure_run.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <memory>

#include "physics/math/cancelled.h"
#include "physics/math/least_squares.h"
#include "physics/observe/observables.h"
#include "physics/observe/quantity.h"
#include "physics/preset/preset.h"
#include "physics/run/simulation.h"

namespace carom {
namespace {

using Reduction = Expectation::Reduction;

constexpr double kNever = std::numeric_limits<double>::quiet_NaN();
// Steps between two copies of a run, from which impacts are reached again: many enough to make copies cheap,
// few enough to repeat.
constexpr int kStepsBetweenCopies = 64;

// A simulation and the sums of its impacts. Copies are independent.
struct Run {
  explicit Run(const Preset& preset) : simulation(setup_of(preset)) {}

  void step() {
    simulation.step();
    tally.add(simulation);
  }
  void step(double h) {
    simulation.step(h);
    tally.add(simulation);
  }
  void advance_to(double time) {
    simulation.advance_to(time, [this] { tally.add(simulation); });
  }
  [[nodiscard]] Reading reading() const { return reading_of(simulation, tally); }

  Simulation simulation;
  ImpactTally tally;
};

// One expectation during its run.
struct Measurement {
  const Expectation* expectation = nullptr;
  const Observable* observable = nullptr;
  std::vector<BodyIndex> bodies;
  double moment = 0.0;  // s: when it is read (at, final), or its last reading
  double value = kNever;
  bool done = false;
  // Of the readings so far: their number, those above the bound, and the line of value over time.
  std::int64_t count = 0;
  std::int64_t above = 0;
  RunningLine line;

  [[nodiscard]] bool at_a_moment() const {
    return expectation->reduction == Reduction::kAt || expectation->reduction == Reduction::kFinal;
  }
  [[nodiscard]] bool at_an_impact() const { return expectation->reduction == Reduction::kAtImpact; }

  // Adds a reading at the end of a step, for reductions over time.
  void take(const Reading& r) {
    const double y = observable->value(r, bodies);
    ++count;
    if (y > expectation->above) ++above;
    line.add(r.time, y);
    switch (expectation->reduction) {
      case Reduction::kMaximum:
        value = count == 1 ? y : std::max(value, y);
        break;
      case Reduction::kMinimum:
        value = count == 1 ? y : std::min(value, y);
        break;
      case Reduction::kMean:
        value = line.mean();
        break;
      case Reduction::kCount:
        value = static_cast<double>(above) / static_cast<double>(count);
        break;
      case Reduction::kFit:
        value = line.slope();
        break;
      case Reduction::kAt:
      case Reduction::kAtImpact:
      case Reduction::kFinal:
        break;
    }
  }
};

std::vector<Measurement> prepare(const Preset& preset, const std::vector<Expectation>& expectations, Run& run) {
  std::vector<Measurement> all;
  for (const Expectation& e : expectations) {
    Measurement m;
    m.expectation = &e;
    m.observable = find_observable(e.observable);
    m.moment = e.reduction == Reduction::kAt ? e.time : e.until.value_or(preset.duration);
    m.bodies = indices_of(e.bodies, run.simulation.bodies());
    if (m.bodies.size() == 2) run.tally.watch(m.bodies[0], m.bodies[1]);
    all.push_back(std::move(m));
  }
  run.tally.begin(run.simulation);
  return all;
}

class Measuring {
 public:
  Measuring(const Preset& preset, const std::vector<Expectation>& expectations)
      : run_(preset), step_(preset.method.step), all_(prepare(preset, expectations, run_)) {
    copied_ = std::any_of(all_.begin(), all_.end(), [](const Measurement& m) { return m.at_an_impact(); });
  }

  std::vector<double> values(const std::stop_token& stop) {
    look();
    for (std::int64_t steps = 0; !done(); ++steps) {
      throw_if_cancelled(stop);
      if (copied_ && steps % kStepsBetweenCopies == 0) copy_ = std::make_unique<Run>(run_);
      read_moments_within_the_step();
      if (done()) break;
      const std::int64_t impacts = run_.simulation.impact_count();
      const double start = run_.simulation.time();
      run_.step();
      if (run_.simulation.lost()) {
        // Anything not read so far never will be: a part of a run has no extremes, means or fits.
        for (Measurement& m : all_) {
          if (!m.done) m.value = kNever;
        }
        break;
      }
      read_impacts(start, impacts);
      look();
    }
    std::vector<double> values;
    for (const Measurement& m : all_) values.push_back(m.value);
    return values;
  }

 private:
  [[nodiscard]] bool done() const {
    return std::all_of(all_.begin(), all_.end(), [](const Measurement& m) { return m.done; });
  }

  static void read(const Run& at, Measurement& m) {
    m.value = m.observable->value(at.reading(), m.bodies);
    m.done = true;
  }

  // Reads everything that is due at the time the run has reached.
  void look() {
    const double time = run_.simulation.time();
    const double same = kSameMoment * step_;
    std::vector<Measurement*> looking;
    for (Measurement& m : all_) {
      if (m.done) continue;
      const bool reached = time >= m.moment - same;
      if (m.at_a_moment()
              ? reached
              : !m.at_an_impact() && time >= m.expectation->from - same && time <= m.moment + same) {
        looking.push_back(&m);
      }
      m.done = reached;
    }
    if (looking.empty()) return;
    const Reading r = run_.reading();
    for (Measurement* m : looking) {
      if (m->at_a_moment()) {
        m->value = m->observable->value(r, m->bodies);
      } else {
        m->take(r);
      }
    }
  }

  // A copy reaches moments between two steps, so that the run keeps its own steps.
  void read_moments_within_the_step() {
    const double end = run_.simulation.time() + (1.0 - kSameMoment) * step_;
    for (Measurement& m : all_) {
      if (m.done || !m.at_a_moment() || m.moment >= end) continue;
      Run copy = run_;
      copy.advance_to(m.moment);
      if (!copy.simulation.lost()) read(copy, m);
      m.done = true;
    }
  }

  // Reads the impacts of the last step, which began at `start` after `before` impacts.
  void read_impacts(double start, std::int64_t before) {
    const double same = kSameMoment * step_;
    for (Measurement& m : all_) {
      if (!m.at_an_impact() || !std::isnan(m.value)) continue;
      const std::int64_t index = m.expectation->impact - before - 1;
      if (index < 0 || run_.simulation.impact_count() < m.expectation->impact) continue;
      const auto& logged = run_.simulation.last_impacts();
      if (static_cast<std::size_t>(index) >= logged.size()) continue;
      const double time = logged[static_cast<std::size_t>(index)].time;
      if (time > m.moment + same) continue;
      if (m.expectation->observable == "time") {
        m.value = time;
        m.done = true;
        continue;
      }
      // A step that ends just after the impact has the state after it. advance_to() would treat an impact at
      // the very start of a step as rounding.
      Run copy = *copy_;
      while (copy.simulation.time() < start && !copy.simulation.lost()) copy.step();
      copy.step(std::nextafter(time, std::numeric_limits<double>::infinity()) - start);
      read(copy, m);
    }
  }

  Run run_;
  double step_;
  std::vector<Measurement> all_;
  bool copied_ = false;
  std::unique_ptr<Run> copy_;  // the run at most kStepsBetweenCopies steps ago
};

}  // namespace

std::vector<double> measure_run(const Preset& preset, const std::vector<Expectation>& expectations,
                                const std::stop_token& stop) {
  return Measuring(preset, expectations).values(stop);
}

std::vector<StatedFigure> check_stated_figures(const Preset& preset, const Method& method, double until,
                                               const std::stop_token& stop) {
  Preset with_method = preset;
  with_method.method = method;
  std::vector<Expectation> stated;
  for (const Expectation& e : preset.expect) {
    const bool of_this_run = e.settings.empty() && !e.over;
    if (e.reduction == Expectation::Reduction::kAt && of_this_run && e.time <= until) stated.push_back(e);
  }
  std::vector<StatedFigure> figures;
  const std::vector<double> values = measure_run(with_method, stated, stop);
  for (std::size_t i = 0; i < stated.size(); ++i) {
    const Expectation& e = stated[i];
    figures.push_back({std::abs(values[i] - e.value),
                       fmt::format("{}{}{} at t = {:.6g} s", e.observable, e.bodies.empty() ? "" : " of ",
                                   fmt::join(e.bodies, " and "), e.time),
                       std::string(find_observable(e.observable)->unit)});
  }
  return figures;
}

}  // namespace carom
