#pragma once

#include "widgets/scene/drawing.h"

namespace carom {

// The normal impulse on each free body of a recent impact: an arrow away from the contact point, which fades.
// Adds the items within `seen` to `out`, and the impacts that are drawn to its marks.
void add_impacts(const DrawingInput& input, const WorldRect& seen, Drawing& out);

}  // namespace carom
