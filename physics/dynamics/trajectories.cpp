#include "physics/dynamics/trajectories.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "physics/dynamics/flight_rates.h"
#include "physics/math/roots.h"
#include "physics/scene/method.h"

namespace carom {
namespace {

// Below this the adaptive integrator's step is rounding, and the tolerance counts as out of reach.
double shortest_step(double time) {
  return 1e-15 + 16.0 * std::numeric_limits<double>::epsilon() * std::abs(time);
}
// A kinematic body's trajectory is at most this fraction of a radian of its swing long, so that its bend stays
// small.
constexpr double kSwing = 0.5;
// A trajectory in which nothing moves ends some time.
constexpr double kLongestTrajectory = 1e6;  // s

// The time after which a body of this speed and acceleration has moved by `reach` at the most.
double time_to_move(double reach, double speed, double acceleration) {
  return std::min(kLongestTrajectory,
                  2.0 * reach / (speed + std::sqrt(speed * speed + 2.0 * acceleration * reach)));
}

}  // namespace

Trajectories::Trajectories(std::shared_ptr<const Model> model, const Method& method)
    : model_(std::move(model)),
      field_(model_),
      joints_(model_),
      general_(model_->needs.untrimmed),
      released_at_(model_->scene.joints.size(), -1.0) {
  const std::vector<Body>& bodies = model_->bodies();
  const Needs& needs = model_->needs;
  const int n = static_cast<int>(bodies.size());
  island_of_.assign(n, -1);
  at_start_.resize(Eigen::NoChange, n);
  constant_ = Eigen::Matrix3Xd::Zero(3, n);
  curvature_bound_ = Eigen::VectorXd::Zero(n);
  turn_bound_ = Eigen::VectorXd::Zero(n);
  std::vector<std::vector<int>> groups;
  if (needs.has(Part::kSprings) || needs.has(Part::kAttraction) || needs.has(Part::kJoints))
    groups = field_.coupled_groups(model_->joint_terms.joined());
  if (general_) {
    groups.assign(1, {});
    for (int i = 0; i < n; ++i) {
      if (!has_infinite_mass(bodies[i])) groups[0].push_back(i);
    }
    if (groups[0].empty()) groups.clear();
  }
  const auto add_island = [&](const std::vector<int>& members) -> Island& {
    for (const int i : members) island_of_[i] = static_cast<int>(islands_.size());
    Island& island = islands_.emplace_back();
    island.first = static_cast<int>(members_.size());
    island.count = static_cast<int>(members.size());
    members_.insert(members_.end(), members.begin(), members.end());
    return island;
  };
  for (const std::vector<int>& members : groups) {
    add_island(members).group = static_cast<int>(groups_.size());
    Group& group = groups_.emplace_back();
    group.from.resize(Eigen::NoChange, static_cast<Eigen::Index>(members.size()));
    group.now = group.from;
    group.change.resize(Eigen::NoChange, static_cast<Eigen::Index>(members.size()));
    group.stages.resize(static_cast<int>(members.size()));
  }
  joints_.set_groups(groups);
  for (int i = 0; i < n; ++i) {
    at_start_.col(i) = initial_motion(bodies[i], model_->start_time);
    constant_.col(i) = field_.constant_acceleration(i);
    if (!bodies[i].fixed && island_of_[i] < 0) add_island({i}).kinematic = bodies[i].drive.has_value();
  }
  at_end_ = at_start_;
  set_method(method);
}

void Trajectories::set_method(const Method& method) {
  const IntegratorChoice& choice = choice_of(kIntegrators, method.integrator);
  integrator_ = method.integrator;
  adaptive_ = choice.adaptive;
  evaluations_a_flight_ = choice.evaluations - (choice.adaptive ? 1 : 0);
  // Without any acceleration every integrator goes straight.
  const bool straight = constant_.isZero(0.0) && method.contacts == ContactsId::kImpulse;
  parabolic_ = !general_ && field_.is_constant() && (choice.exact_under_gravity || straight);
  tolerance_ = method.tolerance;
  for (Island& island : islands_) island.next_step = 0.0;
}

void Trajectories::begin(double epoch) {
  epoch_ = epoch;
  for (Island& island : islands_) {
    island.start = island.end = 0.0;
    forget(island);
    for (const int i : members_of(island)) field_.set_phase(i, epoch);
  }
}

void Trajectories::begin_step() {
  flight_work_ = 0;
  step_start_.springs = field_.switches();
  step_start_.taut = joints_.strings_taut();
  step_start_.lost_to_joints = lost_to_joints_;
}

void Trajectories::undo_step() {
  field_.set_switches(step_start_.springs);
  joints_.set_strings_taut(step_start_.taut);
  lost_to_joints_ = step_start_.lost_to_joints;
}

void Trajectories::lose(const Island& island, LossReason reason) const {
  const auto members = members_of(island);
  const auto lost = std::find_if(members.begin(), members.end(),
                                 [this](int i) { return !has_finite_squares(at_end_.col(i)); });
  throw LostMotion{reason, lost == members.end() ? members.front() : *lost, epoch_ + island.start};
}

// The trajectory that has been laid.
void Trajectories::check_flight(const Island& island) const {
  for (const int i : members_of(island)) {
    if (!has_finite_squares(at_end_.col(i))) lose(island, LossReason::kTooLarge);
  }
  if (!adaptive_) return;
  if (flight_work_ > kMostFlightWork + kMostFlightWorkPerBody * static_cast<std::int64_t>(bodies().size()))
    lose(island, LossReason::kTooManySteps);
}

void Trajectories::take_over(Trajectories& other, double time) {
  for (int i = 0; i < static_cast<int>(other.bodies().size()); ++i) at_start_.col(i) = other.at(i, time);
  field_.take_over(other.field_);
  joints_.take_over(other.joints_);
  if (other.field_.in_contact()) {
    for (int i = 0; i < static_cast<int>(other.bodies().size()); ++i)
      set_contact_acceleration(i, other.field_.contact_acceleration(i));
  }
  lost_to_joints_ = other.lost_to_joints_;
  joints_missed_since_ = other.joints_missed_since_;
  switches_missed_since_ = other.switches_missed_since_;
  evaluations_ = other.evaluations_;
  flight_work_ = other.flight_work_;
  step_start_ = other.step_start_;
  rejected_steps_ = other.rejected_steps_;
  tolerance_missed_since_ = other.tolerance_missed_since_;
  begin(other.epoch_);
  for (Island& island : islands_) {
    island.start = island.end = time;
    for (const int i : members_of(island)) field_.set_phase(i, epoch_ + time);
    if (island.kinematic) at_start_.col(body_of(island)) = at(body_of(island), time);
  }
}

void Trajectories::shift_epoch(double by) {
  epoch_ += by;
  for (Island& island : islands_) {
    island.start -= by;
    island.end -= by;
    forget(island);
  }
}

Eigen::Index Trajectories::column_of(const Island& island, int body) const {
  const auto members = members_of(island);
  return std::lower_bound(members.begin(), members.end(), body) - members.begin();
}

void Trajectories::gather(const Island& island) {
  Motions& from = groups_[island.group].from;
  for (int j = 0; j < island.count; ++j) from.col(j) = at_start_.col(members_[island.first + j]);
}

// --- along a trajectory
// ------------------------------------------------------------------------------------------------

void Trajectories::fly_one(const Island& island, double time, Motion& out) {
  const int body = body_of(island);
  if (island.kinematic) {
    const Body& b = bodies()[body];
    out = at_start_.col(body);
    out.head<2>() = drive_position(*b.drive, b.position, epoch_ + time);
    out.segment<2>(3) = drive_velocity(*b.drive, epoch_ + time);
    return;
  }
  evaluations_ += evaluations_a_flight_;
  flight_work_ += evaluations_a_flight_;
  if (parabolic_ && !field_.has_quadratures()) {
    // Every such method's flight, whatever way it goes.
    out << parabola(body, time), parabola_velocity(body, time), at_start_.col(body).tail<kQuadratures>();
    return;
  }
  const OneBody f{field_, body, epoch_};
  const double h = time - island.start;
  if (field_.has_quadratures()) {
    const Motion from = at_start_.col(body);
    Stages<Motion> stages;
    integrator_step(integrator_, f, island.start, from, h, stages, out);
  } else {
    // Under gravity alone the quadratures stay what they are.
    using Flight = Eigen::Matrix<double, kRows - kQuadratures, 1>;
    const Flight from = at_start_.col(body).head<kRows - kQuadratures>();
    Stages<Flight> stages;
    Flight to;
    integrator_step(integrator_, f, island.start, from, h, stages, to);
    out << to, at_start_.col(body).tail<kQuadratures>();
  }
}

const Motions& Trajectories::fly_group(const Island& island, double time) {
  Group& group = groups_[island.group];
  if (group.cached != time) {
    group.cached = time;
    gather(island);
    integrator_step(integrator_, Together{field_, joints_, island.group, members_of(island), epoch_},
                    island.start, group.from, time - island.start, group.stages, group.now);
    const std::int64_t evaluations = evaluations_a_flight_ * static_cast<std::int64_t>(island.count);
    evaluations_ += evaluations;
    flight_work_ += evaluations * (field_.attracts() ? 1 + island.count / 8 : 1) +
                    evaluations_a_flight_ * joints_.evaluation_work(island.group) - joints_.restoring_work();
    group.missed = !joints_.restore(island.group, epoch_ + time, group.now);
    flight_work_ += joints_.restoring_work();
  }
  return group.now;
}

Motion Trajectories::at(int body, double time) {
  const int k = island_of_[body];
  if (k < 0) return at_start_.col(body);
  const Island& island = islands_[k];
  if (!island.kinematic) {
    if (time == island.start) return at_start_.col(body);
    if (time == island.end) return at_end_.col(body);
  }
  if (island.group < 0) {
    Motion out;
    fly_one(island, time, out);
    return out;
  }
  return fly_group(island, time).col(column_of(island, body));
}

Eigen::Vector3d Trajectories::acceleration(int body) {
  const int k = island_of_[body];
  if (k < 0 || islands_[k].kinematic) return Eigen::Vector3d::Zero();
  if (parabolic_) return constant_.col(body);
  const Island& island = islands_[k];
  if (island.group < 0) {
    const Motion y = at_start_.col(body);
    Motion rate;
    OneBody{field_, body, epoch_}(island.start, y, rate);
    return rate.segment<3>(3);
  }
  Group& group = groups_[island.group];
  if (!group.rates_known) {
    group.start_rates = rates_of(island, island.start, group_at(island, island.start));
    group.rates_known = true;
  }
  return group.start_rates.col(column_of(island, body)).segment<3>(3);
}

const Motions& Trajectories::rates_of(const Island& island, double time, const Motions& y) {
  Motions& rates = groups_[island.group].stages.k[0];
  Together{field_, joints_, island.group, members_of(island), epoch_}(time, y, rates);
  flight_work_ += island.count + joints_.evaluation_work(island.group);
  return rates;
}

const Motions& Trajectories::group_at(const Island& island, double time) {
  if (time != island.start) return fly_group(island, time);
  gather(island);
  return groups_[island.group].from;
}

void Trajectories::advance_to(int k, double time) {
  Island& island = islands_[k];
  if (island.group < 0) {
    at_start_.col(body_of(island)) = at(body_of(island), time);
  } else if (time != island.start) {
    for (const int i : members_of(island)) at_end_.col(i) = at(i, time);
    for (const int i : members_of(island)) at_start_.col(i) = at_end_.col(i);
  }
  island.start = island.end = time;
  island.switching = -1;
  forget(island);
}

double Trajectories::advance_to_end(int k) {
  const Island& island = islands_[k];
  const int a_switch = island.switching;
  advance_to(k, island.end);
  if (field_.has_breaks()) {
    for (const int i : members_of(island)) field_.set_phase(i, epoch_ + island.start);
  }
  return a_switch < 0 ? 0.0 : flip(island, a_switch, island.start);
}

void Trajectories::set_velocity(int body, const Vec2& velocity, double spin) {
  at_start_.col(body).segment<3>(3) << velocity, spin;
  if (island_of_[body] >= 0) forget(islands_[island_of_[body]]);
}

void Trajectories::set_contact_acceleration(int body, const Eigen::Vector3d& by) {
  field_.set_contact_acceleration(body, by);
  constant_.col(body) = field_.constant_acceleration(body) + by;
  if (island_of_[body] >= 0) forget(islands_[island_of_[body]]);
}

void Trajectories::set_pose(int body, const Eigen::Vector3d& q) {
  at_start_.col(body).head<3>() = q;
  if (island_of_[body] >= 0) forget(islands_[island_of_[body]]);
}

// --- laying a trajectory
// -----------------------------------------------------------------------------------------------

void Trajectories::rebuild(int k, double horizon, double reach, double turn_bound) {
  Island& island = islands_[k];
  island.switching = -1;
  forget(island);
  island.end = horizon;
  // Where no step ends the trajectory, its path's length does.
  if (!(horizon < kForever)) {
    island.end = island.start +
                 (adaptive_ && is_lost(island) ? kLongestTrajectory : time_to_end(island, reach, turn_bound));
  }
  if (field_.has_breaks()) {
    for (const int i : members_of(island))
      island.end = std::min(island.end, field_.next_break(i, epoch_ + island.start) - epoch_);
  }
  if (adaptive_ && !island.kinematic) limit_to_adaptive_step(island);
  if (island.group < 0) {
    Motion out;
    fly_one(island, island.end, out);
    at_end_.col(body_of(island)) = out;
  } else {
    const Motions& now = fly_group(island, island.end);
    for (int j = 0; j < island.count; ++j) at_end_.col(members_[island.first + j]) = now.col(j);
    if (groups_[island.group].missed && joints_missed_since_ < 0.0)
      joints_missed_since_ = epoch_ + island.start;
  }
  check_flight(island);
  if (has_switches(island) && !island.kinematic && follows_switches(island)) find_switch(island);
}

double Trajectories::time_to_end(const Island& island, double reach, double turn_bound) const {
  double most = kLongestTrajectory;
  for (const int i : members_of(island)) {
    if (island.kinematic) {
      const Drive& d = *bodies()[i].drive;
      most = std::min(most,
                      time_to_move(reach, d.velocity.norm() + d.angular_frequency * d.amplitude.norm(), 0.0));
      if (d.angular_frequency > 0.0) most = std::min(most, kSwing / d.angular_frequency);
    } else {
      most = std::min(
          most, time_to_move(reach, at_start_.col(i).segment<2>(3).norm(), constant_.col(i).head<2>().norm()));
      if (!model_->shapes.is_disc(i)) most = std::min(most, turn_bound / std::abs(at_start_(5, i)));
    }
  }
  return most;
}

// The error estimate of the step that ends at `time`.
double Trajectories::error_of(const Island& island, double time) {
  const double h = time - island.start;
  evaluations_ += island.count;
  if (island.group < 0) {
    const Motion from = at_start_.col(body_of(island));
    const OneBody f{field_, body_of(island), epoch_};
    Stages<Motion> stages;
    Motion out;
    integrator_step(integrator_, f, island.start, from, h, stages, out);
    evaluations_ += evaluations_a_flight_;
    return dormand_prince_error(f, island.start, h, stages, out);
  }
  fly_group(island, time);
  Group& group = groups_[island.group];
  return dormand_prince_error(Together{field_, joints_, island.group, members_of(island), epoch_}, island.start,
                              h, group.stages, group.now);
}

// A cautious first try, from the time in which the velocities would change by themselves.
double Trajectories::first_step(const Island& island) {
  double time = kLongestTrajectory;
  for (const int i : members_of(island)) {
    const double speed = at_start_.col(i).segment<3>(3).norm();
    const double change = acceleration(i).head<2>().norm();
    if (change > 0.0) time = std::min(time, speed > 0.0 ? speed / change : 1.0);
  }
  return std::pow(tolerance_, 0.2) * time;
}

// Rounding alone is far beyond the tolerance: the run has blown up, and goes on in whole trajectories, as they
// come.
bool Trajectories::is_lost(const Island& island) const {
  constexpr double kFarBeyond = 1e3;
  const double largest = kFarBeyond * tolerance_ / std::numeric_limits<double>::epsilon();
  const auto members = members_of(island);
  return std::any_of(members.begin(), members.end(), [&](int i) {
    const auto moved = at_start_.col(i).head<6>();
    return !moved.allFinite() || moved.cwiseAbs().maxCoeff() > largest;
  });
}

// Shortens the trajectory to one step whose error estimate keeps the tolerance.
void Trajectories::limit_to_adaptive_step(Island& island) {
  const double most = island.end - island.start;
  if (island.next_step == 0.0) island.next_step = first_step(island);
  double h = std::min(island.next_step, most);
  if (is_lost(island)) {
    if (tolerance_missed_since_ < 0.0) tolerance_missed_since_ = epoch_ + island.start;
    return;
  }
  while (true) {
    forget(island);
    const double error = error_of(island, island.start + h);
    const double next = next_adaptive_step(h, error, tolerance_);
    const bool shortest = !std::isfinite(error) || h < shortest_step(epoch_ + island.start);
    if (error <= tolerance_ || shortest) {
      if (!(error <= tolerance_) && tolerance_missed_since_ < 0.0)
        tolerance_missed_since_ = epoch_ + island.start;
      // A step that was cut short tells little about the next one.
      if (h < most || next < island.next_step) island.next_step = next;
      break;
    }
    ++rejected_steps_;
    h = next;
  }
  if (h < most) island.end = island.start + h;
}

}  // namespace carom
