#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "physics/observe/expression.h"
#include "physics/observe/observables.h"
#include "physics/observe/quantity_name.h"
#include "physics/scene/scene.h"

namespace carom {

// NaN while one of the bodies is not there yet.
[[nodiscard]] inline double value_of(const Observable& observable, const std::vector<int>& bodies,
                                     const Reading& reading) {
  for (const int body : bodies) {
    if (body >= reading.state.size()) return std::numeric_limits<double>::quiet_NaN();
  }
  return observable.value(reading, bodies);
}

// A closed form that a quantity is set beside: of time and, where there is an x, of that observable too.
struct Theory {
  Expression formula;
  const Observable* x = nullptr;
  std::vector<int> x_bodies;

  [[nodiscard]] bool empty() const { return formula.empty(); }
  [[nodiscard]] double value(const Reading& reading) const {
    return formula(reading.time, x == nullptr ? 0.0 : value_of(*x, x_bodies, reading));
  }
  auto operator<=>(const Theory&) const = default;
};

// An observable of certain bodies, which are indices into Simulation::bodies().
struct Quantity {
  const Observable* observable = nullptr;
  std::vector<int> bodies;
  Theory less{};  // if there is one the quantity is a residual: the observable less this

  // NaN while one of the bodies is not there yet, and where the theory has no value.
  [[nodiscard]] double value(const Reading& reading) const {
    const double measured = value_of(*observable, bodies, reading);
    return less.empty() ? measured : measured - less.value(reading);
  }
  auto operator<=>(const Quantity&) const = default;
};

// What a plot draws as one line: a quantity over time or, with `x`, over another one.
struct Curve {
  Quantity y;
  std::optional<Quantity> x;

  auto operator<=>(const Curve&) const = default;
};

// Of bodies by their names. Throws SceneError where one is not there.
[[nodiscard]] std::vector<int> indices_of(const std::vector<std::string>& names, std::span<const Body> bodies);

// The quantity that a file names. Throws SceneError where there is no such observable, it asks for another
// number of bodies, or a body is not there.
[[nodiscard]] Quantity quantity_of(const QuantityName& name, std::span<const Body> bodies);

// The theory of a line of a plot over `x`; empty if it has none. Throws SceneError where its text is wrong.
[[nodiscard]] Theory theory_of(const QuantityName& line, const std::optional<Quantity>& x);

}  // namespace carom
