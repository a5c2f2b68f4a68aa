#include "physics/observe/histogram.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace carom {

double Histogram::quantile(double share) const {
  const double wanted = share * static_cast<double>(total);
  std::int64_t below = 0;
  for (std::size_t bin = 0; bin < counts.size(); ++bin) {
    below += counts[bin];
    if (static_cast<double>(below) >= wanted) return from(bin + 1);
  }
  return from(counts.size());
}

Histogram histogram_of(std::span<const double> values, double width) {
  Histogram h;
  double largest = -1.0;
  for (const double value : values) {
    if (std::isfinite(value)) largest = std::max(largest, value);
  }
  h.width = width;
  while (largest >= kMostBins * h.width) h.width *= 2.0;
  if (largest >= 0.0) h.counts.resize(static_cast<std::size_t>(largest / h.width) + 1);
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    ++h.counts[std::min(static_cast<std::size_t>(value / h.width), h.counts.size() - 1)];
    ++h.total;
  }
  return h;
}

double bin_width(std::vector<double> values) {
  std::erase_if(values, [](double v) { return !std::isfinite(v); });
  if (values.size() < 2) return 0.0;
  const auto n = static_cast<double>(values.size());
  const auto quarter = [&](std::size_t k) {
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(k * (values.size() - 1) / 4);
    std::nth_element(values.begin(), at, values.end());
    return *at;
  };
  const double low = quarter(1);
  const double spread = quarter(3) - low;
  if (spread > 0.0) return 2.0 * spread / std::cbrt(n);
  double mean = 0.0;
  for (const double v : values) mean += v / n;
  double variance = 0.0;
  for (const double v : values) variance += (v - mean) * (v - mean) / (n - 1.0);
  return 3.49 * std::sqrt(variance) / std::cbrt(n);
}

double steady_bin_width(double current, double wanted) {
  constexpr double kSteady = 2.5;
  constexpr double kLeast = 1e-300;
  if (!(wanted > kLeast) || !std::isfinite(wanted)) return current > 0.0 ? current : 1.0;
  if (current > 0.0 && current <= kSteady * wanted && wanted <= kSteady * current) return current;
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  const double mantissa = wanted / power;
  // The nearest of them by ratio.
  return power * (mantissa < std::sqrt(2.0)    ? 1.0
                  : mantissa < std::sqrt(10.0) ? 2.0
                  : mantissa < std::sqrt(50.0) ? 5.0
                                               : 10.0);
}

Maxwell::Maxwell(std::span<const double> masses, std::span<const double> speeds) {
  const std::size_t n = std::min(masses.size(), speeds.size());
  for (std::size_t i = 0; i < n; ++i) kt_ += 0.5 * masses[i] * speeds[i] * speeds[i] / static_cast<double>(n);
  if (!(kt_ > 0.0)) return;
  // Masses within one per cent count as one, so that many different masses give a short sum.
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
