#pragma once

#include <Eigen/Core>
#include <vector>

namespace carom {

// The linear complementarity problem: z >= 0 and w = M z + q >= 0 with z·w = 0, solved by Lemke's pivoting
// (Cottle, Pang and Stone, The Linear Complementarity Problem, 1992, section 4.4) with the covering vector
// (1, ..., 1) and the lexicographic ratio test, which cannot cycle on degenerate problems. It ends with a
// solution for every positive semidefinite M that has one, and for the copositive M of contact with friction.
// The values are those of the final basis, refined against M and q. Scale the problem so that the entries of M
// and q are about 1: what counts as zero is told from that. Buffers are kept, so that solving again at no
// greater size allocates nothing.
class LcpSolver {
 public:
  enum class Status {
    kSolved,
    kNoSolutionFound,  // ended on a ray: for a positive semidefinite M there is no solution
    kTooManyPivots,
  };

  // M is n x n, q has n entries.
  [[nodiscard]] Status solve(const Eigen::Ref<const Eigen::MatrixXd>& m,
                             const Eigen::Ref<const Eigen::VectorXd>& q);

  // The last solved problem's z.
  [[nodiscard]] Eigen::Map<const Eigen::VectorXd> solution() const { return {z_.data(), size_}; }

 private:
  [[nodiscard]] double& at(int row, int column) { return tableau_[row * columns_ + column]; }
  void pivot(int row, int column);
  [[nodiscard]] int leaving_row(int column);
  void read_basis(const Eigen::Ref<const Eigen::MatrixXd>& m, const Eigen::Ref<const Eigen::VectorXd>& q);

  int size_ = 0;
  int columns_ = 0;
  std::vector<double> tableau_;  // n rows of: the columns of w, of z, of the covering variable, right-hand side
  std::vector<int> basis_;       // the variable of each row, numbered as the columns
  std::vector<int> candidates_;
  std::vector<double> value_;
  std::vector<double> residual_;
  std::vector<double> z_;
};

}  // namespace carom
