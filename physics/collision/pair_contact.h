#pragma once

#include <array>
#include <cstdint>

#include "physics/collision/contact.h"
#include "physics/collision/convex.h"

// How two convex bodies lie to each other. Body b may be a half-plane or a may be, not both.
namespace carom {

// The signed distance of two bodies, the greatest separation along any direction: the distance of their
// surfaces, or minus the shortest way that parts them. Its error is a few ulp of the bodies' sizes and
// distance.
struct Gap {
  double gap;   // m
  Vec2 normal;  // unit, from a to b; +x for discs whose centres coincide
};

[[nodiscard]] Gap gap_between(const ConvexShapes& shapes, int a, const Pose& pose_a, int b, const Pose& pose_b);

// The same with a contact point. Where two faces touch that are parallel within rounding, it is the middle of
// the stretch that they share. A disc in a box leaves by the nearest face.
[[nodiscard]] Contact contact_between(const ConvexShapes& shapes, int a, const Pose& pose_a, int b,
                                      const Pose& pose_b);

// One point of a manifold.
struct ManifoldPoint {
  Vec2 point;        // m, half-way between the surfaces
  double gap;        // m, along the manifold's normal
  std::uint32_t id;  // stays the same from step to step while the same features touch
};

// The points at which two bodies hold each other, along one normal: both ends of the stretch that two faces
// share, or one point.
struct Manifold {
  Vec2 normal = Vec2::UnitX();  // unit, from a to b
  int count = 0;
  std::array<ManifoldPoint, 2> points;
};

// Points with a gap of more than `margin` (m) are left out; bodies whose bounding circles are farther apart
// cost next to nothing. The normal is that of gap_between; the smallest gap is the one of gap_between where
// cores are apart or overlap by less than rounding, and no less elsewhere.
//
// An edge of a and the edge of b that faces it most are clipped against each other along the tangent. A point's
// id names the two edges and which end of the stretch it is, not whose corner ends the stretch there nor whose
// edge gave the normal: so it survives rocking, where the normal changes sides, and stacks of equal boxes,
// where the corners' order is a matter of rounding. No memory of earlier steps is needed. (Edge against edge as
// in E. Catto, Computing Contact Manifolds, GDC 2007, which keeps reference and incident edge in the id.)
[[nodiscard]] Manifold manifold(const ConvexShapes& shapes, int a, const Pose& pose_a, int b,
                                const Pose& pose_b, double margin);

}  // namespace carom
