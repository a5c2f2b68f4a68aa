#pragma once

#include "physics/impact/impact_law.h"
#include "physics/step/world.h"

namespace carom {

// How impacts of this model are resolved; chosen once a run.
[[nodiscard]] ApplyImpact apply_impact_of(const Model& model);

// Resolves the impact of two bodies at the start of their trajectories, `within` s after the epoch: changes
// their velocities, records the impact and keeps the ledger. The impulse acts at the contact's point: for faces
// that meet, that of pressed_contact(). Does nothing if the pair does not close. Bodies whose surfaces stick
// are joined by a weld.
inline ImpactEffect apply_impact(World& world, BodyIndex a, BodyIndex b, const Contact& contact,
                                 const SurfaceLaw& material, double within) {
  return world.apply_impact(world, a, b, contact, material, within);
}

// Joins two bodies whose surfaces stick, where they touch and are pressed together: as apply_impact() does
// where they close.
void join_at_rest(World& world, BodyIndex a, BodyIndex b, const Contact& contact);

// Counts and records a resolved impact and enters its losses in the ledger. `closing` in m/s.
void record_impact(World& world, BodyIndex a, BodyIndex b, const Contact& contact, const Impact& impact,
                   double closing, double within);
// Enters what passes to walls and drives by the impulse of an impact. What passes through a joint, such as the
// weld of two bodies that have stuck, is in the bodies' quadratures.
void record_impulse(World& world, BodyIndex a, BodyIndex b, const Contact& contact, const Impact& impact);

}  // namespace carom
