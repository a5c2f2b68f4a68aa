#pragma once

#include <span>
#include <vector>

namespace carom {

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
