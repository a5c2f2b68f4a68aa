#include "physics/dynamics/joint_constraints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "physics/math/vectors.h"
#include "physics/scene/drive.h"

namespace carom {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
// A pivot below this share of its diagonal element is rounding: the row depends on those before it. Masses that
// differ by a factor of 10⁶ leave 10⁻⁶.
constexpr double kDependent = 1e-12;
// Newton's method converges quadratically: near a solution a few corrections reach rounding.
constexpr int kMostCorrections = 60;
// Where it fails, each row is corrected by itself this often, which brings the ends nearer from any position.
constexpr int kSweeps = 8;
// Cost of setting up a row, in units of Trajectories::flight_work().
constexpr std::int64_t kRowWork = 4;
// Relative to the size: a gap within kClosed is closed; with one beyond kMissed the projection has failed.
constexpr double kClosed = 2.0 * kEpsilon;
constexpr double kMissed = 1e-10;
// A string at its length counts as no longer than that.
constexpr double kAtLength = 32.0 * kEpsilon;
// Relative to the largest impulse of the group: a smaller push by a string is rounding.
constexpr double kPush = 1e-12;
// A string this near to its length (dimensionless) whose ends don't move along it is taut at the start.
constexpr double kTautAtStart = 1e-6;

}  // namespace

JointConstraints::JointConstraints(std::shared_ptr<const Model> model)
    : model_(std::move(model)), terms_(model_->joint_terms), welded_(model_->shapes.welded) {
  const double time = model_->start_time;
  for (const JointTerm& joint : terms_.all) {
    Motions ends(kRows, 2);
    ends.col(0) = motion_at_start(model_->starts, joint.body);
    ends.col(1) = joint.other >= 0 ? motion_at_start(model_->starts, joint.other) : Motion(Motion::Zero());
    const Ends e = ends_of(joint, time, ends, 0, joint.other >= 0 ? 1 : -1);
    const double distance = e.d.norm();
    const double speeds = ends.middleRows<2>(3).norm() + e.end_velocity.norm();
    const bool at_length = distance >= (1.0 - kTautAtStart) * joint.length;
    const bool stays = std::abs(e.d.dot(e.u)) <= kTautAtStart * distance * speeds;
    taut_.push_back(joint.kind != JointKind::kString || (at_length && stays) ? 1 : 0);
  }
}

void JointConstraints::add_weld(const Weld& weld) {
  terms_.all.push_back(weld_term(weld, {model_->starts, model_->drives, model_->mass}));
  welds_.push_back(weld);
  welded_.join(weld.body, weld.other);
  taut_.push_back(1);
}

