#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "physics/math/bounds.h"
#include "physics/math/vectors.h"
#include "physics/model/index.h"
#include "physics/scene/scene.h"
#include "physics/scene/shape.h"

// Collision shapes: a convex core grown by a rounding radius, or a half-plane. Queries of a pair
// (contact_between, manifold) are in pair_contact.h.
namespace carom {

enum class Core : std::uint8_t {
  kPoint,     // a disc, or a point-like body without rounding; always at the body's origin
  kSegment,   // two vertices: a capsule, or a thin wall without rounding
  kBox,       // a rectangle along the body's axes, centred at its origin
  kPolygon,   // three vertices or more, counter-clockwise
  kHalfPlane  // all points x with normal·x <= normal·vertex; no rounding; it may move, but not turn
};

// One shape in its body's frame, whose origin is the centre of mass.
struct ConvexShape {
  Core core = Core::kPoint;
  std::vector<Vec2> vertices = {Vec2::Zero()};  // m, strictly convex; of a half-plane one point of its edge
  double rounding = 0.0;                        // m, >= 0
  Vec2 normal = Vec2::Zero();                   // unit, outward; half-plane only
};

[[nodiscard]] ConvexShape disc_shape(double radius);
[[nodiscard]] ConvexShape box_shape(double width, double height, double rounding = 0.0);
// The two ends must differ.
[[nodiscard]] ConvexShape segment_shape(const Vec2& from, const Vec2& to, double rounding = 0.0);
// 3 to kMostVertices vertices as tidied() gives them (physics/scene/shape.h).
[[nodiscard]] ConvexShape polygon_shape(std::vector<Vec2> vertices, double rounding = 0.0);
// Solid where normal·x <= offset; `normal` is a unit vector.
[[nodiscard]] ConvexShape half_plane_shape(const Vec2& normal, double offset);

// A vertex, and the edge that starts there.
struct Corner {
  Vec2 vertex;    // m, in the body's frame
  Vec2 normal;    // outward normal of the edge
  double length;  // m, of the edge; 0 at the ends of a segment
};

// Outward normals at a corner that others meet: those between the faces before and after it which are left
// bare, its own or those of others flush with it. Where all of them together are flat or reentrant, only the
// bare faces have normals; one that is covered is zero.
struct CornerCone {
  Vec2 last;
  Vec2 next;
  bool reentrant = false;
};

// The shapes of N bodies as arrays. Body i has the corners first[i] ... first[i] + corners[i] - 1 of
// `corner`. A segment is stored as a rectangle of zero width: four corners v0 v1 v1 v0, with an edge of its
// length on each side and an edge of zero length at each end. So every core but a point has edges that turn
// by less than 180°.
struct ConvexShapes {
  std::vector<Corner> corner;
  ArrayOf<ShapeIndex, int> first;
  ArrayOf<ShapeIndex, int> corners;
  ArrayOf<ShapeIndex, Core> core;
  ArrayOf<ShapeIndex, double> rounding;  // m
  // m, of the circle about the origin that contains the core; 0 for a disc.
  ArrayOf<ShapeIndex, double> core_radius;
  // m, of the circle that contains the body with its largest rounding; infinite for a half-plane.
  ArrayOf<ShapeIndex, double> radius;

  // What has no inside would pass through another such: a particle through a thin wall by the rounding of its
  // place, a thin wall through another one also by the error of the forces that hold one of its ends while
  // the other one lands. So their roundings add up to these shares of the
  // sum of their core radii, and of pair_size() of those.
  static constexpr double kThin = 1e-9;
  static constexpr double kThinWalls = 4e-5;
  [[nodiscard]] bool has_inside(ShapeIndex i) const {
    return core[i] != Core::kPoint && core[i] != Core::kSegment;
  }
  // With which two shapes touch each other, in m.
  struct Roundings {
    double a;
    double b;
    [[nodiscard]] double sum() const { return a + b; }
  };
  [[nodiscard]] Roundings roundings(ShapeIndex a, ShapeIndex b) const {
    if (has_inside(a) || has_inside(b)) return {rounding[a], rounding[b]};
    return thin_roundings(a, b);
  }
  [[nodiscard]] Roundings thin_roundings(ShapeIndex a, ShapeIndex b) const;
  // The largest one with which it touches any other shape, in m.
  [[nodiscard]] double most_rounding(ShapeIndex i) const {
    return has_inside(i) ? rounding[i] : std::max(rounding[i], kThinWalls * core_radius[i]);
  }

