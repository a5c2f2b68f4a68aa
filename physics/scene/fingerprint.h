#pragma once

#include <cstdint>

#include "physics/scene/scene.h"

namespace carom {

// A number that tells scenes apart by all that has a part in their physics, but for the method: bodies (those
// of the generators as such), forces, surfaces, laws and links. Never 0. FNV-1a, 64 bits; the same everywhere.
[[nodiscard]] std::uint64_t fingerprint(const Scene& scene);

// Whether the state of a saved run is one of this scene.
[[nodiscard]] bool state_belongs(const Scene& scene);

}  // namespace carom
