#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "physics/measure/observables.h"
#include "physics/scene/scene.h"

namespace carom {

// An observable of certain bodies, which are indices into Simulation::bodies().
struct Quantity {
  const Observable* observable = nullptr;
  std::vector<int> bodies;

  // NaN while one of the bodies is not there yet.
  [[nodiscard]] double value(const Reading& reading) const {
    for (const int body : bodies) {
      if (body >= reading.state.size()) return std::numeric_limits<double>::quiet_NaN();
    }
    return observable->value(reading, bodies);
  }
  auto operator<=>(const Quantity&) const = default;
};

// What a plot draws as one line: a quantity over time or, with `x`, over another one.
struct Curve {
  Quantity y;
  std::optional<Quantity> x;

  auto operator<=>(const Curve&) const = default;
};

// The quantity that a file names. Throws SceneError where there is no such observable, it asks for another
// number of bodies, or a body is not there.
[[nodiscard]] Quantity quantity_of(const QuantityName& name, std::span<const Body> bodies);

}  // namespace carom
