#include "physics/dynamics/flights.h"

#include <algorithm>

#include "physics/dynamics/flight_rates.h"

namespace carom {

Flights::Flights(std::shared_ptr<const Model> compiled, const Method& method)
    : model(std::move(compiled)), field(model), joints(model), general(model->untrimmed) {
  const int n = bodies();
  at_start.resize(Eigen::NoChange, n);
  constant = Eigen::Matrix3Xd::Zero(3, n);
  for (BodyIndex i{0}; i < n; ++i) {
    at_start.col(i) = motion_at_start(model->starts, i);
    constant.col(i) = field.constant_acceleration(i);
  }
  at_end = at_start;
  make_islands();
  set_method(method);
}

void Flights::make_islands() {
  const int n = bodies();
  islands.clear();
  members.clear();
  groups.clear();
  island_of.assign(n, kNoIsland);
  std::vector<std::vector<BodyIndex>> coupled = field.coupled_groups(joints.joined());
  if (general) {
    coupled.assign(1, {});
    for (BodyIndex i{0}; i < n; ++i) {
      if (!model->infinite_mass(i)) coupled[0].push_back(i);
    }
    if (coupled[0].empty()) coupled.clear();
  }
  const auto add_island = [&](const std::vector<BodyIndex>& of) -> Island& {
    for (const BodyIndex i : of) island_of[i] = islands.end_index();
    Island& island = islands.emplace_back();
    island.first = static_cast<int>(members.size());
    island.count = static_cast<int>(of.size());
    members.insert(members.end(), of.begin(), of.end());
    return island;
  };
  for (const std::vector<BodyIndex>& of : coupled) {
    add_island(of).group = groups.end_index();
    Group& group = groups.emplace_back();
    group.from.resize(Eigen::NoChange, static_cast<Eigen::Index>(of.size()));
    group.now = group.from;
    group.change.resize(Eigen::NoChange, static_cast<Eigen::Index>(of.size()));
    group.stages.resize(static_cast<int>(of.size()));
  }
  joints.set_groups(coupled);
  for (BodyIndex i{0}; i < n; ++i) {
    const bool kinematic = model->is_kinematic(i);
    if (island_of[i] == kNoIsland && (kinematic || !model->infinite_mass(i)))
      add_island({i}).kinematic = kinematic;
  }
}

void Flights::add_weld(const Weld& weld) {
  joints.add_weld(weld);
  field.add_joints();
  parabolic = false;
  make_islands();
}

void Flights::set_method(const Method& method) {
  const IntegratorChoice& choice = choice_of(kIntegrators, method.integrator);
  integrator = method.integrator;
  adaptive = choice.adaptive;
  evaluations_a_flight = choice.evaluations - (choice.adaptive ? 1 : 0);
  // Without any acceleration every integrator goes straight.
  const bool straight = constant.isZero(0.0) && method.contacts == ContactsId::kImpulse;
  parabolic = !general && field.is_constant() && (choice.exact_under_gravity || straight);
  tolerance = method.tolerance;
  for (Island& island : islands) island.next_step = 0.0;
}

Eigen::Index Flights::column_of(const Island& island, BodyIndex body) const {
  const auto of = members_of(island);
  return std::lower_bound(of.begin(), of.end(), body) - of.begin();
}

void Flights::gather(const Island& island) {
  Motions& from = groups[island.group].from;
  for (int j = 0; j < island.count; ++j) from.col(j) = at_start.col(members[island.first + j]);
}

void Flights::spread(const Island& island) {
  const Motions& from = groups[island.group].from;
  for (int j = 0; j < island.count; ++j) at_start.col(members[island.first + j]) = from.col(j);
  forget(island);
}

template <int kGiven>
void Flights::fly_rows(const Island& island, double h, Motion& out) {
  using Flight = Eigen::Matrix<double, kGiven, 1>;
  const BodyIndex body = body_of(island);
  const Flight from = at_start.col(body).head<kGiven>();
  Stages<Flight> stages;
  Flight to = from;
  integrator_step(integrator, BodyRates{field, body, epoch}, island.start, from, h, stages, to);
  out.head<kGiven>() = to;
  out.tail<kRows - kGiven>() = at_start.col(body).tail<kRows - kGiven>();
}

void Flights::fly_one(const Island& island, double time, Motion& out) {
  const BodyIndex body = body_of(island);
  if (island.kinematic) {
    const DriveTerm& drive = model->drives.at(body);
    out = at_start.col(body);
    out.head<2>() = drive_position(drive.law, drive.home, epoch + time);
    out.segment<2>(3) = drive_velocity(drive.law, epoch + time);
    return;
  }
  count_flight();
  if (parabolic && !field.has_quadratures()) {
    // Every such method's flight, whatever way it goes.
    const double h = time - island.start;
    const auto y = at_start.col(body);
    out = y;
    out.head<3>() += h * (y.segment<3>(3) + 0.5 * h * constant.col(body));
    out.segment<3>(3) += h * constant.col(body);
    if (field.contact_changes()) {
      const double from = island.start - bent_from;
      out.head<3>() += h * h * (0.5 * from + h / 6.0) * field.contact_rate(body);
      out.segment<3>(3) += h * (from + 0.5 * h) * field.contact_rate(body);
    }
    if (!model->forces.gravity.isZero(0.0))
      out[6 + kGravityAngularImpulse] = angular_impulse_of_gravity(body, time);
    return;
  }
  const double h = time - island.start;
  if (field.has_quadratures()) {
    if (model->forces.gravity.isZero(0.0)) {
      fly_rows<kRowsWithoutGravity>(island, h, out);
    } else {
      fly_rows<kRows>(island, h, out);
    }
    return;
  }
  // Under gravity alone the only quadrature is that of gravity, here by explicit Euler: the other methods have
  // parabolas.
  fly_rows<kMotionRows>(island, h, out);
  out[6 + kGravityAngularImpulse] += h * field.torque_of_gravity(body, at_start.col(body).head<2>());
}

const Motions& Flights::fly_group(const Island& island, double time) {
  Group& group = groups[island.group];
  if (group.cached != time) {
    group.cached = time;
    gather(island);
    integrator_step(integrator, GroupRates{field, joints, island.group, members_of(island), epoch},
                    island.start, group.from, time - island.start, group.stages, group.now);
    const std::int64_t evaluated = evaluations_a_flight * static_cast<std::int64_t>(island.count);
    evaluations += evaluated;
    flight_work += evaluated * (field.attracts() ? 1 + island.count / 8 : 1) +
                   evaluations_a_flight * joints.evaluation_work(island.group) - joints.restoring_work();
    group.missed = !joints.restore(island.group, epoch + time, group.now);
    flight_work += joints.restoring_work();
  }
  return group.now;
}

const Motions& Flights::group_at(const Island& island, double time) {
  if (time != island.start) return fly_group(island, time);
  gather(island);
  return groups[island.group].from;
}

const Motions& Flights::rates_of(const Island& island, double time, const Motions& y) {
  Motions& rates = groups[island.group].stages.k[0];
  GroupRates{field, joints, island.group, members_of(island), epoch}(time, y, rates);
  flight_work += island.count + joints.evaluation_work(island.group);
  return rates;
}

Motion Flights::at(BodyIndex body, double time) {
  const IslandIndex k = island_of[body];
  if (k == kNoIsland) return at_start.col(body);
  const Island& island = islands[k];
  if (!island.kinematic) {
    if (time == island.start) return at_start.col(body);
    if (time == island.end) return at_end.col(body);
  }
  if (!island.coupled()) {
    Motion out;
    fly_one(island, time, out);
    return out;
  }
  return fly_group(island, time).col(column_of(island, body));
}

void Flights::read(double time, State& into) {
  const bool everywhere = parabolic && !field.has_quadratures();
  const bool bends = field.contact_changes();
  for (BodyIndex i{0}; i < into.size(); ++i) {
    const IslandIndex k = island_of[i];
    if (!everywhere || (k != kNoIsland && islands[k].kinematic)) {
      into.set_motion(i, at(i, time));
      continue;
    }
    if (bends) {
      into.q.col(i) = parabola(i, time);
      into.v.col(i) = parabola_velocity(i, time);
      continue;
    }
    const double h = k == kNoIsland ? 0.0 : time - islands[k].start;
    const auto y = at_start.col(i);
    into.q.col(i) = y.head<3>() + h * (y.segment<3>(3) + 0.5 * h * constant.col(i));
    into.v.col(i) = y.segment<3>(3) + h * constant.col(i);
  }
  if (!everywhere || model->forces.gravity.isZero(0.0)) return;
  for (BodyIndex i{0}; i < into.size(); ++i) {
    if (!model->infinite_mass(i))
      into.quadratures.col(i)[kGravityAngularImpulse] = angular_impulse_of_gravity(i, time);
  }
}

Eigen::Vector3d Flights::acceleration(BodyIndex body) {
  const IslandIndex k = island_of[body];
  if (k == kNoIsland || islands[k].kinematic) return Eigen::Vector3d::Zero();
  const Island& island = islands[k];
  if (parabolic) return parabola_acceleration(body, island.start);
  if (!island.coupled()) {
    const Motion y = at_start.col(body);
    Motion rate;
    BodyRates{field, body, epoch}(island.start, y, rate);
    return rate.segment<3>(3);
  }
  Group& group = groups[island.group];
  if (!group.rates_known) {
    group.start_rates = rates_of(island, island.start, group_at(island, island.start));
    group.rates_known = true;
  }
  return group.start_rates.col(column_of(island, body)).segment<3>(3);
}

void Flights::accelerations(const Island& island, const State& state, double time, Eigen::Matrix3Xd& by) {
  if (island.kinematic) return;
  const auto of = members_of(island);
  const auto motion = [&state](BodyIndex i) {
    Motion y;
    y << state.q.col(i), state.v.col(i), state.quadratures.col(i);
    return y;
  };
  if (!island.coupled()) {
    Motion rate;
    BodyRates{field, of.front(), epoch}(time, motion(of.front()), rate);
    by.col(of.front()) = v_of(rate);
    return;
  }
  Motions y(kRows, island.count);
  for (int j = 0; j < island.count; ++j) y.col(j) = motion(of[static_cast<std::size_t>(j)]);
  Motions rates(kRows, island.count);
  GroupRates{field, joints, island.group, of, epoch}(time, y, rates);
  for (int j = 0; j < island.count; ++j) by.col(of[static_cast<std::size_t>(j)]) = v_of(rates).col(j);
}

double Flights::error_of(const Island& island, double time) {
  const double h = time - island.start;
  evaluations += island.count;
  if (!island.coupled()) {
    const Motion from = at_start.col(body_of(island));
    const BodyRates f{field, body_of(island), epoch};
    Stages<Motion> stages;
    Motion out;
    integrator_step(integrator, f, island.start, from, h, stages, out);
    evaluations += evaluations_a_flight;
    return dormand_prince_error(f, island.start, h, stages, out);
  }
  fly_group(island, time);
  Group& group = groups[island.group];
  return dormand_prince_error(GroupRates{field, joints, island.group, members_of(island), epoch}, island.start,
                              h, group.stages, group.now);
}

double Flights::apply_taut_impulse(const Island& island) {
  gather(island);
  const double taken = joints.apply_taut_impulse(island.group, epoch + island.start, groups[island.group].from);
  spread(island);
  return taken;
}

}  // namespace carom
