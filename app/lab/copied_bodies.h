#pragma once

#include <string>
#include <vector>

#include "physics/preset/preset.h"
#include "physics/scene/edit.h"

// Copies of bodies: a preset of its own in between, which is what the clipboard holds.
namespace carom {

// A preset of these bodies as they stand in a scene, with the joints and springs among them or to points of the
// plane, the forces on them, and their surfaces.
[[nodiscard]] Preset copied_bodies(const Scene& scene, const std::vector<std::string>& names);

// The edits that put a preset's bodies, joints, springs, forces on bodies and unknown surfaces into a scene,
// moved by `shift` (m).
struct Paste {
  SceneEdits edits;
  std::vector<std::string> names;  // of the new bodies
};
[[nodiscard]] Paste paste_into(const Scene& scene, const Preset& from, const Vec2& shift);

// m: the smallest upright box about all bodies but half-planes; empty: lower > upper.
struct Extent {
  Vec2 lower;
  Vec2 upper;
};
[[nodiscard]] Extent extent_of(const std::vector<Body>& bodies);

// m: where a copy of these bodies stands beside them: to the right, above, to the left or below, the first of
// these places that is in sight and free, else the first in sight, else to the right. The way there is 1, 2 or
// 5 times a power of ten, so that typed places stay short numbers.
[[nodiscard]] Vec2 shift_beside(const std::vector<Body>& copied, const std::vector<Body>& others,
                                const Extent& seen);

}  // namespace carom
