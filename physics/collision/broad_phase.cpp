#include "physics/collision/broad_phase.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace carom {

const std::vector<std::pair<int, int>>& BroadPhase::pairs(const std::vector<Bounds>& bounds,
                                                          const std::vector<std::uint8_t>& fixed) {
  const bool fresh = order_.size() != bounds.size();
  if (fresh) {
    order_.resize(bounds.size());
    for (std::size_t i = 0; i < order_.size(); ++i) order_[i] = static_cast<int>(i);
  }
  const auto before = [&](int a, int b) {
    return bounds[a].low.x() < bounds[b].low.x() || (bounds[a].low.x() == bounds[b].low.x() && a < b);
  };
  if (fresh) std::sort(order_.begin(), order_.end(), before);
  for (std::size_t i = 1; i < order_.size(); ++i) {
    const int moved = order_[i];
    std::size_t j = i;
    for (; j > 0 && before(moved, order_[j - 1]); --j) order_[j] = order_[j - 1];
    order_[j] = moved;
  }

  pairs_.clear();
  for (std::size_t i = 0; i < order_.size(); ++i) {
    const int a = order_[i];
    for (std::size_t j = i + 1; j < order_.size(); ++j) {
      const int b = order_[j];
      if (bounds[b].low.x() > bounds[a].high.x()) break;
      if ((fixed[a] != 0 && fixed[b] != 0) || !bounds[a].overlaps(bounds[b])) continue;
      pairs_.emplace_back(std::min(a, b), std::max(a, b));
    }
  }
  std::sort(pairs_.begin(), pairs_.end());
  return pairs_;
}

}  // namespace carom
