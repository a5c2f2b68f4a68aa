#include "physics/contact/contact_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/model/coulomb_friction.h"

namespace carom {

namespace {

inline void solve_row(ContactRow& row, SolverBody& a, SolverBody& b) {
  const RowVelocity u = row_velocity(row, a, b);
  const double normal = std::max(0.0, row.normal - (u.normal - row.target) * row.mass_n);
  const double dn = normal - row.normal;
  // u_t after the normal impulse.
  const double k_nt = a.inverse_inertia * row.arm_na * row.arm_ta + b.inverse_inertia * row.arm_nb * row.arm_tb;
  const double slip = u.tangential - row.slip_target + k_nt * dn;
  const double tangential = limited_by_friction(row.tangential - slip * row.mass_t, row.friction, normal);
  const double dt = tangential - row.tangential;
  row.normal = normal;
  row.tangential = tangential;
  apply_impulse(row, dn, dt, 0.0, a, b);
  if (row.rolling > 0.0) {
    const double moment = limited_by_friction(row.moment - (b.spin - a.spin) * row.mass_r, row.rolling, normal);
    const double dm = moment - row.moment;
    row.moment = moment;
    a.spin -= a.inverse_inertia * dm;
    b.spin += b.inverse_inertia * dm;
  }
}

}  // namespace

void apply_all(std::span<const ContactRow> rows, std::span<SolverBody> bodies) {
  for (const ContactRow& row : rows) {
    for (const BodyIndex i : {row.a, row.b}) {
      SolverBody& body = bodies[i];
      body.vx = body.free_vx;
      body.vy = body.free_vy;
      body.spin = body.free_spin;
    }
  }
  for (const ContactRow& row : rows)
    apply_impulse(row, row.normal, row.tangential, row.moment, bodies[row.a], bodies[row.b]);
}

void sweep(std::span<ContactRow> rows, std::span<SolverBody> bodies, bool backwards) {
  if (backwards) {
    for (auto row = rows.rbegin(); row != rows.rend(); ++row) solve_row(*row, bodies[row->a], bodies[row->b]);
  } else {
    for (ContactRow& row : rows) solve_row(row, bodies[row.a], bodies[row.b]);
  }
}

double residual(std::span<const ContactRow> rows, std::span<const SolverBody> bodies) {
  // If a clamp does not act, its term is the velocity itself; a difference of impulses would only add
  // rounding.
  const auto miss = [](double impulse, double velocity, double mass, double limit) {
    const double asked = impulse - velocity * mass;
    if (std::abs(asked) <= limit) return std::abs(velocity);
    return std::abs(std::copysign(limit, asked) - impulse) / mass;
  };
  double largest = 0.0;
  for (const ContactRow& row : rows) {
    const RowVelocity u = row_velocity(row, bodies[row.a], bodies[row.b]);
    const double beyond = u.normal - row.target;
    double worst = row.normal - beyond * row.mass_n > 0.0 ? std::abs(beyond) : row.normal / row.mass_n;
    worst = std::max(
        worst, miss(row.tangential, u.tangential - row.slip_target, row.mass_t, row.friction * row.normal));
    if (row.rolling > 0.0)
      worst = std::max(worst, row.rolling * miss(row.moment, u.spin, row.mass_r, row.rolling * row.normal));
    // Keeps a NaN, which comes from invalid input.
    if (!(worst <= largest)) largest = worst;
  }
  return largest;
}

double momentum_to_change(std::span<const ContactRow> rows, std::span<const SolverBody> bodies) {
  double mass = 0.0;
  double speed = 0.0;
  const auto free = [&](BodyIndex i) {
    SolverBody body = bodies[i];
    body.vx = body.free_vx;
    body.vy = body.free_vy;
    body.spin = body.free_spin;
    return body;
  };
  for (const ContactRow& row : rows) {
    const RowVelocity u = row_velocity(row, free(row.a), free(row.b));
    mass += row.mass_n;
    for (const BodyIndex i : {row.a, row.b}) {
      if (bodies[i].inverse_mass > 0.0) mass += 1.0 / bodies[i].inverse_mass;
    }
    speed = std::max({speed, std::isfinite(row.target) ? row.target - u.normal : 0.0,
                      row.friction > 0.0 ? std::abs(u.tangential - row.slip_target) : 0.0});
  }
  return mass * speed;
}

double largest_impulse(std::span<const ContactRow> rows) {
  double largest = 0.0;
  for (const ContactRow& row : rows) largest = std::max(largest, row.normal);
  return largest;
}

double rounding_level(std::span<const ContactRow> rows, std::span<SolverBody> bodies) {
  for (const ContactRow& row : rows) {
    for (const BodyIndex i : {row.a, row.b}) {
      SolverBody& body = bodies[i];
      body.vx = std::sqrt(body.free_vx * body.free_vx + body.free_vy * body.free_vy);
      body.spin = std::abs(body.free_spin);
    }
  }
  for (const ContactRow& row : rows) {
    const double push = row.normal + std::abs(row.tangential);
    const auto add = [&](SolverBody& body, double arm_n, double arm_t) {
      body.vx += body.inverse_mass * push;
      body.spin += body.inverse_inertia *
                   (std::abs(arm_n) * row.normal + std::abs(arm_t * row.tangential) + std::abs(row.moment));
    };
    add(bodies[row.a], row.arm_na, row.arm_ta);
    add(bodies[row.b], row.arm_nb, row.arm_tb);
  }
  double largest = 0.0;
  for (const ContactRow& row : rows) {
    const SolverBody& a = bodies[row.a];
    const SolverBody& b = bodies[row.b];
    const double arm_a = std::max(std::sqrt(row.arm_na * row.arm_na + row.arm_ta * row.arm_ta), row.rolling);
    const double arm_b = std::max(std::sqrt(row.arm_nb * row.arm_nb + row.arm_tb * row.arm_tb), row.rolling);
    largest = std::max(largest, a.vx + b.vx + arm_a * a.spin + arm_b * b.spin);
  }
  return 8.0 * std::numeric_limits<double>::epsilon() * largest;
}

}  // namespace carom
