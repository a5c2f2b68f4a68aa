#include "physics/impact/simultaneous_impact.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "physics/math/vectors.h"

namespace carom {
namespace {

constexpr double kNoGain = 1e-13;  // of the energy of the hardest impact: rounding
constexpr int kMostHalvings = 50;  // of e
// Lowered by less, e is what it was: the energy of redundant impulses rounds by more than kNoGain.
constexpr double kRoundedRestitution = 1e-9;

using Row = ClusterScratch::Row;

// Calls visit(row) for the normal and the tangent of a contact.
void each_row(const ClusterContact& c, const auto& visit) {
  for (const Vec2& d : {c.normal, crossed(c.normal)})
    visit(Row{c.a, c.b, d, cross(c.from_a, d), cross(c.from_b, d)});
}

// The contacts of a cluster. Rows 2i and 2i + 1 are the normal and the tangent of contact i.
class Cluster {
 public:
  Cluster(Eigen::Ref<Eigen::Matrix3Xd> velocities, const Eigen::Ref<const Eigen::Matrix3Xd>& answers,
          std::span<const ClusterContact> contacts, ClusterScratch& s)
      : v_(velocities), answers_(answers), contacts_(contacts), s_(s) {
    const int m = static_cast<int>(contacts.size());
    s_.rows.clear();
    for (const ClusterContact& c : contacts) each_row(c, [&](const Row& row) { s_.rows.push_back(row); });
    s_.response.resize(4 * m * m);
    for (int i = 0; i < 2 * m; ++i) {
      for (int j = 0; j <= i; ++j)
        s_.response[i * 2 * m + j] = s_.response[j * 2 * m + i] = speed_along(s_.rows[i], answer(j));
    }
    s_.scale.resize(m);
    s_.rubbing.clear();
    for (int i = 0; i < m; ++i) {
      const double k_nn = response(2 * i, 2 * i);
      s_.scale[i] = k_nn > 0.0 ? 1.0 / std::sqrt(k_nn) : 0.0;
      if (k_nn > 0.0 && contacts[i].kinetic_friction > 0.0) s_.rubbing.push_back(i);
    }
    s_.velocity.resize(2 * m);
    s_.after.resize(2 * m);
    s_.impulse.resize(2 * m);
  }

  [[nodiscard]] bool takes_part(int contact) const { return s_.scale[contact] > 0.0; }

  // Reads the velocities of the contacts; true if one that takes part approaches.
  [[nodiscard]] bool read() {
    bool approaches = false;
    for (int i = 0; i < rows(); ++i) {
      s_.velocity[i] = speed_along(s_.rows[i], v_);
      approaches = approaches || (i % 2 == 0 && takes_part(i / 2) && s_.velocity[i] < 0.0);
    }
    return approaches;
  }

  // Finds impulses with which no contact has a larger e than `most`, and the velocities after them, which are
  // not applied yet.
  [[nodiscard]] bool solve(double most);
  // Whether these impulses increase the energy.
  [[nodiscard]] bool gains() const {
    double work = 0.0;
    for (int i = 0; i < rows(); ++i) work += 0.5 * s_.impulse[i] * (s_.velocity[i] + s_.after[i]);
    return work > kNoGain * size_ * size_;
  }
  void apply(std::span<Impact> impacts);

 private:
  // The changes of the bodies' velocities by a unit impulse along row i.
  [[nodiscard]] Eigen::Ref<const Eigen::Matrix3Xd> answer(int i) const {
    return answers_.middleCols(i * v_.cols(), v_.cols());
  }

  // The least normal velocity after the impact.
  [[nodiscard]] double rebound(int contact, double most) const {
    return std::min(contacts_[contact].restitution, most) * std::max(-s_.velocity[2 * contact], 0.0);
  }

