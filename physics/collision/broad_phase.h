#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "physics/collision/cell_grid.h"
#include "physics/math/bounds.h"

namespace carom {

// Finds the pairs (a, b), a < b, whose bounds overlap and of which at least one body can move, in the order
// of index pairs. The grid and the candidates (pairs whose bounds, each with a skin around it, overlap) are
// kept from call to call for as long as bounds stay within their skins; where few leave theirs, only the
// candidates of these are found again.
class BroadPhase {
 public:
  // The limit of the number of pairs; beyond it the last bodies get none. Bodies that do not overlap have
  // about three neighbours each, but N bodies at one place would have N²/2 pairs.
  [[nodiscard]] static std::size_t most_pairs(std::size_t bodies) { return 200'000 + 128 * bodies; }
  [[nodiscard]] const std::vector<BodyPair>& pairs(const std::vector<Bounds>& bounds,
                                                   const std::vector<std::uint8_t>& fixed);
  // Whether the last call left out pairs beyond the limit.
  [[nodiscard]] bool cut() const { return cut_; }

 private:
  void find_candidates(const std::vector<Bounds>& bounds, const std::vector<std::uint8_t>& fixed);
  [[nodiscard]] bool find_candidates_of_moved(const std::vector<Bounds>& bounds);
  void put(BodyIndex body, const Bounds& bounds);

  CellGrid grid_;
  double cell_ = 0.0;                // m
  double skin_ = 0.0;                // m
  std::vector<Bounds> skins_;        // bounds when last searched for, with a skin around what moves
  std::vector<std::uint8_t> fixed_;  // at the last search
  bool cut_ = false;
  std::vector<BodyIndex> near_;
  std::vector<BodyIndex> moved_;          // out of their skins
  std::vector<std::uint8_t> has_moved_;   // by body
  std::vector<BodyPair> of_moved_, all_;  // candidates
  std::vector<BodyPair> candidates_;
  std::vector<BodyPair> pairs_;
};

}  // namespace carom
