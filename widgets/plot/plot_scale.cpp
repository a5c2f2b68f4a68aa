#include "widgets/plot/plot_scale.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <qwt_scale_engine.h>
#include <qwt_text.h>

#include "widgets/base/number_text.h"

namespace carom {
namespace {

// The smallest of `mantissas` times a power of ten that is at least `value` > 0; mantissas rise from 1 to 10.
template <std::size_t N>
double round_up(double value, const std::array<double, N>& mantissas) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double mantissa : mantissas) {
    // A value that is round up to its last bits counts as round.
    if (mantissa * power >= value * (1.0 - 1e-9)) return mantissa * power;
  }
  return 10.0 * power;
}

QwtText colored(const QString& text, const QColor& color) {
  QwtText label(text, QwtText::PlainText);
  label.setColor(color);
  return label;
}

}  // namespace

double nice_time_end(double newest) {
  constexpr std::array kMantissas = {1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0};
  constexpr double kLeast = 1e-6;  // s
  if (!std::isfinite(newest) || newest <= 0.0) return 1.0;
  return round_up(std::max(newest, kLeast), kMantissas);
}

double time_axis_end(double newest, double duration) {
  constexpr std::array kMantissas = {1.0, 2.0, 5.0, 10.0};
  if (!(duration > 0.0)) return nice_time_end(newest);
  const double at_once = nice_time_end(std::min(duration, kLongestAtOnce));
  if (!(newest > at_once * (1.0 + 1e-9)) || !std::isfinite(newest)) return at_once;
  const double grown = round_up(newest, kMantissas);
  const double planned = nice_time_end(duration);
  return newest <= planned ? std::min(grown, planned) : grown;
}

QwtInterval nice_range(double low, double high, const Zero& zero) {
  constexpr std::array kMantissas = {1.0, 2.0, 5.0, 10.0};
  constexpr double kLeast = 1e-300;  // any unit: smaller powers of ten are not exact
  if (!std::isfinite(low) || !std::isfinite(high) || low > high) return {-1.0, 1.0};
  const double magnitude = std::max(std::abs(low), std::abs(high));
  if (magnitude <= std::max(zero.below, kLeast)) {
    const double end = zero.range > kLeast ? round_up(zero.range, kMantissas) : 1.0;
    return {-end, end};
  }
  if (high - low < kLeastSpread * magnitude) {
    const double middle = 0.5 * (low + high);
    low = middle - 0.1 * magnitude;
    high = middle + 0.1 * magnitude;
  } else {
    const double margin = 0.04 * (high - low);
    if (low > 0.0 && low < 0.5 * high) low = 0.0;
    if (high < 0.0 && high > 0.5 * low) high = 0.0;
    if (low != 0.0) low -= margin;
    if (high != 0.0) high += margin;
  }
  const double step = round_up((high - low) / 5.0, kMantissas);
  return {step * std::floor(low / step + 1e-6), step * std::ceil(high / step - 1e-6)};
}

QwtInterval steady_range(const QwtInterval& current, double low, double high, const Zero& zero) {
  const QwtInterval wanted = nice_range(low, high, zero);
  const bool holds =
      current.isValid() && current.minValue() <= wanted.minValue() && current.maxValue() >= wanted.maxValue();
  return holds && current.width() <= 1.6 * wanted.width() ? current : wanted;
}

QwtScaleDiv ticks(const QwtInterval& range, int most) {
  const QwtLinearScaleEngine engine;
  QwtScaleDiv division = engine.divideScale(range.minValue(), range.maxValue(), std::max(most, 1), 0);
  division.setInterval(range);
  return division;
}

QwtInterval steady_powers(const QwtInterval& current, double low, double high) {
  constexpr double kLeast = 1e-280;
  if (!(high >= low) || !(high > kLeast) || !(high < 1e280)) return {0.1, 10.0};
  const double to = std::ceil(std::log10(high) + 1e-9);
  const double from = std::max(std::floor(std::log10(std::max(low, kLeast)) - 1e-9), to - kMostPowers);
  const QwtInterval wanted(std::pow(10.0, std::min(from, to - 1.0)), std::pow(10.0, to));
  const bool holds =
      current.isValid() && current.minValue() <= wanted.minValue() && current.maxValue() >= wanted.maxValue();
  return holds && current.maxValue() / current.minValue() <= 1e3 * wanted.maxValue() / wanted.minValue()
             ? current
             : wanted;
}

QwtScaleDiv power_ticks(const QwtInterval& range, int most) {
  const QwtLogScaleEngine engine;
  QwtScaleDiv division = engine.divideScale(range.minValue(), range.maxValue(), std::max(most, 1), 0);
  division.setInterval(range);
  return division;
}

QuietScaleDraw::QuietScaleDraw(ShownUnit unit, bool powers) : unit_(std::move(unit)), powers_(powers) {
  enableComponent(Backbone, false);
  enableComponent(Ticks, false);
}

void QuietScaleDraw::set_color(const QColor& color) {
  color_ = color;
  invalidateCache();
}

QwtText QuietScaleDraw::label(double at) const {
  const QList<double> major = scaleDiv().ticks(QwtScaleDiv::MajorTick);
  const double step = unit_.of(major.size() > 1 ? major[1] - major[0] : scaleDiv().range());
  double value = unit_.of(at);
  if (std::abs(value) < 1e-6 * step) value = 0.0;
  const QwtInterval range = scaleDiv().interval();
  const double magnitude = unit_.of(std::max(std::abs(range.minValue()), std::abs(range.maxValue())));
  if (powers_) return colored(short_figure(value, 3), color_);
  const int step_digit = static_cast<int>(std::floor(std::log10(step) + 1e-9));
  QString text;
  if (magnitude < 1e5 && magnitude >= 1e-3) {
    text = QString::number(value, 'f', std::max(0, -step_digit));
  } else if (value == 0.0) {
    text = "0";
  } else {
    const int digit = static_cast<int>(std::floor(std::log10(std::abs(value)) + 1e-9));
    text = short_exponent(QString::number(value, 'e', std::max(0, digit - step_digit)));
  }
  text.replace('-', kMinus);
  return colored(!major.isEmpty() && at == major.back() ? unit_.after(text) : text, color_);
}

}  // namespace carom
