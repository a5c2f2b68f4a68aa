#include "physics/measure/expectation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/measure/observables.h"
#include "physics/world/simulation.h"

namespace carom {
namespace {

using Reduction = Expectation::Reduction;

// One expectation while its run goes on.
struct Measurement {
  const Expectation* expectation;
  const Observable* observable;
  std::vector<int> bodies;
  double value = std::numeric_limits<double>::quiet_NaN();
  double sum = 0.0;
  int count = 0;
  bool done = false;

  [[nodiscard]] double read(const Simulation& s) const {
    return observable->value(
        {s.state(), s.totals(), s.time(), static_cast<int>(s.impact_count()), s.mass(), s.shapes()}, bodies);
  }
};

void look(Measurement& m, const Simulation& s) {
  switch (m.expectation->reduction) {
    case Reduction::kAt:
    case Reduction::kAtImpact:
    case Reduction::kCount:
    case Reduction::kFit:
      return;
    case Reduction::kFinal:
      m.value = m.read(s);
      return;
    case Reduction::kMaximum:
      m.value = std::fmax(m.value, m.read(s));
      return;
    case Reduction::kMinimum:
      m.value = std::fmin(m.value, m.read(s));
      return;
    case Reduction::kMean:
      m.sum += m.read(s);
      m.value = m.sum / ++m.count;
      return;
  }
}

}  // namespace

std::vector<Outcome> measure_expectations(const Scene& scene) {
  Simulation simulation(scene);
  std::vector<Measurement> all;
  double end = scene.duration;
  for (const Expectation& e : scene.expect) {
    Measurement m{&e, find_observable(e.observable), {}};
    for (const std::string& name : e.bodies) {
      const auto found = std::find_if(simulation.bodies().begin(), simulation.bodies().end(),
                                      [&](const Body& b) { return b.name == name; });
      m.bodies.push_back(static_cast<int>(found - simulation.bodies().begin()));
    }
    all.push_back(std::move(m));
    if (e.reduction == Reduction::kAt) end = std::max(end, e.time);
  }

  // Moments between two steps are reached by a copy, so that the run itself keeps its steps.
  const auto read_at = [&](const Simulation& from, double time, Measurement& m) {
    Simulation copy = from;
    copy.advance_to(time);
    m.value = m.read(copy);
    m.done = true;
  };
  for (Measurement& m : all) look(m, simulation);
  while (simulation.time() < end - 1e-9 * scene.method.step) {
    const Simulation before = simulation;
    simulation.step();
    for (Measurement& m : all) {
      const Expectation& e = *m.expectation;
      look(m, simulation);
      if (m.done) continue;
      if (e.reduction == Reduction::kAt && simulation.time() >= e.time - 1e-9 * scene.method.step) {
        read_at(before, e.time, m);
      }
      if (e.reduction == Reduction::kAtImpact && simulation.impact_count() >= e.impact) {
        const auto index = static_cast<std::size_t>(e.impact - before.impact_count() - 1);
        const double time = simulation.last_impacts()[index].time;
        if (e.observable == "time") {
          m.value = time;
          m.done = true;
        } else {
          // A step that ends just after the impact holds the state that it left. advance_to() would take an
          // impact at the very start of a step for rounding.
          Simulation copy = before;
          copy.step(std::nextafter(time, std::numeric_limits<double>::infinity()) - before.time());
          m.value = m.read(copy);
          m.done = true;
        }
      }
    }
  }

  std::vector<Outcome> outcomes;
  for (const Measurement& m : all) {
    const double error = m.value - m.expectation->value;
    outcomes.push_back({m.value, error, std::abs(error) <= m.expectation->tolerance});
  }
  return outcomes;
}

}  // namespace carom
