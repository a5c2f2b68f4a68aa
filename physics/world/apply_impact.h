#pragma once

#include "physics/impact/impact_law.h"
#include "physics/world/world.h"

namespace carom {

// How impacts of this model are resolved; chosen once a run.
[[nodiscard]] ApplyImpact apply_impact_of(const Model& model);

// Resolves the impact of two bodies at their settled poses, `within` s after the epoch: changes their
// velocities, records it and keeps the ledger. Nothing happens to a pair that does not close. Bodies whose
// surfaces stick are joined from then on (can_collide() is false), under a model compiled anew.
inline void apply_impact(World& world, int a, int b, const Contact& contact, const Material& material,
                         double within) {
  world.apply_impact(world, a, b, contact, material, within);
}

// Counts and records an impact that has been resolved, and keeps the ledger. `closing` in m/s.
void record_impact(World& world, int a, int b, const Contact& contact, const Impact& impact, double closing,
                   double within);

}  // namespace carom
