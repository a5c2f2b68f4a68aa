#pragma once

#include "physics/preset/value_reader.h"
#include "physics/scene/method.h"
#include "physics/scene/scene.h"

namespace carom {

void read_method(FieldReader& r, Method& m);
// With the tolerance also where no integrator asks for it, if `all` is wanted.
[[nodiscard]] Json method_json(const Method& method, bool all);

}  // namespace carom
