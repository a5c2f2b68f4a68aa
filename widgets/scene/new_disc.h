#pragma once

#include <span>

#include "physics/scene/scene.h"

namespace carom {

// The first disc that moves, which new ones are like; null if there is none.
[[nodiscard]] const Body* model_disc(std::span<const Body> bodies);

// A disc for a scene of these bodies, with a free name, and with the density and material of the model
// disc; 1 kg/m² if there is none.
[[nodiscard]] Body new_disc(std::span<const Body> bodies, const Vec2& position, double radius);

}  // namespace carom
