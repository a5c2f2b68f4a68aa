#pragma once

#include <vector>

#include "physics/scene/scene.h"

namespace carom {

// Of a homogeneous shape, per unit of density.
struct AreaMoments {
  double area = 0.0;             // m²
  Vec2 centroid = Vec2::Zero();  // m
  double second = 0.0;           // m⁴, polar moment ∫|x - centroid|² dA: the moment of inertia per density
};

// Exact moments of a convex core grown by a rounding radius r: a counter-clockwise polygon, two vertices for a
// capsule, one for a disc. The area is that of the core, of a rectangle of width r on each edge, and of a
// sector of radius r at each vertex whose angle θ is the one by which the edges turn there. With the edges'
// directions d, their lengths L, and moments about a point c from which all is measured:
//   core       Σ of the triangles (c, p, q): area A = p×q/2, first moment A (p+q)/3, second A (p²+p·q+q²)/6;
//   rectangle  A = L r at the centre m; second A (L²+r²)/12 + A m²;
//   sector     A = θ r²/2; first moment about the vertex v: (r³/3)(d_before - d_after), from ∫ρ² u(φ) dρ dφ
//   with
//              u = -d/dφ of u turned by +90°, and d is the outward normal turned so; second θ r⁴/4 + 2 v·first
//              + A v².
// The second moment is taken about the centroid from the start, so that nothing cancels.
[[nodiscard]] AreaMoments area_moments(const std::vector<Vec2>& core, double rounding);

}  // namespace carom
