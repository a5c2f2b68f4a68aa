#include "physics/scene/validate.h"

#include <cmath>
#include <fmt/format.h>
#include <unordered_map>
#include <unordered_set>

#include "physics/scene/needs.h"
#include "physics/scene/polygon.h"
#include "physics/scene/validate_links.h"

namespace carom {
namespace {

constexpr std::size_t kMostSweepValues = 10'000;

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

void check_surface(const std::string& at, const Material& m) {
  check_range(at + "/restitution", m.restitution, 0.0, 1.0, "");
  check_range(at + "/tangential_restitution", m.tangential_restitution, -1.0, 1.0, "");
  check_range(at + "/kinetic_friction", m.kinetic_friction, 0.0, 1e3, "");
  if (!(m.static_friction >= m.kinetic_friction && m.static_friction <= 1e3)) {
    refuse_value(at + "/static_friction", fmt::format("{}", m.static_friction),
                 fmt::format("a number from kinetic_friction = {} to 1000", m.kinetic_friction));
  }
  check_range(at + "/rolling_resistance", m.rolling_resistance, 0.0, 1e3, "");
}

void check_materials(const Scene& scene) {
  std::unordered_set<std::string> names;
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const Material& m = scene.materials[i];
    const std::string at = fmt::format("/materials/{}", i);
    if (m.name.empty()) refuse_value(at + "/name", "an empty name", "a name");
    if (!names.insert(m.name).second)
      refuse_value(at + "/name", fmt::format("\"{}\", used before,", m.name), "a name of its own");
    check_surface(at, m);
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

// Pairs name known materials, each two at most once.
void check_pairs(const Scene& scene) {
  for (std::size_t i = 0; i < scene.pairs.size(); ++i) {
    const MaterialPair& p = scene.pairs[i];
    const std::string at = fmt::format("/material_pairs/{}", i);
    check_material_reference(scene, at + "/materials/0", p.a);
    check_material_reference(scene, at + "/materials/1", p.b);
    for (std::size_t k = 0; k < i; ++k) {
      const MaterialPair& q = scene.pairs[k];
      if ((p.a == q.a && p.b == q.b) || (p.a == q.b && p.b == q.a)) {
        refuse_value(at + "/materials", fmt::format("[\"{}\", \"{}\"], named before,", p.a, p.b),
                     "each two materials once");
      }
    }
    check_surface(at, p.surface);
  }
}

// A driven body's motion is its drive alone.
void check_drive(const std::string& at, const Body& b) {
  const auto refuse = [&](const char* key, const char* what) {
    refuse_value(fmt::format("{}/{}", at, key), fmt::format("{} beside a drive", what),
                 "either of the two: what drives a body decides its whole motion");
  };
  if (b.fixed) refuse("fixed", "\"fixed\": true");
  if (!b.velocity.isZero(0.0)) refuse("velocity", "a velocity of its own");
  if (b.spin != 0.0) refuse("spin", "a spin");
  if (b.mass) refuse("mass", "a mass");
  if (b.density) refuse("density", "a density");
  if (b.inertia) refuse("inertia", "an inertia");
  check_vector(at + "/drive/velocity", b.drive->velocity, "m/s");
  check_vector(at + "/drive/amplitude", b.drive->amplitude, "m");
  check_range(at + "/drive/angular_frequency", b.drive->angular_frequency, 0.0, kLargestNumber, "rad/s");
  check_range(at + "/drive/phase", b.drive->phase, -kLargestNumber, kLargestNumber, "rad");
}

void check_shape(const std::string& at, const Body& b) {
  if (const auto* disc = std::get_if<Disc>(&b.shape)) {
    if (disc->radius != 0.0) check_positive(at + "/shape/radius", disc->radius, "m");
  } else if (const auto* box = std::get_if<Box>(&b.shape)) {
    check_positive(at + "/shape/width", box->width, "m");
    check_positive(at + "/shape/height", box->height, "m");
  } else if (const auto* polygon = std::get_if<Polygon>(&b.shape)) {
    check_range(at + "/shape/rounding", polygon->rounding, 0.0, kLargestNumber, "m");
    for (std::size_t k = 0; k < polygon->vertices.size(); ++k)
      check_vector(fmt::format("{}/shape/vertices/{}", at, k), polygon->vertices[k], "m");
    if (const auto fault = fault_of(polygon->vertices, polygon->rounding))
      throw SceneError(at + "/shape/vertices: " + *fault);
  } else if (const auto& wall = std::get<Wall>(b.shape); wall.length) {
    check_positive(at + "/shape/length", *wall.length, "m");
  } else if (!is_immovable(b)) {
    refuse_value(at + "/fixed", "false for a half-plane",
                 "true, or a \"drive\", or a \"length\" that makes it a thin wall");
  }
  if (!is_immovable(b) && !b.mass && area(b.shape) == 0.0)
    refuse_value(at + "/mass", "no mass of a body without an area", "a \"mass\", in kg");
}

void check_bodies(const Scene& scene) {
  std::unordered_set<std::string> names;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Body& b = scene.bodies[i];
    const std::string at = fmt::format("/bodies/{}", i);
    if (b.name.empty()) refuse_value(at + "/name", "an empty name", "a name");
    if (!names.insert(b.name).second)
      refuse_value(at + "/name", fmt::format("\"{}\", used before,", b.name), "a name of its own");
    check_shape(at, b);
    check_vector(at + "/position", b.position, "m");
    check_vector(at + "/velocity", b.velocity, "m/s");
    check_range(at + "/angle", b.angle, -kLargestNumber, kLargestNumber, "rad");
    check_range(at + "/spin", b.spin, -kLargestNumber, kLargestNumber, "rad/s");
    if (b.fixed && (!b.velocity.isZero(0.0) || b.spin != 0.0)) {
      refuse_value(at + "/velocity", "a motion of a fixed body",
                   "no velocity and no spin, or \"fixed\": false");
    }
    if (b.drive) check_drive(at, b);
    if (b.mass && b.density) refuse_value(at + "/density", "a density beside a mass", "either of the two");
    if (b.mass) check_positive(at + "/mass", *b.mass, "kg");
    if (b.density) check_positive(at + "/density", *b.density, "kg/m²");
    if (b.inertia) check_positive(at + "/inertia", *b.inertia, "kg m²");
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

// Bodies by name.
using Bodies = std::unordered_map<std::string, const Body*>;

const Body& named_body(const Bodies& bodies, const std::string& place, const std::string& name) {
  const auto found = bodies.find(name);
  if (found == bodies.end()) refuse_value(place, "\"" + name + "\"", "the name of a body");
  return *found->second;
}

void check_movable(const Bodies& bodies, const std::string& place, const std::string& name) {
  if (is_immovable(named_body(bodies, place, name)))
    refuse_value(place, "\"" + name + "\", which no force moves,", "a body that is neither fixed nor driven");
}

void check_springs(const Forces& forces, const ForcePlaces& places, const Bodies& bodies) {
  std::unordered_set<std::string> names;
  for (std::size_t i = 0; i < forces.springs.size(); ++i) {
    const Spring& s = forces.springs[i];
    const std::string at = fmt::format("/forces/{}", places.springs[i]);
    if (!s.name.empty() && !names.insert(s.name).second)
      refuse_value(at + "/name", fmt::format("\"{}\", used before,", s.name), "a name of its own");
    check_movable(bodies, at + "/body", s.body);
    if (!s.to.empty()) {
      (void)named_body(bodies, at + "/to", s.to);
      if (s.to == s.body) refuse_value(at + "/to", "the spring's own body", "another body");
    }
    check_vector(at + "/anchor", s.anchor, "m");
    check_positive(at + "/stiffness", s.stiffness, "N/m");
    check_range(at + "/damping", s.damping, 0.0, kLargestNumber, "N s/m");
    check_range(at + "/rest_length", s.rest_length, 0.0, kLargestNumber, "m");
  }
}

void check_applied(const Forces& forces, const ForcePlaces& places, const Bodies& bodies) {
  for (std::size_t i = 0; i < forces.applied.size(); ++i) {
    const AppliedForce& f = forces.applied[i];
    const std::string at = fmt::format("/forces/{}", places.applied[i]);
    check_movable(bodies, at + "/body", f.body);
    check_vector(at + "/force", f.force, "N");
    check_range(at + "/torque", f.torque, -kLargestNumber, kLargestNumber, "N m");
    check_range(at + "/start", f.start, 0.0, kLargestNumber, "s");
    check_range(at + "/rise", f.rise, 0.0, kLargestNumber, "s");
    if (f.end) check_range(at + "/end", *f.end, f.start, kLargestNumber, "s");
  }
}

void check_forces(const Forces& forces, const ForcePlaces& places, const Bodies& bodies) {
  check_vector("/gravity", forces.gravity, "m/s²");
  check_range(fmt::format("/forces/{}/coefficient", places.linear_drag.value_or(0)), forces.linear_drag, 0.0,
              kLargestNumber, "kg/s");
  check_range(fmt::format("/forces/{}/coefficient", places.quadratic_drag.value_or(0)), forces.quadratic_drag,
              0.0, kLargestNumber, "kg/m");
  check_springs(forces, places, bodies);
  if (forces.attraction) {
    const std::string at = fmt::format("/forces/{}", places.attraction.value_or(0));
    check_positive(at + "/constant", forces.attraction->constant, "N m²/kg²");
    check_range(at + "/softening", forces.attraction->softening, 0.0, kLargestNumber, "m");
  }
  check_applied(forces, places, bodies);
}

void check_sweep(const std::string& at, const Sweep& sweep) {
  using Reduction = Sweep::Reduction;
  const bool parabola =
      sweep.reduction == Reduction::kWhereMaximum || sweep.reduction == Reduction::kWhereMinimum;
  const std::size_t least = parabola ? 3 : sweep.reduction == Reduction::kExponent ? 2 : 1;
  if (sweep.values.size() < least || sweep.values.size() > kMostSweepValues) {
    refuse_value(at + "/values", fmt::format("{} values", sweep.values.size()),
                 fmt::format("{} to {} for this reduction", least, kMostSweepValues));
  }
  for (std::size_t i = 0; i < sweep.values.size(); ++i) {
    const std::string place = fmt::format("{}/values/{}", at, i);
    check_range(place, sweep.values[i],
                sweep.reduction == Reduction::kExponent ? kLeastPositive : -kLargestNumber, kLargestNumber, "");
    if (i > 0 && least > 1 && !(sweep.values[i] > sweep.values[i - 1]))
      refuse_value(place, fmt::format("{}", sweep.values[i]), "values in rising order for this reduction");
  }
}

void check_expectation(const std::string& at, const Expectation& e, const Bodies& bodies) {
  for (std::size_t k = 0; k < e.bodies.size(); ++k)
    (void)named_body(bodies, fmt::format("{}/bodies/{}", at, k), e.bodies[k]);
  check_range(at + "/tolerance", e.tolerance, 0.0, kLargestNumber, "");
  check_range(at + "/time", e.time, 0.0, kLargestNumber, "s");
  check_range(at + "/from", e.from, 0.0, kLargestNumber, "s");
  if (e.until) check_range(at + "/until", *e.until, e.from, kLargestNumber, "s");
  if (e.reduction == Expectation::Reduction::kAtImpact && e.impact < 1)
    refuse_value(at + "/impact", fmt::format("{}", e.impact), "1, 2, ...");
  for (const Setting& s : e.settings) {
    check_range(fmt::format("{}/with {}", at, s.place), s.value, -kLargestNumber, kLargestNumber, "");
  }
  if (e.over) check_sweep(at + "/over", *e.over);
}

void check_plot(const std::string& at, const Plot& plot, const Bodies& bodies) {
  const auto check = [&](const std::string& place, const QuantityName& quantity) {
    for (std::size_t k = 0; k < quantity.bodies.size(); ++k)
      (void)named_body(bodies, fmt::format("{}/bodies/{}", place, k), quantity.bodies[k]);
  };
  for (std::size_t i = 0; i < plot.y.size(); ++i) check(fmt::format("{}/y/{}", at, i), plot.y[i]);
  if (plot.x) check(at + "/x", *plot.x);
}

void check_method(const std::string& place, const Method& method) {
  check_range(place + "/step", method.step, kLeastStep, kLargestStep, "s");
  check_range(place + "/tolerance", method.tolerance, kLeastTolerance, kLargestTolerance, "m and m/s");
}

void check_integrator(const std::string& place, const Scene& scene, const Method& method) {
  if (const auto reason = why_not(scene, method.integrator))
    throw SceneError(place + "/integrator: " + *reason);
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

ForcePlaces written_places(const Forces& forces) {
  ForcePlaces places;
  int next = 0;
  if (forces.linear_drag != 0.0) places.linear_drag = next++;
  if (forces.quadratic_drag != 0.0) places.quadratic_drag = next++;
  for (std::size_t i = 0; i < forces.springs.size(); ++i) places.springs.push_back(next++);
  if (forces.attraction) places.attraction = next++;
  for (std::size_t i = 0; i < forces.applied.size(); ++i) places.applied.push_back(next++);
  return places;
}

void validate(const Scene& scene, const ForcePlaces& places) {
  check_method("/method", scene.method);
  if (scene.compare.size() > kMostCompared) {
    refuse_value("/compare", fmt::format("{} methods", scene.compare.size()),
                 fmt::format("up to {}", kMostCompared));
  }
  for (std::size_t i = 0; i < scene.compare.size(); ++i) {
    check_method(fmt::format("/compare/{}", i), scene.compare[i]);
  }
  check_positive("/duration", scene.duration, "s");
  check_range("/state/time", start_time(scene), 0.0, kLargestNumber, "s");
  check_materials(scene);
  check_pairs(scene);
  check_bodies(scene);
  check_generators(scene);
  const std::vector<Body> all = all_bodies(scene);
  Bodies bodies;
  for (const Body& b : all) bodies.emplace(b.name, &b);
  check_forces(scene.forces, places, bodies);
  check_links(scene, all);
  if (scene.several_impacts == SeveralImpactsId::kSimultaneous &&
      (!scene.links.empty() || has_sticking_surface(scene))) {
    refuse_value("/several_impacts",
                 fmt::format("\"simultaneous\" with {}", scene.links.empty() ? "surfaces that stick" : "links"),
                 "\"pairwise\": impacts of linked bodies go pair by pair");
  }
  check_integrator("/method", scene, scene.method);
  for (std::size_t i = 0; i < scene.compare.size(); ++i) {
    check_integrator(fmt::format("/compare/{}", i), scene, scene.compare[i]);
  }
  for (std::size_t i = 0; i < scene.expect.size(); ++i)
    check_expectation(fmt::format("/expect/{}", i), scene.expect[i], bodies);
  for (std::size_t i = 0; i < scene.plots.size(); ++i)
    check_plot(fmt::format("/plots/{}", i), scene.plots[i], bodies);
  if (scene.view) {
    check_vector("/view/center", scene.view->center, "m");
    check_positive("/view/width", scene.view->width, "m");
  }
}

void validate_method(const std::string& place, const Scene& scene, const Method& method) {
  check_method(place, method);
  check_integrator(place, scene, method);
}

void validate(const Scene& scene) { validate(scene, written_places(scene.forces)); }

}  // namespace carom
