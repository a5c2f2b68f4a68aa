#pragma once

#include <Eigen/Core>

#include "physics/record/jump_moment.h"

namespace carom {

// Why no closed law tells the velocities after an impact.
enum class NoTheory {
  kNone,            // one does
  kJoints,          // a joint passes the impulse on to other bodies
  kMaterials,       // a body has several materials
  kSlipStops,       // friction stops the slip of an off-centre impact on the way
  kFrictionAtOnce,  // several contacts at once with friction
  kRestitution      // the contacts at once have different e, or one that was lowered
};

// The velocities after the impacts of one moment by closed laws, from those before it; found without the code
// that makes the steps. Of two bodies, with n the normal, t = n turned by +90°, u the relative velocity at the
// contact and K its inverse mass (impact_law.h):
//   no friction, or centres on the normal:
//     j_n = -(1 + e) u_n / K_nn,  j_t = clamp(-(1 + e_t) u_t / K_tt, ±μ j_n)
//   slip in the direction s throughout:
//     j_n = -(1 + e) u_n / (K_nn - s μ K_nt),  j_t = -s μ j_n
//   no slip throughout (Newton's law):
//     K j = (-(1 + e) u_n, -u_t)
//   the bodies stick:
//     one velocity and one spin, by momentum and angular momentum
// Of several contacts at once without friction: u_n' = -e u_n at each, u_n' = 0 where they part before. Impacts
// of one moment that follow one another each take the velocities that the one before left.
struct ImpactTheory {
  NoTheory why_not = NoTheory::kNone;
  Eigen::Matrix3Xd v;  // after, by body, as in State; only if there is a law
};
[[nodiscard]] ImpactTheory theory_of(const JumpMoment& moment);

}  // namespace carom
