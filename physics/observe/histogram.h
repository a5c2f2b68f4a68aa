#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace carom {

// Counts of nonnegative values by bin: bin k is [k width, (k + 1) width).
struct Histogram {
  double width = 1.0;  // in the values' unit, > 0
  std::vector<std::int64_t> counts;
  std::int64_t total = 0;

  [[nodiscard]] double from(std::size_t bin) const { return width * static_cast<double>(bin); }
  // Share of the values over the bin's width: the integral is 1.
  [[nodiscard]] double density(std::size_t bin) const {
    return static_cast<double>(counts[bin]) / (static_cast<double>(total) * width);
  }
  // The end of the first bin at which the cumulative share reaches `share`.
  [[nodiscard]] double quantile(double share) const;
};

inline constexpr int kMostBins = 200;

// Uses bins of that width, or wider ones so that there are at most kMostBins. Non-finite values don't count.
[[nodiscard]] Histogram histogram_of(std::span<const double> values, double width);

// 2 IQR n^(-1/3): D. Freedman and P. Diaconis, Zeitschrift für Wahrscheinlichkeitstheorie und verwandte
// Gebiete 57 (1981) 453. If half of the values are equal, 3.49 σ n^(-1/3): D. W. Scott, Biometrika 66 (1979)
// 605. 0 if all are equal.
[[nodiscard]] double bin_width(std::vector<double> values);

// A round width (1, 2 or 5 times a power of ten) near the wanted one. It stays at `current` while that is
// within a factor of 2.5, so that bins don't move as values are added. 1 if there are no values.
[[nodiscard]] double steady_bin_width(double current, double wanted);

// Speed distribution of a gas in equilibrium, in the plane: f(v) = (m v/kT) exp(-m v²/2kT), where kT is the
// mean translational kinetic energy, ½kT per direction. For bodies of different masses it is the mean of
// their distributions at the same kT.
class Maxwell {
 public:
  Maxwell() = default;  // of no bodies
  // Masses (kg) and speeds (m/s) of the same bodies.
  Maxwell(std::span<const double> masses, std::span<const double> speeds);

  [[nodiscard]] double thermal_energy() const { return kt_; }  // kT in J; 0: nothing moves, no distribution
  [[nodiscard]] double density(double speed) const;            // s/m
  [[nodiscard]] double share_below(double speed) const;        // of all bodies

 private:
  struct Kind {
    double rate = 0.0;   // m/kT in s²/m²
    double share = 0.0;  // of the bodies
  };
  double kt_ = 0.0;
  std::vector<Kind> kinds_;
};

}  // namespace carom
