#pragma once

#include <QColor>
#include <QString>
#include <qwt_interval.h>

#include "widgets/plot/plot_scale.h"

class QwtPlot;

namespace carom {

// The two axes of a plot: quiet labels, round ranges that hold what is shown without trembling, and what the
// reader's zooming and moving makes of them. A range that could not be drawn is not taken.
class PlotAxes {
 public:
  PlotAxes(QwtPlot* plot, const QString& x_unit, bool logarithmic);

  void set_color(const QColor& color);
  [[nodiscard]] QwtInterval x() const;
  [[nodiscard]] QwtInterval values() const;
  void set_x(const QwtInterval& range);
  void set_values(const QwtInterval& range);
  // A range with room for `spread`, the one that is shown if it will do.
  void fit_x(const QwtInterval& spread);
  void fit_values(const QwtInterval& spread, const Zero& zero = {});
  void forget_values() { fitted_ = QwtInterval(); }  // the next fit starts anew

  // To `factor` of the width, with `at` where it is; from one place to another; to what a box holds.
  void zoom_x(double at, double factor);
  void zoom_values(double at, double factor);
  void pan_x(double from, double to);
  void pan_values(double from, double to);
  void zoom_to(const QwtInterval& x, const QwtInterval& values);

  // The room in px that the value axis' labels take, and the room that they are to take at least.
  [[nodiscard]] int label_extent() const;
  void set_label_extent(int extent);

 private:
  [[nodiscard]] bool takes_values(const QwtInterval& range) const;

  QwtPlot* plot_;
  bool logarithmic_;
  QwtInterval fitted_;  // the values' last range
};

}  // namespace carom
