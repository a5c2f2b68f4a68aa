#pragma once

#include "physics/preset/value_reader.h"

// The array /links of a preset file and the links of a scene.
namespace carom {

void read_link(FieldReader& r, Link& link);

// One element of the array; with `all`, members that hold their default too.
[[nodiscard]] Json link_json(const Link& link, bool all);

}  // namespace carom
