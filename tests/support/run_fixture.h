#pragma once

#include <memory>
#include <string>
#include <vector>

#include "physics/preset/preset.h"
#include "physics/record/frame.h"
#include "physics/record/recorder.h"
#include "physics/run/simulation.h"

namespace carom {

inline Body disc(const std::string& name, const Vec2& position, const Vec2& velocity, double mass) {
  Body body;
  body.name = name;
  body.shape = Disc{0.2};
  body.position = position;
  body.velocity = velocity;
  body.mass = mass;
  return body;
}

// 1 kg at 3 m/s hits 2 kg at rest at t = 0.2 s, elastically: they leave at -1 and 2 m/s.
inline Preset head_on_scene() {
  Preset preset;
  preset.title = "Head-on";
  preset.scene.bodies = {disc("A", {-1.0, 0.0}, {3.0, 0.0}, 1.0), disc("B", {0.0, 0.0}, {0.0, 0.0}, 2.0)};
  return preset;
}

// The frame of a run from the start to `time`, as the simulation's thread would publish it.
inline Frame run_to(const Preset& preset, double time, const std::vector<Curve>& curves = {}) {
  Simulation simulation(setup_of(preset));
  simulation.watch_impacts(true);
  Frame frame;
  frame.run = 1;
  Sampler sampler(curves);
  sampler.begin(simulation);
  simulation.advance_to(time, [&] {
    sampler.after_step(simulation);
    const auto& impacts = simulation.last_impacts();
    frame.impacts.insert(frame.impacts.end(), impacts.begin(), impacts.end());
  });
  take_moment(simulation, frame);
  frame.rows = {sampler.take()};
  frame.rows_known_until = frame.time;
  frame.scales = sampler.scales();
  frame.bodies = std::make_shared<const std::vector<Body>>(simulation.bodies());
  frame.forces = std::make_shared<const Forces>(preset.scene.forces);
  return frame;
}

// A plot by its name.
inline Plot named(const std::string& id) {
  Plot plot;
  plot.id = id;
  return plot;
}

}  // namespace carom
