#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "physics/world/frame.h"

namespace carom {

// One curve of a plot. Exactly one of the two functions is set: a line through the samples, or a stick at each
// impact.
struct PlotCurve {
  const char* label;
  double (*of_sample)(const Sample& sample) = nullptr;
  double (*of_impact)(const ImpactRecord& impact) = nullptr;
};

// A plot over time, as preset files name it.
struct PlotKind {
  std::string_view id;
  const char* title;  // UTF-8, as unit and labels
  const char* unit;
  std::vector<PlotCurve> curves;
};

// All plots, in the order in which they are stacked: energy, momentum, impulse.
[[nodiscard]] std::span<const PlotKind> plot_table();

}  // namespace carom
