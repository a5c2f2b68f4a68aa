#include "physics/dynamics/force_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "physics/math/vectors.h"

namespace carom {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The moments at which the law of an applied force changes: start, end of the rise, end.
std::array<double, 3> breaks_of(const AppliedTerm& f) {
  return {f.start, f.start + f.rise, f.end.value_or(kInfinity)};
}

}  // namespace

ForceField::ForceField(std::shared_ptr<const Model> model)
    : model_(std::move(model)),
      terms_(&model_->forces),
      add_external_(add_external_of(*terms_)),
      has_quadratures_(!terms_->gravity_only),
      constant_(terms_->constant) {
  phase_.assign(terms_->applied.size(), 0);
  const double time = model_->start_time;
  for (const SpringIndex spring : terms_->springs.indices()) {
    const SpringTerm& s = terms_->springs[spring];
    const Motion a = motion_at_start(model_->starts, s.body);
    const Motion b = s.other >= 0 ? motion_at_start(model_->starts, s.other) : spring_end(spring, time);
    // At a margin of zero a spring acts if its ends move into its range.
    double margin = switch_margin(spring, a, b);
    if (margin == 0.0) {
      const SpringLine line = line_of(s, a, b);
      const double closing = -line.along.dot(line.rate);
      margin = s.acts == SpringActs::kPull ? -closing : closing;
    }
    engaged_.push_back(s.acts == SpringActs::kBoth || margin > 0.0 ? 1 : 0);
  }
  for (const AppliedTerm& a : terms_->applied) set_phase(a.body, time);
  if (terms_->hand) hand_place_ = terms_->hand->place;
}

// --- forces

ForceField::Pull ForceField::pull(const SpringTerm& spring, const Vec2& d, const Vec2& u) const {
  if (spring.rest_length == 0.0 && spring.damping == 0.0) return {-spring.stiffness * d, 0.0};
  const double length = d.norm();
  if (!(length > 0.0)) return {Vec2::Zero(), 0.0};
  const Vec2 direction = d / length;
  const double rate = direction.dot(u);
  const double force = -spring.stiffness * (length - spring.rest_length) - spring.damping * rate;
  return {force * direction, spring.damping * rate * rate};
}

template <bool kOnEach, bool kSprings, bool kApplied>
void ForceField::add_external(BodyIndex body, double t, const Eigen::Vector3d& q, const Eigen::Vector3d& rate,
                              double* k) const {
  const Vec2 x = q.head<2>();
  const Vec2 v = rate.head<2>();
  const double spin = rate[2];
  Vec2 force = Vec2::Zero();
  double torque = 0.0;
  Eigen::Map<Eigen::Matrix<double, kQuadratures, 1>> quadratures(k + 6);
  if constexpr (kOnEach) {
    const double coefficient = terms_->linear_drag + terms_->quadratic_drag * v.norm();
    force -= coefficient * v;
    quadratures[kDragLoss] = coefficient * v.squaredNorm();
  }
  if constexpr (kSprings) {
    for (const SpringIndex i : terms_->outside[body]) {
      if (!engaged(i)) continue;
      const SpringTerm& term = terms_->springs[i];
      Vec2 end = term.anchor;
      Vec2 end_velocity = Vec2::Zero();
      if (term.drive >= 0) {
        end = drive_position(model_->drive(term.drive), term.anchor, t);
        end_velocity = drive_velocity(model_->drive(term.drive), t);
      }
      const Vec2 arm = arm_at(term.point, q[2]);
      const Pull p = pull(term, x + arm - end, v + spin * crossed(arm) - end_velocity);
      force += p.force;
      torque += cross(arm, p.force);
      quadratures[kDamperLoss] += p.loss;
      // Work of the drive: it becomes kinetic energy, spring energy and the damper's loss.
      quadratures[kWorkIn] += p.force.dot(end_velocity) - idle_power(body, cross(arm, p.force), spin);
    }
  }
  if constexpr (kApplied) {
    for (const AppliedForceIndex i : terms_->applied_to[body]) {
      const AppliedTerm& a = terms_->applied[i];
      if (phase_[i] == 0 || phase_[i] == 3) continue;
      const double share = phase_[i] == 1 ? (t - a.start) / a.rise : 1.0;
      const double turning = a.torque + cross(arm_at(a.point, q[2]), a.force);
      force += share * a.force;
      torque += share * turning;
      quadratures[kWorkIn] += share * (a.force.dot(v) + turning * spin - idle_power(body, turning, spin));
    }
    if (terms_->hand && terms_->hand->body == body) {
      const Vec2 arm = turned_by(q[2], terms_->hand->grip);
      const Vec2 grip_velocity = v + spin * crossed(arm);
      const Vec2 pull = pull_of_hand(x + arm, grip_velocity);
      force += pull;
      torque += cross(arm, pull);
      quadratures[kHandWork] = pull.dot(v) + cross(arm, pull) * spin - idle_power(body, cross(arm, pull), spin);
    }
  }
  k[3] += model_->mass.inverse_mass[body] * force.x();
  k[4] += model_->mass.inverse_mass[body] * force.y();
  k[5] += model_->mass.inverse_inertia[body] * torque;
  quadratures[kImpulseX] = force.x();
  quadratures[kImpulseY] = force.y();
  quadratures[kAngularImpulse] = cross(x, force) + (torque - untaken(body, torque));
}

