#pragma once

#include <QString>
#include <optional>
#include <utility>

#include "widgets/plot/reading_table.h"

namespace carom {

// The interval between the marks A and B as the exports take it, s: the earlier one first; none without both.
[[nodiscard]] std::optional<std::pair<double, double>> interval_of(const ReadingMarks& marks);
// "0.1 s to 0.7 s"; empty without an interval.
[[nodiscard]] QString text_of(const std::optional<std::pair<double, double>>& interval);
// How marks are set, for what needs them.
[[nodiscard]] QString marks_tip();

}  // namespace carom
