#pragma once

#include <variant>

#include "physics/scene/id.h"
#include "physics/scene/scene.h"

namespace carom {

// A part of a scene that is no body, for what is chosen and edited by hand.
using PartId = std::variant<Id<Joint>, Id<Spring>, Id<AppliedForce>>;

}  // namespace carom
