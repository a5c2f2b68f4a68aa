#pragma once

#include <QPen>
#include <QPolygonF>
#include <optional>
#include <qwt_interval.h>
#include <qwt_plot_item.h>
#include <vector>

#include "physics/observe/quantity.h"
#include "physics/record/series.h"

namespace carom {

// A closed form as a line over the x axis, evaluated at each pixel: it has no points of its own. A jump is a
// vertical line at its place; the line is broken at a pole and where there is no value.
class TheoryCurve : public QwtPlotItem {
 public:
  // `over_x`: over the theory's x, not over time. `magnitudes`: |y|, for a logarithmic axis.
  TheoryCurve(const Expression& formula, bool over_x, bool magnitudes);

  void set_pen(const QPen& pen);
  // Over x, a theory that depends on time is drawn along the run: over its x, at the times of the path.
  void take(const Series<2>& path, const QwtInterval& time);
  [[nodiscard]] bool needs_path() const { return over_x_ && formula_.uses_t(); }
  // Values over the range `x`.
  [[nodiscard]] QwtInterval spread(const QwtInterval& x) const;
  // Those of nine tenths of the range, and at most their height more on either side: a pole is left out.
  [[nodiscard]] QwtInterval usual_spread(const QwtInterval& x) const;

  [[nodiscard]] int rtti() const override { return Rtti_PlotUserItem; }
  void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y, const QRectF& canvas) const override;
  // The line in px, piece by piece.
  [[nodiscard]] std::vector<QPolygonF> pieces(const QwtScaleMap& x, const QwtScaleMap& y,
                                              const QRectF& canvas) const;

 private:
  [[nodiscard]] double value(double at) const;
  [[nodiscard]] double shown(double value) const;
  [[nodiscard]] std::vector<double> values(const QwtInterval& x) const;  // finite ones, ascending

  Expression formula_;
  bool over_x_;
  bool magnitudes_;
  QPen pen_;
  std::vector<QPointF> points_;  // for a theory that needs the path
};

}  // namespace carom
