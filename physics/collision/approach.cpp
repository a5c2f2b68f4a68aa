#include "physics/collision/approach.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/collision/pair_contact.h"
#include "physics/collision/tips.h"

namespace carom {
namespace {

// Cosine of the angle between the normals of one face at its middle and at its ends.
constexpr double kSameFace = 0.999;

// A body at one time.
struct Moving {
  BodyIndex body;
  Pose pose{};
  Twist twist{};
};

enum class Place {
  kMiddle,  // if that approaches
  kFastest
};

// What slides past a corner that is flush with it goes on along the face.
template <class Parting>
void pass_along(const Geometry& g, const Moving& a, const Moving& b, const Parting& parting,
                Approach& approach) {
  const auto [part_a, part_b] = g.parts_or_first(approach.contact.parts, a.body, b.body);
  const auto tips = tip_normals(g.shapes, part_a, g.part_pose(a.body, part_a, a.pose), part_b,
                                g.part_pose(b.body, part_b, b.pose));
  if (!tips) return;
  const auto along = [&](const Vec2& normal) {
    Contact contact = approach.contact;
    contact.normal = normal;
    return parting(contact);
  };
  const auto normal = passes_along(*tips, along);
  if (!normal) return;
  approach.contact.normal = *normal;
  approach.speed = parting(approach.contact);
}

// With `parts`, of these two alone; else of all.
Approach approach(const Geometry& g, const Moving& a, const Moving& b, double tolerance, const ShapePair* parts,
                  Place place = Place::kMiddle) {
  // Along the normal a disc's surface moves like its centre.
  const auto normal_speed = [&](const Moving& m, const Contact& c) {
    double speed = m.twist.velocity.dot(c.normal);
    if (g.is_disc(m.body) || m.twist.spin == 0.0) return speed;
    return speed + m.twist.spin * cross(c.point - m.pose.position, c.normal);
  };
  const auto parting = [&](const Contact& c) { return normal_speed(b, c) - normal_speed(a, c); };
  const auto fastest = [&](const Moving& m) {
    const double turning =
        g.is_disc(m.body) || m.twist.spin == 0.0 ? 0.0 : std::abs(m.twist.spin) * g.core_reach[m.body];
    return m.twist.velocity.norm() + turning;
  };

  Approach approach;
  Contact earlier;
  if (parts != nullptr) earlier.parts = *parts;
  approach.contact = contact_again(g, a.body, a.pose, b.body, b.pose, earlier);
  approach.speed = parting(approach.contact);
  approach.scale = fastest(a) + fastest(b);
  const bool several = parts == nullptr && (g.has_parts(a.body) || g.has_parts(b.body));
  if ((g.is_disc(a.body) || g.is_disc(b.body)) && !several) return approach;
  const double rounding = 16.0 * std::numeric_limits<double>::epsilon() * approach.scale;
  if (approach.speed < -rounding) pass_along(g, a, b, parting, approach);
  if (place == Place::kMiddle && approach.speed < -rounding) return approach;
  const double margin = std::max(approach.contact.gap, 0.0) + tolerance;
  const auto look_at = [&](const Manifold& ends) {
    for (int k = 0; k < ends.count; ++k) {
      const Contact end = ends.contact(k);
      const double speed = parting(end);
      if (speed >= approach.speed) continue;
      approach.contact = end;
      approach.speed = speed;
    }
  };
  if (several) {
    each_manifold(g, a.body, a.pose, b.body, b.pose, margin, look_at);
  } else {
    const auto [part_a, part_b] = parts != nullptr ? *parts : g.first_parts(a.body, b.body);
    const Manifold ends = manifold(g, a.body, part_a, a.pose, b.body, part_b, b.pose, margin);
    // Where corners meet it may have the normal of another edge.
    if (ends.normal.dot(approach.contact.normal) > kSameFace) look_at(ends);
  }
  return approach;
}

}  // namespace

Approach approach_of(const Geometry& g, BodyIndex a, const Eigen::Vector3d& qa, const Twist& twist_a,
                     BodyIndex b, const Eigen::Vector3d& qb, const Twist& twist_b, double tolerance) {
  return approach(g, {a, g.pose(a, qa), twist_a}, {b, g.pose(b, qb), twist_b}, tolerance, nullptr);
}

Approach approach_of(const Geometry& g, BodyIndex a, const Eigen::Vector3d& qa, const Twist& twist_a,
                     BodyIndex b, const Eigen::Vector3d& qb, const Twist& twist_b, double tolerance,
                     const ShapePair& parts) {
  return approach(g, {a, g.pose(a, qa), twist_a}, {b, g.pose(b, qb), twist_b}, tolerance, &parts);
}

Approach fastest_approach_of(const Geometry& g, BodyIndex a, const Eigen::Vector3d& qa, const Twist& twist_a,
                             BodyIndex b, const Eigen::Vector3d& qb, const Twist& twist_b, double tolerance,
                             const ShapePair& parts) {
  return approach(g, {a, g.pose(a, qa), twist_a}, {b, g.pose(b, qb), twist_b}, tolerance, &parts,
                  Place::kFastest);
}

}  // namespace carom
