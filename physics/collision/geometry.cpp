#include "physics/collision/geometry.h"

#include <cmath>

namespace carom {
namespace {

// Nearest point of a rectangle's boundary to a point, in the rectangle's own frame, as signed distance and
// outward normal. For a degenerate rectangle (a point) this is the distance to it.
struct Nearest {
  double distance;
  Vec2 normal;
};

Nearest nearest_on_rectangle(const Vec2& half, const Vec2& p) {
  const Vec2 outside = p - p.cwiseMax(-half).cwiseMin(half);
  const double distance = outside.norm();
  if (distance > 0.0) return {distance, outside / distance};
  const Vec2 depth = half - p.cwiseAbs();
  const int axis = depth.x() <= depth.y() ? 0 : 1;
  Vec2 normal = Vec2::Zero();
  normal[axis] = p[axis] < 0.0 ? -1.0 : 1.0;
  return {-depth[axis], normal};
}

}  // namespace

Geometry geometry(const std::vector<Body>& bodies) {
  const auto n = static_cast<Eigen::Index>(bodies.size());
  Geometry g{Eigen::Matrix2Xd::Zero(2, n), Eigen::VectorXd::Zero(n), Eigen::Matrix2Xd::Zero(2, n), {}};
  for (Eigen::Index i = 0; i < n; ++i) {
    const Body& body = bodies[static_cast<std::size_t>(i)];
    if (const auto* disc = std::get_if<Disc>(&body.shape)) g.rounding[i] = disc->radius;
    if (const auto* box = std::get_if<Box>(&body.shape)) g.half.col(i) << 0.5 * box->width, 0.5 * box->height;
    const double c = std::abs(std::cos(body.angle));
    const double s = std::abs(std::sin(body.angle));
    g.extent(0, i) = c * g.half(0, i) + s * g.half(1, i) + g.rounding[i];
    g.extent(1, i) = s * g.half(0, i) + c * g.half(1, i) + g.rounding[i];
    g.fixed.push_back(is_immovable(body) ? 1 : 0);
  }
  return g;
}

Contact contact_between(const Geometry& g, int a, const Eigen::Vector3d& qa, int b, const Eigen::Vector3d& qb) {
  // The body with a core is the frame of reference; of two discs it is a.
  const bool b_has_core = g.half.col(b).maxCoeff() > 0.0;
  const int core = b_has_core ? b : a;
  const Eigen::Vector3d& q_core = b_has_core ? qb : qa;
  const Eigen::Vector3d& q_disc = b_has_core ? qa : qb;
  const double rounding = g.rounding[a] + g.rounding[b];
  const Vec2 d = q_disc.head<2>() - q_core.head<2>();

  Nearest nearest{};
  if (g.half.col(core).maxCoeff() > 0.0) {
    const double c = std::cos(q_core[2]);
    const double s = std::sin(q_core[2]);
    nearest = nearest_on_rectangle(g.half.col(core), Vec2(c * d.x() + s * d.y(), -s * d.x() + c * d.y()));
    nearest.normal =
        Vec2(c * nearest.normal.x() - s * nearest.normal.y(), s * nearest.normal.x() + c * nearest.normal.y());
  } else {
    const double distance = d.norm();
    nearest = {distance, distance > 0.0 ? Vec2(d / distance) : Vec2(Vec2::UnitX())};
  }

  Contact contact;
  contact.gap = nearest.distance - rounding;
  contact.normal = b_has_core ? Vec2(-nearest.normal) : nearest.normal;
  // From the disc's centre back along the normal to the middle of gap or overlap.
  const double disc_radius = g.rounding[b_has_core ? a : b];
  contact.point = q_disc.head<2>() - (disc_radius + 0.5 * contact.gap) * nearest.normal;
  return contact;
}

}  // namespace carom
