#pragma once

#include "physics/model/surface_law.h"
#include "physics/scene/scene.h"

namespace carom {

// One side of an impact: velocity of the centre (m/s), spin (rad/s), inverse mass (1/kg) and inertia
// (1/(kg m²)), and two arms in m. With r from the centre to the contact point, and n turned so that it points
// from this body to the other:
//   arm   = r·n, of the tangential impulse; negative if the contact is beyond the centre (deep penetration)
//   lever = r×n, of the normal impulse; 0 for discs, whose normal passes through the centre
// So arm = r_A·n and lever = r_A×n for A, arm = -r_B·n and lever = -r_B×n for B. A fixed body has zero
// inverse mass and inertia.
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

// The impulse +j acts on B and -j on A, in N s. The energies, in J, are the losses to restitution (work of
// the normal impulse), to friction (work of the tangential one) and to sticking; their sum is the kinetic
// energy lost. Only Newton's law with friction can make lost_to_friction negative; if the sum is negative,
// energy_gain is its amount.
struct Impact {
  double normal = 0.0;
  double tangential = 0.0;
  double lost_to_restitution = 0.0;
  double lost_to_friction = 0.0;
  double lost_to_sticking = 0.0;
  double energy_gain = 0.0;
  bool jammed = false;  // friction drove the bodies together until the slip had stopped (Painlevé)
};

// The inverse mass at the contact point, in 1/kg: an impulse j changes the relative velocity u by K j.
//   K_nn = 1/m_A + 1/m_B + lever_A²/I_A + lever_B²/I_B
//   K_tt = 1/m_A + 1/m_B + arm_A²/I_A + arm_B²/I_B
//   K_nt = lever_A arm_A/I_A + lever_B arm_B/I_B
// K is positive definite. Its determinant is summed from positive parts, so it stays positive in rounding.
struct ContactMatrix {
  double nn = 0.0;
  double nt = 0.0;
  double tt = 0.0;
  double determinant = 0.0;  // 1/kg²
};

[[nodiscard]] RelativeVelocity relative_velocity(const ImpactSide& a, const ImpactSide& b, const Vec2& normal);
[[nodiscard]] ContactMatrix contact_matrix(const ImpactSide& a, const ImpactSide& b, const Vec2& normal);

// The impulse that resolves an impact with relative velocity u at a contact with matrix K, which may include
// the effect of joints. See resolve_impact() for the laws. Tangential restitution is not used. If the contact
// point cannot move along the tangent (det K zero within rounding), there is no friction.
[[nodiscard]] Impact impact_by(const ContactMatrix& k, const RelativeVelocity& u, const SurfaceLaw& material,
                               ImpactLawId law);

// A central impact without friction: changes only the velocities, to the same bits as resolve_impact().
[[nodiscard]] Impact resolve_smooth_impact(Vec2& velocity_a, double inverse_mass_a, Vec2& velocity_b,
                                           double inverse_mass_b, const Vec2& normal, double restitution);

// Resolves one impact: changes both velocities and spins and returns the impulse. At least one side must be
// movable. Bodies that separate (u_n > 0) get no impulse.
//
// Where the normal impulse turns nothing (lever or inverse inertia zero on both sides), the directions
// decouple:
//   j_n = -(1 + e) u_n / K_nn,   j_t = clamp(-(1 + e_t) u_t / K_tt, ±μ_k j_n)
// Slip obeys μ_k throughout; μ_s decides only whether slip that has stopped stays zero, which it does here.
// Energy: W = j·(u + u')/2 for each direction. The law of Walton and Braun (1986) for discs, with Newton's
// restitution; e_t as in Garwin, American Journal of Physics 37 (1969) 88. Only this case uses e_t.
//
// Elsewhere `law` decides: see routh_path.h and newton_law.h. A contact at u_n = 0 that slips in a jam (K_nn <
// μ_k |K_nt|, friction driving the bodies together) is resolved as the limit of u_n -> 0, an "impact without
// collision"; any other contact at u_n = 0 gets no impulse.
[[nodiscard]] Impact resolve_impact(ImpactSide& a, ImpactSide& b, const Vec2& normal,
                                    const SurfaceLaw& material, ImpactLawId law = ImpactLawId::kEnergetic);

}  // namespace carom
