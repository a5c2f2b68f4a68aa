#include "widgets/plot/plot_canvas.h"

#include <QPainter>

namespace carom {

PlotCanvas::PlotCanvas(QwtPlot* plot) : QwtPlotCanvas(plot) {
  setFrameStyle(QFrame::NoFrame);
  setFocusIndicator(CanvasFocusIndicator);
}

// The style's own one would fill the canvas.
void PlotCanvas::drawFocusIndicator(QPainter* painter) {
  constexpr int kWidth = 2;  // px
  const QRect all = contentsRect();
  const QRect inside = all.adjusted(kWidth, kWidth, -kWidth, -kWidth);
  for (const QRect& side : QRegion(all) - inside) painter->fillRect(side, focus_);
}

}  // namespace carom
