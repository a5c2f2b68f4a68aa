#pragma once

#include "physics/collision/contact.h"
#include "physics/dynamics/trajectories.h"
#include "physics/impact/impact_law.h"
#include "physics/model/geometry.h"

namespace carom {

// The impact of two at_start bodies a < b of which joints hold at least one: joints share the impulse at once,
// so the contact answers with the mass that the jointed bodies have together. Changes the at_start motions of
// all that share it. Body b is hit along the contact's normal. The impulse is zero if the bodies don't
// approach.
[[nodiscard]] Impact resolve_jointed_impact(Trajectories& trajectories, const MassProperties& mass, int a,
                                            int b, const Contact& contact, const Material& material,
                                            ImpactLawId law);

}  // namespace carom
