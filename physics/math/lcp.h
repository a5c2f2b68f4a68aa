#pragma once

#include <Eigen/Core>
#include <vector>

namespace carom {

// Solves the linear complementarity problem z >= 0, w = M z + q >= 0, z·w = 0 for the matrices of contact: M
// is positive semidefinite, or copositive (zMz >= 0 for z >= 0) with friction, and often singular. The method
// is Lemke's pivoting (Cottle, Pang and Stone, The Linear Complementarity Problem, 1992, section 4.4) with
// the covering vector (1, ..., 1) and the lexicographic ratio test against cycling. The values of the final
// basis are refined against M and q. If there are several solutions, it returns one.
//
// Rounding in a singular M can lead the pivoting astray, which the result shows. Then the proximal point
// iteration (Rockafellar, SIAM Journal on Control and Optimization 14 (1976) 877) works on regular matrices:
// z_(k+1) = LCP(M + ε I, q - ε z_k) with z_0 = 0, until z_k solves the original problem. If there is no
// solution, the z_k grow without bound.
//
// Scale the problem so that the entries of M and q are about 1: the tolerances for zero assume it. Buffers
// are kept, so solving again at no greater size allocates nothing.
class LcpSolver {
 public:
  // M is n x n, q has n entries. False if no solution was found.
  [[nodiscard]] bool solve(const Eigen::Ref<const Eigen::MatrixXd>& m,
                           const Eigen::Ref<const Eigen::VectorXd>& q);
  // The same by pivoting alone, for any matrix: in less time where it ends without a solution.
  [[nodiscard]] bool solve_by_pivoting(const Eigen::Ref<const Eigen::MatrixXd>& m,
                                       const Eigen::Ref<const Eigen::VectorXd>& q);

  // z of the last problem, if it was solved.
  [[nodiscard]] Eigen::Map<const Eigen::VectorXd> solution() const { return {z_.data(), size_}; }

 private:
  [[nodiscard]] double& at(int row, int column) { return tableau_[row * columns_ + column]; }
  // Of the column of a variable, which is that of the unit matrix, but for rounding, if it is basic.
  [[nodiscard]] double entry(int row, int variable) {
    if (column_of_[variable] >= 0) return at(row, column_of_[variable]);
    return basis_[row] == variable ? unit_[row] : 0.0;
  }
  [[nodiscard]] bool begin(const Eigen::Ref<const Eigen::VectorXd>& q);
  void exchange(int row, int column);
  [[nodiscard]] int leaving_row(int column);
  [[nodiscard]] bool pivot_to_solution(const Eigen::Ref<const Eigen::MatrixXd>& m, double epsilon);
  [[nodiscard]] bool solve_with(const Eigen::Ref<const Eigen::MatrixXd>& m,
                                const Eigen::Ref<const Eigen::VectorXd>& q, double epsilon);
  void read_basis(const Eigen::Ref<const Eigen::MatrixXd>& m, double epsilon);

  int size_ = 0;
  int columns_ = 0;
  // Variables are numbered w, z, covering variable; the last column of the tableau is the right-hand side.
  std::vector<double> tableau_;  // n rows, a column for each variable that is not basic
  std::vector<int> basis_;       // the variable of each row
  std::vector<double> unit_;     // by row: the entry of that variable
  std::vector<int> outside_;     // the variable of each column
  std::vector<int> column_of_;   // by variable; -1: it is basic
  std::vector<int> candidates_;
  std::vector<double> proximal_;  // q - ε z_k
  std::vector<double> value_;
  std::vector<double> residual_;
  std::vector<double> z_;
};

}  // namespace carom
