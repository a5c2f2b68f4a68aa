#pragma once

#include <string>

#include "physics/preset/json_text.h"
#include "physics/scene/scene.h"

namespace carom {

[[nodiscard]] Method read_method(const Json& json, const std::string& place);
// Without the usual tolerance where no integrator asks for it, unless `all` is wanted.
[[nodiscard]] Json method_json(const Method& method, bool all);

}  // namespace carom
