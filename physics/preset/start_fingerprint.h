#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "physics/preset/preset.h"

namespace carom {

// A number that tells apart what runs start from: the scene at its clock (physics/scene/fingerprint.h), then
// the time and the body of each edit that adds one. A start without such edits has the number of its scene.
// Methods, the inner state of a saved run and all that only people read have no part in it. Never 0.
[[nodiscard]] std::uint64_t fingerprint_of_start(const Scene& scene, const std::optional<SavedRun>& saved,
                                                 const std::vector<RunEdit>& late);
[[nodiscard]] std::uint64_t fingerprint_of_start(const Preset& preset);

// Of the bodies that an edit adds, and their time; 0: it adds none.
[[nodiscard]] std::uint64_t fingerprint_of_late_bodies(const RunEdit& edit);

}  // namespace carom
