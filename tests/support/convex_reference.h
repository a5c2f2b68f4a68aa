#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "physics/model/convex.h"

// Random convex shapes, and slow but simple reference results for pairs of them.
namespace carom::test {

inline constexpr ShapeIndex kFirst{0};
inline constexpr ShapeIndex kSecond{1};
inline constexpr ShapeIndex kThird{2};

inline double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
}

enum class ShapeKind { kDisc, kBox, kPolygon, kRoundedPolygon, kCapsule, kSegment, kHalfPlane };
inline constexpr int kShapeKinds = 7;
inline const char* const kShapeNames[kShapeKinds] = {"disc",    "box",     "polygon",   "rounded polygon",
                                                     "capsule", "segment", "half-plane"};

// On an ellipse, so that every vertex is a corner: from nearly regular polygons to needles.
inline std::vector<Vec2> random_polygon(std::mt19937_64& random) {
  const int n = 3 + static_cast<int>(random() % (kMostVertices - 2));
  const Vec2 half(uniform(random, 0.1, 1.0), uniform(random, 0.1, 1.0));
  std::vector<Vec2> vertices;
  const double turn = uniform(random, 0.0, 6.0);
  for (int k = 0; k < n; ++k) {
    const double angle = turn + 2.0 * std::numbers::pi * (k + uniform(random, -0.45, 0.45)) / n;
    vertices.emplace_back(half.x() * std::cos(angle), half.y() * std::sin(angle));
  }
  return vertices;
}

inline ConvexShape random_shape(std::mt19937_64& random, ShapeKind kind) {
  switch (kind) {
    case ShapeKind::kDisc:
      return disc_shape(random() % 8 == 0 ? 0.0 : uniform(random, 0.05, 1.0));
    case ShapeKind::kBox:
      return box_shape(uniform(random, 0.05, 2.0), uniform(random, 0.05, 2.0));
    case ShapeKind::kPolygon:
      return polygon_shape(random_polygon(random));
    case ShapeKind::kRoundedPolygon:
      return random() % 2 == 0 ? polygon_shape(random_polygon(random), uniform(random, 0.01, 0.5))
                               : box_shape(uniform(random, 0.05, 2.0), uniform(random, 0.05, 2.0),
                                           uniform(random, 0.01, 0.5));
    case ShapeKind::kCapsule:
    case ShapeKind::kSegment: {
      const Vec2 half(uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0));
      return segment_shape(-half, half, kind == ShapeKind::kCapsule ? uniform(random, 0.01, 0.5) : 0.0);
    }
    case ShapeKind::kHalfPlane: {
      const double angle = uniform(random, 0.0, 6.3);
      return half_plane_shape({std::cos(angle), std::sin(angle)}, uniform(random, -0.5, 0.5));
    }
  }
  return {};
}

// One body in the world, in extended precision.
using Real = long double;
struct Point {
  Real x, y;
};
struct Outline {
  std::vector<Point> vertices;
  std::vector<Point> normals;  // outward, of the edges; both sides of a segment
  Real rounding = 0.0L;
  bool half_plane = false;
  Point origin{0.0L, 0.0L};
};

inline Outline outline(const ConvexShape& shape, const Eigen::Vector3d& q) {
  const Real c = std::cos(static_cast<Real>(q[2]));
  const Real s = std::sin(static_cast<Real>(q[2]));
  Outline o;
  o.rounding = shape.rounding;
  o.origin = {q[0], q[1]};
  o.half_plane = shape.core == Core::kHalfPlane;
  for (const Vec2& v : shape.vertices) {
    o.vertices.push_back({q[0] + c * v.x() - s * v.y(), q[1] + s * v.x() + c * v.y()});
  }
  if (o.half_plane) {
    o.normals.push_back(
        {c * shape.normal.x() - s * shape.normal.y(), s * shape.normal.x() + c * shape.normal.y()});
    return o;
  }
  const std::size_t n = o.vertices.size();
  for (std::size_t k = 0; n > 1 && k < n; ++k) {
    const Point& p = o.vertices[k];
    const Point& r = o.vertices[(k + 1) % n];
    const Real length = std::hypot(r.x - p.x, r.y - p.y);
    o.normals.push_back({(r.y - p.y) / length, (p.x - r.x) / length});
  }
  return o;
}

