#pragma once

#include <QColor>
#include <QString>
#include <limits>
#include <qwt_scale_div.h>
#include <qwt_scale_draw.h>

namespace carom {

// The least and the largest of positive numbers from 1e-300 to 1e300; others are ignored.
struct LogRange {
  double low = std::numeric_limits<double>::infinity();
  double high = 0.0;

  [[nodiscard]] bool empty() const { return high == 0.0; }
  void take(double value);
  // With a margin on both sides; 0.1 to 1 where it is empty.
  [[nodiscard]] LogRange widened(double factor) const;
  // Extended to whole powers of ten.
  [[nodiscard]] LogRange whole_powers() const;
};

// 10⁻⁵ or, with a mantissa, 2·10⁻⁵; plain from 0.001 to 1000.
[[nodiscard]] QString power_label(double value);
// A time in a suitable unit: 20 µs.
[[nodiscard]] QString duration_label(double seconds);

// Powers of ten, all or every n-th, so that there are about `most` at most; on a short axis also the twos and
// fives, where there is room.
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
