#pragma once

#include <Eigen/Core>
#include <vector>

namespace carom {

// The linear complementarity problem: z >= 0 and w = M z + q >= 0 with z·w = 0, for the matrices of contact: M
// positive semidefinite, or copositive (zMz >= 0 for z >= 0) with friction, and often singular. Lemke's
// pivoting (Cottle, Pang and Stone, The Linear Complementarity Problem, 1992, section 4.4) with the covering
// vector (1, ..., 1) and the lexicographic ratio test against cycling; the values are those of the final basis,
// refined against M and q. Of many solutions it finds one.
//
// Where rounding in a singular M leads the pivoting astray, which shows in the result, the proximal point
// iteration (Rockafellar, SIAM Journal on Control and Optimization 14 (1976) 877) tries again on matrices that
// are not singular: z_(k+1) = LCP(M + ε I, q - ε z_k) with z_0 = 0, until M z_k itself complies. Where there is
// no solution, the z_k grow and never do.
//
// Scale the problem so that the entries of M and q are about 1: what counts as zero is told from that. Buffers
// are kept, so that solving again at no greater size allocates nothing.
class LcpSolver {
 public:
  // M is n x n, q has n entries. False if no solution was found.
  [[nodiscard]] bool solve(const Eigen::Ref<const Eigen::MatrixXd>& m,
                           const Eigen::Ref<const Eigen::VectorXd>& q);

  // Of the last problem, if it was solved: z.
  [[nodiscard]] Eigen::Map<const Eigen::VectorXd> solution() const { return {z_.data(), size_}; }

 private:
  [[nodiscard]] double& at(int row, int column) { return tableau_[row * columns_ + column]; }
  void pivot(int row, int column);
  [[nodiscard]] int leaving_row(int column);
  [[nodiscard]] bool pivot_to_solution(const Eigen::Ref<const Eigen::MatrixXd>& m, double epsilon);
  [[nodiscard]] bool solve_with(const Eigen::Ref<const Eigen::MatrixXd>& m,
                                const Eigen::Ref<const Eigen::VectorXd>& q, double epsilon);
  void read_basis(const Eigen::Ref<const Eigen::MatrixXd>& m, double epsilon);

  int size_ = 0;
  int columns_ = 0;
  std::vector<double> tableau_;  // n rows of: the columns of w, of z, of the covering variable, right-hand side
  std::vector<int> basis_;       // the variable of each row, numbered as the columns
  std::vector<int> candidates_;
  std::vector<double> proximal_;  // q - ε z_k
  std::vector<double> value_;
  std::vector<double> residual_;
  std::vector<double> z_;
};

}  // namespace carom
