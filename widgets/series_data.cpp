#include "widgets/series_data.h"

#include <array>

namespace carom {

QRectF DecimatedSeries::boundingRect() const {
  if (kept_.empty()) return {0.0, 0.0, -1.0, -1.0};
  if (cachedBoundingRect.width() < 0.0) {
    const auto [low, high] = std::minmax_element(
        kept_.begin(), kept_.end(), [](const Kept& a, const Kept& b) { return a.point.y() < b.point.y(); });
    cachedBoundingRect = QRectF(QPointF(kept_.front().point.x(), low->point.y()),
                                QPointF(kept_.back().point.x(), high->point.y()));
  }
  return cachedBoundingRect;
}

void DecimatedSeries::begin(const QwtInterval& visible, int columns, std::size_t first) {
  kept_.clear();
  cachedBoundingRect = QRectF(0.0, 0.0, -1.0, -1.0);
  visible_ = visible;
  columns_ = columns;
  first_ = first;
  next_ = first;
}

void DecimatedSeries::append(std::size_t index, double time, double value) {
  const Kept now{index, {time, value}};
  const double column = std::floor(time / visible_.width() * columns_);
  cachedBoundingRect = QRectF(0.0, 0.0, -1.0, -1.0);
  if (kept_.empty() || column != open_column_) {
    open_column_ = column;
    open_ = kept_.size();
    lowest_ = highest_ = last_ = now;
    kept_.push_back(now);
    return;
  }
  if (value < lowest_.point.y()) lowest_ = now;
  if (value > highest_.point.y()) highest_ = now;
  last_ = now;

  kept_.resize(open_ + 1);
  std::array<Kept, 3> rest = {lowest_, highest_, last_};
  if (rest[1].index < rest[0].index) std::swap(rest[0], rest[1]);
  for (const Kept& kept : rest) {
    if (kept.index > kept_.back().index) kept_.push_back(kept);
  }
}

}  // namespace carom
