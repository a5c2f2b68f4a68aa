#pragma once

#include <QColor>
#include <QString>
#include <qwt_interval.h>
#include <qwt_scale_div.h>
#include <qwt_scale_draw.h>

namespace carom {

// The smallest round time at or after `newest`, in s: it grows in steps, so the time axis stands still between.
[[nodiscard]] double nice_time_end(double newest);

// What counts as zero, in the unit of the values, and the range that is shown about zero if all values do.
struct Zero {
  double below = 0.0;
  double range = 0.0;  // 0: 1
};

// A round range for values within [low, high] of whatever unit, with a margin; finite and not empty whatever
// comes in. It holds zero where that costs less than half of the height. A spread below kLeastSpread of the
// magnitude counts as none: it gets a range a fifth of the magnitude wide.
inline constexpr double kLeastSpread = 1e-6;
[[nodiscard]] QwtInterval nice_range(double low, double high, const Zero& zero = {});

// `current` as long as it holds nice_range(low, high) and is not much larger, else that: the axis doesn't
// tremble.
[[nodiscard]] QwtInterval steady_range(const QwtInterval& current, double low, double high,
                                       const Zero& zero = {});

// Ticks at round values, at most `most`.
[[nodiscard]] QwtScaleDiv ticks(const QwtInterval& range, int most);

// The same for magnitudes on a logarithmic axis: whole powers of ten, at most kMostPowers of them below the
// largest value.
inline constexpr int kMostPowers = 18;
[[nodiscard]] QwtInterval steady_powers(const QwtInterval& current, double low, double high);
[[nodiscard]] QwtScaleDiv power_ticks(const QwtInterval& range, int most);

// Labels only, with no more digits than the distance of the ticks needs, or of powers of ten; the last one is
// followed by `unit`.
class QuietScaleDraw : public QwtScaleDraw {
 public:
  explicit QuietScaleDraw(QString unit = {}, bool powers = false);
  void set_color(const QColor& color);
  [[nodiscard]] QwtText label(double value) const override;

 private:
  QString unit_;
  bool powers_;
  QColor color_;
};

}  // namespace carom
