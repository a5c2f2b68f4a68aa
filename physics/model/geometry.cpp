#include "physics/model/geometry.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <unordered_map>

#include "physics/model/bodies_by_name.h"
#include "physics/model/corner_cones.h"

namespace carom {
namespace {

ConvexShape convex_shape(const ConvexPart& part) {
  const std::vector<Vec2>& v = part.outline.vertices;
  if (part.outline.half_plane) return half_plane_shape(Vec2::UnitY(), 0.0);
  if (v.size() == 1) return disc_shape(part.outline.rounding);
  if (part.box) return box_shape(2.0 * v[2].x(), 2.0 * v[2].y());
  if (v.size() == 2) return segment_shape(v[0], v[1], part.outline.rounding);
  return polygon_shape(v, part.outline.rounding);
}

// The parts of each body; their first ones begin `shapes`.
void add_parts(const std::vector<std::vector<ConvexPart>>& parts, std::vector<ConvexShape>& shapes,
               Geometry& g) {
  const bool several = std::any_of(parts.begin(), parts.end(), [](const auto& of) { return of.size() > 1; });
  const auto n = static_cast<Eigen::Index>(parts.size());
  g.core_reach.setZero(n);
  g.reach.setZero(n);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    shapes.push_back(convex_shape(parts[i].front()));
    if (several) {
      g.place.push_back(parts[i].front().position);
      g.of_shape.push_back(parts[i].front().shape);
    }
  }
  for (std::size_t i = 0; several && i < parts.size(); ++i) {
    g.more.push_back({static_cast<int>(shapes.size()), static_cast<int>(shapes.size() + parts[i].size() - 1)});
    for (std::size_t k = 1; k < parts[i].size(); ++k) {
      shapes.push_back(convex_shape(parts[i][k]));
      g.place.push_back(parts[i][k].position);
      g.of_shape.push_back(parts[i][k].shape);
    }
  }
  g.shapes = convex_shapes(shapes);
  for (BodyIndex i{0}; i < static_cast<int>(n); ++i) {
    g.core_reach[i] = g.shapes.core_radius[g.first_part(i)];
    g.reach[i] = g.shapes.radius[g.first_part(i)];
    if (!g.has_parts(i)) continue;
    g.core_reach[i] = g.reach[i] = 0.0;
    g.each_part(i, [&](ShapeIndex part) {
      const double rounding = g.shapes.most_rounding(part);
      for (int k = 0; k < g.shapes.corners[part]; ++k) {
        const double far = (g.place[part] + g.shapes.corners_of(part)[k].vertex).norm();
        g.core_reach[i] = std::max(g.core_reach[i], far);
        g.reach[i] = std::max(g.reach[i], far + rounding);
      }
    });
  }
}

}  // namespace

Geometry geometry(const std::vector<Body>& bodies, const std::vector<Joint>& joints) {
  const auto n = static_cast<Eigen::Index>(bodies.size());
  Geometry g;
  g.extent.resize(2, n);
  g.size.resize(n);
  std::vector<std::vector<ConvexPart>> parts;
  std::unordered_map<std::string, int> groups;
  for (Eigen::Index i = 0; i < n; ++i) {
    const Body& body = bodies[static_cast<std::size_t>(i)];
    parts.push_back(convex_parts(body.shape));
    const bool infinite_mass = has_infinite_mass(body);
    if (infinite_mass || std::holds_alternative<Disc>(body.shape)) {
      g.extent.col(i) = half_extent(body.shape, body.angle);
    } else {
      g.extent.col(i).setConstant(bounding_radius(body.shape));
    }
    g.size[i] = g.extent.col(i).allFinite() ? g.extent.col(i).sum() : 0.0;
    g.fixed.push_back(infinite_mass ? 1 : 0);
    const int next = static_cast<int>(groups.size());
    g.group.push_back(body.group.empty() ? -1 : groups.try_emplace(body.group, next).first->second);
  }
  std::vector<ConvexShape> shapes;
  add_parts(parts, shapes, g);
  const auto index = joints.empty() ? std::unordered_map<std::string, BodyIndex>{} : bodies_by_name(bodies);
  g.welded = WeldedBodies(bodies.size());
  for (const Joint& joint : joints) {
    if (joint.to.empty()) continue;
    const BodyIndex a = index.at(joint.body);
    const BodyIndex b = index.at(joint.to);
    if (joint.kind == JointKind::kPin) g.pinned.push_back(std::minmax({a, b}));
    if (joint.kind == JointKind::kWeld) g.welded.join(a, b);
  }
  std::sort(g.pinned.begin(), g.pinned.end());
  for (BodyIndex i{0}; i < static_cast<int>(n); ++i) {
    double thin = 0.0;
    g.each_part(i, [&](ShapeIndex part) {
      thin = std::max(thin, g.shapes.most_rounding(part) - g.shapes.rounding[part]);
    });
    g.extent.col(i).array() += thin;
  }
  find_corner_cones(bodies, g);
  return g;
}

}  // namespace carom
