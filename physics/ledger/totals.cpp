#include "physics/ledger/totals.h"

#include "physics/math/vectors.h"
#include "physics/model/mass.h"

namespace carom {

Totals totals(const State& state, const MassProperties& mass, const ForceField& field) {
  Totals t;
  for (BodyIndex i{0}; i < state.size(); ++i) {
    if (!(mass.inverse_mass[i] > 0.0)) continue;
    const Vec2 x = state.position(i);
    const Vec2 v = state.velocity(i);
    const Vec2 p = mass.mass[i] * v;
    const double spin = state.v.col(i)[2];
    t.translational += 0.5 * p.dot(v);
    t.rotational += 0.5 * mass.inertia[i] * spin * spin;
    t.momentum += p;
    t.angular_momentum += cross(x, p) + mass.inertia[i] * spin;
  }
  t.potential = field.potential_energy(state.q);
  return t;
}

double kinetic_energy(const State& state, const MassProperties& mass) {
  double energy = 0.0;
  for (BodyIndex i{0}; i < state.size(); ++i) {
    if (!(mass.inverse_mass[i] > 0.0)) continue;
    energy += 0.5 * mass.mass[i] * state.v.col(i).head<2>().squaredNorm() +
              0.5 * mass.inertia[i] * state.v.col(i)[2] * state.v.col(i)[2];
  }
  return energy;
}

}  // namespace carom
