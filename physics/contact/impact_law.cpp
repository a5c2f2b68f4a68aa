#include "physics/contact/impact_law.h"

#include <algorithm>
#include <cmath>

namespace carom {

RelativeVelocity relative_velocity(const ImpactSide& a, const ImpactSide& b, const Vec2& normal) {
  const Vec2 tangent(-normal.y(), normal.x());
  const Vec2 u = b.velocity - a.velocity;
  return {u.dot(normal), u.dot(tangent) - a.spin * a.arm - b.spin * b.arm};
}

Impact resolve_impact(ImpactSide& a, ImpactSide& b, const Vec2& normal, const Material& material) {
  const RelativeVelocity u = relative_velocity(a, b, normal);
  Impact impact;
  if (u.normal >= 0.0) return impact;

  // The normal's length is 1 within rounding only. Left out, or itself rounded to a number near 1, whose
  // neighbours are not equally far, |n|² - 1 would add up to a drift of the energy over millions of impacts.
  const double excess = std::fma(normal.x(), normal.x(), std::fma(normal.y(), normal.y(), -1.0));
  const double k_nn = a.inverse_mass + b.inverse_mass;
  const double of_unit_normal = -(1.0 + material.restitution) * u.normal / k_nn;
  impact.normal = of_unit_normal - excess * of_unit_normal;
  impact.lost_to_restitution = -0.5 * impact.normal * (2.0 * u.normal + k_nn * of_unit_normal);
  Vec2 j = impact.normal * normal;
  if (material.kinetic_friction > 0.0) {
    const double k_tt =
        k_nn + excess * k_nn + a.arm * a.arm * a.inverse_inertia + b.arm * b.arm * b.inverse_inertia;
    const double most = material.kinetic_friction * impact.normal;
    impact.tangential = std::clamp(-(1.0 + material.tangential_restitution) * u.tangential / k_tt, -most, most);
    impact.lost_to_friction = -0.5 * impact.tangential * (2.0 * u.tangential + k_tt * impact.tangential);
    j += impact.tangential * Vec2(-normal.y(), normal.x());
    a.spin -= a.inverse_inertia * a.arm * impact.tangential;
    b.spin -= b.inverse_inertia * b.arm * impact.tangential;
  }
  a.velocity -= a.inverse_mass * j;
  b.velocity += b.inverse_mass * j;
  return impact;
}

}  // namespace carom
