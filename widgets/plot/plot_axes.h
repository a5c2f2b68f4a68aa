#pragma once

#include <QColor>
#include <QString>
#include <qwt_interval.h>

#include "widgets/plot/plot_scale.h"

class QwtPlot;

namespace carom {

// The two axes of a plot: plain labels, steady round ranges, zooming and panning. A range that cannot be drawn
// is refused.
class PlotAxes {
 public:
  // Ranges are in SI; labels and round values in these units, the name of the one along x at its last label.
  PlotAxes(QwtPlot* plot, const ShownUnit& x_unit, const ShownUnit& unit, bool logarithmic);

  void set_color(const QColor& color);
  [[nodiscard]] QwtInterval x() const;
  [[nodiscard]] QwtInterval values() const;
  void set_x(const QwtInterval& range);
  void set_values(const QwtInterval& range);
  // A range that includes `spread`; the current one if it fits.
  void fit_x(const QwtInterval& spread);
  void fit_values(const QwtInterval& spread, const Zero& zero = {});
  void forget_values() { fitted_ = QwtInterval(); }  // the next fit ignores the old range

  // Zooms by `factor` about `at`; pans from one place to another; zooms to a box.
  void zoom_x(double at, double factor);
  void zoom_values(double at, double factor);
  void pan_x(double from, double to);
  void pan_values(double from, double to);
  void zoom_to(const QwtInterval& x, const QwtInterval& values);

  // Width in px of the value axis' labels, and their minimum width.
  [[nodiscard]] int label_extent() const;
  void set_label_extent(int extent);

 private:
  [[nodiscard]] bool takes_values(const QwtInterval& range) const;

  QwtPlot* plot_;
  double x_si_;  // SI units in one of those along x
  double si_;    // in one of the values'
  bool logarithmic_;
  QwtInterval fitted_;  // last range of the values
};

}  // namespace carom
