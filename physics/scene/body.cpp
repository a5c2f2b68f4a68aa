#include "physics/scene/body.h"

#include <limits>

namespace carom {

double mass_of(const Body& body) {
  if (has_infinite_mass(body)) return std::numeric_limits<double>::infinity();
  if (body.mass) return *body.mass;
  return body.density.value_or(1.0) * area(body.shape);
}

double inertia_of(const Body& body) {
  if (has_infinite_mass(body)) return std::numeric_limits<double>::infinity();
  if (body.inertia) return *body.inertia;
  return mass_of(body) * inertia_per_mass(body.shape);
}

std::vector<Body> bodies_of(const Compound& compound, const Body& body) {
  const Vec2 centre = centre_of(compound);
  std::vector<Body> bodies;
  for (const PlacedShape& placed : compound.shapes) {
    Body& part = bodies.emplace_back(body);
    part.name.clear();
    part.id = {};
    part.shape = shape_of(placed.shape);
    const Vec2 arm = turned_by(body.angle, placed.position - centre);
    part.position += arm;
    part.angle += placed.angle;
    part.velocity += body.spin * crossed(arm);
    part.mass.reset();
    part.inertia.reset();
    if (!has_infinite_mass(body)) part.density = mass_of(body) / area(body.shape);
    if (!placed.material.empty()) part.material = placed.material;
  }
  return bodies;
}

double turning_radius(const Body& body) { return inertia_of(body) > 0.0 ? bounding_radius(body.shape) : 0.0; }

}  // namespace carom
