#pragma once

#include <cstdint>
#include <variant>

#include "physics/scene/scene.h"
#include "physics/world/simulation.h"

namespace carom {

// A user's change to a run after `step` steps: a new method or an added body.
struct Edit {
  std::int64_t step = 0;
  double time = 0.0;  // s, at that step's end
  std::variant<Method, Body> what;
};

void apply(const Edit& edit, Simulation& simulation);

}  // namespace carom
