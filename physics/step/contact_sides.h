#pragma once

#include <optional>
#include <span>

#include "physics/collision/pair_contact.h"
#include "physics/collision/tip_on_face.h"
#include "physics/model/convex.h"
#include "physics/step/contact_finder.h"
#include "physics/step/internal_edges.h"
#include "physics/step/world.h"

// The two parts that touch at a contact, with their faces and corners.
namespace carom {

[[nodiscard]] inline bool is_round(const ConvexShapes& shapes, ShapeIndex part) {
  return shapes.core[part] == Core::kPoint;
}
// A half-plane has no face that ends.
[[nodiscard]] inline bool has_faces(const ConvexShapes& shapes, ShapeIndex part) {
  return shapes.edges(part) > 0 && shapes.core[part] != Core::kHalfPlane;
}

// Sine by which a normal and that of a face differ at most.
inline constexpr double kOnFace = 1e-7;
// The face that has this outward normal in the part's frame.
[[nodiscard]] std::optional<Face> face_with(const ConvexShapes& shapes, ShapeIndex part, const Vec2& normal);
// The corner of a part's core that is nearest to this point of its frame, if within `near` m; else null.
[[nodiscard]] const Corner* core_corner_at(const ConvexShapes& shapes, ShapeIndex part, const Vec2& point,
                                           double near);
// Likewise, of a part without rounding.
[[nodiscard]] const Corner* corner_at(const ConvexShapes& shapes, ShapeIndex part, const Vec2& point,
                                      double near);
// The one before it around the part: the face that comes to this corner is its.
[[nodiscard]] const Corner& corner_before(const ConvexShapes& shapes, ShapeIndex part, const Corner& corner);

// Relative to the pair's size: a corner so near a contact is the one that touches.
inline constexpr double kAtCorner = 4e-5;

// One of the two parts of a contact, at the start of the trajectories.
struct ContactSide {
  BodyIndex body;
  ShapeIndex part;
  Pose pose;  // of the part
  Vec2 out;   // the contact's normal out of it, in the plane

  [[nodiscard]] std::optional<Face> face(const ConvexShapes& shapes) const {
    return has_faces(shapes, part) ? face_with(shapes, part, pose.turned_back(out)) : std::nullopt;
  }
  [[nodiscard]] Vec2 of_part(const Vec2& point) const { return pose.turned_back(Vec2(point - pose.position)); }
};
struct ContactSides {
  ContactSide a, b;
};
[[nodiscard]] ContactSides sides_of(const World& world, const FoundContacts& found, int i);

// Whether another part goes on with the surface of a side at this corner of it (m, in its frame): the other
// side leaves no contact with the side's normal, which is that of what lies beyond. pose(i) is the pose of a
// body.
template <class PoseOf>
[[nodiscard]] bool goes_on(const World& world, const ContactSide& side, const ContactSide& other,
                           const Vec2& corner, std::span<const BodyIndex> others, const PoseOf& pose) {
  const Geometry& g = world.shapes();
  const bool first = side.body < other.body;
  const auto [a, b] = std::minmax(side.body, other.body);
  Contact contact{0.0, first ? side.out : Vec2(-side.out), side.pose.position + side.pose.turned(corner)};
  if (g.has_parts(a) || g.has_parts(b))
    contact.parts = first ? ShapePair{side.part, other.part} : ShapePair{other.part, side.part};
  return on_internal_edge(world, a, b, contact, others, pose);
}

// rad: beyond an end the normal turns to this side of the face's own; far enough to tell a corner from
// rounding.
inline constexpr double kBeyond = 1e-6;

// Whether another part goes on with the face of a body beyond its end, or its start, under a part of a toucher.
template <class PoseOf>
[[nodiscard]] bool goes_on_past(const World& world, BodyIndex body, const Face& face, bool at_end,
                                BodyIndex toucher, ShapeIndex toucher_part, std::span<const BodyIndex> others,
                                const PoseOf& pose) {
  const Pose of_face = world.shapes().part_pose(body, face.part, pose(body));
  const Vec2 past = of_face.turned(turned_by(at_end ? kBeyond : -kBeyond, face.normal));
  return goes_on(world, {body, face.part, of_face, past}, {toucher, toucher_part, {}, {}},
                 face.at(at_end ? face.length : 0.0), others, pose);
}

}  // namespace carom
