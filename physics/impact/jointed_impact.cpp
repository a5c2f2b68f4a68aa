#include "physics/impact/jointed_impact.h"

#include <array>

#include "physics/collision/contact.h"
#include "physics/math/vectors.h"
#include "physics/model/mass.h"

namespace carom {
namespace {

// The change of (v, spin) of a free body by the impulse j at r from its centre.
Eigen::Vector3d free_change(const MassProperties& mass, BodyIndex body, const Vec2& r, const Vec2& j) {
  const double turn = mass.inverse_inertia[body] * cross(r, j);
  return {mass.inverse_mass[body] * j.x(), mass.inverse_mass[body] * j.y(), turn};
}

Vec2 at_point(const Eigen::Vector3d& v, const Vec2& r) { return v.head<2>() + v[2] * crossed(r); }

}  // namespace

Impact resolve_jointed_impact(Trajectories& trajectories, const MassProperties& mass, BodyIndex a, BodyIndex b,
                              const Contact& contact, const SurfaceLaw& material, ImpactLawId law) {
  const Vec2 r_a = contact.point - trajectories.at_start(a).head<2>();
  const Vec2 r_b = contact.point - trajectories.at_start(b).head<2>();
  const std::array<Vec2, 2> axes = {contact.normal, crossed(contact.normal)};
  const Vec2 u = at_point(trajectories.at_start(b).segment<3>(3), r_b) -
                 at_point(trajectories.at_start(a).segment<3>(3), r_a);
  const RelativeVelocity before{u.dot(axes[0]), u.dot(axes[1])};
  const std::array bodies = {a, b};
  const auto changes_by = [&](const Vec2& j) {
    Eigen::Matrix<double, 3, 2> by;
    by << free_change(mass, a, r_a, -j), free_change(mass, b, r_b, j);
    return by;
  };
  // Each round but the last makes one string slack.
  while (true) {
    Eigen::Matrix2d k;
    for (int i = 0; i < 2; ++i) {
      Eigen::Matrix<double, 3, 2> by = changes_by(axes[i]);
      trajectories.project_changes(bodies, by);
      const Vec2 u_by = at_point(by.col(1), r_b) - at_point(by.col(0), r_a);
      k.col(i) << u_by.dot(axes[0]), u_by.dot(axes[1]);
    }
    const double nt = 0.5 * (k(0, 1) + k(1, 0));
    const ContactMatrix answer{k(0, 0), nt, k(1, 1), k(0, 0) * k(1, 1) - nt * nt};
    const Impact impact = impact_by(answer, before, material, law);
    const Vec2 j = impact.normal * axes[0] + impact.tangential * axes[1];
    if (trajectories.apply_changes(bodies, changes_by(j))) return impact;
  }
}

}  // namespace carom
