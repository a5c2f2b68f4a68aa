#pragma once

#include "physics/preset/preset.h"
#include "physics/scene/validate.h"

namespace carom {

// Checks the scene (physics/scene/validate.h), whether the methods can run it, expectations, plots and the
// view. Throws SceneError with the JSON pointer of the first fault; `places` are those of the forces in its
// file.
void validate(const Preset& preset, const ForcePlaces& places);
void validate(const Preset& preset);

}  // namespace carom