  // m/s, along a row, of bodies with these velocities.
  template <class Velocities>
  [[nodiscard]] static double speed_along(const Row& r, const Velocities& v) {
    return r.direction.dot(v.col(r.b).template head<2>() - v.col(r.a).template head<2>()) +
           r.turn_b * v(2, r.b) - r.turn_a * v(2, r.a);
  }

  [[nodiscard]] int rows() const { return static_cast<int>(s_.rows.size()); }
  [[nodiscard]] double response(int i, int j) const { return s_.response[i * rows() + j]; }

  Eigen::Ref<Eigen::Matrix3Xd> v_;
  Eigen::Ref<const Eigen::Matrix3Xd> answers_;
  std::span<const ClusterContact> contacts_;
  ClusterScratch& s_;
  double size_ = 0.0;  // of the scaled velocities: its square is twice the energy of the hardest impact
};

// Unknowns, scaled by √K_nn of their contact and by the fastest contact: j_n of all contacts, then j_t+, j_t-
// and λ of those with friction, j_t = j_t+ - j_t-, λ the slip that is left:
//   w_n = u_n' + e min(u_n, 0),   w_+ = u_t' + λ,   w_- = -u_t' + λ,   w_λ = μ j_n - j_t+ - j_t-
bool Cluster::solve(double most) {
  const int m = static_cast<int>(contacts_.size());
  const int rubbing = static_cast<int>(s_.rubbing.size());
  const int n = m + 3 * rubbing;
  s_.matrix.assign(n * n, 0.0);
  s_.vector.assign(n, 0.0);
  Eigen::Map<Eigen::MatrixXd> matrix(s_.matrix.data(), n, n);
  Eigen::Map<Eigen::VectorXd> vector(s_.vector.data(), n);
  const auto scaled = [&](int i, int j) { return s_.scale[i / 2] * s_.scale[j / 2] * response(i, j); };
  const auto scaled_velocity = [&](int i) { return s_.scale[i / 2] * s_.velocity[i]; };
  for (int i = 0; i < m; ++i) {
    for (int j = 0; j < m; ++j) matrix(i, j) = scaled(2 * i, 2 * j);
    vector[i] = scaled_velocity(2 * i) - s_.scale[i] * rebound(i, most);
  }
  for (int p = 0; p < rubbing; ++p) {
    const int i = s_.rubbing[p];
    const int plus = m + 3 * p, minus = plus + 1, left = plus + 2;
    for (int j = 0; j < m; ++j) {
      const double k = scaled(2 * i + 1, 2 * j);
      matrix(plus, j) = matrix(j, plus) = k;
      matrix(minus, j) = matrix(j, minus) = -k;
    }
    for (int q = 0; q < rubbing; ++q) {
      const double k = scaled(2 * i + 1, 2 * s_.rubbing[q] + 1);
      matrix(plus, m + 3 * q) = matrix(minus, m + 3 * q + 1) = k;
      matrix(plus, m + 3 * q + 1) = matrix(minus, m + 3 * q) = -k;
    }
    matrix(plus, left) = matrix(minus, left) = 1.0;
    matrix(left, plus) = matrix(left, minus) = -1.0;
    matrix(left, i) = contacts_[i].kinetic_friction;
    vector[plus] = scaled_velocity(2 * i + 1);
    vector[minus] = -vector[plus];
  }
  size_ = vector.cwiseAbs().maxCoeff();
  vector /= size_;
  if (!s_.lcp.solve(matrix, vector)) return false;
  const Eigen::Map<const Eigen::VectorXd> z = s_.lcp.solution();
  for (int i = 0; i < m; ++i) {
    s_.impulse[2 * i] = size_ * s_.scale[i] * z[i];
    s_.impulse[2 * i + 1] = 0.0;
  }
  for (int p = 0; p < rubbing; ++p) {
    const int i = s_.rubbing[p];
    const double cone = contacts_[i].kinetic_friction * s_.impulse[2 * i];
    s_.impulse[2 * i + 1] = std::clamp(size_ * s_.scale[i] * (z[m + 3 * p] - z[m + 3 * p + 1]), -cone,
                                       cone);  // kept in rounding too
  }
  for (int i = 0; i < rows(); ++i) {
    s_.after[i] = s_.velocity[i];
    for (int j = 0; j < rows(); ++j) s_.after[i] += response(i, j) * s_.impulse[j];
  }
  return true;
}

// The work is that of the velocities actually reached: where heavy bodies press through a light one, those
// predicted from the impulses are off by far more than the energy's rounding.
void Cluster::apply(std::span<Impact> impacts) {
  for (int i = 0; i < rows(); ++i) {
    if (s_.impulse[i] != 0.0) v_ += s_.impulse[i] * answer(i);
  }
  for (int i = 0; i < rows(); ++i) {
    const double j = s_.impulse[i];
    const double lost = -0.5 * j * (s_.velocity[i] + speed_along(s_.rows[i], v_));
    Impact& impact = impacts[i / 2];
    (i % 2 == 0 ? impact.normal : impact.tangential) = j;
    (i % 2 == 0 ? impact.lost_to_restitution : impact.lost_to_friction) = lost;
  }
}

}  // namespace

void free_answers(const Eigen::Ref<const Eigen::VectorXd>& inverse_mass,
                  const Eigen::Ref<const Eigen::VectorXd>& inverse_inertia,
                  std::span<const ClusterContact> contacts, Eigen::Matrix3Xd& answers) {
  const Eigen::Index n = inverse_mass.size();
  answers.setZero(3, 2 * n * static_cast<Eigen::Index>(contacts.size()));
  Eigen::Index first = 0;
  for (const ClusterContact& c : contacts) {
    each_row(c, [&](const Row& r) {
      answers.col(first + r.a).head<2>() -= inverse_mass[r.a] * r.direction;
      answers(2, first + r.a) -= inverse_inertia[r.a] * r.turn_a;
      answers.col(first + r.b).head<2>() += inverse_mass[r.b] * r.direction;
      answers(2, first + r.b) += inverse_inertia[r.b] * r.turn_b;
      first += n;
    });
  }
}

ClusterOutcome resolve_simultaneous(Eigen::Ref<Eigen::Matrix3Xd> velocities,
                                    const Eigen::Ref<const Eigen::Matrix3Xd>& answers,
                                    std::span<const ClusterContact> contacts, ClusterRestitution restitution,
                                    std::span<Impact> impacts, ClusterScratch& scratch) {
  assert(impacts.size() == contacts.size());
  std::fill(impacts.begin(), impacts.end(), Impact{});
  ClusterOutcome outcome;
  Cluster cluster(velocities, answers, contacts, scratch);
  double smallest = 1.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (!cluster.takes_part(static_cast<int>(i))) continue;
    smallest = std::min(smallest, contacts[i].restitution);
    largest = std::max(largest, contacts[i].restitution);
  }
  outcome.restitution = restitution == ClusterRestitution::kSmallest ? smallest : largest;
  if (!cluster.read()) return outcome;
  // If this e has no solution, one at a smaller e > 0 would be at the edge of solvability, with huge
  // impulses.
  const bool solvable = cluster.solve(outcome.restitution);
  if (!solvable || cluster.gains()) {
    double high = solvable ? outcome.restitution : 0.0;
    const double asked = outcome.restitution;
    outcome.restitution = 0.0;
    for (int i = 0; high > 0.0 && i < kMostHalvings; ++i) {
      const double middle = 0.5 * (outcome.restitution + high);
      (cluster.solve(middle) && !cluster.gains() ? outcome.restitution : high) = middle;
    }
    outcome.lowered = asked - outcome.restitution > kRoundedRestitution;
    if (!cluster.solve(outcome.restitution)) {
      outcome.solved = false;
      return outcome;
    }
  }
  cluster.apply(impacts);
  return outcome;
}

}  // namespace carom
