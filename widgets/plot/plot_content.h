#pragma once

#include <QString>
#include <optional>
#include <span>
#include <vector>

#include "physics/observe/quantity.h"
#include "physics/observe/quantity_name.h"
#include "physics/preset/preset.h"
#include "physics/record/recorder.h"
#include "physics/scene/scene.h"

namespace carom {

// One line of a plot: a curve, or without one a stick for the normal impulse of each impact.
struct PlotLine {
  QString label;
  QString unit;
  QString tip;  // what it is, where its label doesn't tell
  std::optional<Curve> curve;
  bool sum = false;  // of the others: a broad line behind them, which is seen where it coincides with one
  Theory theory{};   // drawn beside it
};

// What a plot takes for zero, and the range that it shows then, as parts of the run's scale.
struct Rounding {
  double zero;   // values below are rounding
  double range;  // shown about zero if there is nothing else
};

// What a plot shows, ready to be drawn.
struct PlotContent {
  // Lines, or how often each speed of the moving bodies or each strength of the impacts comes.
  enum class Shows { kLines, kSpeeds, kImpulses };

  Plot plot;
  QString title;
  QString unit;  // of the values; empty where the lines have several
  QString tip;
  QString x_title;  // empty: time
  QString x_unit;
  std::vector<PlotLine> lines;
  double Scales::*scale = nullptr;  // none where the run has no scale of this kind
  Rounding rounding{0.0, 0.0};
  Shows shows = Shows::kLines;

  // The label as the legend has it: with its unit where the plot has none.
  [[nodiscard]] QString legend(const PlotLine& line) const {
    return unit.isEmpty() && !line.unit.isEmpty() ? line.label + " / " + line.unit : line.label;
  }
};

// The plots that have a name, in the order in which they are offered.
[[nodiscard]] std::span<const PlotContent> named_plots();

// Of a plot as a scene asks for it. Throws SceneError where a body is not there.
[[nodiscard]] PlotContent content_of(const Plot& plot, std::span<const Body> bodies);

// The plots of a scene that asks for none.
[[nodiscard]] const std::vector<Plot>& default_plots();

// As a plot writes it: N·s for N s.
[[nodiscard]] QString unit_text(const Observable& observable);
// "speed of A"; of a quantity of the whole scene its label alone.
[[nodiscard]] QString label_of(const QuantityName& quantity);

}  // namespace carom