// m: of the circle about its frame's origin that contains its core.
inline Real core_radius(const Outline& o) {
  Real radius = 0.0L;
  for (const Point& p : o.vertices) radius = std::max(radius, std::hypot(p.x - o.origin.x, p.y - o.origin.y));
  return radius;
}

// Two that have no inside reach each other before they touch: by 1e-9 of their sizes, two segments by 4e-5 of
// twice the smaller size; or by their roundings if those are larger.
inline void grow_thin(Outline& a, Outline& b) {
  const auto is_thin = [](const Outline& o) { return o.vertices.size() <= 2 && !o.half_plane; };
  if (!is_thin(a) || !is_thin(b)) return;
  const Real size_a = core_radius(a);
  const Real size_b = core_radius(b);
  const Real of_segments = a.vertices.size() == 2 && b.vertices.size() == 2 ? 4e-5L : 0.0L;
  const Real missing = std::max(1e-9L * (size_a + size_b), 2.0L * of_segments * std::min(size_a, size_b)) -
                       (a.rounding + b.rounding);
  if (!(missing > 0.0L)) return;
  a.rounding += 0.5L * missing;
  b.rounding += 0.5L * missing;
}

// The smallest n·(x_b - x_a), by definition.
inline Real separation_along(const Outline& a, const Outline& b, const Point& n) {
  Real least = std::numeric_limits<Real>::infinity();
  for (const Point& p : a.vertices) {
    for (const Point& q : b.vertices) least = std::min(least, n.x * (q.x - p.x) + n.y * (q.y - p.y));
  }
  return least - a.rounding - b.rounding;
}

inline Real distance_to_segment(const Point& x, const Point& p, const Point& q) {
  const Real dx = q.x - p.x;
  const Real dy = q.y - p.y;
  const Real length = dx * dx + dy * dy;
  const Real t =
      length > 0.0L ? std::clamp(((x.x - p.x) * dx + (x.y - p.y) * dy) / length, 0.0L, 1.0L) : Real(0.0L);
  return std::hypot(x.x - p.x - t * dx, x.y - p.y - t * dy);
}

// The distance of two cores over all pairs of a vertex and an edge, both ways.
inline Real core_distance(const Outline& a, const Outline& b) {
  Real least = std::numeric_limits<Real>::infinity();
  const auto each = [&](const Outline& of_vertices, const Outline& of_edges) {
    const std::size_t n = of_edges.vertices.size();
    for (const Point& x : of_vertices.vertices) {
      for (std::size_t k = 0; k < n; ++k) {
        least = std::min(least, distance_to_segment(x, of_edges.vertices[k], of_edges.vertices[(k + 1) % n]));
      }
    }
  };
  each(a, b);
  each(b, a);
  return least;
}

// The largest separation along the edges' normals (those of a and of b, where a's outside is -n for b).
inline Real core_penetration(const Outline& a, const Outline& b) {
  Real most = -std::numeric_limits<Real>::infinity();
  for (const Point& n : a.normals) most = std::max(most, separation_along(a, b, n));
  for (const Point& n : b.normals) most = std::max(most, separation_along(a, b, {-n.x, -n.y}));
  return most + a.rounding + b.rounding;
}

// The signed gap. Cores overlap if no edge separates them; two points, a point and a segment, or two
// collinear segments always have a distance.
inline Real reference_gap(const Outline& a, const Outline& b) {
  if (a.half_plane) return separation_along(a, b, a.normals[0]);
  if (b.half_plane) return separation_along(a, b, {-b.normals[0].x, -b.normals[0].y});
  const Real rounding = a.rounding + b.rounding;
  const Real overlap = core_penetration(a, b);
  const bool flat = a.vertices.size() <= 2 && b.vertices.size() <= 2;
  if (overlap > 0.0L || a.normals.empty() + b.normals.empty() == 2) return core_distance(a, b) - rounding;
  if (flat && overlap > -1e-18L) return core_distance(a, b) - rounding;
  return overlap - rounding;
}

// m: the scale of a gap's rounding: the sizes and the distance of both bodies' frames.
inline double scale_of(const Outline& a, const Outline& b) {
  Real most = a.rounding + b.rounding + std::hypot(a.origin.x - b.origin.x, a.origin.y - b.origin.y);
  return static_cast<double>(most + core_radius(a) + core_radius(b));
}

}  // namespace carom::test
