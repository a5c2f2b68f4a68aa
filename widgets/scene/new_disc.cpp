#include "widgets/scene/new_disc.h"

#include <variant>
#include <vector>

namespace carom {

Body new_disc(std::span<const Body> bodies, const Vec2& position, double radius) {
  Body body;
  body.name = free_body_name(std::vector<Body>(bodies.begin(), bodies.end()), "new");
  body.shape = Disc{radius};
  body.position = position;
  body.density = 1.0;
  for (const Body& other : bodies) {
    const auto* disc = std::get_if<Disc>(&other.shape);
    if (disc == nullptr || disc->radius == 0.0 || has_infinite_mass(other)) continue;
    body.density = mass_of(other) / area(other.shape);
    body.material = other.material;
    break;
  }
  return body;
}

}  // namespace carom
