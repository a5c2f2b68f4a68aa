#include "physics/measure/observables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace carom {
namespace {

using Ids = std::span<const int>;

// The largest value(i) over the moving bodies; zero if there are none.
template <class Value>
double largest(const Reading& r, const Value& value) {
  double most = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < r.state.size(); ++i) {
    if (r.mass.inverse_mass[i] > 0.0) most = std::max(most, value(i));
  }
  return std::isinf(most) ? 0.0 : most;
}

double rms_spin(const Reading& r) {
  double sum = 0.0;
  int moving = 0;
  for (int i = 0; i < r.state.size(); ++i) {
    if (!(r.mass.inverse_mass[i] > 0.0)) continue;
    sum += r.state.v(2, i) * r.state.v(2, i);
    ++moving;
  }
  return moving == 0 ? 0.0 : std::sqrt(sum / moving);
}

Bounds bounds_at(const Reading& r, int i) {
  return bounds_of(r.shapes.shapes, i, pose_of(r.shapes.shapes, i, r.state.q.col(i)));
}

// J; an immovable body has none to give.
double body_kinetic_energy(const Reading& r, int i) {
  if (!(r.mass.inverse_mass[i] > 0.0)) return 0.0;
  const double spin = r.state.v(2, i);
  return 0.5 * r.mass.mass[i] * r.state.velocity(i).squaredNorm() + 0.5 * r.mass.inertia[i] * spin * spin;
}

// The sum over the contacts of two bodies, in whatever order they are named.
template <class Value>
double between(const Reading& r, Ids pair, const Value& value) {
  const int a = std::min(pair[0], pair[1]);
  const int b = std::max(pair[0], pair[1]);
  double sum = 0.0;
  for (const ContactForce& f : r.contacts) {
    if (f.a == a && f.b == b) sum += value(f);
  }
  return sum;
}

