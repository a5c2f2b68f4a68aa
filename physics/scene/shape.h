#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "physics/math/vectors.h"

namespace carom {

// The shapes of bodies, in the body's own frame. The centre of mass is the frame's origin.

struct Disc {
  double radius = 0.1;  // m, >= 0; a body of radius 0 is point-like
};

struct Box {
  double width = 1.0;   // m, > 0; along the body's own x axis
  double height = 1.0;  // m, > 0; along the body's own y axis
};

// A convex polygon grown outwards by `rounding`; with two vertices a capsule. The vertices may be given in
// any frame and in either sense of rotation; the shape is moved so that its centre of mass becomes the
// origin.
struct Polygon {
  std::vector<Vec2> vertices;  // m
  double rounding = 0.0;       // m, >= 0
};

// Without a length: the half-plane below the body's x axis, with the origin on its surface. With a length: a
// thin wall along that axis, solid from both sides, with the origin in its middle.
struct Wall {
  std::optional<double> length;  // m, > 0
};

using Shape = std::variant<Disc, Box, Polygon, Wall>;

// The common form of all shapes: a convex core of one or more vertices, counter-clockwise, grown by a
// rounding; or the half-plane y <= 0.
struct Outline {
  std::vector<Vec2> vertices;  // m, from the centre of mass
  double rounding = 0.0;       // m
  bool half_plane = false;     // no vertices
};

// The shape must be valid (validate.h).
[[nodiscard]] Outline outline_of(const Shape& shape);

// m², 0 for a thin wall or a point, infinite for a half-plane.
[[nodiscard]] double area(const Shape& shape);
// m, radius of the circle about the centre of mass that contains the shape; infinite for a half-plane.
[[nodiscard]] double bounding_radius(const Shape& shape);
// Moment of inertia about the centre of mass for a homogeneous body, divided by its mass, in m². Disc: r²/2;
// box: (w² + h²)/12; thin wall: l²/12; polygon: see moments_of; 0 for a half-plane.
[[nodiscard]] double inertia_per_mass(const Shape& shape);
// m, half width and height of the axis-aligned rectangle about the origin that contains the shape turned by
// `angle`. Infinite for a half-plane.
[[nodiscard]] Vec2 half_extent(const Shape& shape, double angle);

// m, signed distance of a point from the outline, both in the body's frame; negative inside.
[[nodiscard]] double signed_distance(const Outline& outline, const Vec2& point);
// Where the line from + s along, |along| = 1, enters and leaves the outline: s in m; nothing if it misses.
[[nodiscard]] std::optional<std::pair<double, double>> chord(const Outline& outline, const Vec2& from,
                                                             const Vec2& along);

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
