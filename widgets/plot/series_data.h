#pragma once

#include <QPointF>
#include <qwt_interval.h>
#include <qwt_series_data.h>
#include <vector>

#include "physics/record/series.h"

namespace carom {

// The points of a curve, thinned for the screen: in each pixel column the first, the lowest, the highest and
// the last point, in their order, so that one-point spikes and vertical jumps are kept. Columns are aligned to
// a fixed grid of time, not to the left edge, so that points do not flicker while the plot pans.
class DecimatedSeries : public QwtSeriesData<QPointF> {
 public:
  [[nodiscard]] size_t size() const override { return kept_.size(); }
  [[nodiscard]] QPointF sample(size_t i) const override { return kept_[i]; }
  // Bounds of the kept points, and so of all points taken; invalid (negative width) without points.
  [[nodiscard]] QRectF boundingRect() const override;

  // Takes the points within `visible` and one beyond each end; `magnitudes`: |y|, without zeros.
  void take(const Series<1>& series, const QwtInterval& visible, int columns, bool magnitudes);
  // Takes a path over x within the visible time: every point.
  void take(const Series<2>& path, const QwtInterval& visible, bool magnitudes);
  // Moves the points along x, to another clock (s).
  void shift(double by);
  void clear();

 private:
  void append(double column, const QPointF& point);

  std::vector<QPointF> kept_;
  std::vector<SeriesPoint<1>> read_;
  std::vector<SeriesPoint<2>> read_path_;
  // The newest column: the start of its points in kept_, and the candidates for them.
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
