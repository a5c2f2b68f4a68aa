#include "physics/math/lcp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace carom {
namespace {

// In units of the scaled problem.
constexpr std::array<double, 3> kProximal = {0.0, 1e-5, 1e-3};  // ε of each attempt
constexpr double kComplied = 1e-10;    // accepted error: -w and min(w, z), per unit of the largest z
constexpr double kSettled = 1e-13;     // the same: further rounds gain nothing
constexpr double kLeastPivot = 1e-10;  // smaller pivots are zeros of a singular matrix plus rounding
constexpr double kTie = 1e-12;         // ratios closer than this are ties
constexpr int kMostRounds = 30;
constexpr int kMostPivotsPerRow = 50;  // one or two are usual
constexpr int kRefinements = 2;

// Takes the pivot row off all others, so often that its column is 0 there.
inline void eliminate(double* tableau, int rows, int columns, int row, int column) {
  const double* const pivot_row = tableau + row * columns;
  for (int r = 0; r < rows; ++r) {
    if (r == row) continue;
    double* const other = tableau + r * columns;
    const double factor = std::exchange(other[column], 0.0);
    if (factor == 0.0) continue;
    for (int c = 0; c < columns; ++c) other[c] -= factor * pivot_row[c];
  }
}

#if defined(__x86_64__)
// The same in wider vectors, bit for bit.
__attribute__((target("avx2"), flatten)) void eliminate_avx2(double* tableau, int rows, int columns, int row,
                                                             int column) {
  eliminate(tableau, rows, columns, row, column);
}
#endif

}  // namespace

// The variable of a column becomes basic, and that of a row takes its column.
void LcpSolver::exchange(int row, int column) {
  const double inverse = 1.0 / at(row, column);
  double* const pivot_row = &at(row, 0);
  std::swap(unit_[row], pivot_row[column]);
  unit_[row] *= inverse;
  for (int c = 0; c < columns_; ++c) pivot_row[c] *= inverse;
#if defined(__x86_64__)
  static const bool has_avx2 = __builtin_cpu_supports("avx2") != 0;
  (has_avx2 ? eliminate_avx2 : eliminate)(tableau_.data(), size_, columns_, row, column);
#else
  eliminate(tableau_.data(), size_, columns_, row, column);
#endif
  std::swap(basis_[row], outside_[column]);
  column_of_[basis_[row]] = -1;
  column_of_[outside_[column]] = column;
}

// The row with the least ratio of right-hand side to pivot. Ties are broken by the columns of w in order,
// which hold the inverse of the basis. The covering variable leaves whenever it can. -1 if no pivot is
// positive.
int LcpSolver::leaving_row(int column) {
  const int covering = 2 * size_;
  candidates_.clear();
  for (int r = 0; r < size_; ++r) {
    if (at(r, column) > kLeastPivot) candidates_.push_back(r);
  }
  for (int key = -1; key < size_ && candidates_.size() > 1; ++key) {
    const auto ratio = [&](int r) { return (key < 0 ? at(r, columns_ - 1) : entry(r, key)) / at(r, column); };
    double least = ratio(candidates_.front());
    for (const int r : candidates_) least = std::min(least, ratio(r));
    const double limit = least + kTie * (1.0 + std::abs(least));
    std::erase_if(candidates_, [&](int r) { return ratio(r) > limit; });
    for (const int r : candidates_) {
      if (basis_[r] == covering) return r;
    }
  }
  return candidates_.empty() ? -1 : candidates_.front();
}

// Solves B x = q for the basic variables x and refines them with the tableau's B⁻¹. The columns of B are
// columns of I and of -(M + ε I).
void LcpSolver::read_basis(const Eigen::Ref<const Eigen::MatrixXd>& m, double epsilon) {
  value_.resize(size_);
  for (int r = 0; r < size_; ++r) value_[r] = at(r, columns_ - 1);
  for (int refinement = 0; refinement < kRefinements; ++refinement) {
    residual_ = proximal_;
    for (int r = 0; r < size_; ++r) {
      const int variable = basis_[r] - size_;
      if (variable < 0) {
        residual_[basis_[r]] -= value_[r];
      } else {
        for (int i = 0; i < size_; ++i) residual_[i] += m(i, variable) * value_[r];
        residual_[variable] += epsilon * value_[r];
      }
    }
    for (int r = 0; r < size_; ++r) {
      for (int i = 0; i < size_; ++i) value_[r] += entry(r, i) * residual_[i];
    }
  }
  z_.assign(size_, 0.0);
  for (int r = 0; r < size_; ++r) {
    if (basis_[r] >= size_) z_[basis_[r] - size_] = std::max(value_[r], 0.0);
  }
}

