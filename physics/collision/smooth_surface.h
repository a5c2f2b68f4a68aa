#pragma once

#include <optional>

#include "physics/collision/contact.h"
#include "physics/model/convex.h"

namespace carom {

// Around a point of its surface, a body fills a wedge of directions: half of them at a face, fewer at a corner.
// Where the wedges of two neighbours lie side by side and fill at most half of all directions together, as two
// flush boxes of a floor do, their common surface is smooth there, or a ridge. Another body can touch it only
// along a normal of the common wedge: the edges inside it do not catch.
//
// `point` lies on the surface of `owner`, in m, and `normal` is a unit vector out of it. True if `neighbour`
// leaves no contact with this normal here: it covers the point, or the normal is none of the common wedge.
// False at a step, where the two wedges fill more than half. `tolerance` in m: surfaces that are no farther
// from the point pass through it. `may_overlap`: owner and neighbour don't
// collide. Where they do, a point that has sunk between or into them has done so by the method's error. Then
// its contact is needed, unless it is near the end of a seam that it should have passed. `by_face`: a face of
// the other body touches here, and owner and neighbour are parts of one body. It may also touch a corner that
// both make where it is tilted against it, as an end of a face that is to land.
[[nodiscard]] bool neighbour_covers(const ConvexShapes& shapes, ShapeIndex owner, const Pose& pose_owner,
                                    ShapeIndex neighbour, const Pose& pose_neighbour, const Vec2& point,
                                    const Vec2& normal, double tolerance, bool may_overlap,
                                    bool by_face = false);

// Whether a face of the toucher is over the place where owner and neighbour make one face with this normal: the
// point is an end of theirs, but of none of the whole face. `at` is on the owner, `over` on the toucher, in m,
// each within `tolerance`. Faces that are tilted against each other touch at corners of theirs alone, too.
[[nodiscard]] bool lies_over_seam(const ConvexShapes& shapes, ShapeIndex owner, const Pose& pose_owner,
                                  ShapeIndex neighbour, const Pose& pose_neighbour, ShapeIndex toucher,
                                  const Pose& pose_toucher, const Vec2& at, const Vec2& over,
                                  const Vec2& normal, double tolerance);

// Where a corner of the toucher is over a face of the owner, the contact of these two along the normal of that
// face, from owner to toucher; nothing if it is over none that is turned from `normal` by less than half a
// right angle. `over` is on the toucher, in m. The nearest features of two shapes need not be these, but the
// seam at the end of the owner's face, over which the toucher's face lies.
[[nodiscard]] std::optional<Contact> corner_over_face(const ConvexShapes& shapes, ShapeIndex owner,
                                                      const Pose& pose_owner, ShapeIndex toucher,
                                                      const Pose& pose_toucher, const Vec2& over,
                                                      const Vec2& normal, double tolerance);

// Whether the shape has a face with this outward unit normal.
[[nodiscard]] bool has_face(const ConvexShapes& shapes, ShapeIndex i, const Pose& pose, const Vec2& normal);

}  // namespace carom
