#include "widgets/number_text.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

namespace carom {

QString short_exponent(const QString& text) {
  const qsizetype e = text.indexOf('e');
  return e < 0 ? text : text.left(e + 1) + QString::number(text.mid(e + 1).toInt());
}

QString figure(double value, int digits) {
  if (std::isnan(value)) return "not a number";
  QString text;
  if (std::isinf(value)) {
    text = value > 0.0 ? QString("∞") : QString("-∞");
  } else if (value == 0.0) {
    text = "0";
  } else {
    // Rounded first: 9.9996 has four digits as 10.00.
    const QString rounded = QString::number(value, 'e', digits - 1);
    const int power = rounded.mid(rounded.indexOf('e') + 1).toInt();
    if (power >= -2 && power < digits) {
      text = QString::number(value, 'f', std::clamp(digits - 1 - power, 0, digits));
    } else {
      text = short_exponent(QString::number(value, 'e', std::min(digits - 1, power < -6 ? 1 : 2)));
    }
  }
  return text.replace('-', kMinus);
}

QString figures(const Vec2& value, int digits) {
  const double least = 1e-9 * value.cwiseAbs().maxCoeff();
  const auto part = [&](double x) { return figure(std::abs(x) < least ? 0.0 : x, digits); };
  return part(value.x()) + ", " + part(value.y());
}

QString full_figure(double value) {
  return QString::number(value, 'g', QLocale::FloatingPointShortest).replace('-', kMinus);
}

}  // namespace carom
