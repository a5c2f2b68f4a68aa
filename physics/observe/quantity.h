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

// NaN while one of the bodies does not exist yet.
[[nodiscard]] inline double value_of(const Observable& observable, const std::vector<BodyIndex>& bodies,
                                     const Reading& reading) {
  for (const BodyIndex body : bodies) {
    if (body >= reading.state.size()) return std::numeric_limits<double>::quiet_NaN();
  }
  return observable.value(reading, bodies);
}

// A formula to compare a quantity with: of time and, if there is an x, of that observable too.
struct Theory {
  Expression formula;
  const Observable* x = nullptr;
  std::vector<BodyIndex> x_bodies;

  [[nodiscard]] bool empty() const { return formula.empty(); }
  [[nodiscard]] double value(const Reading& reading) const {
    return formula(reading.time, x == nullptr ? 0.0 : value_of(*x, x_bodies, reading));
  }
  auto operator<=>(const Theory&) const = default;
};

// An observable of certain bodies, which are indices into Simulation::bodies().
struct Quantity {
  const Observable* observable = nullptr;
  std::vector<BodyIndex> bodies;
  Theory less{};  // if present, the quantity is a residual: the observable less this

  // NaN while one of the bodies does not exist yet, and where the theory has no value.
  [[nodiscard]] double value(const Reading& reading) const {
    const double measured = value_of(*observable, bodies, reading);
    return less.empty() ? measured : measured - less.value(reading);
  }
  auto operator<=>(const Quantity&) const = default;
};

// One line of a plot: a quantity over time or, with `x`, over another quantity.
struct Curve {
  Quantity y;
  std::optional<Quantity> x;

  auto operator<=>(const Curve&) const = default;
};

// Indices of bodies by name. Throws SceneError if one does not exist.
[[nodiscard]] std::vector<BodyIndex> indices_of(const std::vector<std::string>& names,
                                                std::span<const Body> bodies);

// The quantity that a file names. Throws SceneError if there is no such observable, if the number of bodies
// is wrong, or if a body does not exist.
[[nodiscard]] Quantity quantity_of(const QuantityName& name, std::span<const Body> bodies);

// The theory of a plot's line over `x`; empty if it has none. Throws SceneError if its text is wrong.
[[nodiscard]] Theory theory_of(const QuantityName& line, const std::optional<Quantity>& x);

}  // namespace carom