void JointConstraints::set_groups(const std::vector<std::vector<BodyIndex>>& groups) {
  groups_.clear();
  first_row_.assign(terms_.all.size(), -1);
  std::vector<std::vector<JointIndex>> joints_at(model_->mass.mass.size());  // by their first body
  for (const JointIndex l : terms_.all.indices()) joints_at[terms_.all[l].body].push_back(l);
  for (const std::vector<BodyIndex>& members : groups) {
    Group& g = groups_.emplace_back();
    const auto column_of = [&](BodyIndex body) {
      const auto found = std::lower_bound(members.begin(), members.end(), body);
      return found != members.end() && *found == body ? static_cast<int>(found - members.begin()) : -1;
    };
    std::vector<std::vector<int>> rows_of(members.size());
    std::size_t next = 0;
    std::vector<JointIndex> own;
    for (const BodyIndex body : members) own.insert(own.end(), joints_at[body].begin(), joints_at[body].end());
    std::sort(own.begin(), own.end());
    for (const JointIndex l : own) {
      const int a = column_of(terms_.all[l].body);
      const int b = terms_.all[l].other >= 0 ? column_of(terms_.all[l].other) : -1;
      if (terms_.all[l].kind == JointKind::kString) g.strings.push_back(l);
      first_row_[l] = static_cast<int>(g.rows.size());
      for (int axis = 0; axis < terms_.all[l].rows; ++axis) {
        const int i = static_cast<int>(g.rows.size());
        int first = i;
        for (const int column : {a, b}) {
          if (column < 0) continue;
          for (const int j : rows_of[column]) {
            first = std::min(first, j);
            g.shared.emplace_back(i, j);
          }
          rows_of[column].push_back(i);
        }
        const std::size_t diagonal = next + static_cast<std::size_t>(i - first);
        g.rows.push_back({l, axis, a, b, first, next, diagonal});
        next = diagonal + 1;
      }
    }
    // Joints between the same two bodies share both of them.
    std::sort(g.shared.begin(), g.shared.end());
    g.shared.erase(std::unique(g.shared.begin(), g.shared.end()), g.shared.end());
    const auto rows = static_cast<Eigen::Index>(g.rows.size());
    g.rest.setZero(3, static_cast<Eigen::Index>(members.size()));
    g.inverse_mass.resize(3, static_cast<Eigen::Index>(members.size()));
    for (std::size_t j = 0; j < members.size(); ++j) {
      const double w = model_->mass.inverse_mass[members[j]];
      g.inverse_mass.col(static_cast<Eigen::Index>(j)) << w, w, model_->mass.inverse_inertia[members[j]];
    }
    for (Eigen::Matrix3Xd* m : {&g.ja, &g.jb}) m->setZero(3, rows);
    g.normal.setZero(2, rows);
    for (Eigen::VectorXd* v : {&g.gap, &g.velocity_term, &g.end_rate, &g.size, &g.force, &g.inverse_pivot})
      v->setZero(rows);
    g.matrix.setZero(static_cast<Eigen::Index>(next));
  }
}

// --- the rows

JointConstraints::Ends JointConstraints::ends_of(const JointTerm& joint, double t, const Motions& y, int a,
                                                 int b) const {
  Ends e;
  const auto ya = y.col(a);
  e.arm_a = turned_by(ya[2], joint.point);
  e.d = ya.head<2>() + e.arm_a;
  e.u = ya.segment<2>(3) + ya[5] * crossed(e.arm_a);
  e.velocity_term = -ya[5] * ya[5] * e.arm_a;
  e.size = ya.head<2>().lpNorm<1>() + (1.0 + std::abs(ya[2])) * joint.point.lpNorm<1>();
  e.end_velocity.setZero();
  e.arm_b.setZero();
  if (b >= 0) {
    const auto yb = y.col(b);
    e.arm_b = turned_by(yb[2], joint.anchor);
    e.d -= yb.head<2>() + e.arm_b;
    e.u -= yb.segment<2>(3) + yb[5] * crossed(e.arm_b);
    e.velocity_term += yb[5] * yb[5] * e.arm_b;
    e.size += yb.head<2>().lpNorm<1>() + (1.0 + std::abs(yb[2])) * joint.anchor.lpNorm<1>();
    return e;
  }
  Vec2 end = joint.anchor;
  if (joint.drive >= 0) {
    const Drive& drive = model_->drive(joint.drive);
    end = drive_position(drive, joint.anchor, t);
    e.end_velocity = drive_velocity(drive, t);
    e.velocity_term -= drive_acceleration(drive, t);
  }
  e.d -= end;
  e.u -= e.end_velocity;
  e.size += end.lpNorm<1>();
  return e;
}

