#pragma once

#include "physics/preset/value_reader.h"

// Converts between the array /links of a preset file and the joints of a scene.
namespace carom {

void read_joint(FieldReader& r, Joint& joint);

// One element of the array; with `all` also members with their default value.
[[nodiscard]] Json joint_json(const Joint& joint, bool all);

}  // namespace carom
