#pragma once

#include <Eigen/Core>

namespace carom {

// An axis-aligned rectangle, in m.
struct Bounds {
  Eigen::Array2d low;
  Eigen::Array2d high;

  [[nodiscard]] bool overlaps(const Bounds& other) const {
    // Without branches, because it is unpredictable which comparison fails.
    return ((low.x() <= other.high.x()) & (other.low.x() <= high.x()) & (low.y() <= other.high.y()) &
            (other.low.y() <= high.y())) != 0;
  }
  [[nodiscard]] bool contains(const Bounds& other) const {
    return ((low.x() <= other.low.x()) & (low.y() <= other.low.y()) & (other.high.x() <= high.x()) &
            (other.high.y() <= high.y())) != 0;
  }
};

}  // namespace carom
