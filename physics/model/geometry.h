#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "physics/model/convex.h"
#include "physics/scene/scene.h"

namespace carom {

// What collision needs to know of N bodies, as arrays.
struct Geometry {
  ConvexShapes shapes;
  // m, 2×N: half of the upright rectangle about its centre that holds the body, at any angle that it can take.
  // Infinite for a half-plane.
  Eigen::Matrix2Xd extent;
  Eigen::VectorXd size;                     // m, about that of the body; 0 for a half-plane
  std::vector<std::uint8_t> fixed;          // immovable: fixed or kinematic
  std::vector<int> group;                   // bodies of one group >= 0 do not collide with each other
  std::vector<std::pair<int, int>> pinned;  // nor those that a pin joins; a < b, in rising order
  std::vector<int> welded;                  // nor those that welds make one, whose number >= 0 is the same

  [[nodiscard]] bool is_disc(int i) const { return shapes.core[i] == Core::kPoint; }
  // Whether the two can collide at all.
  [[nodiscard]] bool can_collide(int a, int b) const {
    if ((fixed[a] != 0 && fixed[b] != 0) || (group[a] >= 0 && group[a] == group[b]) ||
        (welded[a] >= 0 && welded[a] == welded[b])) {
      return false;
    }
    return pinned.empty() ||
           !std::binary_search(pinned.begin(), pinned.end(), std::pair<int, int>(std::minmax(a, b)));
  }
};

[[nodiscard]] Geometry geometry(const std::vector<Body>& bodies, const std::vector<Joint>& joints = {});

}  // namespace carom
