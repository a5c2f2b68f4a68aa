#pragma once

#include <array>
#include <optional>
#include <string>

#include "physics/math/vectors.h"
#include "physics/scene/fields.h"
#include "physics/scene/id.h"
#include "physics/scene/named.h"

namespace carom {

// What a joint constrains between its two points.
enum class JointKind {
  kRod,     // their distance
  kString,  // their distance to at most its length; slack or pulling, with a taut impulse when it tightens
  kPin,     // both at one place; the bodies turn about it and do not collide with one another
  kWeld     // both at one place, and the angle between the bodies; they move as one and do not collide
};

inline constexpr auto kJointNames = std::to_array<Named<JointKind>>({
    {JointKind::kRod, "rod"},
    {JointKind::kString, "string"},
    {JointKind::kPin, "pin"},
    {JointKind::kWeld, "weld"},
});

// A massless joint between a point of a body and a point of another body or of the plane. Its forces do no
// work, except through a kinematic body. A string's taut impulse removes the speed that would lengthen it.
struct Joint {
  std::string name;  // may be empty
  JointKind kind = JointKind::kRod;
  std::string body;              // a body that moves
  Vec2 point = Vec2::Zero();     // m, from its centre, along its own axes
  std::string to;                // the body at the other end; empty: the plane
  Vec2 anchor = Vec2::Zero();    // m, from that body's centre along its own axes, or a point of the plane
  std::optional<double> length;  // m, > 0, of a rod or a string; none: the distance at the start
  // rad, weld only: the body's angle minus that of the other body (0 for the plane); none: as at the start. A
  // point-like body has no angle.
  std::optional<double> angle;
  Id<Joint> id{};  // a weld that a run makes has none
};

template <class V>
void fields(V& v, Is<Joint> auto& joint) {
  v.field({"name", "its own, if any"}, joint.name, kPerhapsNameLength);
  v.required({"body", "the name of a body that moves"}, joint.body, kNameLength);
  v.field({"point", "of it, along its own axes, [x, y]"}, joint.point, any_number("m"));
  v.together({KeysTogether::Rule::kOneOrBoth, "to", "anchor", "a link without its other end", "",
              "\"anchor\": [x, y], a point of the plane in m, or \"to\": the name of a body"});
  if (v.shows(!joint.to.empty())) v.field({"to", "the body at the other end"}, joint.to, kNameLength);
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

}  // namespace carom
