#pragma once

#include <QString>
#include <span>

#include "physics/scene/scene.h"

namespace carom {

// A number with this many decimal places, a true minus sign and no negative zero.
[[nodiscard]] QString fixed_text(double value, int decimals);
// Decimal places that tell multiples of `step` apart.
[[nodiscard]] int decimals_of(double step);

// Degrees, from -180 (exclusive) to 180.
[[nodiscard]] double degrees(double radians);
[[nodiscard]] double direction(const Vec2& v);
// The unit vector in this direction, without the rounding of cos and sin at right angles.
[[nodiscard]] Vec2 unit_vector(double degrees);

// "x 0.50 m, y 0.20 m", "2.0 m/s at 15°", "45°": what bubbles say. A place has the decimals that a scale in
// px/m can show.
[[nodiscard]] QString place_text(const Vec2& position, double scale);
[[nodiscard]] QString velocity_text(const Vec2& velocity, int decimals, int decimals_of_direction = 0);
[[nodiscard]] QString angle_text(double radians, int decimals = 0);

// "light", or "3 bodies".
[[nodiscard]] QString name_of_bodies(std::span<const Body> bodies);
// "Speed of light 1.00 → 2.00 m/s", or "Direction of light 0° → 15°" at the same speed.
[[nodiscard]] QString name_of_velocity(std::span<const Body> before, std::span<const Body> after);

}  // namespace carom
