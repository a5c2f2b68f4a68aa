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
[[nodiscard]] double radians(double degrees);  // of any angle
[[nodiscard]] double direction(const Vec2& v);
// The unit vector in this direction, without the rounding of cos and sin at right angles.
[[nodiscard]] Vec2 unit_vector(double degrees);

// "x 0.50 m, y 0.20 m", "2.0 m/s at 15°", "45°": what bubbles say. A place has the decimals that a scale in
// px/m can show.
[[nodiscard]] QString place_text(const Vec2& position, double scale);
[[nodiscard]] QString velocity_text(const Vec2& velocity, int decimals, int decimals_of_direction = 0);
[[nodiscard]] QString angle_text(double radians, int decimals = 0);

// "m = 4 kg · was 10 cm": a detail, which may be empty, with what a value was.
[[nodiscard]] QString with_former(const QString& detail, const QString& value);

// "2.00 rad/s" and "0.32 turns a second".
[[nodiscard]] QString spin_text(double spin);
[[nodiscard]] QString turns_text(double spin);

// "Rod 1", "a rod" without a name, "a force on A".
[[nodiscard]] QString name_of_part(const Joint& joint);
[[nodiscard]] QString name_of_part(const Spring& spring);
[[nodiscard]] QString name_of_part(const AppliedForce& force);
// "light", or "3 bodies".
[[nodiscard]] QString name_of_bodies(std::span<const Body> bodies);
// "Speed of light 1.00 → 2.00 m/s", or "Direction of light 0° → 15°" at the same speed.
[[nodiscard]] QString name_of_velocity(std::span<const Body> before, std::span<const Body> after);

// "Spin of A 0.00 → 2.00 rad/s"
[[nodiscard]] QString name_of_spin(const Body& before, const Body& after);
// "Force on A 1.00 → 2.00 N", or "Direction of the force on A 0° → 15°".
[[nodiscard]] QString name_of_force(const AppliedForce& before, const AppliedForce& after);

}  // namespace carom
