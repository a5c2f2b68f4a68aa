#pragma once

#include <cstdint>
#include <variant>

#include "physics/scene/scene.h"
#include "physics/world/simulation.h"

namespace carom {

// What the user did to a run, after so many of its steps: another method from now on, or one more body.
struct Edit {
  std::int64_t step = 0;
  double time = 0.0;  // s, at that step's end
  std::variant<Method, Body> what;
};

void apply(const Edit& edit, Simulation& simulation);

}  // namespace carom
