#include "physics/collision/approach.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/collision/pair_contact.h"

namespace carom {

Approach approach_of(const Geometry& g, int a, const Eigen::Vector3d& qa, const Twist& twist_a, int b,
                     const Eigen::Vector3d& qb, const Twist& twist_b, double tolerance) {
  // Along the normal a disc's surface moves like its centre.
  const auto normal_speed = [&](int i, const Eigen::Vector3d& q, const Twist& twist, const Contact& c) {
    double speed = twist.velocity.dot(c.normal);
    if (g.is_disc(i) || twist.spin == 0.0) return speed;
    const Vec2 r = c.point - q.head<2>();
    return speed + twist.spin * cross(r, c.normal);
  };
  const auto parting = [&](const Contact& c) {
    return normal_speed(b, qb, twist_b, c) - normal_speed(a, qa, twist_a, c);
  };
  const auto fastest = [&](int i, const Twist& twist) {
    const double turning =
        g.is_disc(i) || twist.spin == 0.0 ? 0.0 : std::abs(twist.spin) * g.shapes.core_radius[i];
    return twist.velocity.norm() + turning;
  };

  Approach approach;
  approach.contact = contact_between(g, a, qa, b, qb);
  approach.speed = parting(approach.contact);
  approach.scale = fastest(a, twist_a) + fastest(b, twist_b);
  if (g.is_disc(a) || g.is_disc(b)) return approach;
  if (approach.speed < -16.0 * std::numeric_limits<double>::epsilon() * approach.scale) return approach;
  const Manifold ends = manifold(g.shapes, a, pose_of(g.shapes, a, qa), b, pose_of(g.shapes, b, qb),
                                 std::max(approach.contact.gap, 0.0) + tolerance);
  for (int k = 0; k < ends.count; ++k) {
    const Contact end{ends.points[k].gap, ends.normal, ends.points[k].point};
    const double speed = parting(end);
    if (speed >= approach.speed) continue;
    approach.contact = end;
    approach.speed = speed;
  }
  return approach;
}

}  // namespace carom
