#pragma once

#include "widgets/scene/drawing.h"

namespace carom {

// The moving bodies of the other runs as outlines in their colours, each with a line to where it is in the run
// that is drawn whole; of a few bodies the line has its length beside it. Adds to `out` what `seen` of the
// world shows.
void add_other_runs(const DrawingInput& input, const WorldRect& seen, Drawing& out);

}  // namespace carom
