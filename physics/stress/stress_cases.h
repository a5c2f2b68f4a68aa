#pragma once

#include <span>

#include "physics/stress/stress.h"

// The cases of the suite by theme, one file each.
namespace carom::stress {

[[nodiscard]] std::span<const StressCase> stacks();
[[nodiscard]] std::span<const StressCase> piles();
[[nodiscard]] std::span<const StressCase> friction();
[[nodiscard]] std::span<const StressCase> impacts();
[[nodiscard]] std::span<const StressCase> rods();
[[nodiscard]] std::span<const StressCase> integrators();

}  // namespace carom::stress
