#pragma once

#include "physics/impact/impact_law.h"

namespace carom {

// The impact as a process in the normal impulse p = j_n, which grows from 0 while the bodies do not move
// (Routh, Dynamics of a System of Rigid Bodies, 1905; Wang and Mason, Journal of Applied Mechanics 59 (1992)
// 635). Each leg is linear in p:
//   slide in direction s:
//     dj_t/dp = -s μ_k,  du_n/dp = K_nn - s μ_k K_nt,  du_t/dp = K_nt - s μ_k K_tt
//   stick:
//     dj_t/dp = -K_nt/K_tt,  du_n/dp = det K / K_tt,  du_t/dp = 0
// Slip that is zero or becomes zero sticks iff |K_nt| <= μ_s K_tt, else it slides off along sign(K_nt). So
// there are at most two legs: slide, then stick or slide back.
// The path ends by energetic restitution (Stronge, Proceedings of the Royal Society A 431 (1990) 169): the
// work of the normal impulse after the greatest compression (u_n = 0) is -e² times the work before it. Both
// are quadratic in p on each leg, so the end has a closed form. Neither direction can gain energy.
// In a jam the first leg has du_n/dp < 0. As K is positive definite, its slip always stops and sticks, and
// u_n grows again. The result is continuous in u_n up to u_n = 0, where a jam is still resolved.
[[nodiscard]] Impact energetic_impact(const ContactMatrix& k, const RelativeVelocity& u,
                                      const SurfaceLaw& material);

}  // namespace carom
