#include "widgets/scene/new_disc.h"

#include <algorithm>
#include <variant>
#include <vector>

namespace carom {

const Body* model_disc(std::span<const Body> bodies) {
  const auto found = std::find_if(bodies.begin(), bodies.end(), [](const Body& body) {
    const auto* disc = std::get_if<Disc>(&body.shape);
    return disc != nullptr && disc->radius > 0.0 && !has_infinite_mass(body);
  });
  return found == bodies.end() ? nullptr : &*found;
}

Body new_disc(std::span<const Body> bodies, const Vec2& position, double radius) {
  Body body;
  body.name = free_body_name(std::vector<Body>(bodies.begin(), bodies.end()), "new");
  body.shape = Disc{radius};
  body.position = position;
  body.density = 1.0;
  if (const Body* model = model_disc(bodies)) {
    body.density = mass_of(*model) / area(model->shape);
    body.material = model->material;
  }
  return body;
}

}  // namespace carom
