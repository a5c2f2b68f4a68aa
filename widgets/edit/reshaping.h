#pragma once

#include <string>
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

// Larger by this factor in all directions; a half-plane stays.
[[nodiscard]] Shape scaled(const Shape& shape, double factor);

// What a body keeps that gets another size: its density, and a stated mass and inertia follow; or its mass.
enum class Keeps { kDensity, kMass };
[[nodiscard]] Body resized(const Body& body, const Shape& shape, Keeps keeps = Keeps::kDensity);

// m: where a polygon has its centre of mass in the frame of its vertices; the origin if they are no polygon.
[[nodiscard]] Vec2 centre_of(const Polygon& polygon);

// The edits that keep the ends on a body where they are in the scene, while its centre moves by `moved` (m,
// along its own axes). What pulls at the centre itself goes with it.
[[nodiscard]] SceneEdits kept_ends(const Attached& attached, const std::string& body, const Vec2& moved);

// The edits that make a body another one whose shape is written in the same frame. What both shapes have in
// common stays where it is in the scene and moves as before, and so do the ends on the body (kept_ends()): its
// centre of mass goes to the new place.
[[nodiscard]] SceneEdits reshaping(const Attached& attached, const Body& body, Body changed);

}  // namespace carom
