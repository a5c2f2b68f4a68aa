#pragma once

#include "widgets/scene/drawing.h"

namespace carom {

// A rod is a bar between its two points, a string a thin line that sags while it is slack, a pin a small ring,
// a weld a dot. A point of the plane has a larger dot, a pin in it a dot in its ring. Adds to `out` the items
// within `seen`.
void add_joints(const DrawingInput& input, const WorldRect& seen, Drawing& out);

}  // namespace carom
