#pragma once

#include <QPointF>
#include <qwt_interval.h>
#include <qwt_series_data.h>
#include <vector>

#include "physics/record/series.h"

namespace carom {

// The points of a curve that the pixels can show: of the points in each pixel column the first, the lowest, the
// highest and the last, in their order, so that a spike of one point and an upright jump survive. Columns stand
// on a fixed grid of time, not on the left edge, so that points don't flicker while the plot pans.
class DecimatedSeries : public QwtSeriesData<QPointF> {
 public:
  [[nodiscard]] size_t size() const override { return kept_.size(); }
  [[nodiscard]] QPointF sample(size_t i) const override { return kept_[i]; }
  // Of the kept points, so of all that were taken; invalid (negative width) without points.
  [[nodiscard]] QRectF boundingRect() const override;

  // Takes the points of `visible` and one beyond each of its ends; `magnitudes`: |y|, without zeros.
  void take(const Series<1>& series, const QwtInterval& visible, int columns, bool magnitudes);
  // A path over x, of the visible time: every point.
  void take(const Series<2>& path, const QwtInterval& visible, bool magnitudes);
  void clear();

 private:
  void append(double column, const QPointF& point);

  std::vector<QPointF> kept_;
  std::vector<SeriesPoint<1>> read_;
  std::vector<SeriesPoint<2>> read_path_;
  // The newest column: where its points begin in kept_, and what they are chosen from.
  struct Extreme {
    QPointF point;
    int order = 0;
  };
  std::size_t open_ = 0;
  double open_column_ = 0.0;
  int order_ = 0;
  Extreme lowest_, highest_;
};

}  // namespace carom
