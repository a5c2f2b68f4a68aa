#pragma once

#include "widgets/scene/joint_tools.h"

namespace carom {

// The first end's body, driven with the velocity whose arrow's tip is at the second end; with Shift to and fro
// that far.
[[nodiscard]] Joined drive(const JointTool& tool, const JointSight& sight, const LinkEnds& ends);

}  // namespace carom
