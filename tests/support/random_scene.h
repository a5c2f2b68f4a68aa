#pragma once

#include <cstdint>

#include "physics/preset/preset.h"
#include "physics/scene/scene.h"

namespace carom::test {

struct RandomScene {
  Preset preset;
  bool overlaps = false;  // some bodies overlap at t = 0
  bool cornered = false;  // some moving bodies may be no discs
};

// A valid scene for each seed: up to twelve discs or bodies of other shapes, fixed boxes at any angle, often
// within four walls, and sometimes a driven box, springs of all kinds, drag, gravity, attraction, applied
// forces, friction, any restitution, and lengths of a millimetre, a metre or a kilometre. Its method is to be
// chosen by the caller.
[[nodiscard]] RandomScene random_scene(std::uint64_t seed);

}  // namespace carom::test
