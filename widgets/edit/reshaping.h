#pragma once

#include <vector>

#include "physics/scene/edit.h"
#include "physics/scene/scene.h"

namespace carom {

// What has its ends on bodies.
struct Attached {
  std::vector<Joint> joints{};
  std::vector<Spring> springs{};
  std::vector<AppliedForce> applied{};
};
[[nodiscard]] inline Attached attached_in(const Scene& scene) {
  return {scene.joints, scene.forces.springs, scene.forces.applied};
}

// The body with another shape of the same density: a stated mass, and inertia, follow.
[[nodiscard]] Body resized(const Body& body, const Shape& shape);

// m: where a polygon has its centre of mass in the frame of its vertices; the origin if they are no polygon.
[[nodiscard]] Vec2 centre_of(const Polygon& polygon);

// The edits that make a body another one whose shape is written in the same frame. What both shapes have in
// common stays where it is in the scene and moves as before, and so do the ends of joints, springs and forces
// on the body: its centre of mass goes to the new place. What pulls at the centre itself goes with it.
[[nodiscard]] SceneEdits reshaping(const Attached& attached, const Body& body, Body changed);

}  // namespace carom
