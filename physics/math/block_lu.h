#pragma once

#include <Eigen/Core>
#include <span>
#include <utility>
#include <vector>

namespace carom {

// LU factors of a sparse matrix of 3×3 blocks (one a body) whose pattern, not whose values, is symmetric.
// Pivots within the diagonal blocks only: meant for matrices near to positive definite. The elimination order
// is one of least degree (Tinney and Walker, Proceedings of the IEEE 55 (1967) 1801), which on the planar
// graphs of piles costs about n^1.5 block products. Storage is kept and reused.
class BlockLu {
 public:
  using Block = Eigen::Matrix3d;

  // Orders n blocks joined by `edges` (i != j, may repeat).
  void analyse(int n, std::span<const std::pair<int, int>> edges);

  void clear();
  Block& diagonal(int i) { return diagonal_[place_[i]]; }
  // The blocks (i, j) and (j, i), as (slot, whether i is eliminated before j).
  struct Slot {
    int index = -1;
    bool upper = true;
  };
  [[nodiscard]] Slot slot(int i, int j) const;
  Block& row_col(const Slot& s) { return s.upper ? upper_[s.index] : lower_[s.index]; }  // block (i, j)
  Block& col_row(const Slot& s) { return s.upper ? lower_[s.index] : upper_[s.index]; }  // block (j, i)

  // Replaces the matrix by its factors; false if a pivot block is singular.
  [[nodiscard]] bool factorise();
  // x = A⁻¹ x after factorise().
  void solve(Eigen::Ref<Eigen::VectorXd> x);

 private:
  std::vector<int> place_;            // of a block in the order of elimination
  std::vector<int> first_, index_;    // row k of U, without its diagonal, is index_[first_[k] ..), sorted
  std::vector<Block> diagonal_;       // after factorise(): the inverses of the pivots
  std::vector<Block> upper_, lower_;  // U(k, j) and L(j, k) for j = index_[slot]
  std::vector<std::vector<int>> neighbours_;  // scratch of analyse()
  std::vector<int> merged_, order_;
  std::vector<std::pair<int, int>> queue_;
  Eigen::VectorXd permuted_;
};

}  // namespace carom
