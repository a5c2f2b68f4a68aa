#pragma once

#include <string>

#include "physics/preset/json_text.h"
#include "physics/scene/scene.h"

// One element of the array /expect of a preset file and an expectation of a scene.
namespace carom {

[[nodiscard]] Expectation read_expectation(const Json& json, const std::string& place);
[[nodiscard]] Json expectation_json(const Expectation& expectation);

}  // namespace carom