constexpr auto kObservables = std::to_array<Observable>({
    {"x", "m", 1, [](const Reading& r, Ids b) { return r.state.q(0, b[0]); }},
    {"y", "m", 1, [](const Reading& r, Ids b) { return r.state.q(1, b[0]); }},
    {"angle", "rad", 1, [](const Reading& r, Ids b) { return r.state.q(2, b[0]); }},
    {"velocity_x", "m/s", 1, [](const Reading& r, Ids b) { return r.state.v(0, b[0]); }},
    {"velocity_y", "m/s", 1, [](const Reading& r, Ids b) { return r.state.v(1, b[0]); }},
    {"speed", "m/s", 1, [](const Reading& r, Ids b) { return r.state.velocity(b[0]).norm(); }},
    {"direction", "rad", 1,
     [](const Reading& r, Ids b) { return std::atan2(r.state.v(1, b[0]), r.state.v(0, b[0])); }},
    {"spin", "rad/s", 1, [](const Reading& r, Ids b) { return r.state.v(2, b[0]); }},
    {"body_kinetic_energy", "J", 1, [](const Reading& r, Ids b) { return body_kinetic_energy(r, b[0]); }},
    {"angle_between", "rad", 2,
     [](const Reading& r, Ids b) {
       const Vec2 u = r.state.velocity(b[0]);
       const Vec2 v = r.state.velocity(b[1]);
       return std::abs(std::atan2(u.x() * v.y() - u.y() * v.x(), u.dot(v)));
     }},
    {"distance", "m", 2,
     [](const Reading& r, Ids b) { return (r.state.position(b[1]) - r.state.position(b[0])).norm(); }},
    {"impacts_between", "1", 2, [](const Reading& r, Ids b) { return r.tally.between(b[0], b[1]); }},
    {"contact_force", "N", 2,
     [](const Reading& r, Ids b) {
       return between(r, b, [](const ContactForce& f) { return f.normal_force; });
     }},
    {"friction_force", "N", 2,
     [](const Reading& r, Ids b) {
       return between(r, b, [](const ContactForce& f) { return f.tangential_force; });
     }},
    {"kinetic_energy", "J", 0, [](const Reading& r, Ids) { return r.totals.kinetic(); }},
    {"rotational_energy", "J", 0, [](const Reading& r, Ids) { return r.totals.rotational; }},
    {"potential_energy", "J", 0, [](const Reading& r, Ids) { return r.totals.potential; }},
    {"total_energy", "J", 0, [](const Reading& r, Ids) { return r.totals.energy(); }},
    {"momentum_x", "N s", 0, [](const Reading& r, Ids) { return r.totals.momentum.x(); }},
    {"momentum_y", "N s", 0, [](const Reading& r, Ids) { return r.totals.momentum.y(); }},
    {"momentum", "N s", 0, [](const Reading& r, Ids) { return r.totals.momentum.norm(); }},
    {"angular_momentum", "kg m²/s", 0, [](const Reading& r, Ids) { return r.totals.angular_momentum; }},
    {"time", "s", 0, [](const Reading& r, Ids) { return r.time; }},
    {"impacts", "1", 0, [](const Reading& r, Ids) { return static_cast<double>(r.impacts); }},
    {"wall_impacts", "1", 0, [](const Reading& r, Ids) { return r.tally.with_walls(); }},
    {"mutual_impacts", "1", 0, [](const Reading& r, Ids) { return r.tally.mutual(); }},
    {"wall_impulse", "N s", 0, [](const Reading& r, Ids) { return r.tally.wall_impulse(); }},
    {"lost_to_restitution", "J", 0, [](const Reading& r, Ids) { return r.ledger.lost_to_restitution; }},
    {"lost_to_friction", "J", 0, [](const Reading& r, Ids) { return r.ledger.lost_to_friction; }},
    {"lost_to_rolling", "J", 0, [](const Reading& r, Ids) { return r.ledger.lost_to_rolling; }},
    {"lost_to_sticking", "J", 0, [](const Reading& r, Ids) { return r.ledger.lost_to_sticking; }},
    {"lost_to_drag", "J", 0, [](const Reading& r, Ids) { return r.ledger.lost_to_drag; }},
    {"lost_to_dampers", "J", 0, [](const Reading& r, Ids) { return r.ledger.lost_to_dampers; }},
    {"lost_to_links", "J", 0, [](const Reading& r, Ids) { return r.ledger.lost_to_links; }},
    {"put_in_by_drives", "J", 0, [](const Reading& r, Ids) { return r.ledger.put_in_by_drives; }},
    {"numerical_drift", "J", 0,
     [](const Reading& r, Ids) { return r.ledger.numerical_drift(r.totals.energy()); }},
    {"rms_spin", "rad/s", 0, [](const Reading& r, Ids) { return rms_spin(r); }},
    {"fastest", "m/s", 0,
     [](const Reading& r, Ids) { return largest(r, [&](int i) { return r.state.velocity(i).norm(); }); }},
    {"lowest_y", "m", 0,
     [](const Reading& r, Ids) { return -largest(r, [&](int i) { return -bounds_at(r, i).low.y(); }); }},
    {"highest_y", "m", 0,
     [](const Reading& r, Ids) { return largest(r, [&](int i) { return bounds_at(r, i).high.y(); }); }},
    {"leftmost_x", "m", 0,
     [](const Reading& r, Ids) { return -largest(r, [&](int i) { return -bounds_at(r, i).low.x(); }); }},
    {"rightmost_x", "m", 0,
     [](const Reading& r, Ids) { return largest(r, [&](int i) { return bounds_at(r, i).high.x(); }); }},
});

}  // namespace

std::span<const Observable> observables() { return kObservables; }

const Observable* find_observable(std::string_view name) {
  const auto found = std::find_if(kObservables.begin(), kObservables.end(),
                                  [&](const Observable& o) { return o.name == name; });
  return found == kObservables.end() ? nullptr : &*found;
}

}  // namespace carom
