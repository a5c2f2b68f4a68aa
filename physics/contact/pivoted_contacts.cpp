#include "physics/contact/pivoted_contacts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace carom {
namespace {

Eigen::Map<Eigen::MatrixXd> zeros(std::vector<double>& memory, Eigen::Index rows, Eigen::Index columns) {
  memory.assign(static_cast<std::size_t>(rows * columns), 0.0);
  return {memory.data(), rows, columns};
}

}  // namespace

void PivotedContacts::add(const ContactRow& row, std::span<const SolverBody> bodies) {
  const SolverBody& a = bodies[row.a];
  const SolverBody& b = bodies[row.b];
  const Eigen::Vector3d of_a(a.free_vx, a.free_vy, a.free_spin);
  const Eigen::Vector3d of_b(b.free_vx, b.free_vy, b.free_spin);
  const auto add_direction = [&](const Eigen::Vector3d& on_a, const Eigen::Vector3d& on_b, double mass,
                                 double target) {
    const double scale = std::sqrt(mass);
    const double beyond = on_a.dot(of_a) + on_b.dot(of_b) - target;
    directions_.push_back({row.a, row.b, scale * on_a, scale * on_b, scale, scale * beyond});
    return static_cast<int>(directions_.size()) - 1;
  };
  const int normal =
      add_direction({-row.nx, -row.ny, -row.arm_na}, {row.nx, row.ny, row.arm_nb}, row.mass_n, row.target);
  normals_.push_back(normal);
  // λ_t √K_t = σ √K_t - μ √(K_t/K_n) λ_n √K_n
  if (row.friction > 0.0) {
    const int along = add_direction({row.ny, -row.nx, -row.arm_ta}, {-row.ny, row.nx, row.arm_tb}, row.mass_t,
                                    row.slip_target);
    limited_.push_back({along, normal, row.friction * std::sqrt(row.mass_n / row.mass_t)});
  }
  if (row.rolling > 0.0) {
    const int turn = add_direction({0.0, 0.0, -1.0}, {0.0, 0.0, 1.0}, row.mass_r, 0.0);
    limited_.push_back({turn, normal, row.rolling * std::sqrt(row.mass_n / row.mass_r)});
  }
}

double PivotedContacts::coupling(int i, int j, std::span<const SolverBody> bodies) const {
  const Direction& x = directions_[static_cast<std::size_t>(i)];
  const Direction& y = directions_[static_cast<std::size_t>(j)];
  const auto through = [&](BodyIndex body, const Eigen::Vector3d& of_x, const Eigen::Vector3d& of_y) {
    const SolverBody& s = bodies[body];
    return s.inverse_mass * of_x.head<2>().dot(of_y.head<2>()) + s.inverse_inertia * of_x.z() * of_y.z();
  };
  double sum = 0.0;
  if (x.a == y.a) sum += through(x.a, x.row_a, y.row_a);
  if (x.a == y.b) sum += through(x.a, x.row_a, y.row_b);
  if (x.b == y.a) sum += through(x.b, x.row_b, y.row_a);
  if (x.b == y.b) sum += through(x.b, x.row_b, y.row_b);
  return sum;
}

bool PivotedContacts::solve(std::span<ContactRow> rows, std::span<const SolverBody> bodies, double compliance) {
  directions_.clear();
  normals_.clear();
  limited_.clear();
  for (const ContactRow& row : rows) {
    if (std::isfinite(row.target)) add(row, bodies);
  }
  const auto count = static_cast<Eigen::Index>(directions_.size());
  auto couplings = zeros(coupling_, count, count);
  double largest = 0.0;
  for (Eigen::Index i = 0; i < count; ++i) {
    largest = std::max(largest, std::abs(directions_[static_cast<std::size_t>(i)].beyond));
    for (Eigen::Index j = 0; j <= i; ++j)
      couplings(i, j) = couplings(j, i) = coupling(static_cast<int>(i), static_cast<int>(j), bodies);
    couplings(i, i) += compliance;
  }
  if (!(largest > 0.0)) return false;

  // The unknowns are λ_n or σ of each direction, then τ of each limit.
  const auto limits = static_cast<Eigen::Index>(limited_.size());
  auto matrix = zeros(matrix_, count + limits, count + limits);
  matrix.topLeftCorner(count, count) = couplings;
  auto beyond = zeros(beyond_, count + limits, 1);
  for (Eigen::Index i = 0; i < count; ++i)
    beyond(i, 0) = directions_[static_cast<std::size_t>(i)].beyond / largest;
  for (Eigen::Index k = 0; k < limits; ++k) {
    const Limited& limit = limited_[static_cast<std::size_t>(k)];
    matrix.col(limit.normal).head(count) -= limit.share * couplings.col(limit.direction);
    matrix(limit.direction, count + k) = 1.0;
    matrix(count + k, limit.normal) = 2.0 * limit.share;
    matrix(count + k, limit.direction) = -1.0;
  }
  if (!lcp_.solve_by_pivoting(matrix, beyond.col(0))) return false;

  const auto z = lcp_.solution();
  auto limit = limited_.begin();
  auto normal = normals_.begin();
  for (ContactRow& row : rows) {
    row.normal = row.tangential = row.moment = 0.0;
    if (!std::isfinite(row.target)) continue;
    const int n = *normal++;
    row.normal = largest * z[n] * directions_[static_cast<std::size_t>(n)].scale;
    const auto take = [&](double& impulse) {
      impulse = largest * (z[limit->direction] - limit->share * z[n]) *
                directions_[static_cast<std::size_t>(limit->direction)].scale;
      ++limit;
    };
    if (row.friction > 0.0) take(row.tangential);
    if (row.rolling > 0.0) take(row.moment);
  }
  return true;
}

}  // namespace carom
