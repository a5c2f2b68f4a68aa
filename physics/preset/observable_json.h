#pragma once

#include <string>
#include <vector>

#include "physics/preset/value_reader.h"

namespace carom {

// The members "observable" and "bodies" of an object, as many bodies as the observable asks for. Errors against
// a reference are there in plots only.
void read_observable(FieldReader& r, bool in_plot, std::string& name, std::vector<std::string>& bodies);

}  // namespace carom
