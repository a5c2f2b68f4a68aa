#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "physics/model/index.h"
#include "physics/scene/scene.h"

namespace carom {

[[nodiscard]] inline std::unordered_map<std::string, BodyIndex> bodies_by_name(
    const std::vector<Body>& bodies) {
  std::unordered_map<std::string, BodyIndex> index;
  for (BodyIndex i{0}; i < static_cast<int>(bodies.size()); ++i) index.emplace(bodies[i].name, i);
  return index;
}

}  // namespace carom
