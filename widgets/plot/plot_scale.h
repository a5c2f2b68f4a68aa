#pragma once

#include <QColor>
#include <QString>
#include <qwt_interval.h>
#include <qwt_scale_div.h>
#include <qwt_scale_draw.h>

#include "widgets/plot/shown_unit.h"

namespace carom {

// The smallest round time at or after `newest`, in s. It grows in steps, so that the time axis is steady
// between them.
[[nodiscard]] double nice_time_end(double newest);

// The end of the time axis of a run that is `duration` long and recorded up to `newest`, in s: the duration
// from the start, of a run longer than kLongestAtOnce that much, then more in rare steps. A duration of 0 is
// unknown.
inline constexpr double kLongestAtOnce = 20.0;  // s
[[nodiscard]] double time_axis_end(double newest, double duration);

// Values that count as zero, in the unit of the values, and the range about zero if all values do.
struct Zero {
  double below = 0.0;
  double range = 0.0;  // 0: 1
};

// A round range for values within [low, high] of whatever unit, with a margin; finite and not empty for any
// input. It includes zero where that costs less than half of the height. A spread below kLeastSpread of the
// magnitude counts as none: it gets a range a fifth of the magnitude wide.
inline constexpr double kLeastSpread = 1e-6;
[[nodiscard]] QwtInterval nice_range(double low, double high, const Zero& zero = {});

// `current` while it contains nice_range(low, high) and is not much larger, otherwise nice_range(): a steady
// axis.
[[nodiscard]] QwtInterval steady_range(const QwtInterval& current, double low, double high,
                                       const Zero& zero = {});

// Ticks at round values, at most `most`.
[[nodiscard]] QwtScaleDiv ticks(const QwtInterval& range, int most);

// The range of magnitudes on a logarithmic axis: whole powers of ten, at most kMostPowers of them below the
// largest value.
inline constexpr int kMostPowers = 18;
[[nodiscard]] QwtInterval steady_powers(const QwtInterval& current, double low, double high);
[[nodiscard]] QwtScaleDiv power_ticks(const QwtInterval& range, int most);

// Draws labels only, in this unit of values in SI, with the digits that the distance of the ticks needs, or
// powers of ten; the unit's name follows the last one.
class QuietScaleDraw : public QwtScaleDraw {
 public:
  explicit QuietScaleDraw(ShownUnit unit = {}, bool powers = false);
  void set_color(const QColor& color);
  [[nodiscard]] QwtText label(double at) const override;

 private:
  ShownUnit unit_;
  bool powers_;
  QColor color_;
};

}  // namespace carom
