#pragma once

#include <Eigen/Core>
#include <span>
#include <utility>
#include <vector>

namespace carom {

// LU factorisation of a sparse matrix of 3×3 blocks, one per body. The pattern is symmetric, the values need
// not be. Pivots are taken only within diagonal blocks, so the matrix should be nearly positive definite. The
// elimination order is that of least degree (Tinney and Walker, Proceedings of the IEEE 55 (1967) 1801); on
// the planar graphs of piles it costs about n^1.5 block products. Order of calls: analyse(), clear(), fill
// the blocks, factorise(), solve(). Storage is kept and reused.
class BlockLu {
 public:
  using Block = Eigen::Matrix3d;

  // Orders n blocks joined by `edges` (i != j, may repeat).
  void analyse(int n, std::span<const std::pair<int, int>> edges);

  void clear();
  Block& diagonal(int i) { return diagonal_[place_[i]]; }
  // Where the blocks (i, j) and (j, i) are stored; `upper` if i is eliminated before j.
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
  std::vector<int> place_;  // position of each block in the elimination order
  // Row k of U without its diagonal has the columns index_[first_[k] .. first_[k + 1] - 1], sorted.
  std::vector<int> first_, index_;
  std::vector<Block> diagonal_;               // after factorise(): the inverses of the pivots
  std::vector<Block> upper_, lower_;          // U(k, j) and L(j, k) for j = index_[slot]
  std::vector<std::vector<int>> neighbours_;  // scratch of analyse()
  std::vector<int> merged_, order_;
  std::vector<std::pair<int, int>> queue_;
  Eigen::VectorXd permuted_;
};

}  // namespace carom
