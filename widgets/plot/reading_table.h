#pragma once

#include <optional>
#include <vector>

#include "widgets/plot/plot_content.h"
#include "widgets/theme/figure_table.h"
#include "widgets/theme/plotted_run.h"

namespace carom {

// Where the reader looks: two marks on the time axis, and the time that the plots show. All in s.
struct ReadingMarks {
  std::optional<double> a;
  std::optional<double> b;
  double from = 0.0;
  double to = 1.0;

  bool operator==(const ReadingMarks&) const = default;
};

// Of each curve over time, of each run that is shown: its values at the marks, their difference and slope, and
// over the time between the marks (without two of them: over the time that is shown) the area under it, its
// mean, least and largest value. What comes from a part of the run of which only extremes are kept stands pale.
class ReadingTable : public FigureTable {
  Q_OBJECT

 public:
  explicit ReadingTable(QWidget* parent = nullptr);
  void update_from(const std::vector<PlottedRun>& runs, const std::vector<PlotContent>& plots,
                   const ReadingMarks& marks);
};

}  // namespace carom
