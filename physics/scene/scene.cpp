#include "physics/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <unordered_set>

namespace carom {
namespace {

template <class... Ts>
struct Overloaded : Ts... {
  using Ts::operator()...;
};

// Uniform in [low, high); std::uniform_real_distribution differs between standard libraries.
double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
}

}  // namespace

double area(const Shape& shape) {
  return std::visit(Overloaded{[](const Disc& d) { return std::numbers::pi * d.radius * d.radius; },
                               [](const Box& b) { return b.width * b.height; }},
                    shape);
}

double bounding_radius(const Shape& shape) {
  return std::visit(Overloaded{[](const Disc& d) { return d.radius; },
                               [](const Box& b) { return 0.5 * std::hypot(b.width, b.height); }},
                    shape);
}

double inertia_per_mass(const Shape& shape) {
  return std::visit(Overloaded{[](const Disc& d) { return 0.5 * d.radius * d.radius; },
                               [](const Box& b) { return (b.width * b.width + b.height * b.height) / 12.0; }},
                    shape);
}

Material mixed(const Material& a, const Material& b) {
  Material m;
  m.name = a.name + "/" + b.name;
  m.restitution = std::min(a.restitution, b.restitution);
  m.tangential_restitution = std::min(a.tangential_restitution, b.tangential_restitution);
  m.static_friction = std::sqrt(a.static_friction * b.static_friction);
  m.kinetic_friction = std::sqrt(a.kinetic_friction * b.kinetic_friction);
  return m;
}

double mass_of(const Body& body) {
  if (is_immovable(body)) return std::numeric_limits<double>::infinity();
  if (body.mass) return *body.mass;
  return body.density.value_or(1.0) * area(body.shape);
}

Material material_named(const Scene& scene, const std::string& name) {
  const auto found = std::find_if(scene.materials.begin(), scene.materials.end(),
                                  [&](const Material& m) { return m.name == name; });
  if (found != scene.materials.end()) return *found;
  if (name == "default") return Material{};
  throw std::out_of_range("no material is called '" + name + "'");
}

std::vector<Body> all_bodies(const Scene& scene) {
  std::vector<Body> bodies = scene.bodies;
  for (const GridGenerator& g : scene.generators) {
    std::mt19937_64 random(g.seed);
    for (int row = 0; row < g.rows; ++row) {
      for (int column = 0; column < g.columns; ++column) {
        Body body;
        body.name = g.name + "-" + std::to_string(row * g.columns + column + 1);
        body.position = g.origin + Vec2(column * g.spacing.x(), row * g.spacing.y());
        body.position.x() += uniform(random, -g.jitter, g.jitter);
        body.position.y() += uniform(random, -g.jitter, g.jitter);
        body.velocity.x() = uniform(random, -g.speed_max, g.speed_max);
        body.velocity.y() = uniform(random, -g.speed_max, g.speed_max);
        body.shape = Disc{uniform(random, g.radius_min, g.radius_max)};
        body.density = g.density;
        body.material = g.material;
        bodies.push_back(std::move(body));
      }
    }
  }
  return bodies;
}

std::string free_body_name(const Scene& scene, const std::string& stem) {
  std::unordered_set<std::string> taken;
  for (const Body& body : all_bodies(scene)) taken.insert(body.name);
  for (int i = 1;; ++i) {
    std::string name = stem + "-" + std::to_string(i);
    if (!taken.contains(name)) return name;
  }
}

}  // namespace carom
