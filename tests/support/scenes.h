#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "physics/preset/preset.h"
#include "physics/run/simulation.h"
#include "physics/scene/scene.h"

// Small scenes that the tests share.
namespace carom::test {

inline Body disc(const std::string& name, Vec2 position, Vec2 velocity, double radius = 0.1,
                 double mass = 1.0) {
  Body b;
  b.name = name;
  b.shape = Disc{radius};
  b.position = position;
  b.velocity = velocity;
  b.mass = mass;
  return b;
}

inline Body box(const std::string& name, Vec2 position, Vec2 velocity, double width, double height,
                double mass = 1.0) {
  Body b = disc(name, position, velocity, 0.1, mass);
  b.shape = Box{width, height};
  return b;
}

inline Body fixed(const std::string& name, const Shape& shape, Vec2 position) {
  Body b;
  b.name = name;
  b.shape = shape;
  b.position = position;
  b.fixed = true;
  return b;
}

inline Body wall(const std::string& name, Vec2 position, double width, double height, double angle = 0.0) {
  Body b;
  b.name = name;
  b.shape = Box{width, height};
  b.position = position;
  b.angle = angle;
  b.fixed = true;
  return b;
}

// From the centre of one body to that of another.
inline Joint joint_between(JointKind kind, const std::string& body, const std::string& to) {
  Joint j;
  j.kind = kind;
  j.body = body;
  j.to = to;
  return j;
}

// A scene whose default material is the given one.
inline Scene scene_with(std::vector<Body> bodies, double restitution = 1.0, double friction = 0.0) {
  Scene s;
  s.bodies = std::move(bodies);
  s.materials = {{"default", restitution, 0.0, friction, friction}};
  return s;
}
inline RunSetup setup_with(std::vector<Body> bodies, double restitution = 1.0, double friction = 0.0) {
  return {scene_with(std::move(bodies), restitution, friction), {}, {}};
}
inline Preset preset_with(std::vector<Body> bodies, double restitution = 1.0, double friction = 0.0) {
  Preset preset;
  preset.title = "test";
  preset.scene = scene_with(std::move(bodies), restitution, friction);
  return preset;
}

// Four walls of the given thickness around the rectangle [-half, half]².
inline std::vector<Body> room(double half, double thickness) {
  const double middle = half + 0.5 * thickness;
  const double length = 2.0 * (half + thickness);
  return {wall("left", {-middle, 0.0}, thickness, length), wall("right", {middle, 0.0}, thickness, length),
          wall("floor", {0.0, -middle}, length, thickness), wall("ceiling", {0.0, middle}, length, thickness)};
}

inline bool same_bytes(const State& a, const State& b) {
  return a.q == b.q && a.v == b.v && a.quadratures == b.quadratures;
}

}  // namespace carom::test
