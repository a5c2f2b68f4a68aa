#pragma once

#include "physics/preset/json_text.h"
#include "physics/scene/scene.h"

// The array /links of a preset file and the links of a scene.
namespace carom {

[[nodiscard]] Link read_link(const Json& json, const std::string& place);

// One element of the array; with `all`, members that hold their default too.
[[nodiscard]] Json link_json(const Link& link, bool all);

}  // namespace carom
