#pragma once

#include "physics/preset/value_reader.h"
#include "physics/scene/method.h"
#include "physics/scene/scene.h"

namespace carom {

void read_method(FieldReader& r, Method& m);
// With `all`, the tolerance is included even if the integrator does not use it.
[[nodiscard]] Json method_json(const Method& method, bool all);

}  // namespace carom
