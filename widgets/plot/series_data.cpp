#include "widgets/plot/series_data.h"

#include <algorithm>
#include <cmath>

namespace carom {
namespace {

// The value on a logarithmic axis; NaN where it has none.
double shown(double value, bool magnitudes) {
  if (!magnitudes) return value;
  return value == 0.0 ? std::nan("") : std::abs(value);
}

}  // namespace

QRectF DecimatedSeries::boundingRect() const {
  if (kept_.empty()) return {0.0, 0.0, -1.0, -1.0};
  if (cachedBoundingRect.width() < 0.0) {
    const auto [left, right] = std::minmax_element(
        kept_.begin(), kept_.end(), [](const QPointF& a, const QPointF& b) { return a.x() < b.x(); });
    const auto [low, high] = std::minmax_element(
        kept_.begin(), kept_.end(), [](const QPointF& a, const QPointF& b) { return a.y() < b.y(); });
    cachedBoundingRect = QRectF(QPointF(left->x(), low->y()), QPointF(right->x(), high->y()));
  }
  return cachedBoundingRect;
}

void DecimatedSeries::clear() {
  kept_.clear();
  cachedBoundingRect = QRectF(0.0, 0.0, -1.0, -1.0);
}

void DecimatedSeries::take(const Series<1>& series, const QwtInterval& visible, int columns, bool magnitudes) {
  clear();
  series.read(visible.minValue(), visible.maxValue(), read_);
  for (const SeriesPoint<1>& p : read_) {
    const double y = shown(p.value[0], magnitudes);
    if (!std::isnan(y)) append(std::floor(p.at / visible.width() * columns), {p.at, y});
  }
}

void DecimatedSeries::take(const Series<2>& path, const QwtInterval& visible, bool magnitudes) {
  clear();
  path.read(visible.minValue(), visible.maxValue(), read_path_);
  for (const SeriesPoint<2>& p : read_path_) {
    const double y = shown(p.value[0], magnitudes);
    if (!std::isnan(y)) kept_.emplace_back(p.value[1], y);
  }
}

void DecimatedSeries::shift(double by) {
  for (QPointF& point : kept_) point.rx() += by;
  cachedBoundingRect = QRectF(0.0, 0.0, -1.0, -1.0);
}

void DecimatedSeries::append(double column, const QPointF& point) {
  if (kept_.empty() || column != open_column_) {
    open_column_ = column;
    open_ = kept_.size();
    order_ = 0;
    lowest_ = highest_ = {point, 0};
    kept_.push_back(point);
    return;
  }
  const Extreme now{point, ++order_};
  if (point.y() < lowest_.point.y()) lowest_ = now;
  if (point.y() > highest_.point.y()) highest_ = now;

  kept_.resize(open_ + 1);
  const Extreme& sooner = lowest_.order < highest_.order ? lowest_ : highest_;
  const Extreme& later = lowest_.order < highest_.order ? highest_ : lowest_;
  for (const Extreme* extreme : {&sooner, &later}) {
    if (extreme->order > 0 && extreme->order < order_) kept_.push_back(extreme->point);
  }
  kept_.push_back(point);
}

}  // namespace carom
