#pragma once

#include "widgets/scene/drawing.h"

namespace carom {

// The moving bodies of the other runs as outlines in their colours, each with a line to the same body in the
// run drawn in full. With few bodies the line's length is labelled. Adds to `out` the items within `seen`.
void add_other_runs(const DrawingInput& input, const WorldRect& seen, Drawing& out);

}  // namespace carom
