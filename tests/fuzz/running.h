#pragma once

#include <optional>
#include <random>
#include <string_view>

#include "physics/preset/preset.h"
#include "physics/run/simulation.h"

// Common parts of the targets that run scenes.
namespace carom::fuzz {

inline constexpr int kMostSteps = 40;
inline constexpr double kMostTime = 0.2;  // s

// Draws that depend on every byte of an input, so that each change of it also changes what is done with it.
class Draws {
 public:
  explicit Draws(std::string_view bytes);
  int below(int count) { return static_cast<int>(random_() % static_cast<std::uint64_t>(count)); }
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(random_() >> 11) * 0x1p-53);
  }

 private:
  std::mt19937_64 random_;
};

// The scene of these bytes, if they are a preset of at most 20 bodies.
[[nodiscard]] std::optional<Preset> small_scene(std::string_view bytes);

// A method that the scene allows, with the scene's own step and tolerance.
[[nodiscard]] Method draw_method(const Preset& preset, Draws& draws);

// Steps once and checks the laws of every step; throws std::logic_error if one is broken.
void checked_step(Simulation& run);

}  // namespace carom::fuzz
