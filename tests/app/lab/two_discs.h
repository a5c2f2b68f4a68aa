#pragma once

#include "physics/preset/preset.h"

namespace carom {

// Two discs on a line: the left one moves to the right.
inline Preset two_discs() {
  Preset preset;
  preset.title = "Two discs";
  preset.duration = 2.0;
  preset.method.step = 0.01;
  Material wood;
  wood.name = "wood";
  wood.restitution = 1.0;
  preset.scene.materials = {wood};
  for (const char* name : {"left", "right"}) {
    Body body;
    body.name = name;
    body.shape = Disc{0.1};
    body.mass = 1.0;
    body.material = "wood";
    body.position = {preset.scene.bodies.empty() ? 0.0 : 1.0, 0.0};
    preset.scene.bodies.push_back(body);
  }
  preset.scene.bodies[0].velocity = {1.0, 0.0};
  return preset;
}

}  // namespace carom
