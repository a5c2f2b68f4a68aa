#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace carom {

// Beyond this the contact search would be slow and the shape is better a disc.
inline constexpr int kMostVertices = 16;
// Before repeated ones and those on a line are left out.
inline constexpr int kMostPolygonPoints = 4 * kMostVertices;

// The vertices counter-clockwise, without repeated ones and without those on the line of their neighbours (both
// within 1e-9 of the polygon's extent). What is not convex stays so.
[[nodiscard]] std::vector<Eigen::Vector2d> tidied(std::span<const Eigen::Vector2d> vertices);

// What makes the vertices no convex polygon with this rounding, in words: "..., allowed: ..."; nothing if they
// are one. Two distinct vertices are one if they are rounded: a capsule.
[[nodiscard]] std::optional<std::string> fault_of(std::span<const Eigen::Vector2d> vertices, double rounding);

// The moments of a homogeneous plate.
struct PlateMoments {
  double area = 0.0;                                   // m²
  Eigen::Vector2d centroid = Eigen::Vector2d::Zero();  // m
  double second_moment = 0.0;                          // m⁴, polar, about the centroid
};

// Of a tidied convex polygon of at least two vertices (m), grown by `rounding` (m, >= 0). It is the sum of the
// polygon, by Green's theorem over its edges, of a rectangle on each edge and of a sector about each vertex.
[[nodiscard]] PlateMoments moments_of(std::span<const Eigen::Vector2d> vertices, double rounding);

}  // namespace carom
