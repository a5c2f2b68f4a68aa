#include "physics/dynamics/trajectories.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {
namespace {

using Island = Flights::Island;

// Below this the adaptive integrator's step is rounding, and the tolerance cannot be kept.
double shortest_step(double time) {
  return 1e-15 + 16.0 * std::numeric_limits<double>::epsilon() * std::abs(time);
}
// A kinematic body's trajectory is at most this fraction of a radian of its swing long, which bounds its
// curvature.
constexpr double kSwing = 0.5;
// Length of a trajectory on which nothing moves.
constexpr double kLongestTrajectory = 1e6;  // s

// The longest time in which a body of this speed and acceleration moves by `reach` at most.
double time_to_move(double reach, double speed, double acceleration) {
  return std::min(kLongestTrajectory,
                  2.0 * reach / (speed + std::sqrt(speed * speed + 2.0 * acceleration * reach)));
}

double time_to_end(const Flights& f, const Island& island, double reach, double turn) {
  double most = kLongestTrajectory;
  for (const BodyIndex i : f.members_of(island)) {
    if (island.kinematic) {
      const Drive& d = f.model->drive(i);
      most = std::min(most,
                      time_to_move(reach, d.velocity.norm() + d.angular_frequency * d.amplitude.norm(), 0.0));
      if (d.angular_frequency > 0.0) most = std::min(most, kSwing / d.angular_frequency);
    } else {
      most = std::min(most, time_to_move(reach, f.at_start.col(i).segment<2>(3).norm(),
                                         f.constant.col(i).head<2>().norm()));
      if (!f.model->shapes.is_disc(i)) most = std::min(most, turn / std::abs(f.at_start.col(i)[5]));
    }
  }
  return most;
}

// A cautious first step, from the time in which velocities change by their own size.
double first_step(Flights& f, const Island& island) {
  double time = kLongestTrajectory;
  for (const BodyIndex i : f.members_of(island)) {
    const double speed = f.at_start.col(i).segment<3>(3).norm();
    const double change = f.acceleration(i).head<2>().norm();
    if (change > 0.0) time = std::min(time, speed > 0.0 ? speed / change : 1.0);
  }
  return std::pow(f.tolerance, 0.2) * time;
}

// True if rounding alone far exceeds the tolerance: the run has blown up. It continues without step control.
bool is_blown_up(const Flights& f, const Island& island) {
  constexpr double kFarBeyond = 1e3;
  const double largest = kFarBeyond * f.tolerance / std::numeric_limits<double>::epsilon();
  const auto members = f.members_of(island);
  return std::any_of(members.begin(), members.end(), [&](BodyIndex i) {
    const auto moved = f.at_start.col(i).head<6>();
    return !moved.allFinite() || moved.cwiseAbs().maxCoeff() > largest;
  });
}

}  // namespace

Trajectories::Trajectories(const std::shared_ptr<const Model>& model, const Method& method)
    : flights_(model, method),
      switches_(*model),
      curvature_bound_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(model->bodies()))),
      turn_bound_(curvature_bound_) {}

void Trajectories::begin(double epoch) {
  Flights& f = flights_;
  f.epoch = epoch;
  for (Island& island : f.islands) {
    island.start = island.end = 0.0;
    f.forget(island);
    for (const BodyIndex i : f.members_of(island)) f.field.set_phase(i, epoch);
  }
}

void Trajectories::look_at(double time, State& into) {
  const ArrayOf<GroupIndex, Flights::Group> groups = flights_.groups;
  const std::int64_t evaluations = flights_.evaluations;
  const std::int64_t work = flights_.flight_work;
  for (BodyIndex i{0}; i < into.size(); ++i) into.set_motion(i, flights_.at(i, std::max(time, start(i))));
  flights_.groups = groups;
  flights_.evaluations = evaluations;
  flights_.flight_work = work;
}

void Trajectories::begin_step() {
  flights_.flight_work = 0;
  step_start_.springs = flights_.field.switches();
  step_start_.taut = flights_.joints.strings_taut();
  step_start_.lost_to_joints = switches_.lost_to_joints();
}

void Trajectories::undo_step() {
  flights_.field.set_switches(step_start_.springs);
  flights_.joints.set_strings_taut(step_start_.taut);
  switches_.set_lost_to_joints(step_start_.lost_to_joints);
}

void Trajectories::lose(const Island& island, LossReason reason) const {
  const auto members = flights_.members_of(island);
  const auto lost = std::find_if(members.begin(), members.end(),
                                 [this](int i) { return !has_finite_squares(flights_.at_end.col(i)); });
  throw LostMotion{reason, lost == members.end() ? members.front() : *lost, flights_.epoch + island.start};
}

void Trajectories::check_flight(const Island& island) const {
  const Flights& f = flights_;
  for (const BodyIndex i : f.members_of(island)) {
    if (!has_finite_squares(f.at_end.col(i))) lose(island, LossReason::kTooLarge);
  }
  if (!f.adaptive) return;
  if (f.flight_work > kMostFlightWork + kMostFlightWorkPerBody * f.bodies())
    lose(island, LossReason::kTooManySteps);
}

void Trajectories::shift_epoch(double by) {
  flights_.epoch += by;
  for (Island& island : flights_.islands) {
    island.start -= by;
    island.end -= by;
    flights_.forget(island);
  }
}

