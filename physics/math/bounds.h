#pragma once

#include <Eigen/Core>

namespace carom {

// An axis-aligned rectangle, in m.
struct Bounds {
  Eigen::Array2d low;
  Eigen::Array2d high;

  [[nodiscard]] bool overlaps(const Bounds& other) const {
    // Without branches, because it is unpredictable which comparison fails. Of numbers, and of -∞ to ∞.
    return (low - other.high).max(other.low - high).maxCoeff() <= 0.0;
  }
  [[nodiscard]] bool contains(const Bounds& other) const {
    return (int(low.x() <= other.low.x()) & int(low.y() <= other.low.y()) & int(other.high.x() <= high.x()) &
            int(other.high.y() <= high.y())) != 0;
  }
};

}  // namespace carom
