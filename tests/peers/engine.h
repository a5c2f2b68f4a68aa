#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <vector>

#include "tests/peers/scene.h"

// What the cases ask of an engine, and what they tell of it.
namespace carom::peers {

// overlaps(): of every contact point the engine has now, or of the deepest alone, how deep the true shapes are
// in one another (m); a gap is negative. contacts_begun(): how many contacts have begun, where the scene counts
// them.
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
// Each is defined only where its library was found.
[[nodiscard]] Engine box2d();
[[nodiscard]] Engine chipmunk();

}  // namespace carom::peers
