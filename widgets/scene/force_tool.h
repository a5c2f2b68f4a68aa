#pragma once

#include "widgets/scene/joint_tools.h"

namespace carom {

// The force on the first end's body, with its arrow's tip at the second end.
[[nodiscard]] Joined push(const JointTool& tool, const JointSight& sight, const LinkEnds& ends);
// A tip to the right of the body's centre, for a force of about its weight.
[[nodiscard]] Vec2 usual_tip(const JointSight& sight, const Body& body);
// m of arrow per N, so that 100 px are about the body's weight; without gravity, of 1 m/s².
[[nodiscard]] double usual_metres_per_newton(const Frame& frame, const Body& body, double scale);

}  // namespace carom
