#pragma once

#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <string>
#include <vector>

#include "tests/support/draws.h"
#include "tests/support/scenes.h"

// Bodies of several convex parts: compounds and concave polygons.
namespace carom::test {

inline PlacedShape placed(const PlainShape& shape, const Vec2& position, double angle = 0.0) {
  return {shape, position, angle, {}};
}

inline Body shaped(const std::string& name, const Shape& shape, const Vec2& position, double angle = 0.0) {
  Body b = disc(name, position, {0.0, 0.0});
  b.shape = shape;
  b.angle = angle;
  b.mass.reset();
  b.density = 1.0;
  return b;
}

inline Body ground(const std::string& name, const Vec2& position, double angle) {
  Body b = shaped(name, Wall{}, position, angle);
  b.density.reset();
  b.fixed = true;
  return b;
}

inline std::vector<Body> half_planes(double half) {
  return {ground("floor", {0.0, -half}, 0.0), ground("ceiling", {0.0, half}, M_PI),
          ground("left", {-half, 0.0}, -M_PI / 2), ground("right", {half, 0.0}, M_PI / 2)};
}

inline std::vector<Shape> several() {
  return {Polygon{{{0, 0}, {0.6, 0}, {0.6, 0.2}, {0.2, 0.2}, {0.2, 0.6}, {0, 0.6}}},
          Polygon{{{0, 0}, {0.6, 0}, {0.6, 0.4}, {0.4, 0.4}, {0.4, 0.2}, {0.2, 0.2}, {0.2, 0.4}, {0, 0.4}}},
          Compound{{placed(Disc{0.12}, {-0.25, 0.0}), placed(Disc{0.12}, {0.25, 0.0}),
                    placed(Box{0.5, 0.06}, {0, 0})}},
          Compound{{placed(Box{0.5, 0.08}, {0.0, 0.0}), placed(Box{0.14, 0.3}, {0.3, 0.0}, 0.1)}}};
}

inline std::vector<Body> gas_of_compounds(std::uint64_t seed) {
  Draws draws(seed);
  std::vector<Body> bodies = half_planes(2.0);
  const std::vector<Shape> shapes = several();
  for (int i = 0; i < 16; ++i) {
    Body b = shaped(fmt::format("b{}", i), shapes[static_cast<std::size_t>(i) % shapes.size()],
                    {-1.35 + 0.9 * (i % 4), -1.35 + 0.9 * (i / 4)}, draws.angle());
    b.velocity = draws.in_square(1.0);
    b.spin = draws.between(-3.0, 3.0);
    bodies.push_back(b);
  }
  return bodies;
}

}  // namespace carom::test
