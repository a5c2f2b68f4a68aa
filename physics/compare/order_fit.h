#pragma once

#include <span>
#include <string>

namespace carom {

// The error of a run of one method at one step.
struct ErrorAtStep {
  double step = 0.0;   // s, > 0; or a tolerance
  double error = 0.0;  // in whatever unit, >= 0; NaN: none
};

// The slope p of ln(error) over ln(step): error ~ step^p.
struct OrderFit {
  enum class Kind {
    kOrder,  // a number
    kExact,  // every error is rounding: the method is exact here and has no order
    kNone    // fewer than three errors to fit
  };
  Kind kind = Kind::kNone;
  double order = 0.0;        // dimensionless
  double uncertainty = 0.0;  // one standard error of the slope, from the scatter about the line
  double from = 0.0;         // the range of steps that it was fitted on
  double to = 0.0;
  int points = 0;
};

// Errors count for a fit from this multiple of the rounding floor on, and a method is exact up to that one.
inline constexpr double kFittedAboveFloor = 100.0;
inline constexpr double kExactBelowFloor = 1000.0;

// Least squares over the errors between kFittedAboveFloor * floor and `largest`, beyond which they say nothing.
// Steps too coarse for the order to show are left out: as many as it takes for the rest to lie on one line, to
// a twentieth of the error, but no more than half of them. Where that is not enough, as with the scattered
// errors of impacts at the step's end, all are taken. kExact if no error is above kExactBelowFloor * floor.
[[nodiscard]] OrderFit fit_order(std::span<const ErrorAtStep> errors, double floor, double largest);

// "4.01 ± 0.02", "exact here" or "no order".
[[nodiscard]] std::string text_of(const OrderFit& fit);

}  // namespace carom
