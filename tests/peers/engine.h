#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <vector>

#include "tests/peers/scene.h"

// The interface of an engine to the cases, and its figures.
namespace carom::peers {

// overlaps(): penetration (m) of the true shapes at every contact point of the engine, or at the deepest
// alone; a gap is negative. contacts_begun(): number of contacts that have begun, if the scene counts them.
template <class W>
concept World = std::constructible_from<W, const Scene&> &&
    requires(W world, const W& seen, int body, double h) {
  world.step(h);
  { seen.motion(body) } -> std::same_as<Motion>;
  { seen.overlaps() } -> std::same_as<std::vector<double>>;
  { seen.contacts_begun() } -> std::same_as<long>;
};

struct Figure {
  std::string name;
  double value = 0.0;
  std::string_view unit;  // "1": dimensionless, or yes (1) and no (0)
};

struct Case {
  std::string_view id;
  std::vector<double> steps;  // s
  std::vector<Figure> (*run)(double h) = nullptr;
};

struct Engine {
  std::string_view name;
  std::vector<Case> cases;
};

[[nodiscard]] Engine carom_at_step_end();
[[nodiscard]] Engine carom_located();
// Each is defined only if its library was found.
[[nodiscard]] Engine box2d();
[[nodiscard]] Engine chipmunk();

}  // namespace carom::peers
