#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "physics/collision/bounds.h"
#include "physics/collision/cell_grid.h"

namespace carom {

// The pairs (a, b), a < b, whose bounds overlap and of which one at least can move, in the order of index
// pairs. The grid is kept from call to call: only bodies that have come to other cells are moved in it.
class BroadPhase {
 public:
  [[nodiscard]] const std::vector<std::pair<int, int>>& pairs(const std::vector<Bounds>& bounds,
                                                              const std::vector<std::uint8_t>& fixed);

 private:
  CellGrid grid_;
  std::size_t bodies_ = 0;
  double cell_ = 0.0;  // m
  std::vector<int> near_;
  std::vector<std::pair<int, int>> pairs_;
};

}  // namespace carom
