#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "physics/math/vectors.h"
#include "physics/scene/fields.h"
#include "physics/scene/id.h"
#include "physics/scene/shape.h"

namespace carom {

// A prescribed motion: position(t) = position + velocity t + amplitude sin(ω t + φ), with its exact velocity.
// A piston has a velocity, a vibrating table an amplitude.
struct Drive {
  Vec2 velocity = Vec2::Zero();    // m/s
  Vec2 amplitude = Vec2::Zero();   // m
  double angular_frequency = 0.0;  // ω in rad/s, >= 0
  double phase = 0.0;              // φ in rad

  bool operator==(const Drive&) const = default;
};

template <class V>
void fields(V& v, Is<Drive> auto& d) {
  v.field({"velocity", "of the steady part"}, d.velocity, any_number("m/s"));
  v.field({"amplitude", "of the oscillation"}, d.amplitude, any_number("m"));
  v.field({"angular_frequency", "ω of the oscillation"}, d.angular_frequency, from_zero("rad/s"));
  v.field({"phase", "φ of the oscillation"}, d.phase, any_number("rad"));
}

struct Body {
  std::string name;
  Shape shape = Disc{};
  Vec2 position = Vec2::Zero();   // m, of the centre of mass
  double angle = 0.0;             // rad
  Vec2 velocity = Vec2::Zero();   // m/s
  double spin = 0.0;              // rad/s
  std::optional<double> mass;     // kg; either this or density
  std::optional<double> density;  // kg/m² (a plane has no volume)
  std::optional<double> inertia;  // kg m² about the centre of mass, > 0; none: that of a homogeneous body
  bool fixed = false;             // never moves: infinite mass and inertia
  std::optional<Drive> drive;     // prescribed motion: infinite mass and inertia
  std::string material = "default";
  std::string group;  // bodies of one group do not collide with each other; empty: no group
  Id<Body> id{};      // those of a generator have none
};

// Calls visit(name) for the material of the body and those of its shapes.
void each_material(auto& body, const auto& visit) {
  visit(body.material);
  auto* compound = std::get_if<Compound>(&body.shape);
  if (compound == nullptr) return;
  for (auto& placed : compound->shapes) {
    if (!placed.material.empty()) visit(placed.material);
  }
}

// The shapes of a compound `body` as bodies of their own, each where and how it moves, with its surface; of the
// same density, without a mass of their own. They have no name.
[[nodiscard]] std::vector<Body> bodies_of(const Compound& compound, const Body& body);

// True if no force or impact changes its motion: fixed or kinematic.
[[nodiscard]] inline bool has_infinite_mass(const Body& body) { return body.fixed || body.drive.has_value(); }

// kg; infinite for a fixed or kinematic body. A body with neither mass nor density has 1 kg/m².
[[nodiscard]] double mass_of(const Body& body);
// kg m² about the centre of mass; infinite for a fixed or kinematic body, 0 for a point-like one, which
// nothing turns.
[[nodiscard]] double inertia_of(const Body& body);
// m: how far the outline reaches from the centre of mass, so that an error of the angle moves no point of it
// farther than this times the error in rad. 0 for a point-like body.
[[nodiscard]] double turning_radius(const Body& body);

template <class V>
void fields(V& v, Is<Body> auto& b) {
  v.required({"name", "a name of its own"}, b.name, kNameLength);
  v.together({KeysTogether::Rule::kExactlyOne, "shapes", "shape", "a body without a shape",
              "\"shape\" beside \"shapes\"", kShapeForms});
  if (v.shows(!std::holds_alternative<Compound>(b.shape))) {
    v.alternative({"shape", kShapeForms}, b.shape);
    if (!std::holds_alternative<Compound>(b.shape)) v.keep({"shape"});
  }
  v.compound({"shapes", "of a body of several shapes, in a frame of their own"}, b.shape,
             Count{1, kMostShapes});
  v.required({"position", "of the centre of mass, two numbers, [x, y]"}, b.position, any_number("m"));
  v.field({"angle", "counter-clockwise"}, b.angle, any_number("rad"));
  const bool moves = !has_infinite_mass(b);
  if (v.shows(moves || !b.velocity.isZero(0.0)))
    v.field({"velocity", "at the start"}, b.velocity, any_number("m/s"));
  if (v.shows(moves || b.spin != 0.0))
    v.field({"spin", "at the start, counter-clockwise"}, b.spin, any_number("rad/s"));
  v.field({"mass", "or a density"}, b.mass, positive("kg"));
  v.field({"density", "or a mass"}, b.density, positive("kg/m²"));
  v.stands_for("density", 1.0, moves && !b.mass && !b.density);
  v.together(
      {KeysTogether::Rule::kNotBoth, "mass", "density", "", "a density beside a mass", "either of the two"});
  v.field({"inertia", "about the centre of mass"}, b.inertia, positive("kg m²"));
  v.field({"fixed", "it never moves"}, b.fixed);
  v.object({"drive", "its prescribed motion"}, b.drive);
  v.field({"material", "the name of one"}, b.material, kNameLength);
  v.field({"group", "bodies of one group do not collide with each other"}, b.group, kPerhapsNameLength);
}

}  // namespace carom
