#pragma once

#include <qwt_plot_picker.h>

namespace carom {

// Ctrl and a drag on a plot's canvas pull up a box; selected() tells what it holds, in the axes' units. A flat
// box holds the whole height, a narrow one the whole width. Escape lets go of it.
class ZoomBox : public QwtPlotPicker {
 public:
  explicit ZoomBox(QwtPlot* plot);

 protected:
  bool accept(QPolygon& box) const override;
  void widgetKeyPressEvent(QKeyEvent* event) override;
};

}  // namespace carom
