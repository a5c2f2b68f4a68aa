#include "widgets/plot/plot_axes.h"

#include <algorithm>
#include <cmath>
#include <qwt_axis.h>
#include <qwt_plot.h>
#include <qwt_scale_engine.h>
#include <qwt_scale_widget.h>

namespace carom {
namespace {

constexpr int kPixelsPerTimeTick = 60;
constexpr int kPixelsPerValueTick = 20;

void make_quiet(QwtPlot* plot, int axis, const QString& unit, bool powers) {
  QFont font = plot->font();
  font.setPixelSize(11);
  plot->setAxisFont(axis, font);
  plot->setAxisScaleDraw(axis, new QuietScaleDraw(unit, powers));
  plot->axisWidget(axis)->setMargin(0);
  plot->axisWidget(axis)->setSpacing(0);
}

// Zoomed in further, neighbouring labels would be the same double; further out, squares overflow.
bool is_drawable(const QwtInterval& range) {
  const double magnitude = std::max(std::abs(range.minValue()), std::abs(range.maxValue()));
  return range.width() > 1e-12 * magnitude && magnitude < 1e100;
}

QwtInterval about(const QwtInterval& now, double at, double factor) {
  return {at + (now.minValue() - at) * factor, at + (now.maxValue() - at) * factor};
}

}  // namespace

PlotAxes::PlotAxes(QwtPlot* plot, const QString& x_unit, bool logarithmic)
    : plot_(plot), logarithmic_(logarithmic) {
  make_quiet(plot_, QwtAxis::XBottom, x_unit, false);
  make_quiet(plot_, QwtAxis::YLeft, {}, logarithmic);
  if (logarithmic) plot_->setAxisScaleEngine(QwtAxis::YLeft, new QwtLogScaleEngine);
}

void PlotAxes::set_color(const QColor& color) {
  for (const int axis : {static_cast<int>(QwtAxis::XBottom), static_cast<int>(QwtAxis::YLeft)}) {
    static_cast<QuietScaleDraw*>(plot_->axisScaleDraw(axis))->set_color(color);
    plot_->axisWidget(axis)->update();
  }
}

QwtInterval PlotAxes::x() const { return plot_->axisScaleDiv(QwtAxis::XBottom).interval(); }

QwtInterval PlotAxes::values() const { return plot_->axisScaleDiv(QwtAxis::YLeft).interval(); }

void PlotAxes::set_x(const QwtInterval& range) {
  const auto put = [&](int pixels_per_tick) {
    plot_->setAxisScaleDiv(QwtAxis::XBottom, ticks(range, plot_->canvas()->width() / pixels_per_tick));
    plot_->updateAxes();
  };
  put(kPixelsPerTimeTick);
  // Deep in a zoom the labels have many digits.
  constexpr int kGap = 12;  // px, between labels
  const int needed = plot_->axisScaleDraw(QwtAxis::XBottom)->maxLabelWidth(plot_->axisFont(QwtAxis::XBottom));
  if (needed + kGap > kPixelsPerTimeTick) put(needed + kGap);
}

void PlotAxes::set_values(const QwtInterval& range) {
  fitted_ = range;
  const int most = std::clamp(plot_->canvas()->height() / kPixelsPerValueTick, 2, 6);
  plot_->setAxisScaleDiv(QwtAxis::YLeft, logarithmic_ ? power_ticks(range, most) : ticks(range, most));
  plot_->updateAxes();
}

void PlotAxes::fit_x(const QwtInterval& spread) {
  set_x(steady_range(x(), spread.minValue(), spread.maxValue()));
}

void PlotAxes::fit_values(const QwtInterval& spread, const Zero& zero) {
  if (logarithmic_) {
    set_values(steady_powers(fitted_, spread.minValue(), spread.maxValue()));
  } else {
    set_values(spread.isValid() ? steady_range(fitted_, spread.minValue(), spread.maxValue(), zero)
                                : nice_range(0.0, 0.0, zero));
  }
}

bool PlotAxes::takes_values(const QwtInterval& range) const {
  if (!logarithmic_) return is_drawable(range);
  return range.minValue() > 1e-300 && range.maxValue() < 1e300 && range.maxValue() > 1.1 * range.minValue();
}

void PlotAxes::zoom_values(double at, double factor) {
  const QwtInterval now = values();
  const QwtInterval wanted = logarithmic_ ? QwtInterval(at * std::pow(now.minValue() / at, factor),
                                                        at * std::pow(now.maxValue() / at, factor))
                                          : about(now, at, factor);
  if (takes_values(wanted)) set_values(wanted);
}

void PlotAxes::zoom_x(double at, double factor) {
  const QwtInterval wanted = about(x(), at, factor);
  if (is_drawable(wanted)) set_x(wanted);
}

void PlotAxes::pan_values(double from, double to) {
  const QwtInterval now = values();
  if (logarithmic_) {
    set_values({now.minValue() * from / to, now.maxValue() * from / to});
  } else {
    set_values({now.minValue() + from - to, now.maxValue() + from - to});
  }
}

void PlotAxes::pan_x(double from, double to) {
  const QwtInterval now = x();
  set_x({now.minValue() + from - to, now.maxValue() + from - to});
}

void PlotAxes::zoom_to(const QwtInterval& wanted_x, const QwtInterval& wanted_values) {
  if (is_drawable(wanted_x)) set_x(wanted_x);
  if (takes_values(wanted_values)) set_values(wanted_values);
}

int PlotAxes::label_extent() const {
  auto* draw = plot_->axisScaleDraw(QwtAxis::YLeft);
  const double set = draw->minimumExtent();
  draw->setMinimumExtent(0.0);
  const double needed = draw->extent(plot_->axisFont(QwtAxis::YLeft));
  draw->setMinimumExtent(set);
  return static_cast<int>(std::ceil(needed));
}

void PlotAxes::set_label_extent(int extent) {
  auto* draw = plot_->axisScaleDraw(QwtAxis::YLeft);
  if (draw->minimumExtent() == extent) return;
  draw->setMinimumExtent(extent);
  plot_->updateLayout();
}

}  // namespace carom
