#include "widgets/edit/slider_scale.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "widgets/edit/units.h"

namespace carom {
namespace {

// What lessons use of each SI unit: where the slider of a positive value begins, and where all end. What is
// allowed is another matter, the ranges of their fields: no slider leaves them, but most reach much
// farther than a lesson.
struct UsualValues {
  std::string_view unit;
  double least;
  double most;
};
constexpr auto kUsualValues = std::to_array<UsualValues>({
    {"", 0.01, 1.0},
    {"m", 0.01, 1.0},
    {"s", 0.01, 10.0},
    {"kg", 0.1, 10.0},
    {"kg/m²", 1.0, 1000.0},
    {"kg m²", 1e-3, 1.0},
    {"m/s", 0.01, 5.0},
    {"m/s²", 0.1, 20.0},
    {"rad", 0.01, std::numbers::pi},
    {"rad/s", 0.1, 20.0},
    {"Hz", 0.1, 5.0},
    {"N", 0.1, 20.0},
    {"N m", 0.01, 2.0},
    {"N/m", 1.0, 1000.0},
    {"N s/m", 0.1, 10.0},
    {"kg/s", 0.01, 1.0},
    {"kg/m", 0.01, 1.0},
    {"N m²/kg²", 0.01, 10.0},
});
constexpr double kAim = 0.75;     // of a pixel: a rounder value that is so near is meant
constexpr double kSteps = 100.0;  // at least, from 0 to the end of a linear slider

// 1, 2 or 5 times a power of ten, not more than this.
double round_step(double most) {
  const double power = std::pow(10.0, std::floor(std::log10(most) + 1e-9));
  const double digit = most / power + 1e-9;
  return power * (digit >= 5.0 ? 5.0 : digit >= 2.0 ? 2.0 : 1.0);
}

double rounded(double value, double step) {
  // Dividing by the inverse of a decimal fraction gives the double that is nearest to the decimal.
  return step < 1.0 ? std::round(value / step) / std::round(1.0 / step) : std::round(value / step) * step;
}

}  // namespace

double SliderScale::place_of(double value) const {
  const double inside = std::clamp(value, low, high);
  return logarithmic ? std::log(inside / low) / std::log(high / low) : (inside - low) / (high - low);
}

double SliderScale::value_at(double place, double pixel) const {
  const double inside = std::clamp(place, 0.0, 1.0);
  if (!logarithmic) {
    const double wanted = (low + inside * (high - low)) / unit;
    const double near = kAim * pixel * (high - low) / unit;
    double value = rounded(wanted, step);
    for (const double coarse : {5.0 * step, 10.0 * step}) {
      if (std::abs(rounded(wanted, coarse) - wanted) <= near) value = rounded(wanted, coarse);
    }
    return std::clamp(value * unit, low, high);
  }
  const double value = low * std::pow(high / low, inside);
  return std::clamp(rounded(value, std::pow(10.0, std::floor(std::log10(value)) - 2.0)), low, high);
}

SliderScale slider_scale(const Range& range, double value) {
  const auto* const usual = std::find_if(kUsualValues.begin(), kUsualValues.end(),
                                         [&](const UsualValues& values) { return values.unit == range.unit; });
  const UsualValues& values = usual == kUsualValues.end() ? kUsualValues.front() : *usual;
  const double most = std::min(range.high, std::max(values.most, std::abs(value)));
  if (range.low > 0.0) {
    const double least = value > 0.0 ? std::min(values.least, value) : values.least;
    return {.low = std::max(range.low, least), .high = most, .logarithmic = true};
  }
  const double unit = units_of(range.unit).front().factor;
  const double low = range.low < 0.0 ? std::max(range.low, -most) : 0.0;
  return {.low = low, .high = most, .step = round_step(most / unit / kSteps), .unit = unit};
}

}  // namespace carom
