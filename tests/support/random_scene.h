#pragma once

#include <cstdint>

#include "physics/preset/preset.h"
#include "physics/scene/scene.h"

namespace carom::test {

struct RandomScene {
  Preset preset;
  bool overlaps = false;  // some bodies penetrate at t = 0
  bool cornered = false;  // some moving bodies may not be discs
};

// A valid scene for each seed: up to twelve discs or bodies of other shapes, static boxes at any angle, often
// within four walls, and sometimes a kinematic box, springs of all kinds, drag, gravity, attraction, applied
// forces, friction, any restitution, and lengths of a millimetre, a metre or a kilometre. The caller chooses
// the method.
[[nodiscard]] RandomScene random_scene(std::uint64_t seed);

// Likewise, and bodies with corners are compounds of two or three shapes, or concave polygons.
[[nodiscard]] RandomScene random_scene_of_compounds(std::uint64_t seed);

}  // namespace carom::test
