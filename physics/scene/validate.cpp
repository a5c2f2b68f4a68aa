#include "physics/scene/validate.h"

#include <cmath>
#include <fmt/format.h>
#include <unordered_set>

namespace carom {
namespace {

void check_range(const std::string& place, double value, double low, double high, std::string_view unit) {
  if (value >= low && value <= high) return;
  refuse_value(place, fmt::format("{}", value),
               fmt::format("a number from {} to {}{}{}", low, high, unit.empty() ? "" : " ", unit));
}

void check_positive(const std::string& place, double value, std::string_view unit) {
  check_range(place, value, kLeastPositive, kLargestNumber, unit);
}

void check_vector(const std::string& place, const Vec2& value, std::string_view unit) {
  for (int i = 0; i < 2; ++i)
    check_range(fmt::format("{}/{}", place, i), value[i], -kLargestNumber, kLargestNumber, unit);
}

void check_materials(const Scene& scene) {
  std::unordered_set<std::string> names;
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const Material& m = scene.materials[i];
    const std::string at = fmt::format("/materials/{}", i);
    if (m.name.empty()) refuse_value(at + "/name", "an empty name", "a name");
    if (!names.insert(m.name).second)
      refuse_value(at + "/name", fmt::format("\"{}\", used before,", m.name), "a name of its own");
    check_range(at + "/restitution", m.restitution, 0.0, 1.0, "");
    check_range(at + "/tangential_restitution", m.tangential_restitution, -1.0, 1.0, "");
    check_range(at + "/kinetic_friction", m.kinetic_friction, 0.0, 1e3, "");
    if (!(m.static_friction >= m.kinetic_friction && m.static_friction <= 1e3)) {
      refuse_value(at + "/static_friction", fmt::format("{}", m.static_friction),
                   fmt::format("a number from kinetic_friction = {} to 1000", m.kinetic_friction));
    }
  }
}

void check_material_reference(const Scene& scene, const std::string& place, const std::string& name) {
  if (name == "default") return;
  std::string known = "\"default\"";
  for (const Material& m : scene.materials) {
    if (m.name == name) return;
    known += ", \"" + m.name + "\"";
  }
  refuse_value(place, "\"" + name + "\"", known);
}

void check_bodies(const Scene& scene) {
  std::unordered_set<std::string> names;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Body& b = scene.bodies[i];
    const std::string at = fmt::format("/bodies/{}", i);
    if (b.name.empty()) refuse_value(at + "/name", "an empty name", "a name");
    if (!names.insert(b.name).second)
      refuse_value(at + "/name", fmt::format("\"{}\", used before,", b.name), "a name of its own");
    if (const auto* disc = std::get_if<Disc>(&b.shape)) check_positive(at + "/shape/radius", disc->radius, "m");
    if (const auto* box = std::get_if<Box>(&b.shape)) {
      check_positive(at + "/shape/width", box->width, "m");
      check_positive(at + "/shape/height", box->height, "m");
      if (!b.fixed) refuse_value(at + "/fixed", "false for a box", "true: boxes that move are not modelled");
    }
    check_vector(at + "/position", b.position, "m");
    check_vector(at + "/velocity", b.velocity, "m/s");
    check_range(at + "/angle", b.angle, -kLargestNumber, kLargestNumber, "rad");
    check_range(at + "/spin", b.spin, -kLargestNumber, kLargestNumber, "rad/s");
    if (b.fixed && (!b.velocity.isZero(0.0) || b.spin != 0.0)) {
      refuse_value(at + "/velocity", "a motion of a fixed body",
                   "no velocity and no spin, or \"fixed\": false");
    }
    if (b.mass && b.density) refuse_value(at + "/density", "a density beside a mass", "either of the two");
    if (b.mass) check_positive(at + "/mass", *b.mass, "kg");
    if (b.density) check_positive(at + "/density", *b.density, "kg/m²");
    check_material_reference(scene, at + "/material", b.material);
  }
}

