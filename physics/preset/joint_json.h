#pragma once

#include "physics/preset/value_reader.h"

// The array /joints of a preset file and the joints of a scene.
namespace carom {

void read_joint(FieldReader& r, Joint& joint);

// One element of the array; with `all`, members that hold their default too.
[[nodiscard]] Json joint_json(const Joint& joint, bool all);

}  // namespace carom
