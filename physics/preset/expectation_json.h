#pragma once

#include <string>

#include "physics/preset/preset.h"
#include "physics/preset/value_reader.h"
#include "physics/scene/scene.h"

// Converts between an element of the array /expect of a preset file and an expectation.
namespace carom {

void read_expectation(FieldReader& r, Expectation& expectation);
[[nodiscard]] Json expectation_json(const Expectation& expectation);

}  // namespace carom
