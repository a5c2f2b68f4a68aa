#pragma once

#include "widgets/scene/drawing.h"

namespace carom {

// The picked impact: the velocities of its bodies before it on one side of the bodies, after it on the other,
// along a line through the contact, or through a body at a wall; and at the contact the impulse on each, the
// loss and the measured e. Impacts of one moment that share no body have a line each.
void add_jump(const DrawingInput& input, Drawing& out);

// The bodies whose velocities it shows, beside their names: those that move freely, of many the first few.
[[nodiscard]] std::vector<BodyIndex> bodies_of_jump(const DrawingInput& input);

}  // namespace carom
