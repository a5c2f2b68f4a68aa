#pragma once

#include <optional>

#include "physics/collision/contact.h"
#include "physics/step/world.h"

namespace carom {

// The stretch in which two bodies touch: from `low` to `high` along the tangent, from a contact's point.
struct Stretch {
  double low = 0.0;   // m
  double high = 0.0;  // m
};

// That of bodies a < b at the start of the trajectories; none where they touch at one point.
[[nodiscard]] std::optional<Stretch> stretch_of(const World& world, BodyIndex a, BodyIndex b,
                                                const Contact& contact);

// Where the normal impulse of an impact acts, if bodies a < b touch along a stretch: faces that meet flat, or
// several parts of bodies that are welded together. At both ends of the stretch the impulse must stop the
// approach, and it may only push:
//   0 <= λ_i  ⊥  u_i + Σ K_ij λ_j >= 0,  i, j = 1, 2.
// The resultant of λ_1 and λ_2 acts at one point between the ends; an impact there stops the approach of the
// whole stretch, so a body that lands flat does not start to turn. Returns the contact with this point, or as
// it is if they touch at one point or do not approach. At the start of the trajectories.
[[nodiscard]] Contact pressed_contact(World& world, BodyIndex a, BodyIndex b, const Contact& contact);

// Likewise, with the bodies that touch at that point: of several immovable ones that make one face, it need not
// be the one that a contact was found with. Again a < b.
struct PressedPair {
  BodyIndex a;
  BodyIndex b;
  Contact contact;
};
[[nodiscard]] PressedPair pressed_pair(World& world, BodyIndex a, BodyIndex b, const Contact& contact);

}  // namespace carom
