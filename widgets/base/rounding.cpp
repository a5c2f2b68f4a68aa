#include "widgets/base/rounding.h"

#include <cmath>

#include "widgets/base/number_text.h"

namespace carom {

double without_rounding(double sum, double scale) { return std::abs(sum) < kRoundingShare * scale ? 0.0 : sum; }

QString text_of_rounding(double difference, double scale) {
  if (!(scale > 0.0) || !std::isfinite(scale)) return {};
  const int power = static_cast<int>(std::floor(std::log10(kRoundingShare * scale) + 1e-9));
  if (!(std::abs(difference) < std::pow(10.0, power))) return {};
  return "< 1e" + QString::number(power).replace('-', kMinus);
}

}  // namespace carom
