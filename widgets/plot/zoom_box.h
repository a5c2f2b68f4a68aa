#pragma once

#include <qwt_plot_picker.h>

namespace carom {

// Ctrl and a drag on a plot's canvas draw a box; selected() reports it in the axes' units. A flat box has the
// whole height, a narrow one the whole width. Escape cancels it.
class ZoomBox : public QwtPlotPicker {
 public:
  explicit ZoomBox(QwtPlot* plot);

 protected:
  bool accept(QPolygon& box) const override;
  void widgetKeyPressEvent(QKeyEvent* event) override;
};

}  // namespace carom
