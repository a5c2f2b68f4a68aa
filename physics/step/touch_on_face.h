#pragma once

#include <optional>

#include "physics/step/contact_finder.h"
#include "physics/step/contact_sides.h"
#include "physics/step/neighbours.h"
#include "physics/step/world.h"

namespace carom {

// A corner, or the centre of a rounding, that touches a face of another body.
struct TouchOnFace {
  BodyIndex toucher = kNoBody;
  ShapeIndex toucher_part = kNoShape;
  Vec2 tip = Vec2::Zero();  // m, in the frame of its part
  BodyIndex body = kNoBody;
  Face face;
  bool flat = false;    // a face of its own lies on this one
  bool to_end = false;  // which goes from the corner towards the end of this one, else towards its start

  [[nodiscard]] bool is_corner(const World& world) const {
    return world.shapes().shapes.rounding[toucher_part] == 0.0;
  }
  [[nodiscard]] TipOnFace on_line() const {
    const bool is_of_b = body < toucher;
    return {is_of_b ? ShapePair{face.part, toucher_part} : ShapePair{toucher_part, face.part}, is_of_b, tip,
            face};
  }
};

// Contact i as such a touch; where corners of both are near, it is the nearer one that touches, and of two at
// one place the one that comes to the end of its face.
[[nodiscard]] std::optional<TouchOnFace> touch_on_face(const World& world, const FoundContacts& found, int i);

// m: where the disc or corner is along the face, from its start, under these motions of both bodies.
[[nodiscard]] double place_along(const World& world, const TouchOnFace& on, const Motion& toucher,
                                 const Motion& body);
// m/s: how fast it goes along the face, about.
[[nodiscard]] double speed_along(const World& world, const TouchOnFace& on, const Motion& toucher,
                                 const Motion& body);

// m: so far beyond the end of a face only the next one is touched.
[[nodiscard]] double past_seam(const World& world, const TouchOnFace& on);
// Whether another part, of the body or of another one, goes on with the face beyond its end, or its start,
// under another law of the surface.
[[nodiscard]] bool law_changes(const World& world, const TouchOnFace& on, bool at_end,
                               const Neighbours& neighbours);

}  // namespace carom
