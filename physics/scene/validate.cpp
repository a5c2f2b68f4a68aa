#include "physics/scene/validate.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <set>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "physics/scene/facts.h"
#include "physics/scene/method.h"
#include "physics/scene/range_check.h"
#include "physics/scene/shape.h"
#include "physics/scene/value_checks.h"

namespace carom {
namespace {

using MaterialNames = std::unordered_set<std::string>;

void check_surface(const std::string& at, const Material& m) {
  check_order(at + "/static_friction", m.static_friction, m.kinetic_friction, "kinetic_friction");
}

MaterialNames check_materials(const Scene& scene) {
  check_count("/materials", scene.materials.size(), kMostMaterials, "materials");
  MaterialNames names;
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const Material& m = scene.materials[i];
    const std::string at = fmt::format("/materials/{}", i);
    check_fields(at, m);
    check_own_name(names, at + "/name", m.name);
    check_surface(at, m);
  }
  names.insert("default");
  return names;
}

void check_material_reference(const MaterialNames& materials, const std::string& place,
                              const std::string& name) {
  if (materials.contains(name)) return;
  const std::set<std::string> sorted(materials.begin(), materials.end());
  refuse_by(Rule::kReferences, place, "\"" + name + "\"", fmt::format("\"{}\"", fmt::join(sorted, "\", \"")));
}

// Pairs name known materials, and each pair is listed once.
void check_pairs(const Scene& scene, const MaterialNames& materials) {
  check_count("/material_pairs", scene.pairs.size(), kMostMaterialPairs, "pairs");
  std::set<std::pair<std::string_view, std::string_view>> named;
  for (std::size_t i = 0; i < scene.pairs.size(); ++i) {
    const MaterialPair& p = scene.pairs[i];
    const std::string at = fmt::format("/material_pairs/{}", i);
    check_material_reference(materials, at + "/materials/0", p.a);
    check_material_reference(materials, at + "/materials/1", p.b);
    if (!named.insert(std::minmax<std::string_view>(p.a, p.b)).second) {
      refuse_by(Rule::kOwnNames, at + "/materials",
                fmt::format("[\"{}\", \"{}\"], named before,", shortened(p.a, 15), shortened(p.b, 15)),
                "each two materials once");
    }
    check_fields(at, p);
    check_surface(at, p.surface);
  }
}

// The drive alone decides a kinematic body's motion.
void check_drive(const std::string& at, const Body& b) {
  const auto refuse = [&](const char* key, const char* what) {
    refuse_by(Rule::kKeysTogether, fmt::format("{}/{}", at, key), fmt::format("{} beside a drive", what),
              "either of the two: what drives a body decides its whole motion");
  };
  if (b.fixed) refuse("fixed", "\"fixed\": true");
  if (!b.velocity.isZero(0.0)) refuse("velocity", "a velocity of its own");
  if (b.spin != 0.0) refuse("spin", "a spin");
  if (b.mass) refuse("mass", "a mass");
  if (b.density) refuse("density", "a density");
  if (b.inertia) refuse("inertia", "an inertia");
}

void check_polygon(const std::string& at, const Polygon& polygon) {
  if (const auto fault = fault_of(polygon.vertices, polygon.rounding))
    throw RuleError(Rule::kShapeOfPolygon, at + "/vertices: " + *fault);
}

// How many convex parts a body may have.
constexpr std::size_t kMostParts = 128;

void check_compound(const std::string& at, const Compound& compound, const MaterialNames& materials) {
  for (std::size_t k = 0; k < compound.shapes.size(); ++k) {
    const auto& [shape, position, angle, material] = compound.shapes[k];
    const std::string here = fmt::format("{}/shapes/{}", at, k);
    if (const auto* polygon = std::get_if<Polygon>(&shape)) check_polygon(here + "/shape", *polygon);
    if (const auto* wall = std::get_if<Wall>(&shape); wall != nullptr && !wall->length)
      refuse_by(Rule::kKeysTogether, here + "/shape/length", "a half-plane in a body of several shapes",
                "a \"length\" that makes it a thin wall");
    if (!material.empty()) check_material_reference(materials, here + "/material", material);
  }
  if (const std::size_t parts = convex_parts(compound).size(); parts > kMostParts)
    refuse_by(Rule::kCountInAll, at + "/shapes", fmt::format("{} convex parts", parts),
              fmt::format("at most {}", kMostParts));
}

void check_shape(const std::string& at, const Body& b, const MaterialNames& materials) {
  if (const auto* compound = std::get_if<Compound>(&b.shape)) {
    check_compound(at, *compound, materials);
  } else if (const auto* polygon = std::get_if<Polygon>(&b.shape)) {
    check_polygon(at + "/shape", *polygon);
  } else if (const auto* wall = std::get_if<Wall>(&b.shape);
             wall != nullptr && !wall->length && !has_infinite_mass(b)) {
    refuse_by(Rule::kKeysTogether, at + "/fixed", "false for a half-plane",
              "true, or a \"drive\", or a \"length\" that makes it a thin wall");
  }
  if (!has_infinite_mass(b) && !b.mass && area(b.shape) == 0.0)
    refuse_by(Rule::kKeysTogether, at + "/mass", "no mass of a body without an area", "a \"mass\", in kg");
}

void check_bodies(const Scene& scene, const MaterialNames& materials) {
  check_count("/bodies", scene.bodies.size(), kMostBodies, "bodies");
  std::unordered_set<std::string> names;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Body& b = scene.bodies[i];
    const std::string at = fmt::format("/bodies/{}", i);
    check_fields(at, b);
    check_own_name(names, at + "/name", b.name);
    check_shape(at, b, materials);
    if (b.fixed && (!b.velocity.isZero(0.0) || b.spin != 0.0)) {
      refuse_by(Rule::kKeysTogether, at + "/velocity", "a motion of a fixed body",
                "no velocity and no spin, or \"fixed\": false");
    }
    if (b.drive) check_drive(at, b);
    if (b.mass && b.density) refuse_value(at + "/density", "a density beside a mass", "either of the two");
    check_material_reference(materials, at + "/material", b.material);
  }
}

