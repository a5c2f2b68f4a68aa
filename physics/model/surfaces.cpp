#include "physics/model/surfaces.h"

#include <string>
#include <unordered_map>

namespace carom {

Surfaces surfaces_of(const Scene& scene, const std::vector<Body>& bodies) {
  Surfaces surfaces;
  std::vector<std::string> names;
  std::unordered_map<std::string, int> index;
  for (const Body& body : bodies) {
    const auto [at, is_new] = index.try_emplace(body.material, static_cast<int>(names.size()));
    if (is_new) names.push_back(body.material);
    surfaces.material.push_back(at->second);
  }
  surfaces.materials = static_cast<int>(names.size());
  surfaces.pairs = combined_materials(scene, names);
  return surfaces;
}

}  // namespace carom
