#pragma once

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

}  // namespace carom
