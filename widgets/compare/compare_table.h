#pragma once

#include <memory>
#include <vector>

#include "physics/record/frame.h"
#include "widgets/base/figure_table.h"
#include "widgets/theme/theme.h"

namespace carom {

// How far from the origin a body of the frame is at most, in m: the size of what position errors are
// differences of.
[[nodiscard]] double reach_of(const Frame& frame);

// A row for each run: its line and method, its errors against the reference, its energy drift and its cost.
class CompareTable : public FigureTable {
  Q_OBJECT

 public:
  explicit CompareTable(const Theme& theme, QWidget* parent = nullptr);
  void set_theme(const Theme& theme);
  void update_from(const std::vector<std::shared_ptr<const Frame>>& frames);
};

}  // namespace carom