ForceField::AddExternal ForceField::add_external_of(const ForceTerms& terms) {
  const auto with = [&]<bool kOnEach, bool kSprings>(std::bool_constant<kOnEach>,
                                                     std::bool_constant<kSprings>) {
    return !terms.applied_to.empty() ? &ForceField::add_external<kOnEach, kSprings, true>
                                     : &ForceField::add_external<kOnEach, kSprings, false>;
  };
  const std::true_type in;
  const std::false_type out;
  const bool springs = !terms.outside.empty();
  if (terms.on_each) return springs ? with(in, in) : with(in, out);
  return springs ? with(out, in) : with(out, out);
}

void ForceField::add_couplings(std::span<const BodyIndex> members, const Motions& y, Motions& k) const {
  const auto column_of = [&](BodyIndex body) {
    return std::lower_bound(members.begin(), members.end(), body) - members.begin();
  };
  const int n = static_cast<int>(members.size());
  for (int i = 0; i < n && !terms_->between.empty(); ++i) {
    for (const SpringIndex s : terms_->between[members[i]]) {
      const SpringTerm& term = terms_->springs[s];
      if (term.body != members[i] || !engaged(s)) continue;
      const auto j = column_of(term.other);
      const SpringLine line = line_of(term, y.col(i), y.col(j));
      const Pull p = pull(term, line.along, line.rate);
      const double torque = cross(line.arm, p.force);
      const double far_torque = -cross(line.far_arm, p.force);
      k.col(i).segment<2>(3) += model_->mass.inverse_mass[term.body] * p.force;
      k.col(j).segment<2>(3) -= model_->mass.inverse_mass[term.other] * p.force;
      k(5, i) += model_->mass.inverse_inertia[term.body] * torque;
      k(5, j) += model_->mass.inverse_inertia[term.other] * far_torque;
      k(6 + kDamperLoss, i) += p.loss;
      k(6 + kWorkIn, i) -= idle_power(term.body, torque, y(5, i)) + idle_power(term.other, far_torque, y(5, j));
      k(6 + kAngularImpulse, i) -= untaken(term.body, torque) + untaken(term.other, far_torque);
    }
  }
  if (!terms_->attraction) return;
  const double softening = terms_->attraction->softening * terms_->attraction->softening;
  for (int i = 0; i < n; ++i) {
    for (int j = i + 1; j < n; ++j) {
      const Vec2 d = y.col(j).head<2>() - y.col(i).head<2>();
      const double square = d.squaredNorm() + softening;
      if (!(square > 0.0)) continue;
      const Vec2 pull = (terms_->attraction->constant / (square * std::sqrt(square))) * d;
      k.col(i).segment<2>(3) += model_->mass.mass[members[j]] * pull;
      k.col(j).segment<2>(3) -= model_->mass.mass[members[i]] * pull;
    }
  }
}

