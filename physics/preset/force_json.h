#pragma once

#include "physics/preset/value_reader.h"
#include "physics/scene/scene.h"
#include "physics/scene/validate.h"

// The array /forces of a preset file and the forces of a scene.
namespace carom {

// Reads the force that stands at `at`, /forces/`index`, and notes its place.
void read_force(FieldReader& r, const std::string& at, int index, Forces& forces, ForcePlaces& places);

// The array, in the order of written_places(); with `all`, members that hold their default too.
[[nodiscard]] Json forces_json(const Forces& forces, bool all);

}  // namespace carom
