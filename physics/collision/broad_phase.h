#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <utility>
#include <vector>

namespace carom {

// An axis-aligned rectangle, in m.
struct Bounds {
  Eigen::Array2d low;
  Eigen::Array2d high;

  [[nodiscard]] bool overlaps(const Bounds& other) const {
    // All four without a branch: which of them fails can't be foreseen.
    return ((low.x() <= other.high.x()) & (other.low.x() <= high.x()) & (low.y() <= other.high.y()) &
            (other.low.y() <= high.y())) != 0;
  }
};

// Sweep and prune along x: the pairs (a, b), a < b, whose bounds overlap and of which one at least can move, in
// the order of index pairs. The sorted order is kept from call to call, so that a nearly sorted list costs
// little. Baraff, Physically Based Modeling (SIGGRAPH course notes 1997), section 7.
class BroadPhase {
 public:
  [[nodiscard]] const std::vector<std::pair<int, int>>& pairs(const std::vector<Bounds>& bounds,
                                                              const std::vector<std::uint8_t>& fixed);

 private:
  std::vector<int> order_;
  std::vector<std::pair<int, int>> pairs_;
};

}  // namespace carom
