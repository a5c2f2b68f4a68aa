#pragma once

#include "physics/preset/json_text.h"
#include "physics/preset/preset.h"
#include "physics/scene/scene.h"

// The section "state" of a preset file: where a saved run goes on.
namespace carom {

// The clock and, where there is one, the fingerprint. Throws SceneError.
[[nodiscard]] SavedRun read_clock(const Json& json);

// Reads the state itself, of a scene that is valid and that it belongs to (see state_belongs). Throws
// SceneError where it is none of a run of this scene.
void read_state(const Json& json, Preset& preset);

[[nodiscard]] Json state_json(const SavedRun& saved);

}  // namespace carom
