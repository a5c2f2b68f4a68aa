#pragma once

#include <span>
#include <string>
#include <vector>

#include "physics/scene/edit.h"
#include "physics/scene/scene.h"

namespace carom {

// Changes velocities and spins of the moving ones of `bodies` such that the rods, pins and welds of the scene
// hold that have an end on one of them; other bodies keep what they have. It is the least change in the norm
// v·M v, which is that of a plastic impact. Returns the joints (indices) that did not hold before; none:
// nothing has changed.
std::vector<std::size_t> hold_joined_velocities(const Scene& scene, std::span<Body> bodies);

// The bodies of the scene that move otherwise once this joint of it holds them, and those joined to them: so
// that momentum stays where nothing is held by the plane or a fixed body. None of a string, which may part its
// ends.
[[nodiscard]] std::vector<Body> as_joined(const Scene& scene, const Joint& joint);

// These edits, and those of the bodies that joints among them, at other places than before, hold.
[[nodiscard]] SceneEdits with_joined(const Scene& scene, SceneEdits edits);

}  // namespace carom
