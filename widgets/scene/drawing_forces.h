#pragma once

#include "widgets/scene/drawing.h"

namespace carom {

// The parts of a drawing that show forces and drives. Each adds to `out` the items within `seen`.

// A spring is a zigzag between the rims of its ends. A bumper (push only) has its free length and a plate that
// the body will meet; a rubber band (pull only) is a straight line. An idle spring is thin and pale. An end at
// a point of the plane has a dot.
void add_springs(const DrawingInput& input, const WorldRect& seen, Drawing& out);

// The hand that pulls a body: a zigzag from where it holds it to where it is, over the bodies, with its force.
void add_hand(const DrawingInput& input, Drawing& out);

// Driven bodies are hatched. A double arrow shows the amplitude of a vibration, to scale where it is visible;
// an arrow shows the direction of a steady drive.
void add_drives(const DrawingInput& input, const WorldRect& seen, Drawing& out);

// An arrow for each force that acts now and an arc about the body for each torque, with their values.
void add_applied_forces(const DrawingInput& input, const WorldRect& seen, Drawing& out);

// The share of an applied force at a time in s: it rises linearly, stays constant and ends.
[[nodiscard]] double share_at(const AppliedForce& force, double time);

// N: normal and tangential together, on the contact's body b.
[[nodiscard]] Vec2 force_on_b(const ContactForce& contact);

// An arrow for the force of each resting contact, from its point: on the body b, or on a where b is kinematic.
// With the key to the arrows' length if there is any.
void add_contact_forces(const DrawingInput& input, const WorldRect& seen, Drawing& out);

}  // namespace carom
