#include "physics/contact/newton_finish.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {

namespace {

constexpr double kFirstStiffness = 1e4;  // where states are searched
constexpr double kMostStiffness = 1e10;  // beyond it the factors have no digits left
constexpr double kLeastStiffness = 1.0;
constexpr double kInnerAccuracy = 1e-4;  // of a proximal step; the next one takes the rest
constexpr double kSlowProgress = 1e-2;   // of the residual from one proximal step to the next
constexpr int kMostHalvings = 6;
constexpr int kMostBisections = 20;
constexpr int kPatience = 8;  // proximal steps without a better residual

// The rows of J of one contact, for velocities times √m and √I: normal, tangential, rolling; side A, side B.
struct ScaledRows {
  Eigen::Vector3d na, nb, ta, tb, ra, rb;
};

}  // namespace

static ScaledRows scaled_rows(const ContactRow& row, double ma, double ia, double mb, double ib) {
  ScaledRows s;
  s.na << -row.nx * ma, -row.ny * ma, -row.turn_na * ia;
  s.nb << row.nx * mb, row.ny * mb, row.turn_nb * ib;
  s.ta << row.ny * ma, -row.nx * ma, -row.turn_ta * ia;
  s.tb << -row.ny * mb, row.nx * mb, row.turn_tb * ib;
  s.ra << 0.0, 0.0, -ia;
  s.rb << 0.0, 0.0, ib;
  return s;
}

