#pragma once

#include "physics/preset/value_reader.h"
#include "physics/scene/scene.h"
#include "physics/scene/validate.h"

// Converts between the array /forces of a preset file and the forces of a scene.
namespace carom {

// Reads the force at `at`, which is /forces/`index`, and records its place.
void read_force(FieldReader& r, const std::string& at, int index, Forces& forces, ForcePlaces& places);

// The array, in the order of written_places(); with `all` also members with their default value.
[[nodiscard]] Json forces_json(const Forces& forces, bool all);

}  // namespace carom
