#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "physics/compare/reference.h"
#include "physics/preset/preset.h"

namespace carom {

// A number that the file itself states at a given time, beside the reference.
struct StatedFigure {
  double difference = 0.0;  // of the reference from what the file states, >= 0, in the observable's unit
  std::string text;         // "x of disc at t = 2 s"
  std::string unit;
};

// All expectations of the kind "at" of the scene itself, up to `until`, read off a run of the reference's
// method.
[[nodiscard]] std::vector<StatedFigure> check_stated_figures(const Preset& preset, const Reference& reference,
                                                             double until, const std::stop_token& stop = {});

}  // namespace carom
