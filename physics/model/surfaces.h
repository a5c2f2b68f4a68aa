#pragma once

#include <vector>

#include "physics/model/geometry.h"
#include "physics/model/surface_law.h"
#include "physics/scene/scene.h"

namespace carom {

// The surface law of any two convex shapes.
struct Surfaces {
  ArrayOf<ShapeIndex, int> material;
  int materials = 0;              // how many the shapes have
  std::vector<SurfaceLaw> pairs;  // materials × materials, row by row
  bool stick = false;             // some of these do

  [[nodiscard]] const SurfaceLaw& between(const ShapePair& shapes) const {
    return pairs[static_cast<std::size_t>(material[shapes.a] * materials + material[shapes.b])];
  }
};

// Whether some have laws that only contacts that last obey: rolling resistance, or static friction above
// kinetic.
[[nodiscard]] bool has_laws_of_rest(const Surfaces& surfaces);

[[nodiscard]] SurfaceLaw law_of(const Material& material);

[[nodiscard]] Surfaces surfaces_of(const Scene& scene, const std::vector<Body>& bodies, const Geometry& shapes);

}  // namespace carom
