#include "physics/impact/impact_law.h"

#include <algorithm>
#include <cmath>

#include "physics/impact/newton_law.h"
#include "physics/impact/routh_path.h"
#include "physics/math/vectors.h"
#include "physics/model/coulomb_friction.h"

namespace carom {
namespace {

// |n|² - 1, as the normal's length is 1 only within rounding. If it were left out, or |n|² itself rounded to
// a double near 1, where those below and above are not equally spaced, the energy would drift over millions
// of impacts.
double excess_of(const Vec2& normal) {
  return std::fma(normal.x(), normal.x(), std::fma(normal.y(), normal.y(), -1.0));
}

// Relative to the distance of the contact: a normal impulse with a smaller lever turns by rounding alone.
constexpr double kCentral = 1e-9;

bool unturned_by_normal(const ImpactSide& s) { return s.lever == 0.0 || s.inverse_inertia == 0.0; }
bool hardly_turned_by_normal(const ImpactSide& s) {
  return unturned_by_normal(s) || std::abs(s.lever) <= kCentral * std::abs(s.arm);
}

// The normal impulse of an impact that turns nothing, for the closing velocity u_n < 0.
Impact normal_impact(double u_n, double k_nn, double excess, double restitution) {
  Impact impact;
  const double of_unit_normal = -(1.0 + restitution) * u_n / k_nn;
  impact.normal = of_unit_normal - excess * of_unit_normal;
  impact.lost_to_restitution = -0.5 * impact.normal * (2.0 * u_n + k_nn * of_unit_normal);
  return impact;
}

Impact resolve_central(ImpactSide& a, ImpactSide& b, const Vec2& normal, const RelativeVelocity& u,
                       const SurfaceLaw& material) {
  if (u.normal >= 0.0) return {};
  const double excess = excess_of(normal);
  const double k_nn = a.inverse_mass + b.inverse_mass;
  Impact impact = normal_impact(u.normal, k_nn, excess, material.restitution);
  Vec2 j = impact.normal * normal;
  if (material.kinetic_friction > 0.0) {
    const double k_tt =
        k_nn + excess * k_nn + a.arm * a.arm * a.inverse_inertia + b.arm * b.arm * b.inverse_inertia;
    const double wanted = -(1.0 + material.tangential_restitution) * u.tangential / k_tt;
    impact.tangential = limited_by_friction(wanted, material.kinetic_friction, impact.normal);
    impact.lost_to_friction = -0.5 * impact.tangential * (2.0 * u.tangential + k_tt * impact.tangential);
    j += impact.tangential * crossed(normal);
    a.spin -= a.inverse_inertia * a.arm * impact.tangential;
    b.spin -= b.inverse_inertia * b.arm * impact.tangential;
  }
  a.velocity -= a.inverse_mass * j;
  b.velocity += b.inverse_mass * j;
  return impact;
}

// Below this share of K_nn (K_nn + K_tt) a determinant is rounding.
constexpr double kHeld = 1e-14;

}  // namespace

RelativeVelocity relative_velocity(const ImpactSide& a, const ImpactSide& b, const Vec2& normal) {
  const Vec2 tangent = crossed(normal);
  const Vec2 u = b.velocity - a.velocity;
  return {u.dot(normal) - a.spin * a.lever - b.spin * b.lever,
          u.dot(tangent) - a.spin * a.arm - b.spin * b.arm};
}

ContactMatrix contact_matrix(const ImpactSide& a, const ImpactSide& b, const Vec2& normal) {
  const double central = a.inverse_mass + b.inverse_mass;
  const double correction = excess_of(normal) * central;
  const double nn = a.lever * a.lever * a.inverse_inertia + b.lever * b.lever * b.inverse_inertia;
  const double tt = a.arm * a.arm * a.inverse_inertia + b.arm * b.arm * b.inverse_inertia;
  const double cross = a.lever * b.arm - a.arm * b.lever;
  ContactMatrix k;
  k.nn = central + nn + correction;
  k.tt = central + tt + correction;
  k.nt = a.lever * a.arm * a.inverse_inertia + b.lever * b.arm * b.inverse_inertia;
  const double mass_part = central + correction;
  k.determinant = mass_part * (mass_part + nn + tt) + cross * cross * a.inverse_inertia * b.inverse_inertia;
  return k;
}

Impact impact_by(const ContactMatrix& k, const RelativeVelocity& u, const SurfaceLaw& material,
                 ImpactLawId law) {
  if (!(k.determinant > kHeld * k.nn * (k.nn + k.tt))) {
    Impact impact;
    if (u.normal >= 0.0 || !(k.nn > 0.0)) return impact;
    const double e = material.restitution;
    impact.normal = -(1.0 + e) * u.normal / k.nn;
    impact.lost_to_restitution = 0.5 * (1.0 - e * e) * u.normal * u.normal / k.nn;
    return impact;
  }
  return law == ImpactLawId::kNewton ? newton_impact(k, u, material) : energetic_impact(k, u, material);
}

Impact resolve_smooth_impact(Vec2& velocity_a, double inverse_mass_a, Vec2& velocity_b, double inverse_mass_b,
                             const Vec2& normal, double restitution) {
  const double closing = Vec2(velocity_b - velocity_a).dot(normal);
  if (closing >= 0.0) return {};
  const Impact impact = normal_impact(closing, inverse_mass_a + inverse_mass_b, excess_of(normal), restitution);
  const Vec2 j = impact.normal * normal;
  velocity_a -= inverse_mass_a * j;
  velocity_b += inverse_mass_b * j;
  return impact;
}

Impact resolve_impact(ImpactSide& a, ImpactSide& b, const Vec2& normal, const SurfaceLaw& material,
                      ImpactLawId law) {
  // Tangential restitution belongs to impacts that turn nothing by their normal impulse: rounding must not
  // decide.
  if (material.tangential_restitution != 0.0 && hardly_turned_by_normal(a) && hardly_turned_by_normal(b))
    a.lever = b.lever = 0.0;
  const RelativeVelocity u = relative_velocity(a, b, normal);
  if (unturned_by_normal(a) && unturned_by_normal(b)) {
    return resolve_central(a, b, normal, u, material);
  }
  const Impact impact = impact_by(contact_matrix(a, b, normal), u, material, law);
  const Vec2 j = impact.normal * normal + impact.tangential * crossed(normal);
  a.velocity -= a.inverse_mass * j;
  b.velocity += b.inverse_mass * j;
  a.spin -= a.inverse_inertia * (a.lever * impact.normal + a.arm * impact.tangential);
  b.spin -= b.inverse_inertia * (b.lever * impact.normal + b.arm * impact.tangential);
  return impact;
}

}  // namespace carom
