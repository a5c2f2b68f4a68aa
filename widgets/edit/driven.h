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

// The body at the place and with the velocity with which it is seen at this time (s): those that the scene
// states are without the part of its drive.
[[nodiscard]] inline Body as_seen(Body body, double time) { return moved_by_drive(std::move(body), time); }

// Whether its velocity can be any: it moves freely, or is driven straight on.
[[nodiscard]] inline bool has_own_velocity(const Body& body) {
  return !body.fixed && (!body.drive || body.drive->amplitude.isZero(0.0));
}
// A body as it is seen, whose drive has the velocity that the body has.
[[nodiscard]] inline Body driven_as_seen(Body body) {
  if (!body.drive) return body;
  if (has_own_velocity(body)) body.drive->velocity = body.velocity;
  body.velocity = Vec2::Zero();
  return body;
}

// Edits of driven bodies as they are seen, as edits of the scene that states them.
[[nodiscard]] SceneEdits as_stated(SceneEdits edits, const Scene& scene, double time);

}  // namespace carom
