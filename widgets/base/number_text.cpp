#include "widgets/base/number_text.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

namespace carom {

QString short_exponent(const QString& text) {
  const qsizetype e = text.indexOf('e');
  return e < 0 ? text : text.left(e + 1) + QString::number(text.mid(e + 1).toInt());
}

namespace {

// The power of ten of the first digit after rounding: 9.9996 with four digits is 10.00.
int leading_power(double value, int digits) {
  const QString rounded = QString::number(value, 'e', digits - 1);
  return rounded.mid(rounded.indexOf('e') + 1).toInt();
}

// Whether to use fixed notation: from 0.01 up to what the digits can hold.
bool is_handy(int power, int digits) { return power >= -2 && power < digits; }

QString fixed(double value, int decimals) {
  QString text = QString::number(value, 'f', decimals);
  const bool zero = std::none_of(text.begin(), text.end(), [](QChar c) { return c >= '1' && c <= '9'; });
  if (zero) text.remove('-');
  return text.replace('-', kMinus);
}

}  // namespace

QString figure(double value, int digits) {
  if (std::isnan(value)) return "not a number";
  if (std::isinf(value)) return QString(value > 0.0 ? "∞" : "−∞");
  if (value == 0.0) return "0";
  const int power = leading_power(value, digits);
  if (is_handy(power, digits)) return fixed(value, std::clamp(digits - 1 - power, 0, digits));
  const int decimals = std::min(digits - 1, power < -6 ? 1 : 2);
  return short_exponent(QString::number(value, 'e', decimals)).replace('-', kMinus);
}

QString figures(const Vec2& value, int digits) {
  const double larger = value.cwiseAbs().maxCoeff();
  const int power = leading_power(larger, digits);
  if (larger == 0.0 || !value.allFinite() || !is_handy(power, digits)) {
    // Two long exponents leave no room for more than a digit.
    const double smaller = value.cwiseAbs().minCoeff();
    const int few = std::abs(power) >= 10 && smaller >= 0.5 * std::pow(10.0, power - 1) ? 1 : 2;
    const double place = std::pow(10.0, power - few + 1);
    const auto part = [&](double x) { return figure(std::abs(x) < 0.5 * place ? 0.0 : x, few); };
    return part(value.x()) + ", " + part(value.y());
  }
  const int decimals = std::clamp(digits - 1 - power, 0, digits);
  return fixed(value.x(), decimals) + ", " + fixed(value.y(), decimals);
}

QString short_figure(double value, int digits) {
  return short_exponent(QString::number(value, 'g', digits)).replace('-', kMinus);
}

QString full_figure(double value) {
  return QString::number(value, 'g', QLocale::FloatingPointShortest).replace('-', kMinus);
}

}  // namespace carom