Eigen::Vector3d ForceField::constant_acceleration(BodyIndex body) const {
  Eigen::Vector3d a = Eigen::Vector3d::Zero();
  if (!(model_->mass.inverse_mass[body] > 0.0)) return a;
  a.head<2>() = terms_->gravity;
  if (terms_->applied.empty()) return a;
  for (const AppliedForceIndex i : terms_->applied_to[body]) {
    a.head<2>() += model_->mass.inverse_mass[body] * terms_->applied[i].force;
    a[2] += model_->mass.inverse_inertia[body] * terms_->applied[i].torque;
  }
  return a;
}

std::vector<std::vector<BodyIndex>> ForceField::coupled_groups(const std::vector<BodyPair>& pairs) const {
  const int n = static_cast<int>(model_->bodies());
  std::vector<BodyIndex> parent;
  for (BodyIndex i{0}; i < n; ++i) parent.push_back(i);
  const auto root = [&](BodyIndex i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  BodyIndex first_free = kNoBody;
  for (BodyIndex i{0}; i < n; ++i) {
    if (!terms_->between.empty()) {
      for (const SpringIndex s : terms_->between[i])
        parent[root(terms_->springs[s].other)] = root(terms_->springs[s].body);
    }
    if (terms_->attraction && model_->mass.inverse_mass[i] > 0.0) {
      if (first_free < 0) first_free = i;
      parent[root(i)] = root(first_free);
    }
  }
  std::vector<bool> paired(n);
  for (const auto& [a, b] : pairs) {
    parent[root(b)] = root(a);
    paired[a] = true;
  }
  std::vector<std::vector<BodyIndex>> groups(n);
  for (BodyIndex i{0}; i < n; ++i) groups[root(i)].push_back(i);
  std::erase_if(groups,
                [&](const std::vector<BodyIndex>& g) { return g.empty() || (g.size() < 2 && !paired[g[0]]); });
  return groups;
}

// --- energy

double ForceField::spring_energy(SpringIndex spring, double length) const {
  const double stretch = length - terms_->springs[spring].rest_length;
  return engaged(spring) ? 0.5 * terms_->springs[spring].stiffness * stretch * stretch : 0.0;
}

Vec2 ForceField::other_end(const SpringTerm& spring, const Eigen::Matrix3Xd& q) {
  const BodyIndex other = spring.other >= 0 ? spring.other : spring.drive;
  return other < 0 ? spring.anchor : place_of(q, other, spring.other_point);
}

double ForceField::coupling_energy(SpringIndex spring, const Eigen::Matrix3Xd& q) const {
  const SpringTerm& term = terms_->springs[spring];
  return spring_energy(spring, (place_of(q, term.body, term.point) - other_end(term, q)).norm());
}

double ForceField::attraction_energy(BodyIndex a, BodyIndex b, const Vec2& d) const {
  const double distance =
      std::sqrt(d.squaredNorm() + terms_->attraction->softening * terms_->attraction->softening);
  return distance > 0.0 ? -terms_->attraction->constant * model_->mass.mass[a] * model_->mass.mass[b] / distance
                        : 0.0;
}

double ForceField::potential_energy(const Eigen::Matrix3Xd& q) const {
  const int n = static_cast<int>(q.cols());
  double energy = 0.0;
  for (BodyIndex i{0}; i < n; ++i) {
    if (model_->mass.inverse_mass[i] > 0.0)
      energy -= model_->mass.mass[i] * terms_->gravity.dot(q.col(i).head<2>());
  }
  for (const SpringIndex s : terms_->springs.indices()) energy += coupling_energy(s, q);
  if (!terms_->attraction) return energy;
  for (BodyIndex a{0}; a < n; ++a) {
    for (BodyIndex b{a + 1}; b < n; ++b) {
      if (model_->mass.inverse_mass[a] > 0.0 && model_->mass.inverse_mass[b] > 0.0)
        energy += attraction_energy(a, b, q.col(a).head<2>() - q.col(b).head<2>());
    }
  }
  return energy;
}

double ForceField::potential_energy_of(BodyIndex body, const Vec2& position, const Eigen::Matrix3Xd& q) const {
  if (!(model_->mass.inverse_mass[body] > 0.0)) return 0.0;
  double energy = -model_->mass.mass[body] * terms_->gravity.dot(position);
  for (const auto* lists : {&terms_->outside, &terms_->between}) {
    if (lists->empty()) break;
    for (const SpringIndex s : (*lists)[body]) {
      const SpringTerm& term = terms_->springs[s];
      const bool far = term.other == body;
      const Vec2 own = position + arm_at(far ? term.other_point : term.point, q.col(body)[2]);
      const Vec2 end = far ? place_of(q, term.body, term.point) : other_end(term, q);
      energy += spring_energy(s, (own - end).norm());
    }
  }
  if (!terms_->attraction) return energy;
  for (BodyIndex b{0}; b < static_cast<int>(q.cols()); ++b) {
    if (b != body && model_->mass.inverse_mass[b] > 0.0)
      energy += attraction_energy(body, b, position - q.col(b).head<2>());
  }
  return energy;
}

// --- moments at which a law changes

double ForceField::next_break(BodyIndex body, double t) const {
  double next = kInfinity;
  if (!has_breaks()) return next;
  const double now = t + 8.0 * std::numeric_limits<double>::epsilon() * std::abs(t);
  for (const AppliedForceIndex i : terms_->applied_to[body]) {
    for (const double moment : breaks_of(terms_->applied[i])) {
      if (moment > now) next = std::min(next, moment);
    }
  }
  return next;
}

void ForceField::set_phase(BodyIndex body, double t) {
  if (!has_breaks()) return;
  const double now = t + 8.0 * std::numeric_limits<double>::epsilon() * std::abs(t);
  for (const AppliedForceIndex i : terms_->applied_to[body]) {
    const auto moments = breaks_of(terms_->applied[i]);
    phase_[i] = static_cast<int>(
        std::count_if(moments.begin(), moments.end(), [now](double moment) { return now >= moment; }));
    // A force may end while it rises.
    if (now >= moments[2]) phase_[i] = 3;
  }
}

Motion ForceField::spring_end(SpringIndex spring, double t) const {
  const SpringTerm& term = terms_->springs[spring];
  Motion end = Motion::Zero();
  end.head<2>() = term.anchor;
  if (term.drive >= 0) {
    end.head<2>() = drive_position(model_->drive(term.drive), term.anchor, t);
    end.segment<2>(3) = drive_velocity(model_->drive(term.drive), t);
  }
  return end;
}

double ForceField::switch_margin(SpringIndex spring, const Motion& body, const Motion& other) const {
  const SpringTerm& term = terms_->springs[spring];
  const SpringLine line = line_of(term, body, other);
  const double length = line.along.norm();
  const double stretch = length - term.rest_length;
  const double rate = length > 0.0 ? line.along.dot(line.rate) / length : 0.0;
  const double tension = term.stiffness * stretch + term.damping * rate;  // N, pulls if positive
  switch (term.acts) {
    case SpringActs::kBoth:
      return 1.0;
    case SpringActs::kPush:
      return std::min(-stretch, -tension);
    case SpringActs::kPull:
      return std::min(stretch, tension);
    case SpringActs::kWhileShort:
      return -stretch;
  }
  return 1.0;
}

}  // namespace carom
