#include "physics/contact/semismooth_newton.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/model/coulomb_friction.h"

namespace carom {

namespace {

// The stiffness r K of a proximal step. A low stiffness makes an easy problem and a short step; it grows
// while the steps succeed and falls when one fails.
constexpr double kFirstStiffness = 10.0;
constexpr double kStiffer = 10.0;
constexpr double kSofter = 30.0;
constexpr double kLeastStiffness = 0.1;
constexpr double kMostStiffness = 1e10;  // beyond it the factors have no digits left

constexpr double kInnerAccuracy = 1e-4;  // of a proximal step; the next one removes the rest
constexpr double kSlowProgress = 1e-2;   // of the residual from one proximal step to the next
constexpr int kMostHalvings = 6;
constexpr int kPatience = 3;  // proximal steps that may leave a larger residual
// Proximal steps at the largest stiffness, for errors of heavy bodies hidden below the rounding of light
// ones.
constexpr int kPolish = 4;
// Proximal steps to impulses that are larger than any may be.
constexpr int kMostOvershoots = 3;
constexpr int kFirstSweeps = 32;  // after a failed step, then twice as many
constexpr int kMostSweeps = 1024;
constexpr std::size_t kMostPivoted = 64;  // contacts: more take longer than sweeps
constexpr double kCompliance = 1e-6;      // of pivoted contacts, so that they share their load
// Of the largest impulse that any may be: pivoting may return any pressure between jammed bodies.
constexpr double kPivotedStress = 1e-2;
constexpr double kFar = 1e3;  // tolerances: so much is left to do that sharing does not count

// The rows of J of one contact, for velocities times √m and √I: normal, tangential, rolling; side A, side B.
struct ScaledRows {
  Eigen::Vector3d na, nb, ta, tb, ra, rb;
};

}  // namespace

static ScaledRows scaled_rows(const ContactRow& row, double ma, double ia, double mb, double ib) {
  ScaledRows s;
  s.na << -row.nx * ma, -row.ny * ma, -row.arm_na * ia;
  s.nb << row.nx * mb, row.ny * mb, row.arm_nb * ib;
  s.ta << row.ny * ma, -row.nx * ma, -row.arm_ta * ia;
  s.tb << -row.ny * mb, row.nx * mb, row.arm_tb * ib;
  s.ra << 0.0, 0.0, -ia;
  s.rb << 0.0, 0.0, ib;
  return s;
}

void SemismoothNewton::number_bodies(std::span<const ContactRow> rows, std::span<const SolverBody> bodies) {
  local_of_.resize(std::max(local_of_.size(), bodies.size()), -1);
  bodies_.clear();
  for (const ContactRow& row : rows) {
    for (const BodyIndex i : {row.a, row.b}) {
      if (local_of_[i] >= 0 || (bodies[i].inverse_mass <= 0.0 && bodies[i].inverse_inertia <= 0.0)) continue;
      local_of_[i] = static_cast<int>(bodies_.size());
      bodies_.push_back(i);
    }
  }
  const int n = static_cast<int>(bodies_.size());
  root_.resize(n + 1);
  turn_root_.resize(n + 1);
  for (int i = 0; i < n; ++i) {
    root_[i] = std::sqrt(bodies[bodies_[i]].inverse_mass);
    turn_root_[i] = std::sqrt(bodies[bodies_[i]].inverse_inertia);
  }
  root_[n] = turn_root_[n] = 0.0;

  local_.resize(rows.size());
  edges_.clear();
  for (std::size_t c = 0; c < rows.size(); ++c) {
    const int a = local_of_[rows[c].a];
    const int b = local_of_[rows[c].b];
    local_[c] = {a < 0 ? n : a, b < 0 ? n : b, {}};
    if (a >= 0 && b >= 0) edges_.emplace_back(a, b);
  }
  lu_.analyse(n, edges_);
  for (Local& l : local_) {
    if (l.a < n && l.b < n) l.slot = lu_.slot(l.a, l.b);
  }
  for (const BodyIndex i : bodies_) local_of_[i] = -1;
  for (Eigen::VectorXd* x : {&step_, &direction_, &next_, &system_}) x->resize(3 * (n + 1));
  miss_.resize(rows.size());
  change_.resize(rows.size());
  best_.resize(rows.size());
  states_.resize(rows.size());
  factorised_states_.assign(rows.size(), 255);
}

void SemismoothNewton::centre(std::span<const ContactRow> rows, std::span<const SolverBody> bodies) {
  for (std::size_t c = 0; c < rows.size(); ++c) {
    const RowVelocity u = row_velocity(rows[c], bodies[rows[c].a], bodies[rows[c].b]);
    miss_[c] = {rows[c].target - u.normal, rows[c].slip_target - u.tangential, -u.spin};
  }
}

double SemismoothNewton::evaluate(std::span<const ContactRow> rows, const Eigen::VectorXd& step) {
  system_ = step;
  for (std::size_t c = 0; c < rows.size(); ++c) {
    const ContactRow& row = rows[c];
    const Local& l = local_[c];
    const ScaledRows s = scaled_rows(row, root_[l.a], turn_root_[l.a], root_[l.b], turn_root_[l.b]);
    const Eigen::Vector3d ya = step.segment<3>(3 * l.a);
    const Eigen::Vector3d yb = step.segment<3>(3 * l.b);
    const double un = s.na.dot(ya) + s.nb.dot(yb);
    const double ut = s.ta.dot(ya) + s.tb.dot(yb);
    const double spin = s.ra.z() * ya.z() + s.rb.z() * yb.z();
    // Stored as changes: small ones would be lost next to large impulses.
    std::uint8_t state = kOpen;
    Impulses change{-row.normal, -row.tangential, -row.moment};
    const double normal = stiffness_ * row.mass_n * (miss_[c].normal - un);
    if (row.normal + normal > 0.0) {
      state = kClosed;
      change.normal = normal;
      const double limit = row.friction * (row.normal + normal);
      const double most = row.rolling * (row.normal + normal);
      change.tangential = stiffness_ * row.mass_t * (miss_[c].tangential - ut);
      change.moment = stiffness_ * row.mass_r * (miss_[c].spin - spin);
      const double tangential = row.tangential + change.tangential;
      const double moment = row.moment + change.moment;
      if (limit > 0.0 && std::abs(tangential) <= limit) {
        state |= kHeld;
      } else {
        if (tangential > 0.0) state |= kUp;
        change.tangential = std::copysign(limit, tangential) - row.tangential;
      }
      if (most > 0.0 && std::abs(moment) <= most) {
        state |= kLocked;
      } else {
        if (moment > 0.0) state |= kTurnsUp;
        change.moment = std::copysign(most, moment) - row.moment;
      }
    }
    states_[c] = state;
    change_[c] = change;
    system_.segment<3>(3 * l.a) -= change.normal * s.na + change.tangential * s.ta + change.moment * s.ra;
    system_.segment<3>(3 * l.b) -= change.normal * s.nb + change.tangential * s.tb + change.moment * s.rb;
  }
  system_.tail<3>().setZero();
  return system_.norm();
}

bool SemismoothNewton::factorise(std::span<const ContactRow> rows) {
  const int n = static_cast<int>(bodies_.size());
  lu_.clear();
  for (int i = 0; i < n; ++i) lu_.diagonal(i).setIdentity();
  for (std::size_t c = 0; c < rows.size(); ++c) {
    const ContactRow& row = rows[c];
    const Local& l = local_[c];
    const ScaledRows s = scaled_rows(row, root_[l.a], turn_root_[l.a], root_[l.b], turn_root_[l.b]);
    const auto add = [&](double weight, const Eigen::Vector3d& ca, const Eigen::Vector3d& cb,
                         const Eigen::Vector3d& ja, const Eigen::Vector3d& jb) {
      if (l.a < n) lu_.diagonal(l.a) += weight * ca * ja.transpose();
      if (l.b < n) lu_.diagonal(l.b) += weight * cb * jb.transpose();
      if (l.a < n && l.b < n) {
        lu_.row_col(l.slot) += weight * ca * jb.transpose();
        lu_.col_row(l.slot) += weight * cb * ja.transpose();
      }
    };
    const std::uint8_t state = states_[c];
    if (!(state & kClosed)) continue;
    // An impulse of friction or rolling at its limit varies with λ_n, along c = J_n ± μ J_t ± ρ J_r.
    Eigen::Vector3d ca = s.na;
    Eigen::Vector3d cb = s.nb;
    if (state & kHeld) {
      add(stiffness_ * row.mass_t, s.ta, s.tb, s.ta, s.tb);
    } else {
      const double share = state & kUp ? row.friction : -row.friction;
      ca += share * s.ta;
      cb += share * s.tb;
    }
    if (state & kLocked) {
      add(stiffness_ * row.mass_r, s.ra, s.rb, s.ra, s.rb);
    } else if (row.rolling > 0.0) {
      const double share = state & kTurnsUp ? row.rolling : -row.rolling;
      ca += share * s.ra;
      cb += share * s.rb;
    }
    add(stiffness_ * row.mass_n, ca, cb, s.na, s.nb);
  }
  factorised_states_ = states_;
  factorised_stiffness_ = stiffness_;
  return lu_.factorise();
}

bool SemismoothNewton::search_states(std::span<const ContactRow> rows, int& left) {
  const int n = static_cast<int>(bodies_.size());
  const double noise = 16.0 * std::numeric_limits<double>::epsilon() * stiffness_;
  step_.setZero();
  double norm = evaluate(rows, step_);
  while (norm > std::max(kInnerAccuracy, noise) * step_.norm()) {
    if (left-- <= 0) return false;
    if (states_ != factorised_states_ || stiffness_ != factorised_stiffness_) {
      if (!factorise(rows)) {
        factorised_stiffness_ = 0.0;
        return false;
      }
    }
    direction_ = -system_;
    lu_.solve(direction_.head(3 * n));
    if (!direction_.allFinite()) return false;
    double share = 1.0;
    next_ = step_ + direction_;
    double next_norm = evaluate(rows, next_);
    if (states_ == factorised_states_) {  // the states were right: the step is exact
      step_.swap(next_);
      return true;
    }
    for (int i = 0; i < kMostHalvings && !(next_norm < (1.0 - 0.1 * share) * norm); ++i) {
      share *= 0.5;
      next_ = step_ + share * direction_;
      next_norm = evaluate(rows, next_);
    }
    if (!(next_norm < norm)) return false;
    step_.swap(next_);
    norm = next_norm;
  }
  return true;
}

void SemismoothNewton::keep(std::span<const ContactRow> rows) {
  for (std::size_t c = 0; c < rows.size(); ++c) best_[c] = {rows[c].normal, rows[c].tangential, rows[c].moment};
}

void SemismoothNewton::put_best(std::span<ContactRow> rows, std::span<SolverBody> bodies) const {
  for (std::size_t c = 0; c < rows.size(); ++c) {
    rows[c].normal = best_[c].normal;
    rows[c].tangential = best_[c].tangential;
    rows[c].moment = best_[c].moment;
  }
  apply_all(rows, bodies);
}

void SemismoothNewton::take_step(std::span<ContactRow> rows, std::span<SolverBody> bodies) const {
  for (std::size_t c = 0; c < rows.size(); ++c) {
    ContactRow& row = rows[c];
    row.normal += change_[c].normal;
    row.tangential = limited_by_friction(row.tangential + change_[c].tangential, row.friction, row.normal);
    row.moment = limited_by_friction(row.moment + change_[c].moment, row.rolling, row.normal);
  }
  apply_all(rows, bodies);
}

NewtonResult SemismoothNewton::run(std::span<ContactRow> rows, std::span<SolverBody> bodies,
                                   const NewtonOptions& options) {
  number_bodies(rows, bodies);
  keep(rows);
  NewtonResult result{std::numeric_limits<double>::infinity(), 0, false};
  // Measures the residual of the impulses and keeps the best ones. Of those that differ by rounding alone,
  // the last are the best.
  bool rounded = false;
  bool too_large = false;
  const auto measure = [&] {
    const double now = residual(rows, bodies);
    rounded = now <= rounding_level(rows, bodies);
    apply_all(rows, bodies);
    too_large = largest_impulse(rows) > options.most_impulse;
    if ((now < result.residual || rounded) && !too_large) {
      result.residual = now;
      result.settled = rounded || now <= options.tolerance;
      keep(rows);
    }
    return now;
  };

  factorised_stiffness_ = 0.0;
  stiffness_ = kFirstStiffness;
  int left = options.max_iterations;
  int sweeps = kFirstSweeps;
  int sweeps_left = options.max_sweeps;
  int worse = 0;
  int polished = 0;
  int overshoots = 0;
  int pivots_left = rows.size() <= kMostPivoted ? 2 : 0;  // with compliance, then without
  double last = measure();
  while (left > 0 && !(result.residual <= options.tolerance)) {
    centre(rows, bodies);
    const bool found = search_states(rows, left);
    if (found) {
      take_step(rows, bodies);
      const double now = measure();
      if (too_large) {
        if (++overshoots >= kMostOvershoots) break;
        worse = kPatience;
      }
      if (rounded && stiffness_ >= kMostStiffness && ++polished >= kPolish) break;
      if (rounded || now > kSlowProgress * last) stiffness_ = std::min(kMostStiffness, kStiffer * stiffness_);
      if (now >= last && !rounded) ++worse;
      last = now;
    }
    if (!found || worse >= kPatience) {
      if (found) put_best(rows, bodies);
      worse = 0;
      stiffness_ = std::max(kLeastStiffness, stiffness_ / kSofter);
      if (sweeps > sweeps_left || result.residual <= options.enough) break;
      if (pivots_left > 0 && (pivots_left > 1 || result.residual > kFar * options.tolerance) &&
          pivoted_.solve(rows, bodies, --pivots_left > 0 && left > 0 ? kCompliance : 0.0)) {
        apply_all(rows, bodies);
        if (largest_impulse(rows) <= kPivotedStress * options.most_impulse) {
          last = measure();
          stiffness_ = kFirstStiffness;
          continue;
        }
        put_best(rows, bodies);
      }
      sweeps_left -= sweeps;
      for (int i = 0; i < sweeps; ++i) sweep(rows, bodies, i % 2 == 1);
      sweeps = std::min(2 * sweeps, kMostSweeps);
      apply_all(rows, bodies);
      last = measure();
    }
  }
  put_best(rows, bodies);
  result.iterations = options.max_iterations - std::max(left, 0);
  return result;
}

}  // namespace carom
