#include "widgets/plot/plot_render.h"

#include <QPainter>
#include <qwt_plot.h>
#include <qwt_plot_renderer.h>

namespace carom {

void render_plot(QwtPlot& plot, QPainter& painter, const QRectF& where) {
  const double scale = static_cast<double>(painter.device()->logicalDpiX()) / plot.logicalDpiX();
  QwtPlotRenderer renderer;
  renderer.setDiscardFlag(QwtPlotRenderer::DiscardBackground);
  renderer.setDiscardFlag(QwtPlotRenderer::DiscardCanvasFrame);
  painter.save();
  painter.scale(1.0 / scale, 1.0 / scale);
  renderer.render(&plot, &painter, QRectF(where.topLeft() * scale, where.size() * scale));
  painter.restore();
}

}  // namespace carom