void NewtonFinish::number_bodies(std::span<const ContactRow> rows, std::span<const SolverBody> bodies) {
  local_of_.resize(std::max(local_of_.size(), bodies.size()), -1);
  bodies_.clear();
  for (const ContactRow& row : rows) {
    for (const int i : {row.a, row.b}) {
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
  for (const int i : bodies_) local_of_[i] = -1;
  for (Eigen::VectorXd* x : {&step_, &direction_, &next_, &system_}) x->resize(3 * (n + 1));
  miss_.resize(rows.size());
  trial_.resize(rows.size());
  best_.resize(rows.size());
  states_.resize(rows.size());
  factorised_states_.assign(rows.size(), 255);
}

void NewtonFinish::centre(std::span<const ContactRow> rows, std::span<const SolverBody> bodies) {
  for (std::size_t c = 0; c < rows.size(); ++c) {
    const RowVelocity u = row_velocity(rows[c], bodies[rows[c].a], bodies[rows[c].b]);
    miss_[c] = {rows[c].target - u.normal, -u.tangential, -u.spin};
  }
}

double NewtonFinish::evaluate(std::span<const ContactRow> rows, const Eigen::VectorXd& step, bool coupled) {
  system_ = step;
  for (std::size_t c = 0; c < rows.size(); ++c) {
    const ContactRow& row = rows[c];
    const Local& l = local_[c];
    const ScaledRows s = scaled_rows(row, root_[l.a], turn_root_[l.a], root_[l.b], turn_root_[l.b]);
    const Eigen::Vector3d ya = step.segment<3>(3 * l.a);
    const Eigen::Vector3d yb = step.segment<3>(3 * l.b);
    const double un = s.na.dot(ya) + s.nb.dot(yb);
    const double ut = s.ta.dot(ya) + s.tb.dot(yb);
    Impulses& trial = trial_[c];
    std::uint8_t state = kOpen;
    trial.normal = row.normal + stiffness_ * row.mass_n * (miss_[c].normal - un);
    if (trial.normal > 0.0) {
      state |= kClosed;
    } else {
      trial.normal = 0.0;
    }
    const double bound = coupled ? trial.normal : row.normal;
    const double limit = row.friction * bound;
    const double tangential = row.tangential + stiffness_ * row.mass_t * (miss_[c].tangential - ut);
    trial.tangential = std::clamp(tangential, -limit, limit);
    if (limit > 0.0 && std::abs(tangential) <= limit) {
      state |= kHeld;
    } else if (tangential > 0.0) {
      state |= kUp;
    }
    if (row.rolling > 0.0) {
      const double spin = s.ra.z() * ya.z() + s.rb.z() * yb.z();
      const double most = row.rolling * bound;
      const double moment = row.moment + stiffness_ * row.mass_r * (miss_[c].spin - spin);
      trial.moment = std::clamp(moment, -most, most);
      if (most > 0.0 && std::abs(moment) <= most) {
        state |= kLocked;
      } else if (moment > 0.0) {
        state |= kTurnsUp;
      }
    }
    states_[c] = state;
    const double dn = trial.normal - row.normal;
    const double dt = trial.tangential - row.tangential;
    const double dm = trial.moment - row.moment;
    system_.segment<3>(3 * l.a) -= dn * s.na + dt * s.ta + dm * s.ra;
    system_.segment<3>(3 * l.b) -= dn * s.nb + dt * s.tb + dm * s.rb;
  }
  system_.tail<3>().setZero();
  return system_.norm();
}

bool NewtonFinish::factorise(std::span<const ContactRow> rows, bool coupled) {
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
    Eigen::Vector3d ca = s.na;
    Eigen::Vector3d cb = s.nb;
    if (state & kHeld) {
      add(stiffness_ * row.mass_t, s.ta, s.tb, s.ta, s.tb);
    } else if (coupled) {
      const double share = state & kUp ? row.friction : -row.friction;
      ca += share * s.ta;
      cb += share * s.tb;
    }
    if (state & kLocked) {
      add(stiffness_ * row.mass_r, s.ra, s.rb, s.ra, s.rb);
    } else if (coupled && row.rolling > 0.0) {
      const double share = state & kTurnsUp ? row.rolling : -row.rolling;
      ca += share * s.ra;
      cb += share * s.rb;
    }
    if (state & kClosed) add(stiffness_ * row.mass_n, ca, cb, s.na, s.nb);
  }
  factorised_states_ = states_;
  factorised_coupled_ = coupled;
  factorised_stiffness_ = stiffness_;
  return lu_.factorise();
}

bool NewtonFinish::search_states(std::span<const ContactRow> rows, bool coupled, int& left) {
  const int n = static_cast<int>(bodies_.size());
  const double noise = 16.0 * std::numeric_limits<double>::epsilon() * stiffness_;
  step_.setZero();
  double norm = evaluate(rows, step_, coupled);
  while (norm > std::max(kInnerAccuracy, noise) * step_.norm()) {
    if (left-- <= 0) return false;
    if (states_ != factorised_states_ || coupled != factorised_coupled_ ||
        stiffness_ != factorised_stiffness_) {
      if (!factorise(rows, coupled)) {
        factorised_stiffness_ = 0.0;
        return false;
      }
    }
    direction_ = -system_;
    lu_.solve(direction_.head(3 * n));
    if (!direction_.allFinite()) return false;
    const auto at = [&](double t) {
      next_ = step_ + t * direction_;
      return evaluate(rows, next_, coupled);
    };
    double next_norm = at(1.0);
    if (states_ == factorised_states_) {  // the linear system was the right one
      step_.swap(next_);
      return true;
    }
    if (coupled) {
      double t = 1.0;
      for (int i = 0; i < kMostHalvings && !(next_norm < (1.0 - 0.1 * t) * norm); ++i) {
        t *= 0.5;
        next_norm = at(t);
      }
      if (!(next_norm < norm)) return false;
    } else if (direction_.dot(system_) > 0.0) {
      // The residual is the gradient of a convex function: seek its least value along the direction.
      double low = 0.0;
      double high = 1.0;
      for (int i = 0; i < kMostBisections; ++i) {
        const double t = 0.5 * (low + high);
        next_norm = at(t);
        (direction_.dot(system_) > 0.0 ? high : low) = t;
        if (next_norm < 0.5 * norm) break;
      }
    }
    step_.swap(next_);
    norm = next_norm;
  }
  return true;
}

NewtonResult NewtonFinish::run(std::span<ContactRow> rows, std::span<SolverBody> bodies,
                               const NewtonOptions& options) {
  number_bodies(rows, bodies);
  const auto keep = [&] {
    for (std::size_t c = 0; c < rows.size(); ++c)
      best_[c] = {rows[c].normal, rows[c].tangential, rows[c].moment};
  };
  const auto put = [&](const std::vector<Impulses>& impulses) {
    for (std::size_t c = 0; c < rows.size(); ++c) {
      rows[c].normal = impulses[c].normal;
      rows[c].tangential = impulses[c].tangential;
      rows[c].moment = impulses[c].moment;
    }
    apply_all(rows, bodies);
  };

  NewtonResult result;
  result.residual = residual(rows, bodies);
  keep();
  stiffness_ = kFirstStiffness;
  factorised_stiffness_ = 0.0;
  bool coupled = true;
  double last = result.residual;
  int left = options.max_iterations;
  int since_best = 0;
  while (left > 0 && since_best < kPatience && !(result.residual <= options.tolerance)) {
    centre(rows, bodies);
    const bool found = search_states(rows, coupled, left);
    put(trial_);
    const double now = residual(rows, bodies);
    if (now < result.residual) {
      result.residual = now;
      since_best = 0;
      keep();
    } else {
      ++since_best;
    }
    if (!found) {
      put(best_);
      if (!coupled) stiffness_ = std::max(kLeastStiffness, stiffness_ * 1e-2);
      coupled = !coupled;
    } else {
      if (now > kSlowProgress * last) stiffness_ = std::min(kMostStiffness, 1e2 * stiffness_);
      coupled = true;
    }
    last = now;
  }
  put(best_);
  result.iterations = options.max_iterations - std::max(left, 0);
  result.settled = result.residual <= options.tolerance;
  if (!result.settled) {
    result.settled = result.residual <= rounding_level(rows, bodies);
    apply_all(rows, bodies);
  }
  return result;
}

}  // namespace carom
