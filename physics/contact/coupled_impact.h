#pragma once

#include "physics/contact/impact_law.h"

namespace carom {

// How the relative velocity u = (u_n, u_t) at a contact answers to the impulse j = (j_n, j_t) there: u' = u + K
// j. K is symmetric, in 1/kg.
struct ContactAnswer {
  double nn = 0.0;
  double nt = 0.0;
  double tt = 0.0;
};

// Newton's restitution with Coulomb friction for any K, as links make it: without friction j_n = -(1+e)
// u_n/K_nn; with it the j that gives u_n' = -e u_n and stops the slip (or turns it round by e_t where K_nt =
// 0), if that keeps |j_t| <= μ_k j_n, else j_t = ±μ_k j_n against the slip. For K_nt ≠ 0 Newton's law can gain
// energy with friction; an impact that would is taken without friction. Bodies that separate (u_n >= 0) get no
// impulse.
[[nodiscard]] Impact resolve_coupled_impact(const RelativeVelocity& u, const ContactAnswer& k,
                                            const Material& material);

}  // namespace carom
