#pragma once

#include <vector>

#include "physics/step/contact_finder.h"
#include "physics/step/neighbours.h"
#include "physics/step/world.h"

namespace carom {

// A disc on a face of another body.
struct DiscOnFace {
  BodyIndex disc = kNoBody;
  ShapeIndex disc_part = kNoShape;
  BodyIndex body = kNoBody;
  ShapeIndex part = kNoShape;
  Vec2 normal = Vec2::Zero();  // unit, out of the face, in its body's frame
  Vec2 vertex = Vec2::Zero();  // m, the face's start, in its body's frame
  double length = 0.0;         // m
  bool towards_end = false;    // it moves away from the face's start
  double left = 0.0;           // m, to the end that it moves to
};

// A disc that runs off the end of a face is on its corner from then on, and may leave it at once: what has
// pressed it ends, or changes, at that moment.
//
// The contacts whose disc may do so within h s of the trajectories' epoch; none that has passed the end
// already.
void find_discs_near_ends(const World& world, const FoundContacts& found, double h,
                          std::vector<DiscOnFace>& discs);
// The first of these discs to do so, on the motions under the forces that are on the trajectories: when, in s;
// h if none does within h. Faces that another body continues have no end there, nor have those that turn a
// little into the next.
[[nodiscard]] double first_face_end(World& world, const std::vector<DiscOnFace>& discs,
                                    const Neighbours& neighbours, double h);

}  // namespace carom
