#include "physics/impact/routh_path.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {
namespace {

// Rates in p.
struct Leg {
  double impulse = 0.0;     // dj_t/dp, dimensionless
  double normal = 0.0;      // du_n/dp, 1/kg
  double tangential = 0.0;  // du_t/dp, 1/kg
};

Leg slide(const ContactMatrix& k, double direction, double mu) {
  Leg leg{-direction * mu, k.nn - direction * mu * k.nt, k.nt - direction * mu * k.tt};
  // Slip that grows means s K_nt >= μ K_tt, hence K_nn - s μ K_nt >= det K / K_tt > 0, also in rounding.
  if (direction * leg.tangential >= 0.0) leg.normal = std::max(leg.normal, k.determinant / k.tt);
  return leg;
}

Leg after_slip_stopped(const ContactMatrix& k, const SurfaceLaw& material) {
  const double mu_s = std::max(material.static_friction, material.kinetic_friction);
  if (std::abs(k.nt) <= mu_s * k.tt) return {-k.nt / k.tt, k.determinant / k.tt, 0.0};
  return slide(k, std::copysign(1.0, k.nt), material.kinetic_friction);
}

}  // namespace

Impact energetic_impact(const ContactMatrix& k, const RelativeVelocity& u, const SurfaceLaw& material) {
  Impact impact;
  if (u.normal > 0.0) return impact;
  const double mu = material.kinetic_friction;
  const double e = material.restitution;

  const Leg second = after_slip_stopped(k, material);
  Leg first = second;
  double first_length = std::numeric_limits<double>::infinity();  // p at which the slip stops
  if (u.tangential != 0.0) {
    const double direction = std::copysign(1.0, u.tangential);
    first = slide(k, direction, mu);
    if (direction * first.tangential < 0.0) first_length = -u.tangential / first.tangential;
    impact.jammed = first.normal < 0.0;
  }
  if (u.normal == 0.0 && !impact.jammed) return impact;

  // Where the path ends, p_1 on the first leg and p_2 on the second, and the work of compression. Differences
  // of squares are factored, (a² - b²) = (a - b)(a + b): both factors are known without cancellation.
  const double closing = -u.normal;
  double p_1 = first_length;
  double p_2 = 0.0;
  double work = 0.0;  // -∫u_n dp over the compression
  if (first.normal > 0.0 && (1.0 + e) * closing <= first.normal * first_length) {
    p_1 = (1.0 + e) * closing / first.normal;
    work = 0.5 * closing * closing / first.normal;
  } else {
    const double turn = u.normal + first.normal * first_length;  // u_n where the slip stops
    if (turn >= 0.0) {
      const double to_do = std::max(e * closing - turn, 0.0) * (e * closing + turn) / first.normal;
      const double end = std::hypot(turn, std::sqrt(second.normal * to_do));
      work = 0.5 * closing * closing / first.normal;
      p_2 = to_do > 0.0 ? to_do / (end + turn) : 0.0;
    } else {
      const double on_first = p_1 * (closing - turn);  // twice the work of the first leg
      const double end = e * std::hypot(turn, std::sqrt(second.normal * on_first));
      work = 0.5 * (on_first + turn * turn / second.normal);
      p_2 = (end - turn) / second.normal;
    }
  }

  impact.normal = p_1 + p_2;
  impact.tangential = first.impulse * p_1 + second.impulse * p_2;
  impact.lost_to_restitution = (1.0 - e) * (1.0 + e) * work;
  // μ ∫|u_t| dp; the second leg starts without slip, and a sticking one does no work.
  const double slip_end = p_1 == first_length ? 0.0 : std::abs(u.tangential + first.tangential * p_1);
  impact.lost_to_friction =
      0.5 * mu * ((std::abs(u.tangential) + slip_end) * p_1 + std::abs(second.tangential) * p_2 * p_2);
  return impact;
}

}  // namespace carom
