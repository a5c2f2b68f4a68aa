#pragma once

#include "physics/preset/preset.h"
#include "physics/scene/edit.h"

// Parts that edits add to a start: their ids, and surfaces that the start may have already.
namespace carom {

// Gives every part that has none an id, bodies that come in later too.
void give_ids(Preset& preset);

// Gives new parts their ids, so that the start and the runs know them by the same. A surface that a body gets,
// while the start has another one of its name from a later moment, gets a name of its own.
void number_new_parts(const Scene& start, SceneEdits& edits);

// What the start has already is replaced there, not added.
[[nodiscard]] SceneEdits with_known_parts(const Scene& start, SceneEdits edits);

}  // namespace carom
