#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "physics/model/convex.h"
#include "physics/scene/scene.h"

namespace carom {

// What collision detection needs of N bodies, as arrays.
struct Geometry {
  ConvexShapes shapes;
  // m, 2×N: half width and height of the axis-aligned rectangle about the centre that contains the body at
  // every angle that it can take. Infinite for a half-plane.
  Eigen::Matrix2Xd extent;
  Eigen::VectorXd size;                     // m, approximately; 0 for a half-plane
  std::vector<std::uint8_t> fixed;          // infinite mass: fixed or kinematic
  std::vector<int> group;                   // bodies of one group >= 0 do not collide with each other
  std::vector<std::pair<int, int>> pinned;  // nor do pairs that a pin joins; a < b, sorted
  std::vector<int> welded;                  // nor do bodies welded into one, which share a number >= 0

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
