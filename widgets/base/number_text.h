#pragma once

#include <QString>

#include "physics/scene/scene.h"

namespace carom {

inline constexpr QChar kMinus(0x2212);

// A figure for people: at most `digits` significant digits, in fixed notation from 0.01 up to the number that
// the digits can hold, otherwise as in 3.1e−13; with a true minus sign, never a negative zero.
[[nodiscard]] QString figure(double value, int digits = 4);

// Two components, "x, y", both with the decimal places of the larger one.
[[nodiscard]] QString figures(const Vec2& value, int digits = 3);

// In its shortest form: 0.01, 2.5e−9; at most `digits` significant digits.
[[nodiscard]] QString short_figure(double value, int digits = 4);

// All digits of the value, for a round trip.
[[nodiscard]] QString full_figure(double value);

// Without plus sign and leading zeros in the exponent: 1.5e+07 becomes 1.5e7.
[[nodiscard]] QString short_exponent(const QString& text);

}  // namespace carom
