#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace carom {

// With more vertices the contact search would be slow, and a disc is the better shape.
inline constexpr int kMostVertices = 16;
// Before repeated and collinear points are dropped.
inline constexpr int kMostPolygonPoints = 4 * kMostVertices;

// The vertices counter-clockwise, without repeated and collinear ones (both within 1e-9 of the polygon's
// extent). A polygon that is not convex stays so.
[[nodiscard]] std::vector<Eigen::Vector2d> tidied(std::span<const Eigen::Vector2d> vertices);

// Why the vertices are not a convex polygon with this rounding, as text: "..., allowed: ..."; nothing if they
// are. Two distinct vertices are allowed if they are rounded: a capsule.
[[nodiscard]] std::optional<std::string> fault_of(std::span<const Eigen::Vector2d> vertices, double rounding);

// The moments of a homogeneous plate.
struct PlateMoments {
  double area = 0.0;                                   // m²
  Eigen::Vector2d centroid = Eigen::Vector2d::Zero();  // m
  double second_moment = 0.0;                          // m⁴, polar, about the centroid
};

// Moments of a tidied convex polygon of at least two vertices (m), grown by `rounding` (m, >= 0): the sum of
// the polygon, by Green's theorem over its edges, of a rectangle on each edge and of a sector about each
// vertex.
[[nodiscard]] PlateMoments moments_of(std::span<const Eigen::Vector2d> vertices, double rounding);

}  // namespace carom
