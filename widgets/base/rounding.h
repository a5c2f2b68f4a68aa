#pragma once

#include <QString>

namespace carom {

// What is left of values that cancel is rounding below this share of their sizes.
inline constexpr double kRoundingShare = 1e-12;

// A sum of values of the size `scale`, 0 where it is rounding.
[[nodiscard]] double without_rounding(double sum, double scale);

// "< 1e−12" in place of a difference of values of the size `scale`, > 0, that is rounding, at the power of ten
// below the size; empty if it is none. In any unit.
[[nodiscard]] QString text_of_rounding(double difference, double scale);

}  // namespace carom