bool LcpSolver::pivot_to_solution(const Eigen::Ref<const Eigen::MatrixXd>& m, double epsilon) {
  // w - (M + ε I) z - (1, ..., 1) z_0 = q - ε z_k
  const int covering = 2 * size_;
  tableau_.resize(size_ * columns_);
  basis_.resize(size_);
  unit_.assign(size_, 1.0);
  outside_.resize(size_ + 1);
  column_of_.assign(2 * size_ + 1, -1);
  candidates_.reserve(size_);
  int row = 0;  // the last of equal ones: lexicographically least of [q, I]
  for (int r = 0; r < size_; ++r) {
    for (int c = 0; c < size_; ++c) at(r, c) = -m(r, c);
    at(r, r) -= epsilon;
    at(r, size_) = -1.0;
    at(r, columns_ - 1) = proximal_[r];
    basis_[r] = r;
    if (proximal_[r] <= proximal_[row]) row = r;
  }
  for (int c = 0; c <= size_; ++c) {
    outside_[c] = size_ + c;
    column_of_[size_ + c] = c;
  }
  int entering = size_;  // a column
  for (int pivots = 0; pivots < kMostPivotsPerRow * (size_ + 1); ++pivots) {
    const int leaving = basis_[row];
    exchange(row, entering);
    if (leaving == covering) return true;
    // The complement of the variable that left.
    entering = column_of_[leaving < size_ ? leaving + size_ : leaving - size_];
    row = leaving_row(entering);
    if (row < 0) return false;
  }
  return false;
}

// True if zero is the solution.
bool LcpSolver::begin(const Eigen::Ref<const Eigen::VectorXd>& q) {
  size_ = static_cast<int>(q.size());
  columns_ = size_ + 2;
  z_.assign(size_, 0.0);
  return size_ == 0 || q.minCoeff() >= 0.0;
}

bool LcpSolver::solve(const Eigen::Ref<const Eigen::MatrixXd>& m, const Eigen::Ref<const Eigen::VectorXd>& q) {
  if (begin(q)) return true;
  for (const double epsilon : kProximal) {
    if (solve_with(m, q, epsilon)) return true;
  }
  return false;
}

bool LcpSolver::solve_by_pivoting(const Eigen::Ref<const Eigen::MatrixXd>& m,
                                  const Eigen::Ref<const Eigen::VectorXd>& q) {
  return begin(q) || solve_with(m, q, 0.0);
}

bool LcpSolver::solve_with(const Eigen::Ref<const Eigen::MatrixXd>& m,
                           const Eigen::Ref<const Eigen::VectorXd>& q, double epsilon) {
  z_.assign(size_, 0.0);
  proximal_.resize(size_);
  double worst = 0.0;
  for (int round = 0; round < (epsilon > 0.0 ? kMostRounds : 1); ++round) {
    for (int i = 0; i < size_; ++i) proximal_[i] = q[i] - epsilon * z_[i];
    if (!pivot_to_solution(m, epsilon)) return false;
    read_basis(m, epsilon);
    worst = 0.0;
    double largest = 1.0;
    for (int i = 0; i < size_; ++i) {
      double w = q[i];
      for (int j = 0; j < size_; ++j) w += m(i, j) * z_[j];
      const double error = std::max(-w, std::min(w, z_[i]));
      if (std::isnan(error)) return false;
      worst = std::max(worst, error);
      largest = std::max(largest, z_[i]);
    }
    worst /= largest;
    if (worst <= kSettled) return true;
  }
  return worst <= kComplied;
}

}  // namespace carom
