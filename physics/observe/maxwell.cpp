#include "physics/observe/maxwell.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace carom {

Maxwell::Maxwell(std::span<const double> masses, std::span<const double> speeds) {
  const std::size_t n = std::min(masses.size(), speeds.size());
  for (std::size_t i = 0; i < n; ++i) kt_ += 0.5 * masses[i] * speeds[i] * speeds[i] / static_cast<double>(n);
  if (!(kt_ > 0.0)) return;
  // Masses within a per cent count as one, so that a crowd of any masses stays a short sum.
  struct Sum {
    double mass = 0.0;
    double count = 0.0;
  };
  std::map<int, Sum> sums;
  for (std::size_t i = 0; i < n; ++i) {
    Sum& sum = sums[static_cast<int>(std::floor(std::log(masses[i]) * 100.0))];
    sum.mass += masses[i];
    sum.count += 1.0;
  }
  for (const auto& [key, sum] : sums) {
    kinds_.push_back({sum.mass / sum.count / kt_, sum.count / static_cast<double>(n)});
  }
}

double Maxwell::density(double speed) const {
  double sum = 0.0;
  for (const Kind& k : kinds_) sum += k.share * k.rate * speed * std::exp(-0.5 * k.rate * speed * speed);
  return sum;
}

double Maxwell::share_below(double speed) const {
  double sum = 0.0;
  for (const Kind& k : kinds_) sum -= k.share * std::expm1(-0.5 * k.rate * speed * speed);
  return sum;
}

}  // namespace carom
