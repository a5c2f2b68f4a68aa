#pragma once

#include <algorithm>

#include "physics/model/geometry.h"

// The size that a tolerance of a contact refers to: that of the smaller of two, as what is near for a small
// body on a long floor has nothing to do with the floor's length. (How far a pair may move refers to
// smaller_size() in step/pair_motion.h, where what nothing moves doesn't count.)
namespace carom {

// Of the sum of both: the coordinates on the larger one are rounded by its size.
inline constexpr double kLeastShare = 1e-5;

// m: of two sizes, the sum of both if they are equal. One without a size doesn't count.
[[nodiscard]] inline double pair_size(double a, double b) {
  const double smaller = std::min(a, b);
  return smaller > 0.0 ? std::max(2.0 * smaller, kLeastShare * (a + b)) : a + b;
}
[[nodiscard]] inline double pair_size(const Geometry& g, BodyIndex a, BodyIndex b) {
  return pair_size(g.size[a], g.size[b]);
}

}  // namespace carom