  std::vector<int> cone_of;  // of `cones`, by corner; -1: only its own part is there. Empty where that is all
  std::vector<CornerCone> cones;

  // That of corner k of a part in its frame.
  [[nodiscard]] CornerCone cone_at(ShapeIndex i, int k) const {
    const int cone = cone_of.empty() ? -1 : cone_of[static_cast<std::size_t>(first[i] + k)];
    if (cone >= 0) return cones[static_cast<std::size_t>(cone)];
    const Corner* of = corners_of(i);
    return {of[k == 0 ? corners[i] - 1 : k - 1].normal, of[k].normal, false};
  }
  [[nodiscard]] const Corner* corners_of(ShapeIndex i) const { return corner.data() + first[i]; }
  // Number of edges in the contact search: none for a point.
  [[nodiscard]] int edges(ShapeIndex i) const { return core[i] == Core::kPoint ? 0 : corners[i]; }
};

[[nodiscard]] ConvexShapes convex_shapes(const std::vector<ConvexShape>& shapes);

// Position and direction of a body, with the sine and cosine of its angle.
struct Pose {
  Vec2 position = Vec2::Zero();  // m
  double cos = 1.0;
  double sin = 0.0;

  // Turns a vector from the body's frame to the world's, and back.
  [[nodiscard]] Vec2 turned(const Vec2& v) const {
    return {cos * v.x() - sin * v.y(), sin * v.x() + cos * v.y()};
  }
  [[nodiscard]] Vec2 turned_back(const Vec2& v) const {
    return {cos * v.x() + sin * v.y(), -sin * v.x() + cos * v.y()};
  }
};

// The pose of body i at q = (x, y, angle). A disc's angle is ignored: nothing depends on it.
[[nodiscard]] inline Pose pose_of(const ConvexShapes& shapes, ShapeIndex i, const Eigen::Vector3d& q) {
  if (shapes.core[i] == Core::kPoint) return {q.head<2>(), 1.0, 0.0};
  const Vec2 along = direction_at(q[2]);
  return {q.head<2>(), along.x(), along.y()};
}

// The axis-aligned bounding rectangle of a body in m. That of a half-plane is infinite, except beyond an edge
// that is parallel to an axis.
[[nodiscard]] Bounds bounds_of(const ConvexShapes& shapes, ShapeIndex i, const Pose& pose);

// The distance of a and b along a fixed unit vector n, in m: the least n·(x_b - x_a) over all points of both.
// It is at most the gap for every n, and equals the gap along the contact normal. A half-plane is unbounded
// except along its normal: n must be its normal, or the opposite if it is b.
[[nodiscard]] double separation(const ConvexShapes& shapes, ShapeIndex a, const Pose& pose_a, ShapeIndex b,
                                const Pose& pose_b, const Vec2& n);

// Velocity of a body: of its centre in m/s, and its spin in rad/s.
struct Twist {
  Vec2 velocity = Vec2::Zero();
  double spin = 0.0;
};

// A time (s from now, may be infinite) before which a and b cannot penetrate along n; their gap counts as
// closed now. While they separate at the contact with normal n, no vertex can return earlier. It is 0 if a
// touching vertex does not separate. `curvature` is that of first_contact. From n·(x_q - x_p) >= max(0, f0) +
// f1 t - curvature t²/2 for each pair of vertices p, q.
[[nodiscard]] double apart_until(const ConvexShapes& shapes, ShapeIndex a, const Pose& pose_a,
                                 const Twist& twist_a, ShapeIndex b, const Pose& pose_b, const Twist& twist_b,
                                 const Vec2& n, double curvature);

// Curvature bound in m/s² for the path of a core vertex about its centre: (ω² + |α|) r. Zero for a disc,
// whose vertex is the centre. `core_reach` in m.
[[nodiscard]] inline double turning_curvature(double core_reach, double spin, double angular_acceleration) {
  return (spin * spin + std::abs(angular_acceleration)) * core_reach;
}

}  // namespace carom
