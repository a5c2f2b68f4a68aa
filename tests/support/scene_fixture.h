#pragma once

#include <memory>

#include "physics/preset/preset.h"
#include "physics/record/frame.h"

namespace carom {

// The present moment of a simulation as a frame.
inline std::shared_ptr<Frame> frame_of(const Simulation& simulation) {
  auto frame = std::make_shared<Frame>();
  frame->time = simulation.time();
  frame->state = simulation.state();
  frame->bodies = std::make_shared<const std::vector<Body>>(simulation.bodies());
  frame->totals = simulation.totals();
  frame->impacts = simulation.last_impacts();
  return frame;
}

// A floor from x = 0 to 4 m with its top at y = 0, a disc of 0.5 m at (1, 1) that moves up, and one of 0.25 m
// at (3, 1) at rest.
inline Preset two_discs() {
  Preset preset;
  Body floor;
  floor.name = "floor";
  floor.shape = Box{4.0, 0.2};
  floor.position = Vec2(2.0, -0.1);
  floor.fixed = true;
  Body a;
  a.name = "A";
  a.shape = Disc{0.5};
  a.position = Vec2(1.0, 1.0);
  a.velocity = Vec2(0.0, 2.0);
  Body b;
  b.name = "B";
  b.shape = Disc{0.25};
  b.position = Vec2(3.0, 1.0);
  preset.scene.bodies = {floor, a, b};
  return preset;
}

}  // namespace carom
