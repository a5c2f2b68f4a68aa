#pragma once

#include <optional>

#include "physics/collision/contact.h"
#include "physics/impact/impact_law.h"
#include "physics/step/world.h"

namespace carom {

// An impact of faces that meet flat.
struct FaceImpact {
  Vec2 point = Vec2::Zero();  // m, where the impulse acts
  // None where they turn about one end of the stretch: an impact at `point`.
  std::optional<Impact> impact;
};

// With friction, the point where the normal impulse of bodies a < b acts hangs on that of the tangential one:
// while both ends of the stretch press, neither turns about the other, and u_t slides alike all along it. With
// x from the contact's point along the tangent, and the ends x_1, x_2,
//   u_n' = -e min(u_n, 0) at both ends,   u_t' = 0 or j_t = -+ μ_k j_n against u_t',   x_1 <= x <= x_2.
// Beyond an end, the impact is there. None without friction, with tangential restitution, where the bodies
// touch at one point, or where this law has no solution or gains energy. At the start of the trajectories.
[[nodiscard]] std::optional<FaceImpact> face_impact(World& world, BodyIndex a, BodyIndex b,
                                                    const Contact& contact, const SurfaceLaw& material);
// Gives the bodies the impulse of an impact at this contact. False if a string would have to push: it is slack
// from then on, and the impact another one.
[[nodiscard]] bool apply_face_impulse(World& world, BodyIndex a, BodyIndex b, const Contact& contact,
                                      const Impact& impact);

}  // namespace carom
