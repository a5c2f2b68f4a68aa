#include "app/lab/marks_text.h"

#include <QCoreApplication>
#include <algorithm>

#include "widgets/base/number_text.h"

namespace carom {

std::optional<std::pair<double, double>> interval_of(const ReadingMarks& marks) {
  if (!marks.a || !marks.b) return std::nullopt;
  return std::minmax(*marks.a, *marks.b);
}

QString text_of(const std::optional<std::pair<double, double>>& interval) {
  if (!interval) return {};
  constexpr int kDigits = 4;
  return QCoreApplication::translate("Marks", "%1 s to %2 s")
      .arg(short_figure(interval->first, kDigits), short_figure(interval->second, kDigits));
}

QString marks_tip() {
  return QCoreApplication::translate(
      "Marks", "A click in a plot sets A, Shift and a click B; or Ctrl+M, Ctrl+Shift+M at the shown moment");
}

}  // namespace carom
