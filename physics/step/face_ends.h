#pragma once

#include <vector>

#include "physics/step/contact_finder.h"
#include "physics/step/neighbours.h"
#include "physics/step/touch_on_face.h"
#include "physics/step/world.h"

namespace carom {

// A touch that may come to an end of a face.
struct TouchNearEnd {
  TouchOnFace on;
  bool towards_end = false;  // it moves away from the face's start
  bool law_changes = false;  // at that end the surface goes on with another law
  bool comes_on = false;     // it is beside the face, and comes onto it
};

// What runs off the end of a face is at its corner from then on, and may leave it at once: what has pressed it
// ends, or changes, at that moment. Likewise where a disc that rolls about a corner comes to the next face, of
// this body or of another one.
//
// The contacts that may do so within h s of the trajectories' epoch; none that has passed the end already. Also
// those that may come from one surface to another one flush with it: friction changes there.
void find_touches_near_ends(const World& world, const FoundContacts& found, const Neighbours& neighbours,
                            double h, std::vector<TouchNearEnd>& touches);
// The first of them to do so, on the motions under the forces that are on the trajectories: when, in s; h if
// none does within h. Faces that another body continues have no end there but where the law changes, nor have
// those that turn a little into the next.
[[nodiscard]] double first_face_end(World& world, const std::vector<TouchNearEnd>& touches,
                                    const Neighbours& neighbours, double h);
// Whether contact i is that of a disc at a corner from which another contact holds it on a face: it has come
// onto that face, and nothing presses the corner any more. In scenes with few contacts.
[[nodiscard]] bool has_passed_on(const World& world, const FoundContacts& found, int i);
// Whether contact i is that of two corners that leave each other within h s: each moves out of the other body,
// whose surface ends there, or goes on as another part with a contact of its own. Nothing presses them any
// more.
[[nodiscard]] bool leaves_corner(const World& world, const FoundContacts& found, int i,
                                 const Neighbours& neighbours, double h);

}  // namespace carom
