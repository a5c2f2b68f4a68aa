#include "physics/model/surfaces.h"

#include <algorithm>
#include <string>
#include <unordered_map>

namespace carom {

SurfaceLaw law_of(const Material& m) {
  return {m.restitution,      m.tangential_restitution, m.static_friction,
          m.kinetic_friction, m.rolling_resistance,     m.sticks};
}

Surfaces surfaces_of(const Scene& scene, const std::vector<Body>& bodies, const Geometry& shapes) {
  Surfaces surfaces;
  std::vector<std::string> names;
  std::unordered_map<std::string, int> index;
  const auto number = [&](const std::string& name) {
    const auto [at, is_new] = index.try_emplace(name, static_cast<int>(names.size()));
    if (is_new) names.push_back(name);
    return at->second;
  };
  surfaces.material.resize(shapes.shapes.core.size());
  for (BodyIndex i{0}; i < static_cast<int>(bodies.size()); ++i) {
    shapes.each_part(i, [&](ShapeIndex part) {
      const auto* compound = std::get_if<Compound>(&bodies[i].shape);
      const std::string* own =
          compound == nullptr ? nullptr : &compound->shapes[shapes.shape_of(part)].material;
      surfaces.material[part] = number(own == nullptr || own->empty() ? bodies[i].material : *own);
    });
  }
  surfaces.materials = static_cast<int>(names.size());
  for (const Material& pair : combined_materials(scene, names)) {
    surfaces.pairs.push_back(law_of(pair));
    surfaces.stick = surfaces.stick || pair.sticks;
  }
  return surfaces;
}

bool has_laws_of_rest(const Surfaces& surfaces) {
  return std::any_of(surfaces.pairs.begin(), surfaces.pairs.end(), [](const SurfaceLaw& pair) {
    return pair.rolling_resistance > 0.0 || pair.static_friction > pair.kinetic_friction;
  });
}

}  // namespace carom
