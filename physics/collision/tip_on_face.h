#pragma once

#include <cstdint>
#include <optional>

#include "physics/collision/pair_contact.h"
#include "physics/math/vectors.h"
#include "physics/model/geometry.h"

namespace carom {

// A face, in the frame of its part: it goes from `vertex` along crossed(normal). That of a half-plane has an
// infinite length.
struct Face {
  ShapeIndex part = kNoShape;
  Vec2 normal = Vec2::Zero();  // unit, outward
  Vec2 vertex = Vec2::Zero();  // m
  double length = 0.0;         // m

  // m: of a point in this frame, along the face from its start.
  [[nodiscard]] double place_of(const Vec2& point) const { return cross(normal, Vec2(point - vertex)); }
  [[nodiscard]] Vec2 at(double place) const { return vertex + place * crossed(normal); }
};

// A tip of one part, a corner or the centre of a rounding, that touches a face of another. Where it goes beyond
// the end of the face, the shapes' own contact takes another normal within a short way; this one stays on the
// face's line, so that it is smooth in the poses.
struct TipOnFace {
  ShapePair parts;  // of the bodies a and b
  bool is_of_b = true;
  Vec2 tip = Vec2::Zero();  // m, in the frame of its part
  Face face;                // of the other part
};

// Of parts without rounding, what touches at the manifold's point of this id, in these poses of the bodies;
// nothing where that is no corner on a face.
[[nodiscard]] std::optional<TipOnFace> tip_on_face(const Geometry& g, BodyIndex a, const Pose& pose_a,
                                                   BodyIndex b, const Pose& pose_b, std::uint32_t id);
// m: how far the tip is beyond the end of its face, or, below 0, before its start; 0 between them.
[[nodiscard]] double beyond_face(const Geometry& g, BodyIndex a, const Pose& pose_a, BodyIndex b,
                                 const Pose& pose_b, const TipOnFace& touch);
[[nodiscard]] Contact contact_on_line(const Geometry& g, BodyIndex a, const Pose& pose_a, BodyIndex b,
                                      const Pose& pose_b, const TipOnFace& touch);

}  // namespace carom
