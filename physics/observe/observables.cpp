#include "physics/observe/observables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "physics/collision/approach.h"
#include "physics/collision/broad_phase.h"
#include "physics/ledger/ledger_entries.h"

namespace carom {
namespace {

using Ids = std::span<const BodyIndex>;

// The largest value(i) over the moving bodies; zero if there are none.
template <class Value>
double largest(const Reading& r, const Value& value) {
  double most = -std::numeric_limits<double>::infinity();
  for (BodyIndex i{0}; i < r.state.size(); ++i) {
    if (r.mass.inverse_mass[i] > 0.0) most = std::max(most, value(i));
  }
  return std::isinf(most) ? 0.0 : most;
}

double rms_spin(const Reading& r) {
  double sum = 0.0;
  int moving = 0;
  for (BodyIndex i{0}; i < r.state.size(); ++i) {
    if (!(r.mass.inverse_mass[i] > 0.0)) continue;
    sum += r.state.v.col(i)[2] * r.state.v.col(i)[2];
    ++moving;
  }
  return moving == 0 ? 0.0 : std::sqrt(sum / moving);
}

Bounds bounds_at(const Reading& r, BodyIndex i) {
  const Pose pose = r.shapes.pose(i, r.state.q.col(i));
  Bounds all{Eigen::Array2d::Constant(std::numeric_limits<double>::infinity()),
             Eigen::Array2d::Constant(-std::numeric_limits<double>::infinity())};
  r.shapes.each_part(i, [&](ShapeIndex part) {
    const Bounds of = bounds_of(r.shapes.shapes, part, r.shapes.part_pose(i, part, pose));
    all = {all.low.min(of.low), all.high.max(of.high)};
  });
  return all;
}

// J; a static body has none.
double body_kinetic_energy(const Reading& r, Ids body) {
  const int i = body[0];
  if (!(r.mass.inverse_mass[i] > 0.0)) return 0.0;
  const double spin = r.state.v.col(i)[2];
  return 0.5 * r.mass.mass[i] * r.state.velocity(i).squaredNorm() + 0.5 * r.mass.inertia[i] * spin * spin;
}

// The sum over the contacts of two bodies, named in either order; NaN where it is not known.
template <class Value>
double between(const Reading& r, Ids pair, const Value& value) {
  const BodyIndex a = std::min(pair[0], pair[1]);
  const BodyIndex b = std::max(pair[0], pair[1]);
  double sum = r.contacts_known ? 0.0 : std::numeric_limits<double>::quiet_NaN();
  for (const ContactForce& f : r.contacts) {
    if (f.a == a && f.b == b) sum += value(f);
  }
  return sum;
}

// The largest penetration of two bodies, m; 0 if there is none. Joined bodies and those of one group don't
// count.
double largest_penetration(const Reading& r) {
  std::vector<Bounds> bounds;
  for (BodyIndex i{0}; i < r.state.size(); ++i) bounds.push_back(bounds_at(r, i));
  BroadPhase broad_phase;
  double most = 0.0;
  for (const auto& [a, b] : broad_phase.pairs(bounds, r.shapes.fixed)) {
    if (!r.shapes.can_collide(a, b, r.welded)) continue;
    const Approach at = approach_of(r.shapes, a, r.state.q.col(a), {}, b, r.state.q.col(b), {}, 0.0);
    most = std::max(most, -at.contact.gap);
  }
  return most;
}

// Of a pair's resting contacts. The normal force pushes the two apart; the tangential force acts on the body
// that comes later in the scene, along the normal towards it turned by +90°. Both are sums over all points,
// and means over the last step.
double normal_force(const Reading& r, Ids pair) {
  return between(r, pair, [](const ContactForce& f) { return f.normal_force; });
}
double tangential_force(const Reading& r, Ids pair) {
  return between(r, pair, [](const ContactForce& f) { return f.tangential_force; });
}

Vec2 body_momentum(const Reading& r, int i) {
  return r.mass.inverse_mass[i] > 0.0 ? Vec2(r.mass.mass[i] * r.state.velocity(i)) : Vec2(0.0, 0.0);
}

double angle_between(const Reading& r, Ids b) {
  const Vec2 u = r.state.velocity(b[0]);
  const Vec2 v = r.state.velocity(b[1]);
  return std::abs(std::atan2(cross(u, v), u.dot(v)));
}

double distance(const Reading& r, Ids b) { return (r.state.position(b[1]) - r.state.position(b[0])).norm(); }

double lost_in_flight(const Ledger& l) {
  return l.lost_to_drag + l.lost_to_dampers + l.lost_to_rolling + l.lost_to_joints;
}

// The error of one body, or the largest of the moving ones, against the reference; NaN without one.
template <class Distance>
double error_of(const Reading& r, BodyIndex body, const Distance& distance) {
  if (r.reference == nullptr) return std::numeric_limits<double>::quiet_NaN();
  return distance(r.state, r.reference->state, body);
}
// Likewise of what impacts change at once: NaN for a body that waits for an impact.
template <class Distance>
double error_between_impacts(const Reading& r, BodyIndex body, const Distance& distance) {
  const bool waits = r.reference != nullptr && r.reference->awaiting[static_cast<std::size_t>(body)] != 0;
  return waits ? std::numeric_limits<double>::quiet_NaN() : error_of(r, body, distance);
}

template <class Error>
double largest_error(const Reading& r, const Error& error) {
  double most = std::numeric_limits<double>::quiet_NaN();
  for (BodyIndex i{0}; i < r.state.size(); ++i) {
    if (r.mass.inverse_mass[i] > 0.0) most = std::fmax(most, error(i));
  }
  return most;
}

double finite_or_infinite(double value) {
  return std::isfinite(value) ? value : std::numeric_limits<double>::infinity();
}

double position_error(const State& ours, const State& theirs, BodyIndex body) {
  return finite_or_infinite((ours.position(body) - theirs.position(body)).norm());
}
double velocity_error(const State& ours, const State& theirs, BodyIndex body) {
  return finite_or_infinite((ours.velocity(body) - theirs.velocity(body)).norm());
}

// m: as turning_radius().
double radius_of(const Reading& r, BodyIndex body) {
  return r.mass.inverse_inertia[body] > 0.0 ? r.shapes.reach[body] : 0.0;
}
auto angle_error(const Reading& r) {
  return [&r](const State& ours, const State& theirs, BodyIndex body) {
    return finite_or_infinite(radius_of(r, body) * std::abs(ours.q.col(body)[2] - theirs.q.col(body)[2]));
  };
}
auto spin_error(const Reading& r) {
  return [&r](const State& ours, const State& theirs, BodyIndex body) {
    return finite_or_infinite(radius_of(r, body) * std::abs(ours.v.col(body)[2] - theirs.v.col(body)[2]));
  };
}

double energy_error(const Reading& r) {
  if (r.reference == nullptr) return std::numeric_limits<double>::quiet_NaN();
  const auto& awaiting = r.reference->awaiting;
  const bool compared = std::none_of(awaiting.begin(), awaiting.end(), [](std::uint8_t a) { return a != 0; });
  return compared ? std::abs(r.totals.energy() - r.reference->energy)
                  : std::numeric_limits<double>::quiet_NaN();
}

using R = const Reading&;

constexpr auto kOwn = std::to_array<Observable>({
    {"x", "x", "m", 1, Topic::kBody, [](R r, Ids b) { return r.state.q.col(b[0])[0]; }},
    {"y", "y", "m", 1, Topic::kBody, [](R r, Ids b) { return r.state.q.col(b[0])[1]; }},
    {"angle", "angle", "rad", 1, Topic::kBody, [](R r, Ids b) { return r.state.q.col(b[0])[2]; }},
    {"velocity_x", "velocity x", "m/s", 1, Topic::kBody, [](R r, Ids b) { return r.state.v.col(b[0])[0]; }},
    {"velocity_y", "velocity y", "m/s", 1, Topic::kBody, [](R r, Ids b) { return r.state.v.col(b[0])[1]; }},
    {"speed", "speed", "m/s", 1, Topic::kBody, [](R r, Ids b) { return r.state.velocity(b[0]).norm(); }},
    {"direction", "direction of motion", "rad", 1, Topic::kBody,
     [](R r, Ids b) { return std::atan2(r.state.v.col(b[0])[1], r.state.v.col(b[0])[0]); }},
    {"spin", "spin", "rad/s", 1, Topic::kBody, [](R r, Ids b) { return r.state.v.col(b[0])[2]; }},
    {"body_kinetic_energy", "kinetic energy", "J", 1, Topic::kBody, body_kinetic_energy},
    {"body_momentum_x", "momentum x", "N s", 1, Topic::kBody,
     [](R r, Ids b) { return body_momentum(r, b[0]).x(); }},
    {"body_momentum_y", "momentum y", "N s", 1, Topic::kBody,
     [](R r, Ids b) { return body_momentum(r, b[0]).y(); }},
    {"body_momentum", "momentum", "N s", 1, Topic::kBody,
     [](R r, Ids b) { return body_momentum(r, b[0]).norm(); }},
    {"angle_between", "angle between the velocities", "rad", 2, Topic::kPair, angle_between},
    {"distance", "distance of the centres", "m", 2, Topic::kPair, distance},
    {"impacts_between", "impacts so far", "1", 2, Topic::kPair,
     [](R r, Ids b) { return r.tally.between(b[0], b[1]); }},
    {"contact_force", "normal contact force", "N", 2, Topic::kPair, normal_force},
    {"friction_force", "tangential contact force", "N", 2, Topic::kPair, tangential_force},
    {"kinetic_energy", "kinetic energy", "J", 0, Topic::kEnergy, [](R r, Ids) { return r.totals.kinetic(); }},
    {"rotational_energy", "energy of rotation", "J", 0, Topic::kEnergy,
     [](R r, Ids) { return r.totals.rotational; }},
    {"potential_energy", "potential energy", "J", 0, Topic::kEnergy,
     [](R r, Ids) { return r.totals.potential; }},
    {"total_energy", "total energy", "J", 0, Topic::kEnergy, [](R r, Ids) { return r.totals.energy(); }},
    {"momentum_x", "momentum x", "N s", 0, Topic::kMomentum, [](R r, Ids) { return r.totals.momentum.x(); }},
    {"momentum_y", "momentum y", "N s", 0, Topic::kMomentum, [](R r, Ids) { return r.totals.momentum.y(); }},
    {"momentum", "momentum", "N s", 0, Topic::kMomentum, [](R r, Ids) { return r.totals.momentum.norm(); }},
    {"angular_momentum", "angular momentum", "kg m²/s", 0, Topic::kMomentum,
     [](R r, Ids) { return r.totals.angular_momentum; }},
    {"momentum_to_walls_x", "momentum to walls x", "N s", 0, Topic::kMomentum,
     [](R r, Ids) { return r.ledger.momentum_to_walls.x(); }},
    {"momentum_to_walls_y", "momentum to walls y", "N s", 0, Topic::kMomentum,
     [](R r, Ids) { return r.ledger.momentum_to_walls.y(); }},
    {"momentum_drift_x", "momentum drift x", "N s", 0, Topic::kMomentum,
     [](R r, Ids) { return r.momentum_drift.x(); }},
    {"momentum_drift_y", "momentum drift y", "N s", 0, Topic::kMomentum,
     [](R r, Ids) { return r.momentum_drift.y(); }},
    {"angular_momentum_drift", "angular momentum drift", "kg m²/s", 0, Topic::kMomentum,
     [](R r, Ids) { return r.angular_momentum_drift; }},
    {"lost_in_impacts", "lost in impacts, except to friction", "J", 0, Topic::kLedger,
     [](R r, Ids) { return r.ledger.lost_to_restitution + r.ledger.lost_to_sticking; }},
    {"lost_in_flight", "lost between impacts", "J", 0, Topic::kLedger,
     [](R r, Ids) { return lost_in_flight(r.ledger); }},
    {"put_in", "total put in", "J", 0, Topic::kLedger,
     [](R r,
        Ids) { return r.ledger.put_in_by_drives + r.ledger.put_in_by_user + r.ledger.penetration_correction; }},
    {"numerical_drift", "numerical drift", "J", 0, Topic::kLedger, [](R r, Ids) { return r.energy_drift; }},
    {"rms_spin", "root mean square spin", "rad/s", 0, Topic::kAllBodies, [](R r, Ids) { return rms_spin(r); }},
    {"fastest", "largest speed", "m/s", 0, Topic::kAllBodies,
     [](R r, Ids) { return largest(r, [&](BodyIndex i) { return r.state.velocity(i).norm(); }); }},
    {"lowest_y", "lowest point", "m", 0, Topic::kAllBodies,
     [](R r, Ids) { return -largest(r, [&](BodyIndex i) { return -bounds_at(r, i).low.y(); }); }},
    {"highest_y", "highest point", "m", 0, Topic::kAllBodies,
     [](R r, Ids) { return largest(r, [&](BodyIndex i) { return bounds_at(r, i).high.y(); }); }},
    {"leftmost_x", "leftmost point", "m", 0, Topic::kAllBodies,
     [](R r, Ids) { return -largest(r, [&](BodyIndex i) { return -bounds_at(r, i).low.x(); }); }},
    {"rightmost_x", "rightmost point", "m", 0, Topic::kAllBodies,
     [](R r, Ids) { return largest(r, [&](BodyIndex i) { return bounds_at(r, i).high.x(); }); }},
    {"overlap", "largest overlap", "m", 0, Topic::kAllBodies, [](R r, Ids) { return largest_penetration(r); }},
    {"contacts", "resting contact points", "1", 0, Topic::kAllBodies,
     [](R r, Ids) { return static_cast<double>(r.contacts.size()); }},
    {"time", "time", "s", 0, Topic::kRun, [](R r, Ids) { return r.time; }},
    {"impacts", "impacts so far", "1", 0, Topic::kRun, [](R r, Ids) { return static_cast<double>(r.impacts); }},
    {"wall_impacts", "impacts with walls so far", "1", 0, Topic::kRun,
     [](R r, Ids) { return r.tally.with_walls(); }},
    {"mutual_impacts", "impacts between free bodies so far", "1", 0, Topic::kRun,
     [](R r, Ids) { return r.tally.mutual(); }},
    {"wall_impulse", "normal impulses on walls so far", "N s", 0, Topic::kRun,
     [](R r, Ids) { return r.tally.wall_impulse(); }},
    {"position_error", "distance from the reference", "m", 0, Topic::kError,
     [](R r, Ids) { return largest_error(r, [&](BodyIndex i) { return error_of(r, i, position_error); }); }},
    {"velocity_error", "error of the velocities", "m/s", 0, Topic::kError,
     [](R r,
        Ids) { return largest_error(r, [&](BodyIndex i) { return error_between_impacts(r, i, velocity_error); }); }},
    {"angle_error", "error of the angles, times the radius", "m", 0, Topic::kError,
     [](R r, Ids) { return largest_error(r, [&](BodyIndex i) { return error_of(r, i, angle_error(r)); }); }},
    {"spin_error", "error of the spins, times the radius", "m/s", 0, Topic::kError,
     [](R r,
        Ids) { return largest_error(r, [&](BodyIndex i) { return error_between_impacts(r, i, spin_error(r)); }); }},
    {"energy_error", "error of the energy", "J", 0, Topic::kError, [](R r, Ids) { return energy_error(r); }},
    {"body_position_error", "distance from the reference", "m", 1, Topic::kError,
     [](R r, Ids b) { return error_of(r, b[0], position_error); }},
    {"body_velocity_error", "error of the velocity", "m/s", 1, Topic::kError,
     [](R r, Ids b) { return error_between_impacts(r, b[0], velocity_error); }},
    {"body_angle_error", "error of the angle, times the radius", "m", 1, Topic::kError,
     [](R r, Ids b) { return error_of(r, b[0], angle_error(r)); }},
    {"body_spin_error", "error of the spin, times the radius", "m/s", 1, Topic::kError,
     [](R r, Ids b) { return error_between_impacts(r, b[0], spin_error(r)); }},
});

// The entries of the ledger without the first, which is constant in a run.
constexpr std::size_t kEnergies = kEnergyEntries.size() - 1;
constexpr std::size_t kAngular = kMomentumEntries.size() - 1;

template <std::size_t... kEntry>
constexpr std::array<Observable, kEnergies> of_energy(std::index_sequence<kEntry...> /*entries*/) {
  return {Observable{kEnergyEntries[kEntry + 1].key, kEnergyEntries[kEntry + 1].label, "J", 0, Topic::kLedger,
                     [](R r, Ids) { return r.ledger.*kEnergyEntries[kEntry + 1].value; }}...};
}
template <std::size_t... kEntry>
constexpr std::array<Observable, kAngular> of_angular_momentum(std::index_sequence<kEntry...> /*entries*/) {
  return {Observable{kMomentumEntries[kEntry + 1].angular_key, kMomentumEntries[kEntry + 1].angular_label,
                     "kg m²/s", 0, Topic::kMomentum,
                     [](R r, Ids) { return r.ledger.*kMomentumEntries[kEntry + 1].angular; }}...};
}

constexpr auto kObservables = [] {
  std::array<Observable, kOwn.size() + kEnergies + kAngular> all{};
  const auto energy = of_energy(std::make_index_sequence<kEnergies>());
  const auto angular = of_angular_momentum(std::make_index_sequence<kAngular>());
  const auto first =
      std::find_if(kOwn.begin(), kOwn.end(), [](const Observable& o) { return o.topic == Topic::kLedger; });
  auto next = std::copy(kOwn.begin(), first, all.begin());
  next = std::copy(angular.begin(), angular.end(), next);
  next = std::copy(energy.begin(), energy.end(), next);
  std::copy(first, kOwn.end(), next);
  return all;
}();

}  // namespace

Reading reading_of(const Simulation& simulation, const ImpactTally& tally) {
  const Totals totals = simulation.totals();
  const Ledger ledger = simulation.ledger();
  return {simulation.state(),
          tally,
          simulation.time(),
          simulation.impact_count(),
          totals,
          ledger,
          ledger.numerical_drift(totals.energy()),
          ledger.momentum_drift(totals.momentum),
          ledger.angular_momentum_drift(totals.angular_momentum),
          simulation.mass(),
          simulation.shapes(),
          simulation.welded(),
          simulation.contact_forces(),
          knows_contact_forces(simulation.method(), simulation.needs())};
}

bool is_contact_force(std::string_view observable) {
  return observable == "contact_force" || observable == "friction_force";
}

std::span<const Observable> observables() { return kObservables; }

const Observable* find_observable(std::string_view name) {
  const auto found = std::find_if(kObservables.begin(), kObservables.end(),
                                  [&](const Observable& o) { return o.name == name; });
  return found == kObservables.end() ? nullptr : &*found;
}

void ImpactTally::begin(const Simulation& simulation) {
  ImpactCounts counts = simulation.impact_counts();
  for (const ImpactCounts::Pair& p : counts_.pairs)
    counts.watch(p.a, p.b, simulation.impact_count() == 0 ? 0 : ImpactCounts::kNotKnown);
  counts_ = std::move(counts);
  happened(simulation.impact_count());
}

void ImpactTally::add(const Simulation& simulation) {
  for (const ImpactRecord& impact : simulation.last_impacts()) add(impact, simulation.mass());
  happened(simulation.impact_count());
}

double ImpactTally::between(BodyIndex a, BodyIndex b) const {
  const ImpactCounts::Pair* pair = counts_.find(a, b);
  return pair != nullptr && pair->known() ? known(static_cast<double>(pair->count))
                                          : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace carom
