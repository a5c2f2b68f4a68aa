#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "physics/collision/bounds.h"
#include "physics/collision/cell_grid.h"

namespace carom {

// The pairs (a, b), a < b, whose bounds overlap and of which one at least can move, in the order of index
// pairs. Kept from call to call are candidates, pairs whose bounds overlap with a skin around each, for as long
// as all bounds stay within their skins, and the grid that these are found with.
class BroadPhase {
 public:
  [[nodiscard]] const std::vector<std::pair<int, int>>& pairs(const std::vector<Bounds>& bounds,
                                                              const std::vector<std::uint8_t>& fixed);

 private:
  void find_candidates(const std::vector<Bounds>& bounds, const std::vector<std::uint8_t>& fixed);

  CellGrid grid_;
  double cell_ = 0.0;                // m
  std::vector<Bounds> skins_;        // bounds as they were, those of what moves with a skin
  std::vector<std::uint8_t> fixed_;  // as it was
  std::vector<int> near_;
  std::vector<std::pair<int, int>> candidates_;
  std::vector<std::pair<int, int>> pairs_;
};

}  // namespace carom
