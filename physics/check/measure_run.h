#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "physics/preset/preset.h"
#include "physics/scene/scene.h"

namespace carom {

// Runs the scene once under its own method and reduces what each of `expectations` observes to one number, in
// their order; NaN if the moment never came. Their settings and sweeps are not looked at (see
// physics/check/check.h). Each looks at the run up to its own end (`until`, else the scene's duration).
// Maximum, minimum, mean, count and fit go over the ends of the steps between `from` and there, the start
// included; the other reductions read the moment itself, also between two steps, and don't disturb the run.
// Throws SceneError if a body is not there, and Stopped at the next step when `stop` asks for it.
[[nodiscard]] std::vector<double> measure_run(const Preset& preset,
                                              const std::vector<Expectation>& expectations,
                                              const std::stop_token& stop = {});

// A number that the file itself states at a given time, beside the reference.
struct StatedFigure {
  double difference = 0.0;  // of the reference from what the file states, >= 0, in the observable's unit
  std::string text;         // "x of disc at t = 2 s"
  std::string unit;
};

// All expectations of the kind "at" of the scene itself, up to `until`, read off a run of the reference's
// method.
[[nodiscard]] std::vector<StatedFigure> check_stated_figures(const Preset& preset, const Method& method,
                                                             double until, const std::stop_token& stop = {});

}  // namespace carom
