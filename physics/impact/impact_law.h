#pragma once

#include "physics/scene/scene.h"

namespace carom {

// One side of an impact: velocity of the centre (m/s), spin (rad/s), inverse mass and inertia, and the two arms
// of the contact point, r from the centre, in m, with n turned so that it points from this body to the other:
//   arm   = r·n, of the tangential impulse; negative if the contact lies beyond the centre (a deep penetration)
//   lever = r×n, of the normal impulse; 0 for discs, whose normal passes through the centre
// So arm = r_A·n and lever = r_A×n for A, arm = -r_B·n and lever = -r_B×n for B. A fixed body has zero inverse
// mass and inertia.
struct ImpactSide {
  Vec2 velocity = Vec2::Zero();
  double spin = 0.0;
  double inverse_mass = 0.0;
  double inverse_inertia = 0.0;
  double arm = 0.0;
  double lever = 0.0;
};

// Velocity of B relative to A at the contact point, along the normal and along t = n turned by +90°, in m/s.
struct RelativeVelocity {
  double normal = 0.0;
  double tangential = 0.0;
};

// The impulse +j acts on B and -j on A, in N s. The energies, in J, are what restitution (the work of the
// normal impulse), friction (that of the tangential one) and sticking took; their sum is the kinetic energy
// lost. Only Newton's law with friction can make lost_to_friction negative; where the sum is, energy_gain says
// how much.
struct Impact {
  double normal = 0.0;
  double tangential = 0.0;
  double lost_to_restitution = 0.0;
  double lost_to_friction = 0.0;
  double lost_to_sticking = 0.0;
  double energy_gain = 0.0;
  bool jammed = false;  // friction drove the bodies together until the slip had stopped (Painlevé)
};

// The inverse mass that the contact point feels: the velocity u changes by K j, in 1/kg.
//   K_nn = 1/m_A + 1/m_B + lever_A²/I_A + lever_B²/I_B
//   K_tt = 1/m_A + 1/m_B + arm_A²/I_A + arm_B²/I_B
//   K_nt = lever_A arm_A/I_A + lever_B arm_B/I_B
// K is positive definite, and its determinant is summed from positive parts, so it stays so in rounding.
struct ContactMatrix {
  double nn = 0.0;
  double nt = 0.0;
  double tt = 0.0;
  double determinant = 0.0;  // 1/kg²
};

[[nodiscard]] RelativeVelocity relative_velocity(const ImpactSide& a, const ImpactSide& b, const Vec2& normal);
[[nodiscard]] ContactMatrix contact_matrix(const ImpactSide& a, const ImpactSide& b, const Vec2& normal);

// The impulse that resolves an impact with slip u of two bodies that answer to it by K; K need not be that of
// two free bodies, joints may hold them. See resolve_impact() for the laws. Tangential restitution is not used.
// Where the contact point cannot move along the tangent (det K zero within rounding) friction has no part.
[[nodiscard]] Impact impact_by(const ContactMatrix& k, const RelativeVelocity& u, const Material& material,
                               ImpactLawId law);

// The impact of two bodies along the line of their centres, without friction: changes their velocities alone.
// By the law of resolve_impact(), to the same bits.
[[nodiscard]] Impact resolve_smooth_impact(Vec2& velocity_a, double inverse_mass_a, Vec2& velocity_b,
                                           double inverse_mass_b, const Vec2& normal, double restitution);

// Resolves one impact: changes both velocities and spins and says by which impulse. At least one side must be
// movable. Bodies that separate (u_n > 0) get no impulse.
//
// Where no normal impulse turns anything (lever or inverse inertia zero on both sides), the directions
// decouple:
//   j_n = -(1 + e) u_n / K_nn,   j_t = clamp(-(1 + e_t) u_t / K_tt, ±μ_k j_n)
// Slip obeys μ_k throughout; μ_s decides only whether slip that has come to zero stays zero, which here it
// does. Energy: W = j·(u + u')/2 for each direction. The law of Walton and Braun (1986) for discs, with
// Newton's restitution; e_t as in Garwin, American Journal of Physics 37 (1969) 88. Tangential restitution is
// known to this case alone: elsewhere e_t is not used.
//
// Elsewhere `law` decides: see routh_path.h and newton_law.h. A contact at u_n = 0 that slips in a jam (K_nn <
// μ_k |K_nt|, friction driving the bodies together) is resolved as the limit of u_n -> 0, an "impact without
// collision"; any other contact at u_n = 0 gets no impulse.
[[nodiscard]] Impact resolve_impact(ImpactSide& a, ImpactSide& b, const Vec2& normal, const Material& material,
                                    ImpactLawId law = ImpactLawId::kEnergetic);

}  // namespace carom
