#pragma once

#include <span>

#include "physics/scene/scene.h"

namespace carom {

// A disc for a scene of these bodies, with a free name, and with the density and material of the first disc
// that moves; 1 kg/m² if there is none.
[[nodiscard]] Body new_disc(std::span<const Body> bodies, const Vec2& position, double radius);

}  // namespace carom
