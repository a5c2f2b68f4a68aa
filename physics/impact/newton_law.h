#pragma once

#include "physics/impact/impact_law.h"

namespace carom {

// Newton's restitution with Coulomb's cone on the whole impulse:
//   u_n' = -e u_n,   |j_t| <= μ_k j_n,   u_t' = 0 inside the cone, j_t against u_t' on its border
// It has exactly one solution for each u_n < 0: the impulse that stops the slip, clipped to the cone. The law
// uses only μ_k: it has no moment at which the slip stops. Its friction may feed energy into the normal
// direction, and the sum may be a gain (found by Kane and Levinson, Dynamics, 1985, for a pendulum that
// strikes a floor), which energy_gain reports. No impulse for u_n >= 0.
[[nodiscard]] Impact newton_impact(const ContactMatrix& k, const RelativeVelocity& u,
                                   const SurfaceLaw& material);

}  // namespace carom
