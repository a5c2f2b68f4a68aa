#include "physics/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <unordered_map>
#include <unordered_set>

namespace carom {
namespace {

// Uniform in [low, high); std::uniform_real_distribution differs between standard libraries.
double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
}

// Whether a material or a pair of materials has it.
template <class Property>
bool any_surface(const Scene& scene, const Property& has) {
  return std::any_of(scene.materials.begin(), scene.materials.end(), has) ||
         std::any_of(scene.pairs.begin(), scene.pairs.end(),
                     [&](const MaterialPair& p) { return has(p.surface); });
}

}  // namespace

Material material_named(const Scene& scene, const std::string& name) {
  const auto found = std::find_if(scene.materials.begin(), scene.materials.end(),
                                  [&](const Material& m) { return m.name == name; });
  if (found != scene.materials.end()) return *found;
  if (name == "default") return Material{};
  throw std::out_of_range("no material is called '" + name + "'");
}

std::vector<Material> combined_materials(const Scene& scene, const std::vector<std::string>& names) {
  std::vector<Material> materials;
  std::unordered_map<std::string, std::size_t> index;
  {
    std::unordered_map<std::string, const Material*> listed;
    for (const Material& m : scene.materials) listed.try_emplace(m.name, &m);
    for (const std::string& name : names) {
      index.emplace(name, materials.size());
      const auto found = listed.find(name);
      materials.push_back(found != listed.end() ? *found->second : material_named(scene, name));
    }
  }
  std::vector<Material> all;
  all.reserve(materials.size() * materials.size());
  for (const Material& a : materials) {
    for (const Material& b : materials) all.push_back(mixed_surface(a, b));
  }
  // If a pair is listed several times, the first entry counts.
  for (auto pair = scene.pairs.rbegin(); pair != scene.pairs.rend(); ++pair) {
    const auto a = index.find(pair->a);
    const auto b = index.find(pair->b);
    if (a == index.end() || b == index.end()) continue;
    all[a->second * names.size() + b->second] = pair->surface;
    all[b->second * names.size() + a->second] = pair->surface;
  }
  return all;
}

Material combined_material(const Scene& scene, const std::string& a, const std::string& b) {
  return a == b ? combined_materials(scene, {a})[0] : combined_materials(scene, {a, b})[1];
}

bool has_sticking_surface(const Scene& scene) {
  return any_surface(scene, [](const Material& m) { return m.sticks; });
}

bool has_rolling_resistance(const Scene& scene) {
  return any_surface(scene, [](const Material& m) { return m.rolling_resistance > 0.0; });
}

bool has_force_on_each_body(const Scene& scene) {
  bool any = false;
  each_common_force(scene.forces, [&any](const CommonForce& force, const auto& value, const auto&...) {
    any = any || (acts(value) && force.on == ActsOn::kEachBody);
  });
  return any;
}

bool has_dampers(const Scene& scene) {
  return std::any_of(scene.forces.springs.begin(), scene.forces.springs.end(),
                     [](const Spring& spring) { return spring.damping > 0.0; });
}

bool has_strings(const Scene& scene) {
  return std::any_of(scene.joints.begin(), scene.joints.end(),
                     [](const Joint& joint) { return joint.kind == JointKind::kString; });
}

bool has_springs_beside_points(const Scene& scene) {
  const auto pulls = [&scene](const std::string& body, const Vec2& point) {
    return !point.isZero(0.0) && std::any_of(scene.bodies.begin(), scene.bodies.end(), [&](const Body& each) {
      return each.name == body && inertia_of(each) == 0.0;
    });
  };
  return std::any_of(scene.forces.springs.begin(), scene.forces.springs.end(), [&](const Spring& spring) {
    return pulls(spring.body, spring.point) || pulls(spring.to, spring.anchor);
  });
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

std::string free_body_name(const std::vector<Body>& bodies, const std::string& stem) {
  std::unordered_set<std::string> taken;
  for (const Body& body : bodies) taken.insert(body.name);
  for (int i = 1;; ++i) {
    std::string name = stem + "-" + std::to_string(i);
    if (!taken.contains(name)) return name;
  }
}

}  // namespace carom
