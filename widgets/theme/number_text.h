#pragma once

#include <QString>

#include "physics/scene/scene.h"

namespace carom {

inline constexpr QChar kMinus(0x2212);

// A figure for people: at most `digits` significant digits, in fixed notation from 0.01 up to what they can
// hold, else as in 3.1e−13; the proper minus sign, never a negative zero.
[[nodiscard]] QString figure(double value, int digits = 4);

// Two components, "x, y", both to the decimal place that the larger needs for its digits.
[[nodiscard]] QString figures(const Vec2& value, int digits = 3);

// As short as a person writes it: 0.01, 2.5e−9; at most `digits` significant digits.
[[nodiscard]] QString short_figure(double value, int digits = 4);

// All the digits that tell the value apart.
[[nodiscard]] QString full_figure(double value);

// Without plus sign and leading zeros in the exponent: 1.5e+07 becomes 1.5e7.
[[nodiscard]] QString short_exponent(const QString& text);

}  // namespace carom
