#pragma once

#include <vector>

#include "physics/scene/scene.h"
#include "physics/scene/validate.h"

namespace carom {

// Checks the joints of a scene: references, numbers, and that the positions and velocities of their ends fit
// at the start. `bodies` are all bodies of the scene, already valid. Throws SceneError with the JSON pointer
// of the first fault.
void check_joints(const Scene& scene, const std::vector<Body>& bodies, const RunBegin& begin);

}  // namespace carom
