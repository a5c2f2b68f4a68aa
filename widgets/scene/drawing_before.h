#pragma once

#include "widgets/scene/drawing.h"

namespace carom {

// The moving bodies of the run before as pale outlines. Adds to `out` the items within `seen`; they are under
// bodies that are added later.
void add_run_before(const DrawingInput& input, const WorldRect& seen, Drawing& out);

}  // namespace carom
