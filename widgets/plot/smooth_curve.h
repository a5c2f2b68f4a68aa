#pragma once

#include <qwt_plot_curve.h>

namespace carom {

// A curve of lines drawn as one polyline at sub-pixel positions. QwtPlotCurve rounds to pixels and cuts the
// line into short pieces, each of which would restart its dashes.
class SmoothCurve : public QwtPlotCurve {
 public:
  using QwtPlotCurve::QwtPlotCurve;

 protected:
  void drawLines(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y, const QRectF& canvas, int from,
                 int to) const override;
};

}  // namespace carom
