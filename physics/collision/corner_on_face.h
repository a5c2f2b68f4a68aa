#pragma once

#include <cstdint>
#include <optional>

#include "physics/collision/pair_contact.h"
#include "physics/model/geometry.h"

namespace carom {

// A corner of one part that touches a face of another, both without rounding. Where the corner goes beyond the
// end of the face, the shapes' own contact takes another normal within a short way; this one stays on the
// face's line, so that it is smooth in the poses.
struct CornerOnFace {
  ShapePair parts;  // of the bodies a and b
  bool is_of_b = true;
  int corner = 0;  // of the part's corners
  int face = 0;    // of the other part: from the corner of this number on
};

// What touches at the manifold's point of this id, in these poses of the bodies; nothing where that is no
// corner on a face.
[[nodiscard]] std::optional<CornerOnFace> corner_on_face(const Geometry& g, BodyIndex a, const Pose& pose_a,
                                                         BodyIndex b, const Pose& pose_b, std::uint32_t id);
// m: how far the corner is beyond the end of its face, or, below 0, before its start; 0 between them.
[[nodiscard]] double beyond_face(const Geometry& g, BodyIndex a, const Pose& pose_a, BodyIndex b,
                                 const Pose& pose_b, const CornerOnFace& touch);
[[nodiscard]] Contact contact_on_line(const Geometry& g, BodyIndex a, const Pose& pose_a, BodyIndex b,
                                      const Pose& pose_b, const CornerOnFace& touch);

}  // namespace carom
