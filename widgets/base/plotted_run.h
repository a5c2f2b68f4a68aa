#pragma once

#include <QPen>
#include <QString>
#include <memory>

#include "physics/record/recorder.h"
#include "widgets/theme/theme.h"

namespace carom {

// One of the runs that plots show side by side, named by its method.
struct PlottedRun {
  std::shared_ptr<const Recorder> recorder;
  QString name;
  bool shown = true;
  [[nodiscard]] std::uint64_t run() const { return recorder->run(); }
};

inline constexpr double kPlotLineWidth = 1.8;  // px

// The line of the run number `index` among several, in plots and in the scene.
[[nodiscard]] inline QPen pen_of_run(std::size_t index, const Theme& theme, double width = kPlotLineWidth) {
  return {theme.series[index % theme.series.size()], width, series_dash(static_cast<int>(index))};
}

}  // namespace carom