void check_generators(const Scene& scene) {
  double count = static_cast<double>(scene.bodies.size());
  for (std::size_t i = 0; i < scene.generators.size(); ++i) {
    const GridGenerator& g = scene.generators[i];
    const std::string at = fmt::format("/generators/{}", i);
    if (g.name.empty()) refuse_value(at + "/name", "an empty name", "a name");
    check_range(at + "/columns", g.columns, 1, kMostBodies, "");
    check_range(at + "/rows", g.rows, 1, kMostBodies, "");
    count += static_cast<double>(g.columns) * g.rows;
    if (count > kMostBodies)
      refuse_value(at, fmt::format("{} bodies in all", count), fmt::format("at most {}", kMostBodies));
    check_vector(at + "/origin", g.origin, "m");
    check_vector(at + "/spacing", g.spacing, "m");
    check_range(at + "/jitter", g.jitter, 0.0, kLargestNumber, "m");
    check_positive(at + "/radius/0", g.radius_min, "m");
    check_range(at + "/radius/1", g.radius_max, g.radius_min, kLargestNumber, "m");
    check_range(at + "/speed", g.speed_max, 0.0, kLargestNumber, "m/s");
    check_positive(at + "/density", g.density, "kg/m²");
    check_material_reference(scene, at + "/material", g.material);
  }
  std::unordered_set<std::string> names;
  for (const Body& b : all_bodies(scene)) {
    if (!names.insert(b.name).second) {
      refuse_value("/generators", fmt::format("the body name \"{}\", used before,", b.name),
                   "names of their own");
    }
  }
}

void check_forces(const Scene& scene, const std::unordered_set<std::string>& bodies) {
  check_vector("/gravity", scene.forces.gravity, "m/s²");
  check_range("/forces (quadratic_drag)/coefficient", scene.forces.quadratic_drag, 0.0, kLargestNumber, "kg/m");
  for (const Spring& s : scene.forces.springs) {
    const std::string at = fmt::format("/forces (spring of \"{}\")", s.body);
    if (!bodies.contains(s.body)) refuse_value(at + "/body", "\"" + s.body + "\"", "the name of a body");
    check_vector(at + "/anchor", s.anchor, "m");
    check_positive(at + "/stiffness", s.stiffness, "N/m");
    check_range(at + "/rest_length", s.rest_length, 0.0, kLargestNumber, "m");
  }
}

}  // namespace

std::string shortened(std::string text, std::size_t most) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  }
  if (text.size() <= most) return text;
  // Whole UTF-8 characters only.
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0U) == 0x80U) --most;
  return text.substr(0, most) + "...";
}

void refuse_value(const std::string& place, const std::string& found, const std::string& allowed) {
  throw SceneError(fmt::format("{}: {} is not allowed; allowed: {}", place.empty() ? "/" : shortened(place),
                               shortened(found), shortened(allowed, 300)));
}

void validate(const Scene& scene) {
  check_range("/method/step", scene.method.step, kLeastStep, kLargestStep, "s");
  check_positive("/duration", scene.duration, "s");
  check_materials(scene);
  check_bodies(scene);
  check_generators(scene);
  std::unordered_set<std::string> names;
  for (const Body& b : all_bodies(scene)) names.insert(b.name);
  check_forces(scene, names);
  for (std::size_t i = 0; i < scene.expect.size(); ++i) {
    const Expectation& e = scene.expect[i];
    const std::string at = fmt::format("/expect/{}", i);
    for (std::size_t k = 0; k < e.bodies.size(); ++k) {
      if (!names.contains(e.bodies[k])) {
        refuse_value(fmt::format("{}/bodies/{}", at, k), "\"" + e.bodies[k] + "\"", "the name of a body");
      }
    }
    check_range(at + "/tolerance", e.tolerance, 0.0, kLargestNumber, "");
    check_range(at + "/time", e.time, 0.0, kLargestNumber, "s");
    if (e.reduction == Expectation::Reduction::kAtImpact && e.impact < 1) {
      refuse_value(at + "/impact", fmt::format("{}", e.impact), "1, 2, ...");
    }
  }
  if (scene.view) {
    check_vector("/view/center", scene.view->center, "m");
    check_positive("/view/width", scene.view->width, "m");
  }
}

}  // namespace carom
