#pragma once

#include <optional>
#include <vector>

#include "widgets/base/figure_table.h"
#include "widgets/base/plotted_run.h"
#include "widgets/plot/plot_content.h"

namespace carom {

// Two marks on the time axis, and the visible time. All in s.
struct ReadingMarks {
  std::optional<double> a;
  std::optional<double> b;
  double from = 0.0;
  double to = 1.0;

  bool operator==(const ReadingMarks&) const = default;
};

// For each curve over time of each visible run: its values at the marks, their difference and slope, and over
// the time between the marks (without two marks: over the visible time) the area under it, its mean, least and
// largest value. Values from a part of the run with extremes only are pale.
class ReadingTable : public FigureTable {
  Q_OBJECT

 public:
  explicit ReadingTable(QWidget* parent = nullptr);
  void update_from(const std::vector<PlottedRun>& runs, const std::vector<PlotContent>& plots,
                   const ReadingMarks& marks);
};

}  // namespace carom
