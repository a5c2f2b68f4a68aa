#pragma once

#include <cstdint>
#include <numbers>
#include <random>

#include "physics/math/vectors.h"

namespace carom::test {

// Draws that are the same with every standard library.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : random_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53;
  }
  bool chance(double probability) { return between(0.0, 1.0) < probability; }
  int up_to(int most) { return static_cast<int>(random_() % static_cast<std::uint64_t>(most + 1)); }
  Vec2 in_square(double half) {
    const double x = between(-half, half);
    return {x, between(-half, half)};
  }
  double angle() { return between(0.0, 2.0 * std::numbers::pi); }
  Vec2 direction() { return turned_by(angle(), Vec2::UnitX()); }

 private:
  std::mt19937_64 random_;
};

}  // namespace carom::test
