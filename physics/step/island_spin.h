#pragma once

#include <Eigen/Core>
#include <vector>

#include "physics/contact/contacts.h"
#include "physics/contact/islands.h"
#include "physics/step/world.h"

namespace carom {

// Bodies that were moved by `moved` (3×N, m and rad) out of penetrations, with their velocities as they were,
// have another angular momentum than before: Σ m (x + Δx) × v. In each island that touches no body of infinite
// mass, all velocities get a share of a rotation about the centre of mass, v_i += Ω × (x_i - x_cm), that takes
// the change back. Momentum stays too. The energy of it counts as the push's. At the start of the trajectories;
// `scratch` is memory to work in.
void keep_angular_momentum(World& world, const Contacts& contacts, const Islands& islands,
                           const Eigen::Matrix3Xd& moved, std::vector<BodyIndex>& scratch);

}  // namespace carom
