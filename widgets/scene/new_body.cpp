#include "widgets/scene/new_body.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

namespace carom {
namespace {

template <class Predicate>
const Body* first_of(std::span<const Body> bodies, Predicate fits) {
  const auto found = std::find_if(bodies.begin(), bodies.end(), fits);
  return found == bodies.end() ? nullptr : &*found;
}

const Body* model_of(std::span<const Body> bodies) {
  if (const Body* disc = model_disc(bodies)) return disc;
  return first_of(bodies, [](const Body& body) { return !has_infinite_mass(body) && area(body.shape) > 0.0; });
}

const Body* first_that_moves(std::span<const Body> bodies) {
  return first_of(bodies, [](const Body& body) { return !has_infinite_mass(body); });
}

// The nearest one, by its ratio, of 1, 2 or 5 times a power of ten.
double round_mass(double mass) {
  const double exponent = std::floor(std::log10(mass));
  double best = 0.0;
  for (const double digit : {1.0, 2.0, 5.0, 10.0}) {
    const double round = exponent < 0.0 ? digit / std::pow(10.0, -exponent) : digit * std::pow(10.0, exponent);
    if (best == 0.0 || std::abs(std::log(round / mass)) < std::abs(std::log(best / mass))) best = round;
  }
  return best;
}

// At which the mass is this one to its last bit, if doubles can have it so.
double density_for(double mass, double size) {
  const double density = mass / size;
  for (const double each : {density, std::nextafter(density, 0.0), std::nextafter(density, 2.0 * density)}) {
    if (each * size == mass) return each;
  }
  return density;
}

}  // namespace

std::string new_body_name(std::span<const Body> bodies) {
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    std::string name(1, letter);
    if (first_of(bodies, [&](const Body& body) { return body.name == name; }) == nullptr) return name;
  }
  return free_body_name(std::vector<Body>(bodies.begin(), bodies.end()), "A");
}

const Body* model_disc(std::span<const Body> bodies) {
  return first_of(bodies, [](const Body& body) {
    const auto* disc = std::get_if<Disc>(&body.shape);
    return disc != nullptr && disc->radius > 0.0 && !has_infinite_mass(body);
  });
}

Body new_body(std::span<const Body> bodies, const Shape& shape, const Vec2& position, double angle) {
  Body body;
  body.name = new_body_name(bodies);
  body.shape = shape;
  body.position = position;
  body.angle = angle;
  body.fixed = std::holds_alternative<Wall>(shape);
  const Body* model = model_of(bodies);
  if (model != nullptr) body.material = model->material;
  if (body.fixed) return body;
  if (area(shape) > 0.0) {
    const Body* other = first_that_moves(bodies);
    body.density = model != nullptr
                       ? mass_of(*model) / area(model->shape)
                       : density_for(round_mass(other != nullptr ? mass_of(*other) : 1.0), area(shape));
  } else {
    body.mass = model != nullptr ? mass_of(*model) : 1.0;
  }
  return body;
}

}  // namespace carom
