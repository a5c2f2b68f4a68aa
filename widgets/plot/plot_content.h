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
#include "widgets/plot/shown_unit.h"

namespace carom {

// One line of a plot: a curve, or, without one, a bar for the normal impulse of each impact.
struct PlotLine {
  QString label;
  ShownUnit unit;
  QString tip;  // description, where the label is not enough
  std::optional<Curve> curve;
  bool sum = false;       // of the others: a broad line behind them, visible where it coincides with one
  Theory theory{};        // drawn beside it
  Theory first_theory{};  // drawn in its place: that of the first scene
};

// A closed form as a plot has it.
struct PlottedTheory {
  QuantityName line;
  std::optional<QuantityName> x{};

  bool operator==(const PlottedTheory&) const = default;
};

// Theories of the first scene, before it was edited.
struct FirstTheories {
  std::vector<Plot> taken{};          // the plots from which an edit took them, as they were
  std::vector<PlottedTheory> kept{};  // those that plots still have
};

// The values that count as zero, and the range shown then, as parts of the run's scale.
struct Rounding {
  double zero;   // values below are rounding
  double range;  // shown about zero if there is nothing else
};

// The content of a plot, ready to be drawn.
struct PlotContent {
  // Lines, or the distribution of the moving bodies' speeds or of the impacts' strengths.
  enum class Shows { kLines, kSpeeds, kImpulses };

  Plot plot;
  QString title;
  ShownUnit unit;  // of the values; where the lines have several, none: these are in SI
  QString tip;
  QString x_title;  // empty: time
  ShownUnit x_unit;
  std::vector<PlotLine> lines;
  double Scales::*scale = nullptr;  // none where the run has no scale of this kind
  Rounding rounding{0.0, 0.0};
  Shows shows = Shows::kLines;

  // The label in the legend: with its unit where the plot has none.
  [[nodiscard]] QString legend(const PlotLine& line) const {
    return unit.name.isEmpty() ? line.unit.behind(line.label) : line.label;
  }
};

// The named plots, in the order of the menu.
[[nodiscard]] std::span<const PlotContent> named_plots();

// The content of a scene's plot, with the theories that it had in the first scene, if an edit took them. Throws
// SceneError where a body does not exist.
[[nodiscard]] PlotContent content_of(const Plot& plot, std::span<const Body> bodies,
                                     const FirstTheories& first = {});

// A plot of measured values alone; one of residuals only stays, as nothing would be left.
[[nodiscard]] Plot without_theories(Plot plot);

// The plots of a scene that names none.
[[nodiscard]] const std::vector<Plot>& default_plots();

// "speed of A"; for a quantity of the whole scene its label alone.
[[nodiscard]] QString label_of(const QuantityName& quantity);

}  // namespace carom
