#include <algorithm>
#include <cmath>

#include "physics/dynamics/flight_rates.h"
#include "physics/dynamics/trajectories.h"

// Curvature and turn bounds of trajectories, for the search for contacts.
namespace carom {
namespace {

// True if joints bend the path by more than kMostTurns radians within the trajectory: the step does not resolve
// the motion, and a search on it would not end. The stages k[0] and k[1] must hold the rates at both ends.
bool outruns_joints(Flights& f, const Flights::Island& island) {
  constexpr double kMostTurns = 64.0;
  const Flights::Group& group = f.groups[island.group];
  double speed = 0.0;
  double change = 0.0;
  double size = 0.0;  // m, the largest
  for (int j = 0; j < island.count; ++j) {
    const BodyIndex i = f.members[island.first + j];
    size = std::max(size, f.model->shapes.size[i]);
    speed = std::max({speed, f.at_start.col(i).segment<2>(3).norm(), f.at_end.col(i).segment<2>(3).norm()});
    change = std::max(
        {change, group.stages.k[0].col(j).segment<2>(3).norm(), group.stages.k[1].col(j).segment<2>(3).norm()});
  }
  const double duration = island.end - island.start;
  if (change * duration <= kMostTurns * speed) return false;
  // So little that forces of contacts may bring all to rest at both ends.
  if (change * duration * duration <= size) return false;
  // What contact forces hold so still goes round nothing.
  constexpr double kStill = 1e-12;
  if (speed * duration <= kStill * size) return false;
  // Where joints hold bodies at rest, the accelerations are rounding.
  constexpr double kBalanced = 1e-9;
  double outside = 0.0;
  Motions& rates = f.groups[island.group].stages.k[2];
  for (int j = 0; j < island.count; ++j) {
    const BodyIndex i = f.members[island.first + j];
    f.field.external_rate(i, f.epoch + island.start, f.at_start.col(i), rates.col(j));
  }
  f.gather(island);
  f.field.add_couplings(f.members_of(island), f.groups[island.group].from, rates);
  for (int j = 0; j < island.count; ++j) outside = std::max(outside, rates.col(j).segment<2>(3).norm());
  return !(change <= kBalanced * outside);
}

}  // namespace

void Trajectories::bound_curvature(IslandIndex k) {
  Flights& f = flights_;
  const Flights::Island& island = f.islands[k];
  if (island.kinematic) {
    const Drive& d = f.model->drive(f.body_of(island));
    curvature_bound_[f.body_of(island)] = d.angular_frequency * d.angular_frequency * d.amplitude.norm();
    return;
  }
  // Between the ends the spin exceeds both by at most half of its largest change within the trajectory.
  const auto bound_turn = [&](BodyIndex body, double angular_acceleration) {
    const double spin = std::max(std::abs(f.at_start.col(body)[5]), std::abs(f.at_end.col(body)[5])) +
                        0.5 * angular_acceleration * (island.end - island.start);
    turn_bound_[body] = spin * spin + angular_acceleration;
  };
  if (f.parabolic) {
    const BodyIndex body = f.body_of(island);
    const Eigen::Vector3d first = f.parabola_acceleration(body, island.start);
    const Eigen::Vector3d last = f.parabola_acceleration(body, island.end);
    curvature_bound_[body] = std::max(first.head<2>().norm(), last.head<2>().norm());
    bound_turn(body, std::max(std::abs(first[2]), std::abs(last[2])));
    return;
  }
  f.evaluations += 2 * static_cast<std::int64_t>(island.count);
  // Twice the largest of the accelerations at both ends: sub-steps of semi-implicit Euler have a curvature of
  // 2a, and within a step that resolves the motion the acceleration varies by less than that.
  if (!island.coupled()) {
    const BodyIndex body = f.body_of(island);
    const BodyRates rates{f.field, body, f.epoch};
    Motion y = f.at_start.col(body);
    Motion rate;
    rates(island.start, y, rate);
    curvature_bound_[body] = 2.0 * rate.segment<2>(3).norm();
    double angular = 2.0 * std::abs(rate[5]);
    y = f.at_end.col(body);
    rates(island.end, y, rate);
    curvature_bound_[body] = std::max(curvature_bound_[body], 2.0 * rate.segment<2>(3).norm());
    angular = std::max(angular, 2.0 * std::abs(rate[5]));
    bound_turn(body, angular);
    return;
  }
  const GroupRates rates{f.field, f.joints, island.group, f.members_of(island), f.epoch};
  Flights::Group& group = f.groups[island.group];
  // Also at the step's stages: bodies that attract may pass each other between its ends.
  f.fly_group(island, island.end);
  for (const BodyIndex i : f.members_of(island)) curvature_bound_[i] = turn_bound_[i] = 0.0;
  for (int stage = 1; stage < f.evaluations_a_flight; ++stage) {
    for (int j = 0; j < island.count; ++j) {
      const auto rate = group.stages.k[stage].col(j).segment<3>(3);
      const BodyIndex body = f.members[island.first + j];
      curvature_bound_[body] = std::max(curvature_bound_[body], 2.0 * rate.head<2>().norm());
      turn_bound_[body] = std::max(turn_bound_[body], 2.0 * std::abs(rate[2]));
    }
  }
  f.gather(island);
  rates(island.start, group.from, group.stages.k[0]);
  for (int j = 0; j < island.count; ++j) group.from.col(j) = f.at_end.col(f.members[island.first + j]);
  rates(island.end, group.from, group.stages.k[1]);
  if (f.joints.has_joints(island.group) && outruns_joints(f, island)) {
    group.end_missed = true;
    for (const BodyIndex i : f.members_of(island)) curvature_bound_[i] = turn_bound_[i] = 0.0;
    return;
  }
  for (int j = 0; j < island.count; ++j) {
    const auto from = group.stages.k[0].col(j).segment<3>(3);
    const auto to = group.stages.k[1].col(j).segment<3>(3);
    const BodyIndex body = f.members[island.first + j];
    curvature_bound_[body] =
        std::max({curvature_bound_[body], 2.0 * from.head<2>().norm(), 2.0 * to.head<2>().norm()});
    bound_turn(body, std::max({turn_bound_[body], 2.0 * std::abs(from[2]), 2.0 * std::abs(to[2])}));
  }
}

}  // namespace carom
