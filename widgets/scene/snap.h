#pragma once

#include <optional>
#include <span>
#include <string>

#include "physics/scene/scene.h"

namespace carom {

// px: a snap never holds the mouse farther than this.
inline constexpr double kSnapReach = 8.0;

// To what velocities and directions snap.
inline constexpr double kSpeedStep = 0.1;       // m/s
inline constexpr double kDirectionStep = 15.0;  // degrees

// The nearest multiple of `step` > 0; one of a decimal step is the double nearest to its decimal.
[[nodiscard]] double snapped(double value, double step);
// The nearest multiple of `spacing` > 0 if it is within `reach`, else the value itself.
[[nodiscard]] double on_grid(double value, double spacing, double reach);
// `wanted`, or the nearest 1-2-5 step that a mouse can aim at when one unit is `pixels` px long.
[[nodiscard]] double step_for_mouse(double wanted, double pixels);

// m, along the axes of the shape: its corner that is nearest to a place within `reach`, else such a point of
// its rim; nothing if none is that near.
[[nodiscard]] std::optional<Vec2> on_rim(const Shape& shape, const Vec2& place, double reach);

// A place moved along each axis to the nearest level or upright edge of a body within `reach` m of it; along an
// axis without one it is `otherwise`.
[[nodiscard]] Vec2 on_level_edges(const Vec2& place, const Vec2& otherwise, std::span<const Body> bodies,
                                  double reach);

// A place of a body at which it touches another one.
struct Touch {
  Vec2 position;  // m
  std::string with;
};
// The nearest such place within `reach` m of where the body stands, on the line through it along `axis` if
// there is one.
[[nodiscard]] std::optional<Touch> touching_place(const Body& body, std::span<const Body> others, double reach,
                                                  const std::optional<Vec2>& axis);

}  // namespace carom
