#pragma once

#include <vector>

#include "physics/preset/preset.h"
#include "physics/scene/scene.h"
#include "physics/scene/validate.h"

namespace carom {

// The preset with other numbers in some places: those of a written file, with forces in the order of
// written_places() and with default values included. Expectations are left out. Throws SceneError if a place
// has no number, or if the scene does not allow the number.
[[nodiscard]] Preset variant(const Preset& preset, const std::vector<Setting>& settings);

// For the reader: refuses expectations whose settings or sweep name a place without a number, and converts
// the places of forces from those of the file, `places`, to those of a file that Carom writes.
void resolve_places(Preset& preset, const ForcePlaces& places);

}  // namespace carom
