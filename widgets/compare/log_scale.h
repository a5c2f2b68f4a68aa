#pragma once

#include <QColor>
#include <QString>
#include <limits>
#include <qwt_scale_div.h>
#include <qwt_scale_draw.h>

namespace carom {

// The least and the largest of positive numbers; those that have no logarithm don't count.
struct LogRange {
  double low = std::numeric_limits<double>::infinity();
  double high = 0.0;

  [[nodiscard]] bool empty() const { return high == 0.0; }
  void take(double value);
  // With room on both sides; 0.1 to 1 where it is empty.
  [[nodiscard]] LogRange widened(double factor) const;
  // From power of ten to power of ten.
  [[nodiscard]] LogRange whole_powers() const;
};

// 10⁻⁵ or, with a mantissa, 2·10⁻⁵; plain from 0.001 to 1000.
[[nodiscard]] QString power_label(double value);
// A time in the unit that suits it: 20 µs.
[[nodiscard]] QString duration_label(double seconds);

// Powers of ten, all of them or every n-th, so that there are hardly more than `most`; on a short axis the twos
// and fives between, where there is room for them.
[[nodiscard]] QwtScaleDiv log_ticks(const LogRange& range, int most);

// Labels only.
class LogScaleDraw : public QwtScaleDraw {
 public:
  using Label = QString (*)(double value);
  LogScaleDraw(Label text_of_value, const QColor& color);
  [[nodiscard]] QwtText label(double value) const override;

 private:
  Label label_;
  QColor color_;
};

}  // namespace carom
