#pragma once

#include "physics/preset/preset.h"
#include "physics/world/simulation.h"

namespace carom {

// The preset that continues a run from now: `document` with the bodies as they are, the clock, the state, and
// joints for what has stuck together. Kinematic bodies keep the position that their drive starts from.
// Expectations are about the run from its start and are left out. Throws SceneError for a lost run, and for
// numbers that no preset can have.
[[nodiscard]] Preset saved_preset(const Preset& document, const Simulation& simulation);

}  // namespace carom
