#pragma once

#include <concepts>
#include <initializer_list>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "physics/scene/limits.h"
#include "physics/scene/names.h"
#include "physics/scene/scene.h"
#include "physics/scene/shape.h"
#include "physics/scene/stop.h"

// What each type of a scene consists of, stated once: its keys in files, their unit, range, default and
// meaning. fields(visitor, value) shows every member to a visitor. Visitors read a file, write it and describe
// its format (FieldReader in physics/preset/value_reader.h), and check ranges (RangeCheck in
// physics/scene/range_check.h).
//
// A visitor has these functions; a member with `required` in its name has no default.
//   field(key, member, kind)           a number, vector or text of a Range, Whole or Count
//   required(key, member, kind)
//   field(key, flag)                   true or false
//   choice(key, table, member)         one of a table's words
//   object(key, member)                a std::optional with fields of its own
//   required_object(key, member)
//   alternative(key, member)           an object, or else what another key holds (see together)
//   compound(key, shape, count)        the shapes of a Compound, where the shape is one
//   points(key, list, count, range)    a required list of points
//   ends_of_range(key, low, high, range)  required, two numbers in one pair
//   two_names(key, a, b)               required
//   cases(key, words, chosen, each)    a word that says which fields there are: each(index, visitor)
//   together(rule)                     which of two keys there must be
//   shows(condition)  whether a member that is usual only under a condition is visited
//   keep(keys)        members that are written even if they have their default
//   follows(member, other)             the default of `member` is `other`
//   put(key, member)                   the place, in a file, of a member whose field comes later
//   stands_for(key, value, condition)  a value that holds without its key, where `condition` is true
namespace carom {

// A key of an object, and its meaning.
struct Key {
  const char* name;
  const char* meaning;
};

// Limits of the number of elements of a list, or of characters of a text.
struct Count {
  std::size_t least = 0;
  std::size_t most = 0;
};

inline constexpr Count kName{1, kLongestName};
inline constexpr Count kStem{1, kLongestStem};
inline constexpr Count kPerhapsName{0, kLongestName};

// Whole numbers from low to high.
struct Whole {
  double low;
  double high;
};

// Which of two keys an object has, and what is refused with which words.
struct KeysTogether {
  enum class Rule { kExactlyOne, kOneOrBoth, kNotBoth };
  Rule rule;
  const char* first;
  const char* second;  // the place of what is refused
  const char* neither;
  const char* both;
  const char* allowed;
};

using Words = std::vector<std::string>;

// What visitors need that neither set members nor write them.
class OnlyLooks {
 public:
  void together(const KeysTogether&) const {}
  void keep(std::initializer_list<const char*>) const {}
  void follows(double, double) const {}
  void put(const char*, double) const {}
  void stands_for(const char*, double, bool) const {}
  template <class Id>
  void chosen(Id, Id) const {}
};

template <class T, class U>
concept Is = std::same_as<std::remove_const_t<T>, U>;

// How a surface behaves: what materials and pairs of materials share.
template <class V>
void surface_fields(V& v, Is<Material> auto& m) {
  v.field({"restitution", "rebound speed over closing speed"}, m.restitution, kRestitutionRange);
  v.field({"tangential_restitution", "reversed share of the slip"}, m.tangential_restitution,
          kTangentialRestitution);
  v.put("static_friction", m.static_friction);
  v.field({"kinetic_friction", "coefficient"}, m.kinetic_friction, kFrictionCoefficient);
  v.follows(m.static_friction, m.kinetic_friction);
  v.field({"static_friction", "coefficient, kinetic_friction or more"}, m.static_friction,
          kFrictionCoefficient);
  v.field({"rolling_resistance", "moment over radius and normal force"}, m.rolling_resistance,
          kFrictionCoefficient);
  v.field({"sticks", "bodies stay joined from their first impact on"}, m.sticks);
  v.keep(
      {"restitution", "tangential_restitution", "static_friction", "kinetic_friction", "rolling_resistance"});
}

template <class V>
void fields(V& v, Is<Material> auto& m) {
  v.required({"name", "a name of its own"}, m.name, kName);
  surface_fields(v, m);
}

template <class V>
void fields(V& v, Is<MaterialPair> auto& p) {
  v.two_names({"materials", "the names of two materials, [\"a\", \"b\"]"}, p.a, p.b);
  surface_fields(v, p.surface);
}

template <class V>
void fields(V& v, Is<Drive> auto& d) {
  v.field({"velocity", "of the steady part"}, d.velocity, any_number("m/s"));
  v.field({"amplitude", "of the oscillation"}, d.amplitude, any_number("m"));
  v.field({"angular_frequency", "ω of the oscillation"}, d.angular_frequency, from_zero("rad/s"));
  v.field({"phase", "φ of the oscillation"}, d.phase, any_number("rad"));
}

template <class V>
void fields(V& v, Is<Disc> auto& disc) {
  v.required({"radius", "of the disc; 0 for a point-like body"}, disc.radius, kDiscRadius);
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
  v.field({"material", "the name of one; without it that of the body"}, s.material, kPerhapsName);
}

template <class V>
void fields(V& v, Is<Body> auto& b) {
  v.required({"name", "a name of its own"}, b.name, kName);
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
  v.field({"material", "the name of one"}, b.material, kName);
  v.field({"group", "bodies of one group do not collide with each other"}, b.group, kPerhapsName);
}

template <class V>
void fields(V& v, Is<GridGenerator> auto& g) {
  v.cases({"type", "the kind of generator"}, Words{"grid"}, 0, [&](std::size_t, V& k) {
    k.required({"name", "the stem of the bodies' names"}, g.name, kStem);
    k.field({"columns", "discs side by side"}, g.columns, Whole{1, kMostBodies});
    k.field({"rows", "discs one over the other"}, g.rows, Whole{1, kMostBodies});
    k.required({"origin", "the first disc's centre, two numbers, [x, y]"}, g.origin, any_number("m"));
    k.field({"spacing", "from disc to disc, [x, y]"}, g.spacing, any_number("m"));
    k.field({"jitter", "by which each disc is moved at most"}, g.jitter, from_zero("m"));
    k.ends_of_range({"radius", "two numbers, [least, largest]"}, g.radius_min, g.radius_max, positive("m"));
    k.field({"speed", "largest velocity component"}, g.speed_max, from_zero("m/s"));
    k.field({"density", "of each disc"}, g.density, positive("kg/m²"));
    k.field({"material", "the name of one"}, g.material, kName);
    k.field({"seed", "of the random numbers"}, g.seed, Whole{0.0, 9e15});
  });
}

template <class V>
void fields(V& v, Is<Spring> auto& s) {
  v.field({"name", "its own, if any"}, s.name, kPerhapsName);
  v.required({"body", "the name of the body that it acts on"}, s.body, kName);
  v.together({KeysTogether::Rule::kExactlyOne, "to", "anchor", "a spring without its other end",
              "\"anchor\" beside \"to\"", "either \"anchor\": [x, y], in m, or \"to\": the name of a body"});
  if (v.shows(!s.to.empty())) v.field({"to", "the body at the other end"}, s.to, kName);
  if (v.shows(s.to.empty()))
    v.field({"anchor", "the point of the plane at the other end, [x, y]"}, s.anchor, any_number("m"));
  v.keep({"anchor"});
  v.required({"stiffness", "force over stretch"}, s.stiffness, positive("N/m"));
  v.field({"damping", "force over the stretch's speed"}, s.damping, from_zero("N s/m"));
  v.field({"rest_length", "of the spring that pulls at nothing"}, s.rest_length, from_zero("m"));
  v.choice({"acts", "which way it acts"}, kSpringActsNames, s.acts);
}

template <class V>
void fields(V& v, Is<Attraction> auto& a) {
  v.required({"constant", "G"}, a.constant, positive("N m²/kg²"));
  v.field({"softening", "of close encounters"}, a.softening, from_zero("m"));
}

template <class V>
void fields(V& v, Is<AppliedForce> auto& f) {
  v.required({"body", "the name of the body that it acts on"}, f.body, kName);
  v.field({"force", "at the body's centre, [x, y]"}, f.force, any_number("N"));
  v.field({"torque", "counter-clockwise"}, f.torque, any_number("N m"));
  v.field({"start", "when it sets in"}, f.start, from_zero("s"));
  v.field({"rise", "within which it grows to all of it"}, f.rise, from_zero("s"));
  v.field({"end", "when it ends"}, f.end, from_zero("s"));
}

inline constexpr Range kGravity = any_number("m/s²");

enum class ActsOn { kEachBody, kEachPair };  // of bodies that move

// One of the forces that a scene has once, beside gravity: an element of the array of forces of a type of its
// own. All of them vary in flight.
struct CommonForce {
  const char* type;
  const char* name;     // for people
  const char* meaning;  // of its coefficient, or of the force that has fields of its own
  const char* kind;     // as people call it among all forces, "drag"; the noun of its part of the model
  ActsOn on;
};

// Whether a scene has the force.
[[nodiscard]] inline bool acts(double coefficient) { return coefficient != 0.0; }
template <class Force>
[[nodiscard]] bool acts(const std::optional<Force>& force) {
  return force.has_value();
}

// Calls visit(force, coefficient, range) or visit(force, optional with fields) for each of them.
void each_common_force(std::derived_from<CommonForces> auto& f, const auto& visit) {
  visit(CommonForce{"linear_drag", "Linear drag", "b in F = -b v", "drag", ActsOn::kEachBody}, f.linear_drag,
        from_zero("kg/s"));
  visit(CommonForce{"quadratic_drag", "Quadratic drag", "c in F = -c |v| v", "drag", ActsOn::kEachBody},
        f.quadratic_drag, from_zero("kg/m"));
  visit(CommonForce{"attraction", "Attraction", "between every two bodies that move, as of planets",
                    "attraction", ActsOn::kEachPair},
        f.attraction);
}

template <class V>
void fields(V& v, Is<Joint> auto& joint) {
  v.field({"name", "its own, if any"}, joint.name, kPerhapsName);
  v.required({"body", "the name of a body that moves"}, joint.body, kName);
  v.field({"point", "of it, along its own axes, [x, y]"}, joint.point, any_number("m"));
  v.together({KeysTogether::Rule::kOneOrBoth, "to", "anchor", "a link without its other end", "",
              "\"anchor\": [x, y], a point of the plane in m, or \"to\": the name of a body"});
  if (v.shows(!joint.to.empty())) v.field({"to", "the body at the other end"}, joint.to, kName);
  v.field({"anchor", "the point of that body, or of the plane, [x, y]"}, joint.anchor, any_number("m"));
  if (joint.to.empty()) v.keep({"anchor"});
  v.cases(
      {"type", "the kind of link"}, words_of(kJointNames), index_of(kJointNames, joint.kind),
      [&](std::size_t kind, V& k) {
        k.chosen(joint.kind, kJointNames[kind].id);
        if (kJointNames[kind].id == JointKind::kRod || kJointNames[kind].id == JointKind::kString)
          k.field({"length", "the distance at the start, or more of a string"}, joint.length, positive("m"));
        if (kJointNames[kind].id == JointKind::kWeld)
          k.field({"angle", "the body's angle less that of the other"}, joint.angle, any_number("rad"));
      });
}

// Whose impact a run stops at.
template <class V>
void partner_fields(V& v, Is<Stop> auto& stop) {
  v.field({"body", "the name of one of the two bodies; without it any"}, stop.body, kPerhapsName);
  v.field({"with", "the name of the other one; without it any"}, stop.with, kPerhapsName);
  v.field({"with_wall", "the other one is fixed or driven"}, stop.with_wall);
  v.together(
      {KeysTogether::Rule::kNotBoth, "with", "with_wall", "", "a wall beside a name", "either of the two"});
}

template <class V>
void fields(V& v, Is<Stop> auto& stop) {
  v.cases({"type", "what the run stops at"}, words_of(kStopNames), index_of(kStopNames, stop.kind),
          [&](std::size_t i, V& k) {
            const StopKind kind = kStopNames[i].id;
            k.chosen(stop.kind, kind);
            if (kind == StopKind::kTime) k.required({"time", "when"}, stop.time, from_zero("s"));
            if (kind == StopKind::kImpact)
              k.required({"number", "1: the first one of the run"}, stop.number, Whole{1, 1e9});
            if (kind == StopKind::kImpact || kind == StopKind::kEveryImpact) partner_fields(k, stop);
            if (kind == StopKind::kKineticEnergy)
              k.required({"below", "which the kinetic energy falls"}, stop.below, positive("J"));
            if (kind != StopKind::kPassing) return;
            k.required({"body", "the name of the body that passes"}, stop.body, kName);
            k.choice({"quantity", "of the body"}, kStopQuantityNames, stop.quantity);
            k.keep({"quantity"});
            k.required({"value", "in m, rad or m/s"}, stop.value, any_number(""));
            k.choice({"way", "in which the value passes"}, kPassingWayNames, stop.way);
          });
}

}  // namespace carom
