#pragma once

#include <vector>

#include "physics/preset/preset.h"
#include "physics/scene/scene.h"
#include "physics/scene/validate.h"

namespace carom {

// The scene of a preset file with other numbers in some places. Forces stand in the order of written_places(),
// and members that hold their default stand there too. The expectations are left out. Throws SceneError if a
// place holds no number, or if the scene does not allow the number.
[[nodiscard]] Preset variant(const Preset& preset, const std::vector<Setting>& settings);

// For the reader: refuses expectations whose settings or sweep name a place that holds no number, and turns the
// places of forces from those of the file, `places`, to those of a file that Carom writes.
void resolve_places(Preset& preset, const ForcePlaces& places);

}  // namespace carom
