#pragma once

#include <string>
#include <vector>

#include "physics/preset/value_reader.h"

namespace carom {

// Reads the members "observable" and "bodies" of an object; the observable decides the number of bodies.
// Errors against a reference exist in plots only.
void read_observable(FieldReader& r, bool in_plot, std::string& name, std::vector<std::string>& bodies);

}  // namespace carom
