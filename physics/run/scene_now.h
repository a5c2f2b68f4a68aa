#pragma once

#include "physics/scene/scene.h"

namespace carom {

class Simulation;

// The scene in which the run's bodies stand where they are now and move as they do, and links say the lengths
// and angles that they hold: a run of it, from the same time on, continues this one. Kinematic bodies keep
// their home, bodies of generators are listed and numbered (kFirstGenerated), welds that the run made are among
// the links.
[[nodiscard]] Scene scene_now(const Simulation& run);

}  // namespace carom