// Jacobian, gaps and all else that a row needs, at time t and motions y.
void JointConstraints::fill_row(Group& g, int i, double t, const Motions& y) const {
  const Row& row = g.rows[i];
  const JointTerm& joint = terms_.all[row.joint];
  if (row.axis == 2) {
    const double angle_a = y(2, row.a);
    const double angle_b = row.b >= 0 ? y(2, row.b) : 0.0;
    g.gap[i] = angle_a - angle_b - joint.angle;
    g.size[i] = 1.0 + std::abs(angle_a) + std::abs(angle_b);
    g.velocity_term[i] = g.end_rate[i] = 0.0;
    g.normal.col(i).setZero();
    g.ja.col(i) = Eigen::Vector3d::UnitZ();
    g.jb.col(i) = -Eigen::Vector3d::UnitZ();
    return;
  }
  const Ends e = ends_of(joint, t, y, row.a, row.b);
  Vec2 n = row.axis == 0 ? Vec2::UnitX() : Vec2::UnitY();
  // Where all coordinates are about zero, the gap's scale is the body's size.
  g.size[i] = std::max({e.size, model_->shapes.size[joint.body], std::numeric_limits<double>::min()});
  if (joint.rows > 1) {
    g.gap[i] = n.dot(e.d);
    g.velocity_term[i] = n.dot(e.velocity_term);
  } else {
    const double distance = e.d.norm();
    const bool acts = taut(row.joint) && distance > 0.0;
    n = acts ? Vec2(e.d / distance) : Vec2(Vec2::Zero());
    const double along = n.dot(e.u);
    g.gap[i] = acts ? distance - joint.length : 0.0;
    g.velocity_term[i] = acts ? n.dot(e.velocity_term) + (e.u.squaredNorm() - along * along) / distance : 0.0;
    g.size[i] += joint.length;
  }
  g.normal.col(i) = n;
  g.end_rate[i] = n.dot(e.end_velocity);
  g.ja.col(i) << n, n.dot(crossed(e.arm_a));
  g.jb.col(i) << -n, -n.dot(crossed(e.arm_b));
}

void JointConstraints::fill_rows(Group& g, double t, const Motions& y) const {
  for (int i = 0; i < static_cast<int>(g.rows.size()); ++i) fill_row(g, i, t, y);
}

template <class Columns>
double JointConstraints::along(const Group& g, int row, const Columns& v) {
  const Row& r = g.rows[row];
  double sum = g.ja.col(row).dot(v.col(r.a));
  if (r.b >= 0) sum += g.jb.col(row).dot(v.col(r.b));
  return sum;
}

template <class Columns>
void JointConstraints::apply(const Group& g, Columns&& v) {
  for (int i = 0; i < static_cast<int>(g.rows.size()); ++i) {
    const Row& r = g.rows[i];
    v.col(r.a) += g.force[i] * g.inverse_mass.col(r.a).cwiseProduct(g.ja.col(i));
    if (r.b >= 0) v.col(r.b) += g.force[i] * g.inverse_mass.col(r.b).cwiseProduct(g.jb.col(i));
  }
}

// --- J M⁻¹Jᵀ

double JointConstraints::entry(const Group& g, int i, int j) {
  const Row& r = g.rows[i];
  const Row& s = g.rows[j];
  const auto term = [&](int column, const Eigen::Matrix3Xd& jr, const Eigen::Matrix3Xd& js) {
    return g.inverse_mass.col(column).cwiseProduct(jr.col(i)).dot(js.col(j));
  };
  double sum = 0.0;
  if (r.a == s.a) sum += term(r.a, g.ja, g.ja);
  if (r.a == s.b) sum += term(r.a, g.ja, g.jb);
  if (r.b >= 0 && r.b == s.a) sum += term(r.b, g.jb, g.ja);
  if (r.b >= 0 && r.b == s.b) sum += term(r.b, g.jb, g.jb);
  return sum;
}