void Trajectories::advance_to(IslandIndex k, double time) {
  Flights& f = flights_;
  Island& island = f.islands[k];
  if (!island.coupled()) {
    f.at_start.col(f.body_of(island)) = f.at(f.body_of(island), time);
  } else if (time != island.start) {
    const Flights::Group& group = f.groups[island.group];
    const bool whole = time == island.end;
    for (const BodyIndex i : f.members_of(island)) f.at_end.col(i) = f.at(i, time);
    const bool missed = whole ? group.end_missed : group.missed;
    for (const BodyIndex i : f.members_of(island)) f.at_start.col(i) = f.at_end.col(i);
    if (missed && joints_missed_since_ < 0.0) joints_missed_since_ = f.epoch + island.start;
  }
  island.start = island.end = time;
  island.switching.reset();
  f.forget(island);
  // A law may change at this very time.
  if (f.field.has_breaks()) {
    for (const BodyIndex i : f.members_of(island)) f.field.set_phase(i, f.epoch + time);
  }
}

double Trajectories::advance_to_end(IslandIndex k) {
  Flights& f = flights_;
  const Island& island = f.islands[k];
  const std::optional<Switch> ending = island.switching;
  advance_to(k, island.end);
  return ending ? switches_.flip(f, island, *ending, island.start) : 0.0;
}

void Trajectories::set_velocity(BodyIndex body, const Vec2& velocity, double spin) {
  Flights& f = flights_;
  f.at_start.col(body).segment<3>(3) << velocity, spin;
  if (f.island_of[body] != kNoIsland) f.forget(f.islands[f.island_of[body]]);
}

void Trajectories::set_contact_acceleration(BodyIndex body, const Eigen::Vector3d& by) {
  Flights& f = flights_;
  f.field.set_contact_acceleration(body, by);
  f.constant.col(body) = f.field.constant_acceleration(body) + by;
  if (f.island_of[body] != kNoIsland) f.forget(f.islands[f.island_of[body]]);
}

void Trajectories::set_contact_rate(BodyIndex body, const Eigen::Vector3d& rate) {
  Flights& f = flights_;
  f.bent_from = 0.0;
  f.field.set_contact_rate(body, rate, f.epoch);
  if (f.island_of[body] != kNoIsland) f.forget(f.islands[f.island_of[body]]);
}

void Trajectories::set_pose(BodyIndex body, const Eigen::Vector3d& q) {
  Flights& f = flights_;
  f.at_start.col(body).head<3>() = q;
  if (f.island_of[body] != kNoIsland) f.forget(f.islands[f.island_of[body]]);
}

void Trajectories::rebuild(IslandIndex k, double horizon, double reach, double turn) {
  Flights& f = flights_;
  Island& island = f.islands[k];
  island.switching.reset();
  f.forget(island);
  island.end = horizon;
  // Where no step ends the trajectory, the length of its path does.
  if (!(horizon < Flights::kForever)) {
    const bool blown_up = f.adaptive && is_blown_up(f, island);
    const double most = std::min(time_to_end(f, island, reach, turn), switches_.time_to_follow(f, island));
    island.end = island.start + (blown_up ? kLongestTrajectory : most);
  }
  if (f.field.has_breaks()) {
    for (const BodyIndex i : f.members_of(island))
      island.end = std::min(island.end, f.field.next_break(i, f.epoch + island.start) - f.epoch);
  }
  if (f.adaptive && !island.kinematic) limit_to_adaptive_step(island);
  if (!island.coupled()) {
    Motion out;
    f.fly_one(island, island.end, out);
    f.at_end.col(f.body_of(island)) = out;
  } else {
    const Motions& now = f.fly_group(island, island.end);
    for (int j = 0; j < island.count; ++j) f.at_end.col(f.members[island.first + j]) = now.col(j);
    f.groups[island.group].end_missed = f.groups[island.group].missed;
  }
  check_flight(island);
  if (!island.kinematic) switches_.end_at_first(f, island);
}

// Shortens the trajectory to one step whose error estimate keeps the tolerance.
void Trajectories::limit_to_adaptive_step(Island& island) {
  Flights& f = flights_;
  const double most = island.end - island.start;
  if (island.next_step == 0.0) island.next_step = first_step(f, island);
  double h = std::min(island.next_step, most);
  if (is_blown_up(f, island)) {
    if (tolerance_missed_since_ < 0.0) tolerance_missed_since_ = f.epoch + island.start;
    return;
  }
  while (true) {
    f.forget(island);
    const double error = f.error_of(island, island.start + h);
    const double next = next_adaptive_step(h, error, f.tolerance);
    const bool shortest = !std::isfinite(error) || h < shortest_step(f.epoch + island.start);
    if (error <= f.tolerance || shortest) {
      if (!(error <= f.tolerance) && tolerance_missed_since_ < 0.0)
        tolerance_missed_since_ = f.epoch + island.start;
      // A step that was cut short says little about the next one.
      if (h < most || next < island.next_step) island.next_step = next;
      break;
    }
    ++rejected_steps_;
    h = next;
  }
  if (h < most) island.end = island.start + h;
}

}  // namespace carom
