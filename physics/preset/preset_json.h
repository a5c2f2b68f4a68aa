#pragma once

#include "physics/preset/json_text.h"
#include "physics/preset/preset.h"
#include "physics/scene/scene.h"

namespace carom {

// A preset file as a tree of JSON values. With `all`, members with their default value are included, so that
// every number of a scene has its place.
[[nodiscard]] Json preset_json(const Preset& preset, bool all);

// The preset that the tree states, validated. Throws SceneError.
[[nodiscard]] Preset preset_of(const Json& json);

// The JSON Schema (draft 7) of preset files, made by the functions that read them. What it cannot say is listed
// in kRules (physics/scene/validate.h): every other fault of a file that the reader refuses, the schema refuses
// as well, and the other way round.
[[nodiscard]] Json preset_schema();

}  // namespace carom
