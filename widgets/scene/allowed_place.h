#pragma once

#include <QString>

#include "physics/scene/edit.h"
#include "physics/scene/scene.h"

namespace carom {

// Edits whose places and angles joints allow.
struct AllowedPlace {
  SceneEdits edits;
  QString sentence;  // which joint holds what, and where; empty if all was allowed
  QString refusal;   // why nothing of it is allowed
};

// Typed places and angles are held by joints as those of a drag are: the bodies slide to where the joints let
// them, and bodies that are welded or pinned to them come along. Several bodies are moved as one; what they
// would do to a joint between them is refused.
[[nodiscard]] AllowedPlace allowed_place(const Scene& scene, const SceneEdits& edits);

}  // namespace carom
