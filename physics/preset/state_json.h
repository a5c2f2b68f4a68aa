#pragma once

#include "physics/preset/json_text.h"
#include "physics/preset/preset.h"
#include "physics/scene/scene.h"

// The section "state" of a preset file, from which a saved run continues.
namespace carom {

// Reads the clock and, if there is one, the fingerprint. Throws SceneError.
[[nodiscard]] SavedRun read_clock(const Json& json);

// Reads the state itself. The scene must be valid, and the state must belong to it (see state_belongs).
// Throws SceneError if it is not the state of a run of this scene.
void read_state(const Json& json, Preset& preset);

[[nodiscard]] Json state_json(const SavedRun& saved);

}  // namespace carom
