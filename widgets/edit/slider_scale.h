#pragma once

#include "physics/scene/limits.h"

namespace carom {

// The values that a slider reaches, in SI units: logarithmic for what is positive, from 0 for what may be 0,
// and as far to both sides for what has a sign. Places on it go from 0 to 1.
struct SliderScale {
  double low = 0.0;
  double high = 1.0;
  bool logarithmic = false;
  double step = 0.01;  // of a linear one: values are whole multiples of it, in the shown unit
  double unit = 1.0;   // SI units in one of the shown unit

  // Of a value outside, the nearer end.
  [[nodiscard]] double place_of(double value) const;
  // With three figures, or at a whole step; a rounder one if it is less than a `pixel` (of the way) off.
  [[nodiscard]] double value_at(double place, double pixel = 0.0) const;
};

// The usual values of a quantity within its range, or as much more as `value` needs.
[[nodiscard]] SliderScale slider_scale(const Range& range, double value);

}  // namespace carom
