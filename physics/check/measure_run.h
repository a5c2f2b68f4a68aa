#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "physics/preset/preset.h"
#include "physics/scene/scene.h"

namespace carom {

// Runs the scene once under its own method and reduces the observable of each expectation to one number, in
// their order; NaN if the moment never came. Settings and sweeps are ignored (see physics/check/check.h).
// Each expectation ends at its own time (`until`, else the scene's duration). Maximum, minimum, mean, count
// and fit use the ends of the steps from `from` to there, including the start. The other reductions read the
// moment itself, also between two steps, without changing the run. Throws SceneError if a body does not
// exist, and Cancelled at the next step once `stop` is requested.
[[nodiscard]] std::vector<double> measure_run(const Preset& preset,
                                              const std::vector<Expectation>& expectations,
                                              const std::stop_token& stop = {});

// Difference of the reference from a figure that the file states for a given time.
struct StatedFigure {
  double difference = 0.0;  // >= 0, in the observable's unit
  std::string text;         // "x of disc at t = 2 s"
  std::string unit;
};

// All expectations of the kind "at" of the scene itself, up to `until`, compared with a run under the
// reference's method.
[[nodiscard]] std::vector<StatedFigure> check_stated_figures(const Preset& preset, const Method& method,
                                                             double until, const std::stop_token& stop = {});

}  // namespace carom
