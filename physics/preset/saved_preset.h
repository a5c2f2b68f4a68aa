#pragma once

#include "physics/preset/preset.h"
#include "physics/world/simulation.h"

namespace carom {

// The preset that goes on where the run stands now: `document` with the bodies where they are, the clock, what
// has stuck together among the joints, and the state. Driven bodies keep the position that their drive counts
// from. Expectations are about the run from its start, and are left out. Throws SceneError for a run that has
// numbers which no preset can have.
[[nodiscard]] Preset saved_preset(const Preset& document, const Simulation& simulation);

}  // namespace carom
