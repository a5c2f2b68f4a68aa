#pragma once

#include <span>
#include <string>

#include "physics/scene/scene.h"

namespace carom {

// The first disc that moves, which new ones are like; null if there is none.
[[nodiscard]] const Body* model_disc(std::span<const Body> bodies);

// The first letter A, B, C... that no body has for its name; after them A-1 and so on.
[[nodiscard]] std::string new_body_name(std::span<const Body> bodies);

// A body for a scene of these bodies, with a short free name (A, B, C...). It has the density and material of
// the model disc, or of the first body with an area that moves. If there is none its mass is round: of 1, 2 and
// 5 times a power of ten the one nearest to the mass of the first body that moves, or 1 kg. A point-like disc
// has the mass of the model, or 1 kg. A wall is fixed.
[[nodiscard]] Body new_body(std::span<const Body> bodies, const Shape& shape, const Vec2& position,
                            double angle = 0.0);

}  // namespace carom
