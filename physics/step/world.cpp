#include "physics/step/world.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "physics/collision/pair_contact.h"
#include "physics/dynamics/lost_motion.h"
#include "physics/math/vectors.h"
#include "physics/step/apply_impact.h"

namespace carom {

namespace {

std::vector<BodyIndex> immovable_of(const Model& model) {
  std::vector<BodyIndex> bodies;
  for (BodyIndex i{0}; i < static_cast<int>(model.bodies()); ++i) {
    if (model.infinite_mass(i) && !model.is_kinematic(i)) bodies.push_back(i);
  }
  return bodies;
}

}  // namespace

World::World(std::shared_ptr<const Model> compiled, const Method& chosen)
    : model(std::move(compiled)),
      method(chosen),
      apply_impact(apply_impact_of(*model)),
      immovable(immovable_of(*model)),
      trajectories(model, method) {
  const double start = model->start_time;
  trajectories.begin(start);
  // A file's seven digits don't place joints' ends within rounding.
  for (const IslandIndex k : trajectories.islands()) trajectories.restore_joints(k);
  state.resize(bodies());
  state.quadratures.setZero();
  trajectories.begin(start);
  publish(0.0);
  clock.start(start);
  sums.gravity_since = start;
  sums.peak_kinetic = kinetic_energy(state, mass());
  sums.ledger.initial = totals().energy();
  sums.ledger.initial_momentum = totals().momentum;
  sums.ledger.initial_angular_momentum = totals().angular_momentum;
}

State World::state_at(double within) {
  State all;
  all.resize(state.size());
  trajectories.look_at(within, all);
  return all;
}

ImpactSide World::side(BodyIndex body, const Contact& contact, double towards) const {
  const auto y = trajectories.at_start(body);
  const Vec2 r = contact.point - y.head<2>();
  const Vec2& n = contact.normal;
  // The normal of a disc's contact passes through its centre, but for rounding.
  const double lever = shapes().is_disc(body) ? 0.0 : towards * cross(r, n);
  return {y.segment<2>(3),    y[5], mass().inverse_mass[body], mass().inverse_inertia[body],
          towards * r.dot(n), lever};
}

double World::parting_speed(BodyIndex a, BodyIndex b, const Contact& contact) const {
  // As relative_velocity() of both sides has it.
  const auto turning = [&](BodyIndex body, double towards) {
    if (shapes().is_disc(body)) return 0.0;
    const auto y = trajectories.at_start(body);
    return y[5] * (towards * cross(Vec2(contact.point - y.head<2>()), contact.normal));
  };
  const Vec2 u = trajectories.at_start(b).segment<2>(3) - trajectories.at_start(a).segment<2>(3);
  return u.dot(contact.normal) - turning(a, 1.0) - turning(b, -1.0);
}

Approach World::approach(BodyIndex a, BodyIndex b, double tolerance, const ShapePair& parts) const {
  const auto ya = trajectories.at_start(a);
  const auto yb = trajectories.at_start(b);
  if (shapes().is_disc(a) && shapes().is_disc(b)) {
    // The same with less work: what most pairs of a crowd are.
    const auto [part_a, part_b] = shapes().first_parts(a, b);
    const Contact contact = contact_of_discs(shapes().shapes, part_a, ya.head<2>(), part_b, yb.head<2>());
    const Vec2 va = ya.segment<2>(3);
    const Vec2 vb = yb.segment<2>(3);
    return {contact, vb.dot(contact.normal) - va.dot(contact.normal), va.norm() + vb.norm()};
  }
  return approach_of(shapes(), a, ya.head<3>(), {ya.segment<2>(3), ya[5]}, b, yb.head<3>(),
                     {yb.segment<2>(3), yb[5]}, tolerance, parts);
}

Approach World::fastest_approach(BodyIndex a, BodyIndex b, double tolerance, const ShapePair& parts) const {
  const auto ya = trajectories.at_start(a);
  const auto yb = trajectories.at_start(b);
  return fastest_approach_of(shapes(), a, ya.head<3>(), {ya.segment<2>(3), ya[5]}, b, yb.head<3>(),
                             {yb.segment<2>(3), yb[5]}, tolerance, parts);
}

void World::restore_joints(IslandIndex island) {
  const auto totals_now = [&] {
    for (const BodyIndex i : trajectories.members(island)) state.set_motion(i, trajectories.at_start(i));
    return totals();
  };
  const Totals before = totals_now();
  trajectories.restore_joints(island);
  const Totals after = totals_now();
  sums.ledger.penetration_correction += after.energy() - before.energy();
  sums.ledger.momentum_from_forces += after.momentum - before.momentum;
}

Ledger World::ledger() const {
  Ledger ledger = sums.ledger;
  ledger.add(1.0, ledger_of_quadratures(state));
  ledger.lost_to_joints = trajectories.lost_to_joints();
  double total = 0.0;
  for (BodyIndex i{0}; i < state.size(); ++i) {
    if (!infinite_mass(i)) total += mass().mass[i];
  }
  ledger.momentum_from_gravity += total * (clock.time - sums.gravity_since) * model->forces.gravity;
  return ledger;
}

void World::check_motions() const {
  constexpr double kSquare = kLostBeyond * kLostBeyond;
  const auto beyond = [](const auto& m) {
    return !(m.squaredNorm() <= kSquare) && !(m.array().abs() <= kLostBeyond).all();
  };
  // Under gravity alone they are finite where the positions are.
  const bool finite = !field().has_quadratures() || state.quadratures.allFinite();
  if (!beyond(state.q) && !beyond(state.v) && finite) return;
  for (BodyIndex i{0}; i < state.size(); ++i) {
    if (beyond(state.q.col(i)) || beyond(state.v.col(i)) || !state.quadratures.col(i).allFinite())
      throw LostMotion{LossReason::kTooLarge, i, clock.step_end};
  }
}

// Checks the ledger each time the kinetic energy exceeds its peak by a power of four, so that most steps need
// no potential energy, which costs n² under attraction. Two checks in a row must fail, because Euler's first
// step from rest makes all of its energy: nothing has moved yet.
void World::check_energy() {
  constexpr double kMade = 0.75;  // of the kinetic energy and all that the bodies got or lost
  // Of the ledger's turnover: less is rounding, or as good as at rest.
  constexpr double kRounding = 1e-9;
  const double kinetic = kinetic_energy(state, mass());
  const double peak = std::exchange(sums.peak_kinetic, std::max(sums.peak_kinetic, kinetic));
  if (sums.notices.energy_made_since >= 0.0 || std::ilogb(kinetic) / 2 <= std::ilogb(peak) / 2) return;
  const Ledger now = ledger();
  const double made = now.numerical_drift(totals().energy());
  const double turnover = now.turnover();
  // Forces that friction almost balances pass on far more than the bodies keep.
  const double passed = kinetic + turnover - std::abs(now.initial);
  const bool doubtful = made > kMade * passed && std::min(made, kinetic) > kRounding * turnover;
  sums.energy_doubts = doubtful ? sums.energy_doubts + 1 : 0;
  if (sums.energy_doubts == 2) note(&Notices::energy_made_since, clock.step_end);
}

}  // namespace carom
