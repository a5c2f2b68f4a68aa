#pragma once

#include "physics/collision/contact.h"
#include "physics/step/world.h"

namespace carom {

// Where impacts are not located in time, bodies that stick meet before they touch, or after. Moves them until
// they do, along the normal and by inverse mass, each with what it is joined to; enters the change of potential
// energy as overlap correction. The contact where they touch. At the start of the trajectories.
[[nodiscard]] Contact moved_together(World& world, BodyIndex a, BodyIndex b, const Contact& apart);

}  // namespace carom
