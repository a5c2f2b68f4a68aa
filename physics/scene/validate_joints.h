#pragma once

#include <vector>

#include "physics/scene/scene.h"
#include "physics/scene/validate.h"

namespace carom {

// Checks the joints of a scene whose bodies, `bodies`, are good: references, numbers, and that at the start the
// ends are where the joints hold them and don't leave there. Throws SceneError with the JSON pointer of the
// first fault.
void check_joints(const Scene& scene, const std::vector<Body>& bodies, const RunBegin& begin);

}  // namespace carom