// Also the number of bodies of all generators together.
void check_generators(const Scene& scene, const MaterialNames& materials) {
  double count = static_cast<double>(scene.bodies.size());
  for (std::size_t i = 0; i < scene.generators.size(); ++i) {
    const GridGenerator& g = scene.generators[i];
    const std::string at = fmt::format("/generators/{}", i);
    check_fields(at, g);
    count += static_cast<double>(g.columns) * g.rows;
    if (count > kMostBodies)
      refuse_by(Rule::kCountInAll, at, fmt::format("{} bodies in all", count),
                fmt::format("at most {}", kMostBodies));
    check_order(at + "/radius/1", g.radius_max, g.radius_min, "the least radius");
    check_material_reference(materials, at + "/material", g.material);
  }
}

void check_springs(const Forces& forces, const ForcePlaces& places, const NamedBodies& bodies) {
  std::unordered_set<std::string> names;
  for (std::size_t i = 0; i < forces.springs.size(); ++i) {
    const Spring& s = forces.springs[i];
    const std::string at = fmt::format("/forces/{}", places.springs[i]);
    check_fields(at, s);
    if (!s.name.empty()) check_own_name(names, at + "/name", s.name);
    movable_body(bodies, at + "/body", s.body);
    if (!s.to.empty()) {
      (void)named_body(bodies, at + "/to", s.to);
      if (s.to == s.body) refuse_by(Rule::kReferences, at + "/to", "the spring's own body", "another body");
    }
  }
}

void check_applied(const Forces& forces, const ForcePlaces& places, const NamedBodies& bodies) {
  for (std::size_t i = 0; i < forces.applied.size(); ++i) {
    const AppliedForce& f = forces.applied[i];
    const std::string at = fmt::format("/forces/{}", places.applied[i]);
    check_fields(at, f);
    movable_body(bodies, at + "/body", f.body);
    if (f.end) check_order(at + "/end", *f.end, f.start, "start");
  }
}

// Attraction acts between all pairs: one evaluation for so many bodies takes some 20 ms.
constexpr std::size_t kMostAttracted = 2'000;

void check_forces(const Forces& forces, const ForcePlaces& places, const NamedBodies& bodies) {
  RangeCheck("").field({"gravity", ""}, forces.gravity, kGravityRange);
  const auto place = [&places](const char* type) {
    const auto found = places.common.find(type);
    return fmt::format("/forces/{}", found == places.common.end() ? 0 : found->second);
  };
  each_common_force(forces, [&place](const CommonForce& force, const auto& value, const auto&... range) {
    if constexpr (sizeof...(range) > 0) {
      check_range(place(force.type) + "/coefficient", value, range...);
    } else if (value) {
      check_fields(place(force.type), *value);
    }
  });
  if (forces.attraction && bodies.size() > kMostAttracted)
    refuse_by(Rule::kCountInAll, place("attraction"), fmt::format("attraction among {} bodies", bodies.size()),
              fmt::format("among up to {}", kMostAttracted));
  check_count("/forces", forces.springs.size() + forces.applied.size(), kMostForces, "springs and forces");
  check_springs(forces, places, bodies);
  check_applied(forces, places, bodies);
}

}  // namespace

ForcePlaces written_places(const Forces& forces) {
  ForcePlaces places;
  int next = 0;
  each_common_force(forces, [&](const CommonForce& force, const auto& value, const auto&...) {
    if (acts(value)) places.common.emplace(force.type, next++);
  });
  for (std::size_t i = 0; i < forces.springs.size(); ++i) places.springs.push_back(next++);
  for (std::size_t i = 0; i < forces.applied.size(); ++i) places.applied.push_back(next++);
  return places;
}

void validate(const Scene& scene, const ForcePlaces& places, const RunBegin& begin) {
  const MaterialNames materials = check_materials(scene);
  check_pairs(scene, materials);
  check_bodies(scene, materials);
  check_generators(scene, materials);
  const std::vector<Body> all = all_bodies(scene);
  NamedBodies bodies;
  for (const Body& b : all) {
    if (!bodies.emplace(b.name, &b).second) {
      refuse_by(Rule::kOwnNames, "/generators",
                fmt::format("the body name \"{}\", used before,", shortened(b.name, 30)), "names of their own");
    }
  }
  check_forces(scene.forces, places, bodies);
  check_joints(scene, all, begin);
  if (scene.several_impacts == SeveralImpactsId::kSimultaneous && has_sticking_surface(scene)) {
    refuse_by(Rule::kModelled, "/several_impacts", "\"simultaneous\" with surfaces that stick",
              "\"pairwise\": bodies that stick are joined pair by pair");
  }
}

void validate(const Scene& scene) { validate(scene, written_places(scene.forces)); }

void check_integrator(const std::string& place, const Scene& scene, const Method& method) {
  if (const auto reason = why_not(scene, method.integrator))
    throw RuleError(Rule::kModelled, place + "/integrator: " + *reason);
}

}  // namespace carom
