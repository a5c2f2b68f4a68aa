#pragma once

#include "physics/collision/contact.h"
#include "physics/dynamics/trajectories.h"
#include "physics/impact/impact_law.h"
#include "physics/model/geometry.h"

namespace carom {

// The impact of bodies a < b at the start of their trajectories; at least one has joints. Joints transmit the
// impulse at once, so the contact responds with the combined mass of the joined bodies. Changes the motions
// at the start of all bodies that take part. Body b is hit along the contact's normal. The impulse is zero if
// the bodies do not approach.
[[nodiscard]] Impact resolve_jointed_impact(Trajectories& trajectories, const MassProperties& mass, BodyIndex a,
                                            BodyIndex b, const Contact& contact, const SurfaceLaw& material,
                                            ImpactLawId law);

}  // namespace carom
