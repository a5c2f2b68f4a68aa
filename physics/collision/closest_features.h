#pragma once

#include <array>
#include <optional>

#include "physics/model/convex.h"

namespace carom {

// Two cores in the frame of the first, so that the rounding of a gap depends only on the bodies' sizes and
// distance, not on their place in the world. Not for half-planes.
struct PairFrame {
  const Corner* a;  // with its edges; a point has none
  const Corner* b;
  int edges_a;
  int edges_b;
  double scale;                            // m, of the coordinates here
  double size;                             // m, that of the smaller core (pair_size), at most the scale
  Pose relative;                           // of b
  std::array<Vec2, kMostVertices> vertex;  // of b, in the frame of a
  std::array<Vec2, kMostVertices> normal;

  PairFrame(const ConvexShapes& shapes, ShapeIndex i, const Pose& pose_a, ShapeIndex j, const Pose& pose_b);
};

// The nearest features of two cores: a vertex and an edge, or two vertices. For penetrating cores, the edge
// of least penetration and its vertex.
struct ClosestFeatures {
  double separation;  // m, signed
  Vec2 normal;        // from a to b, in the frame of a
  int edge_a;         // -1 if it is a vertex
  int edge_b;
  int vertex_a;  // the vertex, or the start of the edge
  int vertex_b;
};

// Uses the Minkowski sum of b and -a, the set of all x_b - x_a: its distance to the origin is the distance of
// the cores, and the depth of the origin in it is the penetration. Its edges are those of b and of -a in the
// order of their directions (de Berg et al., Computational Geometry, section 13.3), so all cases are exact
// and take time linear in the number of edges. Of several edges of least penetration within rounding, those
// of a go before those of b. At least one of the cores must have edges.
//
// Where two corners meet, an edge of either may part the bodies, and noise would change the normal from one to
// the other. With a `tie` (relative to the size) above rounding, an edge of a is taken there if it parts them
// worse by no more than that.
[[nodiscard]] ClosestFeatures closest_features(const PairFrame& frame, double tie = 0.0);

// Corners of two cores that have gone into each other tip to tip: several edges of least penetration, within
// rounding, with the tips behind each other along the middle of their normals. Nothing if the cores do not
// overlap by more than rounding.
struct OverlappingTips {
  Vec2 normal;  // from a to b, in the frame of a
  int vertex_a;
  int vertex_b;
};
[[nodiscard]] std::optional<OverlappingTips> overlapping_tips(const PairFrame& frame);

// The edge with the greatest separation: that of closest_features, unless two vertices are nearest.
[[nodiscard]] ClosestFeatures parting_edge(const PairFrame& frame, double tie = 0.0);

}  // namespace carom
