#include <algorithm>
#include <cmath>

#include "physics/dynamics/flight_rates.h"
#include "physics/dynamics/trajectories.h"

// How much the paths of trajectories bend: the bounds that the search for contacts goes by.
namespace carom {

// True if joints bend the path by more than kMostTurns radians within the trajectory: no step that resolves the
// motion does, and no search on it would end. The rates of both ends must stand in the stages k[0] and k[1].
bool Trajectories::outruns_joints(const Island& island) {
  constexpr double kMostTurns = 64.0;
  const Group& group = groups_[island.group];
  double speed = 0.0;
  double change = 0.0;
  for (int j = 0; j < island.count; ++j) {
    const int i = members_[island.first + j];
    speed = std::max({speed, at_start_.col(i).segment<2>(3).norm(), at_end_.col(i).segment<2>(3).norm()});
    change = std::max(
        {change, group.stages.k[0].col(j).segment<2>(3).norm(), group.stages.k[1].col(j).segment<2>(3).norm()});
  }
  if (change * (island.end - island.start) <= kMostTurns * speed) return false;
  // Where joints hold bodies at rest, of the accelerations rounding is left.
  constexpr double kBalanced = 1e-9;
  double outside = 0.0;
  Motions& rates = groups_[island.group].stages.k[2];
  for (int j = 0; j < island.count; ++j) {
    const int i = members_[island.first + j];
    field_.external_rate(i, epoch_ + island.start, at_start_.col(i), rates.col(j));
  }
  gather(island);
  field_.add_couplings(members_of(island), groups_[island.group].from, rates);
  for (int j = 0; j < island.count; ++j) outside = std::max(outside, rates.col(j).segment<2>(3).norm());
  return !(change <= kBalanced * outside);
}

void Trajectories::bound_curvature(int k) {
  const Island& island = islands_[k];
  if (island.kinematic) {
    const Drive& d = *bodies()[body_of(island)].drive;
    curvature_bound_[body_of(island)] = d.angular_frequency * d.angular_frequency * d.amplitude.norm();
    return;
  }
  // Between its ends the spin goes beyond both by at most the half of what it may change within the trajectory.
  const auto bound_turn = [&](int body, double angular_acceleration) {
    const double spin = std::max(std::abs(at_start_(5, body)), std::abs(at_end_(5, body))) +
                        0.5 * angular_acceleration * (island.end - island.start);
    turn_bound_[body] = spin * spin + angular_acceleration;
  };
  if (parabolic_) {
    const int body = body_of(island);
    curvature_bound_[body] = constant_.col(body).head<2>().norm();
    bound_turn(body, std::abs(constant_(2, body)));
    return;
  }
  evaluations_ += 2 * static_cast<std::int64_t>(island.count);
  // Twice the largest of the accelerations at both ends: sub-steps of semi-implicit Euler bend by 2a, and
  // within a step that resolves the motion the acceleration varies by less than that.
  if (island.group < 0) {
    const int body = body_of(island);
    const OneBody f{field_, body, epoch_};
    Motion y = at_start_.col(body);
    Motion rate;
    f(island.start, y, rate);
    curvature_bound_[body] = 2.0 * rate.segment<2>(3).norm();
    double angular = 2.0 * std::abs(rate[5]);
    y = at_end_.col(body);
    f(island.end, y, rate);
    curvature_bound_[body] = std::max(curvature_bound_[body], 2.0 * rate.segment<2>(3).norm());
    angular = std::max(angular, 2.0 * std::abs(rate[5]));
    bound_turn(body, angular);
    return;
  }
  const Together f{field_, joints_, island.group, members_of(island), epoch_};
  Group& group = groups_[island.group];
  // Also where the step itself has looked: bodies that attract may pass each other between its ends.
  fly_group(island, island.end);
  for (const int i : members_of(island)) curvature_bound_[i] = turn_bound_[i] = 0.0;
  for (int stage = 1; stage < evaluations_a_flight_; ++stage) {
    for (int j = 0; j < island.count; ++j) {
      const auto rate = group.stages.k[stage].col(j).segment<3>(3);
      const int body = members_[island.first + j];
      curvature_bound_[body] = std::max(curvature_bound_[body], 2.0 * rate.head<2>().norm());
      turn_bound_[body] = std::max(turn_bound_[body], 2.0 * std::abs(rate[2]));
    }
  }
  gather(island);
  f(island.start, group.from, group.stages.k[0]);
  for (int j = 0; j < island.count; ++j) group.from.col(j) = at_end_.col(members_[island.first + j]);
  f(island.end, group.from, group.stages.k[1]);
  if (joints_.has_joints(island.group) && outruns_joints(island)) {
    if (joints_missed_since_ < 0.0) joints_missed_since_ = epoch_ + island.start;
    for (const int i : members_of(island)) curvature_bound_[i] = turn_bound_[i] = 0.0;
    return;
  }
  for (int j = 0; j < island.count; ++j) {
    const auto from = group.stages.k[0].col(j).segment<3>(3);
    const auto to = group.stages.k[1].col(j).segment<3>(3);
    const int body = members_[island.first + j];
    curvature_bound_[body] =
        std::max({curvature_bound_[body], 2.0 * from.head<2>().norm(), 2.0 * to.head<2>().norm()});
    bound_turn(body, std::max({turn_bound_[body], 2.0 * std::abs(from[2]), 2.0 * std::abs(to[2])}));
  }
}

}  // namespace carom
