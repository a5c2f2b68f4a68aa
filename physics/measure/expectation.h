#pragma once

#include <vector>

#include "physics/scene/scene.h"

namespace carom {

// What a run showed beside what its scene expects, in the observable's unit.
struct Outcome {
  double measured = 0.0;  // NaN if the moment never came
  double error = 0.0;     // measured - value
  bool good = false;      // |error| <= tolerance
};

// Runs the scene under its own method, for its duration or the last moment that is asked for, and reduces each
// of its expectations, in their order. Maximum, minimum and mean go over the ends of the steps, the start
// included.
[[nodiscard]] std::vector<Outcome> measure_expectations(const Scene& scene);

}  // namespace carom
