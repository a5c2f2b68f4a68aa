#pragma once

#include <QColor>
#include <qwt_plot_canvas.h>

namespace carom {

// The canvas of a plot, with a frame in the colour of the focus while it has it.
class PlotCanvas : public QwtPlotCanvas {
 public:
  explicit PlotCanvas(QwtPlot* plot);

  void set_focus_color(const QColor& color) { focus_ = color; }

 protected:
  void drawFocusIndicator(QPainter* painter) override;

 private:
  QColor focus_;
};

}  // namespace carom
