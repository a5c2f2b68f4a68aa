#include "physics/impact/newton_law.h"

#include <algorithm>

namespace carom {

Impact newton_impact(const ContactMatrix& k, const RelativeVelocity& u, const SurfaceLaw& material) {
  Impact impact;
  if (u.normal >= 0.0) return impact;
  const double mu = material.kinetic_friction;
  const double change = -(1.0 + material.restitution) * u.normal;  // K_nn j_n + K_nt j_t

  // Sliding along the lower border j_t = -μ j_n needs K_nn - μ K_nt > 0; where it is not, that border is never
  // reached. Likewise the upper one.
  impact.normal = (k.tt * change + k.nt * u.tangential) / k.determinant;
  impact.tangential = (-k.nn * u.tangential - k.nt * change) / k.determinant;
  double slip = 0.0;
  for (const double side : {-1.0, 1.0}) {
    const double stiffness = k.nn + side * mu * k.nt;
    if (stiffness > 0.0 && side * impact.tangential * stiffness > mu * change) {
      impact.normal = change / stiffness;
      impact.tangential = side * mu * impact.normal;
      slip = u.tangential + k.nt * impact.normal + k.tt * impact.tangential;
      break;
    }
  }
  impact.lost_to_restitution = -0.5 * impact.normal * (1.0 - material.restitution) * u.normal;
  impact.lost_to_friction = -0.5 * impact.tangential * (u.tangential + slip);
  impact.energy_gain = std::max(0.0, -(impact.lost_to_restitution + impact.lost_to_friction));
  return impact;
}

}  // namespace carom
