#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "physics/math/vectors.h"
#include "physics/scene/fields.h"
#include "physics/scene/polygon.h"

namespace carom {

// The shapes of bodies, in the body's own frame. The centre of mass is the frame's origin.

struct Disc {
  double radius = 0.1;  // m, >= 0; a body of radius 0 is point-like
};

struct Box {
  double width = 1.0;   // m, > 0; along the body's own x axis
  double height = 1.0;  // m, > 0; along the body's own y axis
};

// A polygon grown outwards by `rounding`; with two vertices a capsule. Without rounding it may have reentrant
// corners. The vertices may be given in any frame and in either sense of rotation; the shape is moved so that
// its centre of mass becomes the origin.
struct Polygon {
  std::vector<Vec2> vertices;  // m
  double rounding = 0.0;       // m, >= 0
};

// Without a length: the half-plane below the body's x axis, with the origin on its surface. With a length: a
// thin wall along that axis, solid from both sides, with the origin in its middle.
struct Wall {
  std::optional<double> length;  // m, > 0
};

using PlainShape = std::variant<Disc, Box, Polygon, Wall>;
// What they are called, in this order.
inline constexpr std::array kShapeWords = {"disc", "box", "polygon", "wall"};

// One of the shapes of a compound.
struct PlacedShape {
  PlainShape shape = Disc{};     // no half-plane
  Vec2 position = Vec2::Zero();  // m, of its centre of mass
  double angle = 0.0;            // rad
  std::string material;          // empty: that of the body
};

// Several shapes that are one rigid body. Their places may be given in any frame; the compound is moved so that
// its centre of mass becomes the origin. All are of one density: where two overlap, both count.
inline constexpr int kMostShapes = 64;
struct Compound {
  std::vector<PlacedShape> shapes;
};

using Shape = std::variant<Disc, Box, Polygon, Wall, Compound>;

[[nodiscard]] Shape shape_of(const PlainShape& shape);

// The common form of plain shapes: a core of one or more vertices, counter-clockwise, grown by a rounding; or
// the half-plane y <= 0. Of a compound the convex hull, about, as it is drawn and picked.
struct Outline {
  std::vector<Vec2> vertices;  // m, from the centre of mass
  double rounding = 0.0;       // m
  bool half_plane = false;     // no vertices
};

// The shape must be valid (validate.h).
[[nodiscard]] Outline outline_of(const Shape& shape);

// m: where its centre of mass is in the frame of its places.
[[nodiscard]] Vec2 centre_of(const Compound& compound);

// A convex part of a shape, in the frame of the body.
struct ConvexPart {
  Outline outline;               // m, from `position`; its vertices are strictly convex
  Vec2 position = Vec2::Zero();  // m, of its centre
  bool box = false;              // a rectangle along the axes of the body
  int shape = 0;                 // of a compound: which of its shapes
};

// A plain convex shape is one part, at the origin. The others are taken apart.
[[nodiscard]] std::vector<ConvexPart> convex_parts(const Shape& shape);

[[nodiscard]] bool is_half_plane(const Shape& shape);

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

// m, signed distance of a point from a convex outline, both in the body's frame; negative inside.
[[nodiscard]] double signed_distance(const Outline& outline, const Vec2& point);
// Of the nearest of its parts.
[[nodiscard]] double signed_distance(const Shape& shape, const Vec2& point);
// Where the line from + s along, |along| = 1, enters and leaves the outline: s in m; nothing if it misses.
[[nodiscard]] std::optional<std::pair<double, double>> chord(const Outline& outline, const Vec2& from,
                                                             const Vec2& along);

template <class V>
void fields(V& v, Is<Disc> auto& disc) {
  v.required({"radius", "of the disc; 0 for a point-like body"}, disc.radius, kDiscRadiusRange);
}

template <class V>
void fields(V& v, Is<Box> auto& box) {
  v.required({"width", "along its own x axis"}, box.width, positive("m"));
  v.required({"height", "along its own y axis"}, box.height, positive("m"));
}

template <class V>
void fields(V& v, Is<Polygon> auto& polygon) {
  v.points({"vertices", "corners of a polygon in order, convex if it is rounded, [[x, y], ...], in m"},
           polygon.vertices, Count{2, kMostPolygonPoints}, any_number("m"));
  if (v.shows(polygon.rounding != 0.0))
    v.field({"rounding", "by which it grows on all sides"}, polygon.rounding, from_zero("m"));
}

template <class V>
void fields(V& v, Is<Wall> auto& wall) {
  v.field({"length", "of a thin wall; without it a half-plane"}, wall.length, positive("m"));
}

// As it stands there, or begun.
template <class Form, class... Forms>
Form& form_of(std::variant<Forms...>& shape) {
  return std::holds_alternative<Form>(shape) ? std::get<Form>(shape) : shape.template emplace<Form>();
}
template <class Form, class... Forms>
const Form& form_of(const std::variant<Forms...>& shape) {
  return std::get<Form>(shape);
}

template <class T>
concept ShapeOfOnePart = Is<T, Shape> || Is<T, PlainShape>;

// Of a compound see fields of a body.
template <class V>
void fields(V& v, ShapeOfOnePart auto& shape) {
  v.cases({"type", "the kind of shape"}, Words(kShapeWords.begin(), kShapeWords.end()), shape.index(),
          [&](std::size_t kind, V& k) {
            if (kind == 0) {
              fields(k, form_of<Disc>(shape));
            } else if (kind == 1) {
              fields(k, form_of<Box>(shape));
            } else if (kind == 2) {
              fields(k, form_of<Polygon>(shape));
            } else {
              fields(k, form_of<Wall>(shape));
            }
          });
}

inline constexpr const char* kShapeForms =
    "{\"type\": \"disc\", \"radius\": r}, {\"type\": \"box\", \"width\": w, \"height\": h}, "
    "{\"type\": \"polygon\", \"vertices\": [[x, y], ...]} or {\"type\": \"wall\"}";

template <class V>
void fields(V& v, Is<PlacedShape> auto& s) {
  v.required_object({"shape", kShapeForms}, s.shape);
  v.field({"position", "of its centre of mass, [x, y]"}, s.position, any_number("m"));
  v.field({"angle", "counter-clockwise"}, s.angle, any_number("rad"));
  v.field({"material", "the name of one; without it that of the body"}, s.material, kPerhapsNameLength);
}

}  // namespace carom
