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

void make_quiet(QwtPlot* plot, int axis, const ShownUnit& unit, bool powers) {
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

QwtInterval scaled(const QwtInterval& range, double by) {
  return {range.minValue() * by, range.maxValue() * by};
}

// At values that are round in a unit of so many SI units.
QwtScaleDiv ticks_in(double si, const QwtInterval& range, int most,
                     QwtScaleDiv (*divide)(const QwtInterval&, int)) {
  QwtScaleDiv division = divide(scaled(range, 1.0 / si), most);
  for (const int type : {QwtScaleDiv::MinorTick, QwtScaleDiv::MediumTick, QwtScaleDiv::MajorTick}) {
    QList<double> values = division.ticks(type);
    for (double& value : values) value *= si;
    division.setTicks(type, values);
  }
  division.setInterval(range);
  return division;
}

QwtInterval about(const QwtInterval& now, double at, double factor) {
  return {at + (now.minValue() - at) * factor, at + (now.maxValue() - at) * factor};
}

}  // namespace

PlotAxes::PlotAxes(QwtPlot* plot, const ShownUnit& x_unit, const ShownUnit& unit, bool logarithmic)
    : plot_(plot), x_si_(x_unit.si), si_(unit.si), logarithmic_(logarithmic) {
  make_quiet(plot_, QwtAxis::XBottom, x_unit, false);
  make_quiet(plot_, QwtAxis::YLeft, {{}, unit.si}, logarithmic);
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
    plot_->setAxisScaleDiv(QwtAxis::XBottom,
                           ticks_in(x_si_, range, plot_->canvas()->width() / pixels_per_tick, ticks));
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
  plot_->setAxisScaleDiv(QwtAxis::YLeft, ticks_in(si_, range, most, logarithmic_ ? power_ticks : ticks));
  plot_->updateAxes();
}

void PlotAxes::fit_x(const QwtInterval& spread) {
  const QwtInterval now = scaled(x(), 1.0 / x_si_);
  set_x(scaled(steady_range(now, spread.minValue() / x_si_, spread.maxValue() / x_si_), x_si_));
}

void PlotAxes::fit_values(const QwtInterval& spread, const Zero& zero) {
  const QwtInterval now = scaled(fitted_, 1.0 / si_);
  const double low = spread.minValue() / si_;
  const double high = spread.maxValue() / si_;
  const Zero shown_zero{zero.below / si_, zero.range / si_};
  const QwtInterval fit = logarithmic_       ? steady_powers(now, low, high)
                          : spread.isValid() ? steady_range(now, low, high, shown_zero)
                                             : nice_range(0.0, 0.0, shown_zero);
  set_values(scaled(fit, si_));
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
