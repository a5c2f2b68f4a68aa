#include "physics/model/convex.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "physics/math/vectors.h"
#include "physics/model/pair_size.h"

namespace carom {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// How far the core of shape i reaches along n from its body's origin, in m. For a half-plane n must be its
// normal.
double reach(const ConvexShapes& shapes, ShapeIndex i, const Pose& pose, const Vec2& n) {
  const Vec2 own = pose.turned_back(n);
  const Corner* corner = shapes.corners_of(i);
  double most = own.dot(corner[0].vertex);
  for (int k = 1; k < shapes.corners[i]; ++k) most = std::max(most, own.dot(corner[k].vertex));
  return most;
}

}  // namespace

ConvexShapes::Roundings ConvexShapes::thin_roundings(ShapeIndex a, ShapeIndex b) const {
  double least = kThin * (core_radius[a] + core_radius[b]);
  if (core[a] == Core::kSegment && core[b] == Core::kSegment)
    least = std::max(least, kThinWalls * pair_size(core_radius[a], core_radius[b]));
  const double more = 0.5 * std::max(least - (rounding[a] + rounding[b]), 0.0);
  return {rounding[a] + more, rounding[b] + more};
}

ConvexShape disc_shape(double radius) { return {Core::kPoint, {Vec2::Zero()}, radius, Vec2::Zero()}; }

ConvexShape box_shape(double width, double height, double rounding) {
  const double x = 0.5 * width;
  const double y = 0.5 * height;
  return {Core::kBox, {Vec2(-x, -y), Vec2(x, -y), Vec2(x, y), Vec2(-x, y)}, rounding, Vec2::Zero()};
}

ConvexShape segment_shape(const Vec2& from, const Vec2& to, double rounding) {
  return {Core::kSegment, {from, to}, rounding, Vec2::Zero()};
}

ConvexShape polygon_shape(std::vector<Vec2> vertices, double rounding) {
  return {Core::kPolygon, std::move(vertices), rounding, Vec2::Zero()};
}

ConvexShape half_plane_shape(const Vec2& normal, double offset) {
  return {Core::kHalfPlane, {offset * normal}, 0.0, normal};
}

ConvexShapes convex_shapes(const std::vector<ConvexShape>& shapes) {
  ConvexShapes all;
  for (const ConvexShape& shape : shapes) {
    std::vector<Vec2> v = shape.vertices;
    assert(!v.empty() && static_cast<int>(v.size()) <= kMostVertices);
    if (shape.core == Core::kSegment) v = {v[0], v[1], v[1], v[0]};
    all.first.push_back(static_cast<int>(all.corner.size()));
    all.corners.push_back(static_cast<int>(v.size()));
    all.core.push_back(shape.core);
    all.rounding.push_back(shape.rounding);
    double radius = 0.0;
    for (std::size_t k = 0; k < v.size(); ++k) {
      const Vec2 along = v[(k + 1) % v.size()] - v[k];
      const double length = along.norm();
      Vec2 normal = shape.normal;
      if (length > 0.0) normal = Vec2(along.y(), -along.x()) / length;
      all.corner.push_back({v[k], normal, length});
      radius = std::max(radius, v[k].norm());
    }
    if (shape.core == Core::kSegment) {
      Corner* corner = all.corner.data() + all.first.back();
      const Vec2 along = (v[1] - v[0]) / corner[0].length;
      corner[1].normal = along;
      corner[3].normal = -along;
    }
    if (shape.core == Core::kHalfPlane) radius = kInfinite;
    all.core_radius.push_back(radius);
    all.radius.push_back(radius + all.most_rounding(ShapeIndex{static_cast<int>(all.core.size()) - 1}));
  }
  return all;
}

Bounds bounds_of(const ConvexShapes& shapes, ShapeIndex i, const Pose& pose) {
  if (shapes.core[i] == Core::kHalfPlane) {
    Bounds all{Eigen::Array2d::Constant(-kInfinite), Eigen::Array2d::Constant(kInfinite)};
    const Corner& edge = *shapes.corners_of(i);
    const Vec2 n = pose.turned(edge.normal);
    const Vec2 x = pose.position + pose.turned(edge.vertex);
    for (const int axis : {0, 1}) {
      if (n[1 - axis] == 0.0) (n[axis] > 0.0 ? all.high : all.low)[axis] = x[axis];
    }
    return all;
  }
  const Vec2 high(reach(shapes, i, pose, Vec2::UnitX()), reach(shapes, i, pose, Vec2::UnitY()));
  const Vec2 low(reach(shapes, i, pose, -Vec2::UnitX()), reach(shapes, i, pose, -Vec2::UnitY()));
  const Vec2 rounding = Vec2::Constant(shapes.rounding[i]);
  return {pose.position - (low + rounding), pose.position + (high + rounding)};
}

double separation(const ConvexShapes& shapes, ShapeIndex a, const Pose& pose_a, ShapeIndex b,
                  const Pose& pose_b, const Vec2& n) {
  const auto [rounding_a, rounding_b] = shapes.roundings(a, b);
  return n.dot(pose_b.position - pose_a.position) - (reach(shapes, a, pose_a, n) + rounding_a) -
         (reach(shapes, b, pose_b, -n) + rounding_b);
}

double apart_until(const ConvexShapes& shapes, ShapeIndex a, const Pose& pose_a, const Twist& twist_a,
                   ShapeIndex b, const Pose& pose_b, const Twist& twist_b, const Vec2& n, double curvature) {
  const Vec2 own_a = pose_a.turned_back(n);
  const Vec2 own_b = pose_b.turned_back(n);
  const auto [rounding_a, rounding_b] = shapes.roundings(a, b);
  const double apart = n.dot(pose_b.position - pose_a.position) - rounding_a - rounding_b;
  const double approach = n.dot(twist_b.velocity - twist_a.velocity);
  double until = kInfinite;
  for (int j = 0; j < shapes.corners[b]; ++j) {
    const Vec2& q = shapes.corners_of(b)[j].vertex;
    for (int i = 0; i < shapes.corners[a]; ++i) {
      const Vec2& p = shapes.corners_of(a)[i].vertex;
      const double f0 = std::max(0.0, apart + own_b.dot(q) - own_a.dot(p));
      // n·(ω × r) = ω (r × n), in each body's own frame.
      const double f1 = approach + twist_b.spin * cross(q, own_b) - twist_a.spin * cross(p, own_a);
      // The positive root of f0 + f1 t - K t²/2, in the form without cancellation.
      const double root = std::sqrt(f1 * f1 + 2.0 * curvature * f0);
      double time = kInfinite;
      if (f1 < 0.0) {
        time = 2.0 * f0 / (root - f1);
      } else if (curvature > 0.0) {
        time = (f1 + root) / curvature;
      }
      if (f0 == 0.0 && f1 <= 0.0) time = 0.0;
      until = std::min(until, time);
    }
  }
  return until;
}

}  // namespace carom
