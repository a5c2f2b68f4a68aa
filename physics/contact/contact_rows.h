#pragma once

#include <span>

#include "physics/model/index.h"

namespace carom {

// The data of the solver's loops, packed for the cache: three lines per contact, one per body.

struct alignas(64) SolverBody {
  double vx = 0.0, vy = 0.0, spin = 0.0;                 // with the impulses so far, m/s and rad/s
  double inverse_mass = 0.0, inverse_inertia = 0.0;      // 0 for infinite mass
  double free_vx = 0.0, free_vy = 0.0, free_spin = 0.0;  // without contact impulses
};

// J is the derivative of the relative velocity by the bodies' velocities, and K = J M⁻¹ Jᵀ the change of the
// velocity along a direction by a unit impulse along it. r×t = r·n.
struct alignas(64) ContactRow {
  BodyIndex a, b;
  double nx = 0.0, ny = 0.0;
  double arm_na = 0.0, arm_nb = 0.0;                    // r_A×n and r_B×n, m
  double arm_ta = 0.0, arm_tb = 0.0;                    // r_A×t and r_B×t, m
  double mass_n = 0.0, mass_t = 0.0, mass_r = 0.0;      // 1/K_nn and 1/K_tt in kg, 1/K_rr in kg m²
  double target = 0.0, slip_target = 0.0;               // m/s
  double friction = 0.0;                                // dimensionless
  double rolling = 0.0;                                 // m
  double normal = 0.0, tangential = 0.0, moment = 0.0;  // impulses, N s and N m s
};
static_assert(sizeof(ContactRow) == 192);

struct RowVelocity {
  double normal = 0.0, tangential = 0.0, spin = 0.0;
};

[[nodiscard]] inline RowVelocity row_velocity(const ContactRow& row, const SolverBody& a, const SolverBody& b) {
  const double dx = b.vx - a.vx;
  const double dy = b.vy - a.vy;
  return {row.nx * dx + row.ny * dy + (row.arm_nb * b.spin - row.arm_na * a.spin),
          row.nx * dy - row.ny * dx + (row.arm_tb * b.spin - row.arm_ta * a.spin), b.spin - a.spin};
}

inline void apply_impulse(const ContactRow& row, double normal, double tangential, double moment, SolverBody& a,
                          SolverBody& b) {
  const double jx = row.nx * normal - row.ny * tangential;
  const double jy = row.ny * normal + row.nx * tangential;
  a.vx -= a.inverse_mass * jx;
  a.vy -= a.inverse_mass * jy;
  a.spin -= a.inverse_inertia * (row.arm_na * normal + row.arm_ta * tangential + moment);
  b.vx += b.inverse_mass * jx;
  b.vy += b.inverse_mass * jy;
  b.spin += b.inverse_inertia * (row.arm_nb * normal + row.arm_tb * tangential + moment);
}

// Sets the bodies of these contacts to their free velocities plus the effect of the impulses.
void apply_all(std::span<const ContactRow> rows, std::span<SolverBody> bodies);

// One sweep of projected Gauss-Seidel on the accumulated impulses, forwards or backwards: each contact in
// turn gets the impulses that satisfy its own law (Moreau; Jean, Computer Methods in Applied Mechanics and
// Engineering 177 (1999) 235).
void sweep(std::span<ContactRow> rows, std::span<SolverBody> bodies, bool backwards);

// The largest change of a contact's own velocity, in m/s, that its law still requires (the natural map of the
// complementarity problem, scaled to a velocity by K): the largest of
//   K_nn |λ_n - max(0, λ_n - (u_n - b_n)/K_nn)|,  K_tt |λ_t - clamp(λ_t - (u_t - b_t)/K_tt, ±μ λ_n)|,
//   ρ K_rr |M - clamp(M - w/K_rr, ±ρ λ_n)|.
// 0 exactly at a solution.
[[nodiscard]] double residual(std::span<const ContactRow> rows, std::span<const SolverBody> bodies);

// N s: the masses of all these bodies, times the largest speed that a contact asks for beyond the free
// velocities. Impulses that are many times larger only press the bodies against each other.
[[nodiscard]] double momentum_to_change(std::span<const ContactRow> rows, std::span<const SolverBody> bodies);
// N s: the largest normal impulse.
[[nodiscard]] double largest_impulse(std::span<const ContactRow> rows);

// The residual that rounding alone may leave, in m/s: 8ε times the largest of |v| + Σ|λ|/m over the bodies,
// rotation included. Changes `bodies`; apply_all() restores them.
[[nodiscard]] double rounding_level(std::span<const ContactRow> rows, std::span<SolverBody> bodies);

}  // namespace carom
