#pragma once

#include <optional>
#include <utility>

#include "physics/scene/drive.h"
#include "physics/scene/edit.h"
#include "physics/scene/scene.h"

namespace carom {

// The body with a prescribed motion: without a mass, a velocity and a spin of its own.
[[nodiscard]] inline Body driven(Body body, const Drive& drive) {
  body.fixed = false;
  body.drive = drive;
  for (std::optional<double>* mass : {&body.mass, &body.density, &body.inertia}) mass->reset();
  body.velocity = Vec2::Zero();
  body.spin = 0.0;
  return body;
}

// Whether its velocity can be any: it moves freely, or is driven straight on.
[[nodiscard]] inline bool has_own_velocity(const Body& body) {
  return !body.fixed && (!body.drive || body.drive->amplitude.isZero(0.0));
}
// A body as it is seen, whose drive has the velocity that the body was given.
[[nodiscard]] inline Body driven_so(Body body) {
  if (body.drive && has_own_velocity(body)) body.drive->velocity = body.velocity;
  return body;
}

// Edits of bodies as they are seen at this time (s; see moved_by_drive()), as edits of the scene that states
// them. Where a drive is another one, what the body does from now on begins where it is seen at the start of a
// run, and where its velocity was pulled (driven_so()); else its drive was always so.
[[nodiscard]] SceneEdits as_stated(SceneEdits edits, const Scene& scene, double time, bool at_start);

}  // namespace carom