// Row by row: u_ij = a_ij - Σ_k u_ik l_jk, l_ij = u_ij/d_j, d_i = a_ii - Σ_j u_ij l_ij.
void JointConstraints::factor(Group& g) {
  g.matrix.setZero();
  double* const m = g.matrix.data();
  const auto place = [&](int i, int j) {
    return g.rows[i].offset + static_cast<std::size_t>(j - g.rows[i].first);
  };
  for (const auto& [i, j] : g.shared) m[place(i, j)] = entry(g, i, j);
  for (int i = 0; i < static_cast<int>(g.rows.size()); ++i) {
    const int first = g.rows[i].first;
    double* const row = m + g.rows[i].offset;
    for (int j = first; j < i; ++j) {
      const int from = std::max(first, g.rows[j].first);
      double u = row[j - first];
      const double* const other = m + g.rows[j].offset;
      for (int k = from; k < j; ++k) u -= row[k - first] * other[k - g.rows[j].first];
      row[j - first] = u;
    }
    const double whole = entry(g, i, i);
    double pivot = whole;
    for (int j = first; j < i; ++j) {
      const double u = row[j - first];
      row[j - first] = u * g.inverse_pivot[j];
      pivot -= u * row[j - first];
    }
    m[g.rows[i].diagonal] = pivot;
    g.inverse_pivot[i] = pivot > kDependent * whole ? 1.0 / pivot : 0.0;
  }
}

void JointConstraints::solve(Group& g) {
  const double* const m = g.matrix.data();
  const int n = static_cast<int>(g.rows.size());
  for (int i = 0; i < n; ++i) {
    const Row& r = g.rows[i];
    for (int j = r.first; j < i; ++j)
      g.force[i] -= m[r.offset + static_cast<std::size_t>(j - r.first)] * g.force[j];
  }
  g.force.array() *= g.inverse_pivot.array();
  for (int i = n - 1; i >= 0; --i) {
    const Row& r = g.rows[i];
    for (int j = r.first; j < i; ++j)
      g.force[j] -= m[r.offset + static_cast<std::size_t>(j - r.first)] * g.force[i];
  }
}

// --- forces and impulses

// Momentum, angular momentum and work from the plane and from kinematic bodies, as rates or at once, of the
// bodies at y.
void JointConstraints::add_quadratures(const Group& g, const Motions& y, Motions& to) {
  for (int i = 0; i < static_cast<int>(g.rows.size()); ++i) {
    const Row& r = g.rows[i];
    if (r.b >= 0) continue;
    to.col(r.a).segment<2>(6 + kImpulseX) += g.force[i] * g.normal.col(i);
    const double moment = g.inverse_mass(2, r.a) > 0.0 ? g.ja(2, i) : 0.0;
    to(6 + kAngularImpulse, r.a) += g.force[i] * (cross(y.col(r.a).head<2>(), g.normal.col(i)) + moment);
    to(6 + kWorkIn, r.a) += g.force[i] * g.end_rate[i];
  }
}

void JointConstraints::add_forces(GroupIndex group, double t, const Motions& y, Motions& k) {
  Group& g = groups_[group];
  if (g.rows.empty()) return;
  fill_rows(g, t, y);
  factor(g);
  for (int i = 0; i < static_cast<int>(g.rows.size()); ++i)
    g.force[i] = -(along(g, i, v_of(k)) + g.velocity_term[i]);
  solve(g);
  apply(g, v_of(k));
  add_quadratures(g, y, k);
}

std::int64_t JointConstraints::evaluation_work(GroupIndex group) const {
  const Group& g = groups_[group];
  return kRowWork * static_cast<std::int64_t>(g.rows.size()) + g.matrix.size() / 2;
}

// Gauss-Seidel: row by row, each from the result of the last.
void JointConstraints::relax(Group& g, double t, Motions& y) const {
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (int i = 0; i < static_cast<int>(g.rows.size()); ++i) {
      fill_row(g, i, t, y);
      const double answer = entry(g, i, i);
      if (!(answer > 0.0)) continue;
      const Row& r = g.rows[i];
      const double push = -g.gap[i] / answer;
      q_of(y).col(r.a) += push * g.inverse_mass.col(r.a).cwiseProduct(g.ja.col(i));
      if (r.b >= 0) q_of(y).col(r.b) += push * g.inverse_mass.col(r.b).cwiseProduct(g.jb.col(i));
    }
  }
}

