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

}  // namespace carom
