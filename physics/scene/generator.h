#pragma once

#include <cstdint>
#include <string>

#include "physics/math/vectors.h"
#include "physics/scene/fields.h"
#include "physics/scene/id.h"

namespace carom {

// A grid of columns × rows discs, row by row from the lower left. Each is displaced by up to `jitter` in x
// and y; its radius and velocity are drawn uniformly, by a 64-bit Mersenne twister with `seed`.
struct GridGenerator {
  std::string name = "disc";      // bodies are called name-1, name-2, ...
  int columns = 1;                // >= 1
  int rows = 1;                   // >= 1
  Vec2 origin = Vec2::Zero();     // m, the first disc's centre
  Vec2 spacing = Vec2(1.0, 1.0);  // m
  double jitter = 0.0;            // m, >= 0
  double radius_min = 0.1;        // m, > 0
  double radius_max = 0.1;        // m, >= radius_min
  double speed_max = 0.0;         // m/s, each velocity component is drawn from [-speed_max, speed_max]
  double density = 1.0;           // kg/m²
  std::string material = "default";
  std::uint64_t seed = 1;
  Id<GridGenerator> id{};
};

template <class V>
void fields(V& v, Is<GridGenerator> auto& g) {
  v.cases({"type", "the kind of generator"}, Words{"grid"}, 0, [&](std::size_t, V& k) {
    k.required({"name", "the stem of the bodies' names"}, g.name, kStemLength);
    k.field({"columns", "discs side by side"}, g.columns, Whole{1, kMostBodies});
    k.field({"rows", "discs one over the other"}, g.rows, Whole{1, kMostBodies});
    k.required({"origin", "the first disc's centre, two numbers, [x, y]"}, g.origin, any_number("m"));
    k.field({"spacing", "from disc to disc, [x, y]"}, g.spacing, any_number("m"));
    k.field({"jitter", "by which each disc is moved at most"}, g.jitter, from_zero("m"));
    k.ends_of_range({"radius", "two numbers, [least, largest]"}, g.radius_min, g.radius_max, positive("m"));
    k.field({"speed", "largest velocity component"}, g.speed_max, from_zero("m/s"));
    k.field({"density", "of each disc"}, g.density, positive("kg/m²"));
    k.field({"material", "the name of one"}, g.material, kNameLength);
    k.field({"seed", "of the random numbers"}, g.seed, Whole{0.0, 9e15});
  });
}

}  // namespace carom
