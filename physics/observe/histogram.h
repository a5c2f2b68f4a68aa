#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace carom {

// How many of some values, none below zero, fall into each bin: bin k is [k width, (k + 1) width).
struct Histogram {
  double width = 1.0;  // in the values' unit, > 0
  std::vector<std::int64_t> counts;
  std::int64_t total = 0;

  [[nodiscard]] double from(std::size_t bin) const { return width * static_cast<double>(bin); }
  // Share of the values over the bin's width: its integral is 1.
  [[nodiscard]] double density(std::size_t bin) const {
    return static_cast<double>(counts[bin]) / (static_cast<double>(total) * width);
  }
  // The end of the first bin up to which the values' share is at least this.
  [[nodiscard]] double quantile(double share) const;
};

inline constexpr int kMostBins = 200;

// Bins of that width, or of so much more that there are at most kMostBins. Values that are not finite don't
// count.
[[nodiscard]] Histogram histogram_of(std::span<const double> values, double width);

// 2 IQR n^(-1/3): D. Freedman and P. Diaconis, Zeitschrift für Wahrscheinlichkeitstheorie und verwandte Gebiete
// 57 (1981) 453. Where half of the values are one and the same, 3.49 σ n^(-1/3) instead: D. W. Scott,
// Biometrika 66 (1979) 605. 0 where all are.
[[nodiscard]] double bin_width(std::vector<double> values);

// A round width (1, 2 or 5 times a power of ten) near the wanted one; `current` as long as it is within a
// factor of 2.5 of that, so that bins stand still while the values go on. 1 for nothing.
[[nodiscard]] double steady_bin_width(double current, double wanted);

// The speeds of a gas in equilibrium, in the plane: f(v) = (m v/kT) exp(-m v²/2kT), where kT is the mean
// kinetic energy of the translation, ½kT for each of its two directions. Of bodies of different masses the mean
// of theirs at one kT.
class Maxwell {
 public:
  Maxwell() = default;  // of nothing
  // The masses (kg) of bodies with these speeds (m/s), as many of each.
  Maxwell(std::span<const double> masses, std::span<const double> speeds);

  [[nodiscard]] double thermal_energy() const { return kt_; }  // kT in J; 0: nothing moves, and there is no law
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
