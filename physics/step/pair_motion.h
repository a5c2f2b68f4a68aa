#pragma once

#include "physics/collision/approach.h"
#include "physics/contact/contacts.h"
#include "physics/step/world.h"

// Relative motion of two bodies, and its rounding.
namespace carom {

// Relative to the pair's size: points touch together if their gaps differ by less.
inline constexpr double kTogether = 1e-9;

// At the start of the body's trajectory.
[[nodiscard]] Pose pose_at_start(const World& world, BodyIndex body);

// m: the size of the smaller body of the pair; bodies of infinite mass don't count.
[[nodiscard]] double smaller_size(const World& world, BodyIndex a, BodyIndex b);
// m: a smaller gap is closed within rounding, in a flight of `duration` s from now on. It depends on the
// motions alone, not on when the epoch began: a saved run that continues decides as the run that was not
// interrupted.
[[nodiscard]] double touch_tolerance(const World& world, BodyIndex a, BodyIndex b, double duration = 0.0);
// m: no more has a contact opened or closed that forces hold, by their error within a step.
[[nodiscard]] double held_gap(const World& world, BodyIndex a, BodyIndex b);
// m: how far apart two parts of the pair are, on their trajectories `within` s after the epoch.
[[nodiscard]] double gap_in_flight(World& world, BodyIndex a, BodyIndex b, const ShapePair& parts,
                                   double within);
// Whether two parts that approach so go past each other's corner, straight on from the start of their
// trajectories (passes_along).
[[nodiscard]] bool passes_by(const World& world, BodyIndex a, BodyIndex b, const Approach& at);
// m/s²: curvature bound of the relative paths of two bodies' points; `of_centres` is that of their centres.
[[nodiscard]] double curvature(const World& world, BodyIndex a, BodyIndex b, double of_centres);
// m/s²: about what their turning alone adds to the relative acceleration of two bodies at contact i.
[[nodiscard]] double turning_press(const World& world, const Contacts& contacts, int i);
// m/s: largest closing speed that forces alone give a resting pair in a step of h s.
[[nodiscard]] double pressed_in(const World& world, BodyIndex a, BodyIndex b, double h);
// m/s²: acceleration by which forces and drives press the pair together along the normal, at the start of
// their trajectories; negative if they separate it. `within` in s after the epoch.
[[nodiscard]] double pressing(World& world, BodyIndex a, BodyIndex b, const Contact& contact, double within);

}  // namespace carom