bool JointConstraints::restore(GroupIndex group, double t, Motions& y) {
  Group& g = groups_[group];
  if (g.rows.empty()) return true;
  const int rows = static_cast<int>(g.rows.size());
  double worst = 0.0;
  for (int round = 0;; ++round) {
    fill_rows(g, t, y);
    const double before = worst;
    worst = (g.gap.cwiseAbs().array() / g.size.array()).maxCoeff();
    factor(g);
    const bool stuck = round > 1 && !(worst < 0.5 * before) && worst < kMissed;
    if (worst <= kClosed || stuck || round == kMostCorrections) break;
    restoring_work_ += evaluation_work(group);
    if (round > 2 && !(worst < 0.5 * before)) {
      restoring_work_ += kSweeps * kRowWork * rows;
      relax(g, t, y);
      continue;
    }
    g.force = -g.gap;
    solve(g);
    apply(g, q_of(y));
  }
  // The second round removes the rounding error of the first.
  for (int round = 0; round < 2; ++round) {
    for (int i = 0; i < rows; ++i) g.force[i] = g.end_rate[i] - along(g, i, v_of(y));
    solve(g);
    apply(g, v_of(y));
  }
  return worst < kMissed;
}

bool JointConstraints::share(GroupIndex group, double t, const Eigen::Matrix3Xd& change, Motions& y) {
  Group& g = groups_[group];
  const int rows = static_cast<int>(g.rows.size());
  fill_rows(g, t, y);
  factor(g);
  for (int i = 0; i < rows; ++i) {
    g.gap[i] = g.end_rate[i] - along(g, i, v_of(y));
    g.force[i] = g.gap[i] - along(g, i, change);
  }
  solve(g);
  const double most = rows > 0 ? g.force.cwiseAbs().maxCoeff() : 0.0;
  int pushes = -1;
  for (int i = 0; i < rows; ++i) {
    if (terms_.all[g.rows[i].joint].kind != JointKind::kString || !(g.force[i] > kPush * most)) continue;
    if (pushes < 0 || g.force[i] > g.force[pushes]) pushes = i;
  }
  if (pushes >= 0) {
    set_taut(g.rows[pushes].joint, false);
    return false;
  }
  v_of(y) += change;
  apply(g, v_of(y));
  add_quadratures(g, y, y);
  return true;
}

double JointConstraints::apply_taut_impulse(GroupIndex group, double t, Motions& y) {
  // Each round but the last makes one string slack.
  while (!share(group, t, groups_[group].rest, y)) {
  }
  // Half of the impulses times the velocity changes: exact to second order in their rounding.
  const Group& g = groups_[group];
  double taken = 0.0;
  for (int i = 0; i < static_cast<int>(g.rows.size()); ++i)
    taken += 0.5 * g.force[i] * (g.gap[i] + g.end_rate[i] - along(g, i, v_of(y)));
  return taken;
}

void JointConstraints::project(GroupIndex group, double t, const Motions& y, Eigen::Matrix3Xd& change) {
  Group& g = groups_[group];
  fill_rows(g, t, y);
  factor(g);
  for (int i = 0; i < static_cast<int>(g.rows.size()); ++i) g.force[i] = -along(g, i, change);
  solve(g);
  apply(g, change);
}

Vec2 JointConstraints::impulse(GroupIndex group, JointIndex joint, BodyIndex body) const {
  const Group& g = groups_[group];
  Vec2 sum = Vec2::Zero();
  for (std::size_t i = 0; i < g.rows.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    if (g.rows[i].joint == joint) sum += g.force[row] * g.normal.col(row);
  }
  return terms_.all[joint].body == body ? sum : Vec2(-sum);
}

double JointConstraints::tension(GroupIndex group, JointIndex joint) const {
  return -groups_[group].force[first_row_[joint]];
}

double JointConstraints::overstretch(GroupIndex group, JointIndex joint, double t, const Motions& y) const {
  const Row& row = groups_[group].rows[first_row_[joint]];
  const Ends e = ends_of(terms_.all[joint], t, y, row.a, row.b);
  return e.d.norm() - terms_.all[joint].length - kAtLength * (e.size + terms_.all[joint].length);
}

}  // namespace carom
