#pragma once

#include "physics/scene/scene.h"

namespace carom {

// One side of an impact: velocity of the centre (m/s), spin (rad/s), inverse mass and inertia, and the arm: how
// far in m the contact point lies from the centre along the normal, towards the other body; negative if it lies
// beyond the centre, as in a deep overlap. For discs the contact point lies on the
// normal through the centre, so the normal impulse turns nothing and the normal and tangential directions
// decouple (K_nt = 0). A fixed body has zero inverse mass and inertia.
struct ImpactSide {
  Vec2 velocity = Vec2::Zero();
  double spin = 0.0;
  double inverse_mass = 0.0;
  double inverse_inertia = 0.0;
  double arm = 0.0;
};

// Velocity of B relative to A at the contact point, along the normal and along t = n turned by +90°, in m/s.
struct RelativeVelocity {
  double normal = 0.0;
  double tangential = 0.0;
};

// The impulse +j acts on B and -j on A, in N s; the energies, in J, are what restitution and friction took.
struct Impact {
  double normal = 0.0;
  double tangential = 0.0;
  double lost_to_restitution = 0.0;
  double lost_to_friction = 0.0;
};

[[nodiscard]] RelativeVelocity relative_velocity(const ImpactSide& a, const ImpactSide& b, const Vec2& normal);

// Newton's restitution with Coulomb friction for K_nt = 0:
//   j_n = -(1 + e) u_n / K_nn,                              K_nn = 1/m_A + 1/m_B
//   j_t = clamp(-(1 + e_t) u_t / K_tt, ±μ_k j_n),           K_tt = K_nn + arm_A²/I_A + arm_B²/I_B
// Slip obeys μ_k throughout; μ_s decides only whether slip that has come to zero stays zero, which for K_nt = 0
// it does. Energy: W = j·(u + u')/2 for each direction. The law of Walton and Braun (1986) for discs, with
// Newton's restitution; e_t as in Garwin, American Journal of Physics 37 (1969) 88. Bodies that separate (u_n
// >= 0) get no impulse.
[[nodiscard]] Impact resolve_impact(ImpactSide& a, ImpactSide& b, const Vec2& normal, const Material& material);

}  // namespace carom
