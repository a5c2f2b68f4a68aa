#pragma once

#include <optional>
#include <random>
#include <string_view>

#include "physics/preset/preset.h"
#include "physics/world/simulation.h"

// What the targets that run scenes share.
namespace carom::fuzz {

inline constexpr int kMostSteps = 40;
inline constexpr double kMostTime = 0.2;  // s

// Draws that hang on every byte of an input, so that each change of it also changes what is done with it.
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

// The scene that the bytes are, if they are one of no more than 20 bodies.
[[nodiscard]] std::optional<Preset> small_scene(std::string_view bytes);

// A method that the scene allows, with the scene's own step and tolerance.
[[nodiscard]] Method draw_method(const Preset& preset, Draws& draws);

// One step, and what holds after every one; throws std::logic_error where it doesn't.
void checked_step(Simulation& run);

}  // namespace carom::fuzz
