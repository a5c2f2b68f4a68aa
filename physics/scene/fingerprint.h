#pragma once

#include <cstdint>

#include "physics/scene/scene.h"

namespace carom {

// A number that tells scenes apart by all that has a part in their physics: bodies (those of the generators as
// such), forces, surfaces, laws and joints, and when the run starts (s). Never 0. FNV-1a, 64 bits; the same
// everywhere, and in every later version, so that saved runs stay those of their scenes.
[[nodiscard]] std::uint64_t fingerprint(const Scene& scene, double start_time);

}  // namespace carom
