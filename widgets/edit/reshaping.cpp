#include "widgets/edit/reshaping.h"

#include <cmath>
#include <type_traits>
#include <utility>
#include <variant>

#include "physics/math/vectors.h"
#include "physics/scene/polygon.h"

namespace carom {
namespace {

// m: the centre of mass in the frame in which the shape is written.
Vec2 written_centre(const Shape& shape) {
  if (const auto* compound = std::get_if<Compound>(&shape)) return centre_of(*compound);
  const auto* polygon = std::get_if<Polygon>(&shape);
  return polygon == nullptr ? Vec2(Vec2::Zero()) : centre_of(*polygon);
}

template <class Form>
Form times(const Form& shape, double factor) {
  if (const auto* disc = std::get_if<Disc>(&shape)) return Disc{factor * disc->radius};
  if (const auto* box = std::get_if<Box>(&shape)) return Box{factor * box->width, factor * box->height};
  if (const auto* wall = std::get_if<Wall>(&shape)) {
    return wall->length ? Wall{factor * *wall->length} : *wall;
  }
  if constexpr (std::is_same_v<Form, Shape>) {
    if (const auto* compound = std::get_if<Compound>(&shape)) {
      Compound out = *compound;
      for (PlacedShape& placed : out.shapes) {
        placed.shape = times(placed.shape, factor);
        placed.position *= factor;
      }
      return out;
    }
  }
  Polygon polygon = std::get<Polygon>(shape);
  for (Vec2& vertex : polygon.vertices) vertex *= factor;
  polygon.rounding *= factor;
  return polygon;
}

}  // namespace

Shape scaled(const Shape& shape, double factor) { return times(shape, factor); }

Body resized(const Body& body, const Shape& shape, Keeps keeps) {
  Body out = body;
  out.shape = shape;
  if (keeps == Keeps::kMass && !out.mass && !has_infinite_mass(body)) {
    out.mass = mass_of(body);
    out.density.reset();
  }
  const double grown = area(shape) / area(body.shape);
  if (!std::isfinite(grown) || grown == 0.0) return out;
  const double heavier = keeps == Keeps::kDensity ? grown : 1.0;
  if (out.mass) *out.mass *= heavier;
  if (out.inertia) *out.inertia *= heavier * inertia_per_mass(shape) / inertia_per_mass(body.shape);
  return out;
}

Vec2 centre_of(const Polygon& polygon) {
  if (fault_of(polygon.vertices, polygon.rounding)) return Vec2::Zero();
  return moments_of(tidied(polygon.vertices), polygon.rounding).centroid;
}

SceneEdits kept_ends(const Attached& attached, const std::string& body, const Vec2& moved) {
  SceneEdits edits;
  for (Joint joint : attached.joints) {
    const bool own = joint.body == body;
    if (!own && joint.to != body) continue;
    if (joint.id.number == 0) continue;  // a run has made it
    (own ? joint.point : joint.anchor) -= moved;
    edits.emplace_back(Replace<Joint>{joint});
  }
  for (Spring spring : attached.springs) {
    Vec2* end = spring.body == body ? &spring.point : spring.to == body ? &spring.anchor : nullptr;
    if (end == nullptr || end->isZero(0.0)) continue;
    *end -= moved;
    edits.emplace_back(Replace<Spring>{spring});
  }
  for (AppliedForce force : attached.applied) {
    if (force.body != body || force.point.isZero(0.0)) continue;
    force.point -= moved;
    edits.emplace_back(Replace<AppliedForce>{force});
  }
  return edits;
}

SceneEdits reshaping(const Attached& attached, const Body& body, Body changed) {
  const Vec2 moved = written_centre(changed.shape) - written_centre(body.shape);
  const Vec2 shift = turned_by(body.angle, moved);
  changed.position += shift;
  changed.velocity += body.spin * crossed(shift);
  SceneEdits edits{Replace<Body>{std::move(changed)}};
  if (moved.isZero(0.0)) return edits;
  for (SceneEdit& edit : kept_ends(attached, body.name, moved)) edits.push_back(std::move(edit));
  return edits;
}

}  // namespace carom
