#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "physics/math/vectors.h"

// Polygons as lists of vertices in m.
namespace carom {

// Beyond this the contact search would be slow and the shape is better a disc.
inline constexpr int kMostVertices = 16;
// Before repeated ones and those on a line are left out.
inline constexpr int kMostPolygonPoints = 4 * kMostVertices;

// The vertices counter-clockwise, without repeated ones and without those on the line of their neighbours (both
// within 1e-9 of the polygon's extent). What is not convex stays so.
[[nodiscard]] std::vector<Vec2> tidied(std::span<const Vec2> vertices);

// What makes the vertices no polygon with this rounding, in words: "..., allowed: ..."; nothing if they are
// one. Two distinct vertices are one if they are rounded: a capsule.
[[nodiscard]] std::optional<std::string> fault_of(std::span<const Vec2> vertices, double rounding);

// Whether the edge from the last corner of a chain to `next` shares more with the chain than that corner.
[[nodiscard]] bool crosses(std::span<const Vec2> chain, const Vec2& next);

// The moments of a homogeneous plate.
struct PlateMoments {
  double area = 0.0;             // m²
  Vec2 centroid = Vec2::Zero();  // m
  double second_moment = 0.0;    // m⁴, polar, about the centroid
};

// Of a tidied polygon of at least two vertices (m), grown by `rounding` (m, >= 0). It is the sum of the
// polygon, by Green's theorem over its edges, of a rectangle on each edge and of a sector about each vertex.
[[nodiscard]] PlateMoments moments_of(std::span<const Vec2> vertices, double rounding);

// The convex hull, counter-clockwise, without points inside its edges.
[[nodiscard]] std::vector<Vec2> convex_hull(std::vector<Vec2> points);

// Strictly convex polygons of at most kMostVertices vertices that a tidied polygon without crossing edges is
// made of: one if it is convex. Ears are clipped and then joined along diagonals that no corner needs (Hertel
// and Mehlhorn, 1983): at most four times as many as need be.
[[nodiscard]] std::vector<std::vector<Vec2>> convex_pieces(const std::vector<Vec2>& vertices);

}  // namespace carom
