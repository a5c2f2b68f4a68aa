#pragma once

#include "widgets/drawing.h"

namespace carom {

// A rod is a bar between its two points, a string a thin line that sags while it is slack, a pin a small ring.
// A point of the plane has a dot, in the ring of a pin too. Adds to `out` what `seen` of the world shows.
void add_links(const DrawingInput& input, const WorldRect& seen, Drawing& out);

}  // namespace carom
