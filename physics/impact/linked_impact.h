#pragma once

#include "physics/collision/contact.h"
#include "physics/dynamics/tracks.h"
#include "physics/impact/impact_law.h"
#include "physics/model/geometry.h"

namespace carom {

// The impact of two settled bodies a < b of which links hold at least one: links share the impulse at once, so
// the contact answers with the mass that the linked bodies have together. Changes the settled motions of all
// that share it. Body b is hit along the contact's normal. The impulse is zero if the bodies don't approach.
[[nodiscard]] Impact resolve_linked_impact(Tracks& tracks, const MassProperties& mass, int a, int b,
                                           const Contact& contact, const Material& material, ImpactLawId law);

}  // namespace carom
