#pragma once

#include "physics/collision/approach.h"
#include "physics/step/world.h"

// Relative motion of two bodies, and its rounding.
namespace carom {

// m/s; a pressed contact that rebounds slower than this is at rest: it would hop by v²/2g = 5e-14 m.
inline constexpr double kRestSpeed = 1e-6;
// Under explicit Euler a pressed contact rests below kRestRebound e/(1 - e) |a| h, where a is the
// acceleration that presses it: its rebounds tend to e |a| h/(1 - e) and would never die out. At most
// kMostRestRebound |a| h, so that nearly elastic bodies still bounce (and show that drift).
inline constexpr double kRestRebound = 1.5;
inline constexpr double kMostRestRebound = 5.0;

// m: the size of the smaller body of the pair; bodies of infinite mass don't count.
[[nodiscard]] double smaller_size(const World& world, int a, int b);
// m: a smaller gap is closed within rounding, in a flight of `duration` s from now on. It depends on the
// motions alone, not on when the epoch began: a saved run that continues decides as the run that was not
// interrupted.
[[nodiscard]] double touch_tolerance(const World& world, int a, int b, double duration = 0.0);
// m/s²: curvature bound of the relative paths of two bodies' points; `of_centres` is that of their centres.
[[nodiscard]] double curvature(const World& world, int a, int b, double of_centres);
// m/s: largest closing speed that forces alone give a resting pair in a step of h s.
[[nodiscard]] double pressed_in(const World& world, int a, int b, double h);
// m/s²: acceleration by which forces and drives press the pair together along the normal, at the start of
// their trajectories; negative if they separate it. `within` in s after the epoch.
[[nodiscard]] double pressing(World& world, int a, int b, const Contact& contact, double within);

}  // namespace carom
