#pragma once

#include <vector>

#include "physics/scene/scene.h"

namespace carom {

// How the surfaces of any two bodies meet, looked up by index.
struct Surfaces {
  std::vector<int> material;    // by body
  int materials = 0;            // that bodies have
  std::vector<Material> pairs;  // row by row

  [[nodiscard]] const Material& between(int a, int b) const {
    return pairs[static_cast<std::size_t>(material[a] * materials + material[b])];
  }
};

[[nodiscard]] Surfaces surfaces_of(const Scene& scene, const std::vector<Body>& bodies);

}  // namespace carom
