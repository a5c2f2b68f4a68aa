#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "physics/collision/cell_grid.h"
#include "physics/math/bounds.h"

namespace carom {

// The pairs (a, b), a < b, whose bounds overlap and of which one at least can move, in the order of index
// pairs. Kept from call to call are candidates, pairs whose bounds overlap with a skin around each, for as long
// as all bounds stay within their skins, and the grid that these are found with.
class BroadPhase {
 public:
  // Bodies that don't overlap have some three neighbours each; N that lie at one place would have N²/2 pairs.
  // Beyond this the last bodies get none.
  [[nodiscard]] static std::size_t most_pairs(std::size_t bodies) { return 200'000 + 128 * bodies; }
  [[nodiscard]] const std::vector<std::pair<int, int>>& pairs(const std::vector<Bounds>& bounds,
                                                              const std::vector<std::uint8_t>& fixed);
  // Whether there were more.
  [[nodiscard]] bool cut() const { return cut_; }

 private:
  void find_candidates(const std::vector<Bounds>& bounds, const std::vector<std::uint8_t>& fixed);

  CellGrid grid_;
  double cell_ = 0.0;                // m
  std::vector<Bounds> skins_;        // bounds as they were, those of what moves with a skin
  std::vector<std::uint8_t> fixed_;  // as it was
  bool cut_ = false;
  std::vector<int> near_;
  std::vector<std::pair<int, int>> candidates_;
  std::vector<std::pair<int, int>> pairs_;
};

}  // namespace carom
