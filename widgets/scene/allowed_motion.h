#pragma once

#include <QString>

#include "physics/scene/edit.h"
#include "physics/scene/scene.h"

namespace carom {

// Edits whose velocities and spins joints allow.
struct AllowedMotion {
  SceneEdits edits;
  QString name;      // of the edits in the undo stack, and
  QString sentence;  // which joint took what: both empty if all was allowed
};

// Typed velocities and spins are held by joints as those of a drag are: of each body whose motion the edits
// change, what its joints don't allow is taken out, and bodies that are welded or pinned to it come along. A
// joint between two changed bodies takes from both, as a plastic impact does. Where nothing of a change is left
// it stays as it was asked for, to be refused.
[[nodiscard]] AllowedMotion allowed_motion(const Scene& scene, const SceneEdits& edits);

}  // namespace carom
