#pragma once

#include "widgets/scene/drawing.h"

namespace carom {

// The parts of a drawing that tell what acts on the bodies. Each adds to `out` what `seen` of the world shows.

// Between its ends' rims, a zigzag; a bumper (one that only pushes) stands at its free length with a plate
// where it waits for the body; a rubber band (one that only pulls) is a straight line. One that rests is thin
// and pale. An end at a point of the plane has a dot.
void add_springs(const DrawingInput& input, const WorldRect& seen, Drawing& out);

// Driven bodies are hatched. A double arrow shows how far a vibration goes, to scale where it can be seen, an
// arrow where a steady drive goes.
void add_drives(const DrawingInput& input, const WorldRect& seen, Drawing& out);

// An arrow for each force that acts now and an arc about the body for each torque, with their values.
void add_applied_forces(const DrawingInput& input, const WorldRect& seen, Drawing& out);

// N: normal and tangential together, on the contact's body b.
[[nodiscard]] Vec2 force_on_b(const ContactForce& contact);

// The force of each contact that lasts, from its point: on the body b, or on a
// where b moves as it is told. Where there is one, also the key to their length.
void add_contact_forces(const DrawingInput& input, const WorldRect& seen, Drawing& out);

}  // namespace carom
