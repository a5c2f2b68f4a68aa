#pragma once

#include <QPointF>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <qwt_interval.h>
#include <qwt_series_data.h>
#include <vector>

namespace carom {

// The points of a curve that the pixels can show: of the records in each pixel column the first, the lowest,
// the highest and the last, in their order, so that a spike of one sample and an upright jump survive. Columns
// stand on a fixed grid of time, not on the left edge, so that points don't flicker while the plot pans.
class DecimatedSeries : public QwtSeriesData<QPointF> {
 public:
  [[nodiscard]] size_t size() const override { return kept_.size(); }
  [[nodiscard]] QPointF sample(size_t i) const override { return kept_[i].point; }
  // Of the kept points, so of every record in the visible range; invalid (negative width) without points.
  [[nodiscard]] QRectF boundingRect() const override;

  // Takes the records of `visible` and one beyond each of its ends. `records` are in the order of their member
  // `time`; values that are not finite are left out. Where records were only added since the last call, only
  // those are read.
  template <class Record>
  void take(const std::vector<Record>& records, double (*value)(const Record&), const QwtInterval& visible,
            int columns);

 private:
  struct Kept {
    std::size_t index;
    QPointF point;
  };

  void begin(const QwtInterval& visible, int columns, std::size_t first);
  void append(std::size_t index, double time, double value);
  // Every kept point is still what its record says: else the recorder dropped its oldest or began anew.
  template <class Record>
  [[nodiscard]] bool still_true(const std::vector<Record>& records, double (*value)(const Record&)) const;

  std::vector<Kept> kept_;
  QwtInterval visible_;
  int columns_ = 0;
  std::size_t first_ = 0;  // records[first_, next_) are taken
  std::size_t next_ = 0;
  // The newest column: where its points begin in kept_, and what they are chosen from.
  std::size_t open_ = 0;
  double open_column_ = 0.0;
  Kept lowest_, highest_, last_;
};

template <class Record>
bool DecimatedSeries::still_true(const std::vector<Record>& records, double (*value)(const Record&)) const {
  return next_ <= records.size() && std::all_of(kept_.begin(), kept_.end(), [&](const Kept& kept) {
           const Record& record = records[kept.index];
           return record.time == kept.point.x() && value(record) == kept.point.y();
         });
}

template <class Record>
void DecimatedSeries::take(const std::vector<Record>& records, double (*value)(const Record&),
                           const QwtInterval& visible, int columns) {
  const auto at = [&](auto it) { return static_cast<std::size_t>(it - records.begin()); };
  std::size_t first = at(std::lower_bound(records.begin(), records.end(), visible.minValue(),
                                          [](const Record& r, double t) { return r.time < t; }));
  if (first > 0) --first;
  std::size_t end = at(std::upper_bound(records.begin(), records.end(), visible.maxValue(),
                                        [](double t, const Record& r) { return t < r.time; }));
  if (end < records.size()) ++end;
  if (visible != visible_ || columns != columns_ || first != first_ || next_ > end ||
      !still_true(records, value)) {
    begin(visible, columns, first);
  }
  for (; next_ < end; ++next_) {
    const double y = value(records[next_]);
    if (std::isfinite(y)) append(next_, records[next_].time, y);
  }
}

}  // namespace carom
