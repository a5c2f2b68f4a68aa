#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "physics/collision/contact.h"
#include "physics/model/convex.h"
#include "physics/model/geometry.h"

// Distance and contacts of two convex bodies, one of which may be a half-plane.
namespace carom {

// The signed distance of two bodies, the greatest separation along any direction: the distance of their
// surfaces, or minus the penetration depth (the shortest translation that separates them). Its error is a few
// ulp of the bodies' sizes and distance.
struct Gap {
  double gap;   // m
  Vec2 normal;  // unit, from a to b; +x for discs whose centres coincide
};

[[nodiscard]] Gap gap_between(const ConvexShapes& shapes, ShapeIndex a, const Pose& pose_a, ShapeIndex b,
                              const Pose& pose_b);

// The same with a contact point. Between touching faces that are parallel (to 1e-9), it is the middle
// of the stretch that they share. A disc inside a box is separated through the nearest face.
[[nodiscard]] Contact contact_between(const ConvexShapes& shapes, ShapeIndex a, const Pose& pose_a,
                                      ShapeIndex b, const Pose& pose_b);

// The same of two discs whose centres are here, in m.
[[nodiscard]] inline Contact contact_of_discs(const ConvexShapes& shapes, ShapeIndex a, const Vec2& at_a,
                                              ShapeIndex b, const Vec2& at_b) {
  const Vec2 d = at_b - at_a;
  const double distance = d.norm();
  const Vec2 normal = distance > 0.0 ? Vec2(d / distance) : Vec2(Vec2::UnitX());
  const double gap = distance - (shapes.rounding[a] + shapes.rounding[b]);
  return {gap, normal, at_b - (shapes.rounding[b] + 0.5 * gap) * normal};
}

// For bodies a and b, at a pose or at q = (x, y, angle): of their nearest parts.
[[nodiscard]] Contact contact_between(const Geometry& g, BodyIndex a, const Pose& pose_a, BodyIndex b,
                                      const Pose& pose_b);
[[nodiscard]] Contact contact_between(const Geometry& g, BodyIndex a, const Eigen::Vector3d& qa, BodyIndex b,
                                      const Eigen::Vector3d& qb);
// For the parts that an earlier contact had.
[[nodiscard]] Contact contact_again(const Geometry& g, BodyIndex a, const Pose& pose_a, BodyIndex b,
                                    const Pose& pose_b, const Contact& earlier);

// One point of a manifold.
struct ManifoldPoint {
  Vec2 point = Vec2::Zero();  // m, half-way between the surfaces
  double gap = 0.0;           // m, along the manifold's normal
  std::uint32_t id = 0;       // stays the same from step to step while the same features touch
};

// The contact points of two bodies, along one normal: both ends of the stretch that two faces share, or one
// point.
struct Manifold {
  Vec2 normal = Vec2::UnitX();  // unit, from a to b
  int count = 0;
  std::array<ManifoldPoint, 2> points;
  ShapePair parts = {};  // as in Contact

  [[nodiscard]] Contact contact(int k) const {
    const ManifoldPoint& at = points[static_cast<std::size_t>(k)];
    return {at.gap, normal, at.point, parts};
  }
};

// Points with a gap above `margin` (m) are left out; bodies whose bounding circles are farther apart cost
// next to nothing. Normal and least gap are those of gap_between, with one exception: if two corners are
// nearest but the faces beside them share a stretch, as in a stack of equal boxes whose edges are not quite
// flush, the normal is that of the face with the greatest separation, not the slanted one from corner to
// corner. The gaps along it are at most the distance.
//
// An edge of a and the edge of b that faces it most are clipped against each other along the tangent. A
// point's id names the two edges and the end of the stretch, not whose corner that end is or whose edge gave
// the normal. So it survives rocking, where the normal changes sides, and stacks of equal boxes, where
// rounding decides the order of the corners. No memory of earlier steps is needed. (Edge against edge as in
// E. Catto, Computing Contact Manifolds, GDC 2007, which keeps reference and incident edge in the id.)
[[nodiscard]] Manifold manifold(const ConvexShapes& shapes, ShapeIndex a, const Pose& pose_a, ShapeIndex b,
                                const Pose& pose_b, double margin);

// The ids of points tell the parts of bodies of several apart: above those bits that name features.
inline constexpr unsigned kFeatureBits = 10;
inline constexpr unsigned kPartBits = 11;

[[nodiscard]] inline std::uint32_t parts_of(std::uint32_t id) { return id >> kFeatureBits; }
// Which shapes of the two bodies, from 0 on.
[[nodiscard]] inline std::pair<std::uint32_t, std::uint32_t> part_numbers(std::uint32_t id) {
  return {id >> kFeatureBits & ((1U << kPartBits) - 1U), id >> (kFeatureBits + kPartBits)};
}

// Of two parts.
[[nodiscard]] Manifold manifold(const Geometry& g, BodyIndex a, ShapeIndex part_a, const Pose& pose_a,
                                BodyIndex b, ShapeIndex part_b, const Pose& pose_b, double margin);
// The parts of a and b that a point of this id belongs to.
[[nodiscard]] ShapePair parts_at(const Geometry& g, BodyIndex a, BodyIndex b, std::uint32_t id);
// Of those parts.
[[nodiscard]] Manifold manifold_of(const Geometry& g, BodyIndex a, const Pose& pose_a, BodyIndex b,
                                   const Pose& pose_b, std::uint32_t id, double margin);
// Calls visit(manifold) for each two parts of a and b that have points.
template <class Visit>
void each_manifold(const Geometry& g, BodyIndex a, const Pose& pose_a, BodyIndex b, const Pose& pose_b,
                   double margin, const Visit& visit) {
  g.each_parts(a, b, [&](ShapeIndex part_a, ShapeIndex part_b) {
    const Manifold m = manifold(g, a, part_a, pose_a, b, part_b, pose_b, margin);
    if (m.count > 0) visit(m);
  });
}

}  // namespace carom
