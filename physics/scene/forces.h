#pragma once

#include <array>
#include <concepts>
#include <optional>
#include <string>
#include <vector>

#include "physics/math/vectors.h"
#include "physics/scene/fields.h"
#include "physics/scene/id.h"
#include "physics/scene/named.h"

namespace carom {

// Which way a spring acts along its line, with the stretch s = length - rest_length.
enum class SpringActs {
  kBoth,       // F = -k s - c s' at any length
  kPush,       // a bumper: only while s < 0 and it pushes; it never pulls
  kPull,       // a rubber band: only while s > 0 and it pulls; it never pushes
  kWhileShort  // while s < 0, also where its damper pulls
};

inline constexpr auto kSpringActsNames = std::to_array<Named<SpringActs>>({
    {SpringActs::kBoth, "both"},
    {SpringActs::kPush, "push"},
    {SpringActs::kPull, "pull"},
    {SpringActs::kWhileShort, "while-short"},
});

// A linear spring with a damper, from a point of a body to a point of another body or of the plane. It exerts
// -k s - c s' on the body, along the line from the other end to it, and the opposite on the other body.
struct Spring {
  std::string name;            // may be empty
  std::string body;            // a body that moves
  std::string to;              // the body at the other end; empty: the plane
  Vec2 anchor = Vec2::Zero();  // m, from that body's centre along its own axes, or a point of the plane
  double stiffness = 1.0;      // N/m, > 0
  double damping = 0.0;        // N s/m, >= 0
  double rest_length = 0.0;    // m, >= 0
  SpringActs acts = SpringActs::kBoth;
  Id<Spring> id{};
  Vec2 point = Vec2::Zero();  // m, of `body`, from its centre along its own axes
};

template <class V>
void fields(V& v, Is<Spring> auto& s) {
  v.field({"name", "its own, if any"}, s.name, kPerhapsNameLength);
  v.required({"body", "the name of the body that it acts on"}, s.body, kNameLength);
  v.field({"point", "of it, along its own axes, [x, y]"}, s.point, any_number("m"));
  v.together({KeysTogether::Rule::kOneOrBoth, "to", "anchor", "a spring without its other end", "",
              "\"anchor\": [x, y], a point of the plane in m, or \"to\": the name of a body"});
  if (v.shows(!s.to.empty())) v.field({"to", "the body at the other end"}, s.to, kNameLength);
  v.field({"anchor", "the point of that body, or of the plane, [x, y]"}, s.anchor, any_number("m"));
  if (s.to.empty()) v.keep({"anchor"});
  v.required({"stiffness", "force over stretch"}, s.stiffness, positive("N/m"));
  v.field({"damping", "force over the stretch's speed"}, s.damping, from_zero("N s/m"));
  v.field({"rest_length", "of the spring that pulls at nothing"}, s.rest_length, from_zero("m"));
  v.choice({"acts", "which way it acts"}, kSpringActsNames, s.acts);
}

// Attraction between every two moving bodies: F = G m_a m_b d / (d² + ε²)^(3/2) along the line of their
// centres (Plummer).
struct Attraction {
  double constant = 1.0;   // G in N m²/kg², > 0
  double softening = 0.0;  // ε in m, >= 0
};

template <class V>
void fields(V& v, Is<Attraction> auto& a) {
  v.required({"constant", "G"}, a.constant, positive("N m²/kg²"));
  v.field({"softening", "of close encounters"}, a.softening, from_zero("m"));
}

// A force at a body's centre and a torque. Both rise linearly from `start` over the time `rise` and end at
// `end`.
struct AppliedForce {
  std::string body;
  Vec2 force = Vec2::Zero();  // N
  double torque = 0.0;        // N m
  double start = 0.0;         // s, >= 0
  double rise = 0.0;          // s, >= 0; 0: all at once
  std::optional<double> end;  // s, >= start; none: never
  Id<AppliedForce> id{};
  Vec2 point = Vec2::Zero();  // m, of the body, from its centre along its own axes
};

template <class V>
void fields(V& v, Is<AppliedForce> auto& f) {
  v.required({"body", "the name of the body that it acts on"}, f.body, kNameLength);
  v.field({"point", "where the force acts, from the body's centre along its own axes, [x, y]"}, f.point,
          any_number("m"));
  v.field({"force", "on the body, [x, y]"}, f.force, any_number("N"));
  v.field({"torque", "counter-clockwise"}, f.torque, any_number("N m"));
  v.field({"start", "when it sets in"}, f.start, from_zero("s"));
  v.field({"rise", "within which it grows to all of it"}, f.rise, from_zero("s"));
  v.field({"end", "when it ends"}, f.end, from_zero("s"));
}

// A hand that pulls a body of a run: a spring with a damper from a point of the body to the hand. It is no part
// of an experiment: no file holds it.
struct Hand {
  std::string body;           // one that moves
  Vec2 grip = Vec2::Zero();   // m, in the body's own axes, from its centre of mass
  Vec2 place = Vec2::Zero();  // m, where the hand is
  double stiffness = 0.0;     // N/m, > 0
  double damping = 0.0;       // N s/m, >= 0, times the velocity of the grip

  bool operator==(const Hand&) const = default;
};

// The forces that a scene has once, on all bodies that move.
struct CommonForces {
  Vec2 gravity = Vec2::Zero();  // m/s²
  double linear_drag = 0.0;     // kg/s: F = -b v
  double quadratic_drag = 0.0;  // kg/m: F = -c |v| v
  std::optional<Attraction> attraction{};
};

inline constexpr Range kGravityRange = any_number("m/s²");

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

struct Forces : CommonForces {
  std::vector<Spring> springs;
  std::vector<AppliedForce> applied;
  std::optional<Hand> hand{};
};

}  // namespace carom
