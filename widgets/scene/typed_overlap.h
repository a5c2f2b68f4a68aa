#pragma once

#include <QString>

#include "physics/scene/edit.h"
#include "physics/scene/scene.h"

namespace carom {

// What these edits make overlap, or overlap more deeply, the deepest pair: "light and heavy overlap by 3.2 cm:
// ...". Empty if nothing, beyond what written numbers are rounded by.
[[nodiscard]] QString typed_overlap(const Scene& scene, const SceneEdits& edits);

}  // namespace carom
