#include "widgets/compare/log_scale.h"

#include <algorithm>
#include <cmath>
#include <qwt_text.h>

namespace carom {
namespace {

// Beyond these there are no whole powers of ten, or no margin.
constexpr double kLeast = 1e-300;
constexpr double kMost = 1e300;

QString superscript(int number) {
  static const QString kDigits = QString::fromUtf8("⁰¹²³⁴⁵⁶⁷⁸⁹");
  QString out;
  for (const QChar c : QString::number(std::abs(number))) out += kDigits[c.digitValue()];
  return (number < 0 ? QString::fromUtf8("⁻") : QString()) + out;
}

}  // namespace

void LogRange::take(double value) {
  if (!(value >= kLeast && value <= kMost)) return;
  low = std::min(low, value);
  high = std::max(high, value);
}

LogRange LogRange::widened(double factor) const {
  if (empty()) return {0.1, 1.0};
  return {low / factor, high * factor};
}

LogRange LogRange::whole_powers() const {
  return {std::pow(10.0, std::floor(std::log10(low))), std::pow(10.0, std::ceil(std::log10(high)))};
}

QString power_label(double value) {
  if (!(value > 0.0)) return {};  // the scale is not set yet
  const int power = static_cast<int>(std::floor(std::log10(value) + 1e-9));
  if (power >= -3 && power <= 3) return QString::number(value, 'g', 3);
  const int mantissa = static_cast<int>(std::lround(value / std::pow(10.0, power)));
  const QString ten = "10" + superscript(power);
  return mantissa == 1 ? ten : QString::number(mantissa) + QString::fromUtf8("·") + ten;
}

QString duration_label(double seconds) {
  if (seconds < 0.99e-6) return QString::number(seconds * 1e9, 'g', 3) + " ns";
  if (seconds < 0.99e-3) return QString::number(seconds * 1e6, 'g', 3) + QString::fromUtf8(" µs");
  if (seconds < 0.99) return QString::number(seconds * 1e3, 'g', 3) + " ms";
  return QString::number(seconds, 'g', 3) + " s";
}

QwtScaleDiv log_ticks(const LogRange& range, int most) {
  const double low = range.low;
  const double high = range.high;
  const int from = static_cast<int>(std::floor(std::log10(low) + 1e-9));
  const int to = static_cast<int>(std::ceil(std::log10(high) - 1e-9));
  QList<double> major;
  const double slack = 1.0 + 1e-9;
  const auto add = [&](double value) {
    if (value >= low / slack && value <= high * slack) major.append(value);
  };
  const int every = (to - from) / most + 1;
  const bool between = to - from <= 3 && 3 * (to - from) <= most;
  for (int power = from; power <= to; ++power) {
    if ((power - from) % every != 0) continue;
    add(std::pow(10.0, power));
    if (!between) continue;
    add(2.0 * std::pow(10.0, power));
    add(5.0 * std::pow(10.0, power));
  }
  return QwtScaleDiv(low, high, {}, {}, major);
}

LogScaleDraw::LogScaleDraw(Label text_of_value, const QColor& color) : label_(text_of_value), color_(color) {
  enableComponent(Backbone, false);
  enableComponent(Ticks, false);
  setSpacing(6);
}

QwtText LogScaleDraw::label(double value) const {
  QwtText text(label_(value), QwtText::PlainText);
  text.setColor(color_);
  return text;
}

}  // namespace carom
