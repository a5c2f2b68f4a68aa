#pragma once

#include <vector>

#include "physics/step/contact_finder.h"
#include "physics/step/neighbours.h"
#include "physics/step/world.h"

namespace carom {

// A disc, or a corner, that touches a face of another body.
struct TouchOnFace {
  BodyIndex toucher = kNoBody;
  ShapeIndex toucher_part = kNoShape;
  Vec2 tip = Vec2::Zero();  // m, the disc's centre or the corner, in the frame of its part
  BodyIndex body = kNoBody;
  ShapeIndex part = kNoShape;
  Vec2 normal = Vec2::Zero();  // unit, out of the face, in its body's frame
  Vec2 vertex = Vec2::Zero();  // m, the face's start, in its body's frame
  double length = 0.0;         // m
  bool towards_end = false;    // it moves away from the face's start
  double left = 0.0;           // m, to the end that it moves to
  bool flat = false;           // a face of its own lies on this one
  bool changes = false;        // at that end the surface goes on with another law
};

// What runs off the end of a face is at its corner from then on, and may leave it at once: what has pressed it
// ends, or changes, at that moment.
//
// The contacts that may do so within h s of the trajectories' epoch; none that has passed the end already. Also
// those that may come from one surface to another one flush with it: friction changes there.
void find_touches_near_ends(const World& world, const FoundContacts& found, const Neighbours& neighbours,
                            double h, std::vector<TouchOnFace>& touches);
// The first of them to do so, on the motions under the forces that are on the trajectories: when, in s; h if
// none does within h. Faces that another body continues have no end there but where the law changes, nor have
// those that turn a little into the next.
[[nodiscard]] double first_face_end(World& world, const std::vector<TouchOnFace>& touches,
                                    const Neighbours& neighbours, double h);
// Whether contact i is that of two corners that leave each other within h s: each moves out of the other body,
// whose surface ends there. Nothing presses them any more.
[[nodiscard]] bool leaves_corner(const World& world, const FoundContacts& found, int i,
                                 const Neighbours& neighbours, double h);

}  // namespace carom
