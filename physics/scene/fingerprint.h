#pragma once

#include <cstdint>

#include "physics/scene/scene.h"

namespace carom {

// A hash of all that affects a scene's physics: bodies (those of the generators expanded), forces, surfaces,
// laws, joints, and the start time of the run (s). Never 0. FNV-1a, 64 bits; the same on every platform.
[[nodiscard]] std::uint64_t fingerprint(const Scene& scene, double start_time);

}  // namespace carom
