#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "physics/measure/recorder.h"

namespace carom {

// One curve of a plot. Exactly one of the two functions is set: a line through the samples, or a stick at each
// impact.
struct PlotCurve {
  const char* label;
  double (*of_sample)(const Sample& sample) = nullptr;
  double (*of_impact)(const ImpactRecord& impact) = nullptr;
  const char* tip = "";  // what the curve is, where its label doesn't tell
  bool sum = false;      // of the others: a broad line behind them, which is seen where it coincides with one
};

// What a plot takes for zero, and the range that it shows then, as parts of the run's scale.
struct Rounding {
  double zero;   // values below are rounding
  double range;  // shown about zero if there is nothing else
};

// A plot over time, as preset files name it.
struct PlotKind {
  std::string_view id;
  const char* title;  // UTF-8, as unit, tip and labels
  const char* unit;
  const char* tip;
  double Scales::*scale;
  Rounding rounding;
  std::vector<PlotCurve> curves;
};

// All plots, in the order in which they are stacked: the names of physics/preset/names.h.
[[nodiscard]] std::span<const PlotKind> plot_table();

// The plots of a scene that asks for none.
[[nodiscard]] const std::vector<std::string>& default_plots();

}  // namespace carom
