#include "physics/observe/quantity.h"

#include <algorithm>
#include <fmt/format.h>

#include "physics/observe/quantity_name.h"
#include "physics/scene/validate.h"

namespace carom {

std::vector<BodyIndex> indices_of(const std::vector<std::string>& names, std::span<const Body> bodies) {
  std::vector<BodyIndex> indices;
  for (const std::string& name : names) {
    const auto found =
        std::find_if(bodies.begin(), bodies.end(), [&](const Body& b) { return b.name == name; });
    if (found == bodies.end()) {
      throw SceneError(
          fmt::format("the body \"{}\" is not there; allowed: the name of a body", shortened(name)));
    }
    indices.emplace_back(static_cast<int>(found - bodies.begin()));
  }
  return indices;
}

Quantity quantity_of(const QuantityName& name, std::span<const Body> bodies) {
  Quantity quantity;
  quantity.observable = find_observable(name.observable);
  if (quantity.observable == nullptr) {
    throw SceneError(fmt::format("the observable \"{}\" is not known; allowed: see the table of observables",
                                 shortened(name.observable)));
  }
  if (static_cast<int>(name.bodies.size()) != quantity.observable->bodies) {
    throw SceneError(fmt::format("\"{}\" has {} bodies; allowed: {}", name.observable, name.bodies.size(),
                                 quantity.observable->bodies));
  }
  quantity.bodies = indices_of(name.bodies, bodies);
  return quantity;
}

Theory theory_of(const QuantityName& line, const std::optional<Quantity>& x) {
  Theory theory;
  if (line.theory.empty()) return theory;
  theory.formula = Expression(line.theory, x.has_value());
  if (x) {
    theory.x = x->observable;
    theory.x_bodies = x->bodies;
  }
  return theory;
}

}  // namespace carom
