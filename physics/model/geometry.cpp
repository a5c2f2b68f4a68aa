#include "physics/model/geometry.h"

#include <cmath>
#include <string>
#include <unordered_map>

namespace carom {
namespace {

ConvexShape convex_shape(const Shape& shape) {
  if (const auto* disc = std::get_if<Disc>(&shape)) return disc_shape(disc->radius);
  if (const auto* box = std::get_if<Box>(&shape)) return box_shape(box->width, box->height);
  const Outline outline = outline_of(shape);
  if (outline.half_plane) return half_plane_shape(Vec2::UnitY(), 0.0);
  if (outline.vertices.size() == 2)
    return segment_shape(outline.vertices[0], outline.vertices[1], outline.rounding);
  return polygon_shape(outline.vertices, outline.rounding);
}

}  // namespace

Geometry geometry(const std::vector<Body>& bodies, const std::vector<Joint>& joints) {
  const auto n = static_cast<Eigen::Index>(bodies.size());
  Geometry g;
  g.extent.resize(2, n);
  g.size.resize(n);
  std::vector<ConvexShape> shapes;
  std::unordered_map<std::string, int> groups;
  for (Eigen::Index i = 0; i < n; ++i) {
    const Body& body = bodies[static_cast<std::size_t>(i)];
    shapes.push_back(convex_shape(body.shape));
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
  g.shapes = convex_shapes(shapes);
  std::unordered_map<std::string, int> index;
  if (!joints.empty()) {
    for (std::size_t i = 0; i < bodies.size(); ++i) index.emplace(bodies[i].name, static_cast<int>(i));
  }
  g.welded.assign(bodies.size(), -1);
  for (const Joint& joint : joints) {
    if (joint.to.empty()) continue;
    const int a = index.at(joint.body);
    const int b = index.at(joint.to);
    if (joint.kind == JointKind::kPin) g.pinned.push_back(std::minmax({a, b}));
    if (joint.kind != JointKind::kWeld) continue;
    // Both bodies and all that are welded to them get one number.
    const int from_a = g.welded[a];
    const int from_b = g.welded[b];
    for (int& number : g.welded) {
      if (number >= 0 && (number == from_a || number == from_b)) number = a;
    }
    g.welded[a] = g.welded[b] = a;
  }
  std::sort(g.pinned.begin(), g.pinned.end());
  return g;
}

}  // namespace carom
