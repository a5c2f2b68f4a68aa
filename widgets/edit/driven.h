#pragma once

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

// The body at the place where it is seen at this time (s), which the scene states without the part of its
// drive.
[[nodiscard]] inline Body as_seen(Body body, double time) {
  if (body.drive) body.position = drive_position(*body.drive, body.position, time);
  return body;
}

// Edits of driven bodies as they are seen, as edits of the scene that states them.
[[nodiscard]] SceneEdits as_stated(SceneEdits edits, const Scene& scene, double time);

}  // namespace carom
