#pragma once

#include "physics/preset/json_text.h"
#include "physics/preset/preset.h"
#include "physics/scene/scene.h"

namespace carom {

// A preset file as a tree of JSON values. With `all`, members that hold their default stand in it too, so that
// every number that a scene has can be found at its place.
[[nodiscard]] Json preset_json(const Preset& preset, bool all);

// The scene that the tree states, validated. Throws SceneError.
[[nodiscard]] Preset preset_of(const Json& json);

}  // namespace carom
