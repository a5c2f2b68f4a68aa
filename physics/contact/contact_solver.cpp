#include "physics/contact/contact_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace carom {

namespace {

// A residual is measured after 1, 2, 4, 8 sweeps and then every 8 (where sweeps are all that is done, every 8):
// measuring costs about half a sweep.
constexpr int kSweepsToMeasure = 8;

double cross(const Vec2& r, const Vec2& d) { return r.x() * d.y() - r.y() * d.x(); }

ContactRow geometry_row(const Contacts& contacts, int c, const MassProperties& mass) {
  ContactRow row;
  row.a = contacts.a[c];
  row.b = contacts.b[c];
  const Vec2& n = contacts.normal[c];
  row.nx = n.x();
  row.ny = n.y();
  row.turn_na = cross(contacts.arm_a[c], n);
  row.turn_nb = cross(contacts.arm_b[c], n);
  row.turn_ta = contacts.arm_a[c].dot(n);
  row.turn_tb = contacts.arm_b[c].dot(n);
  const double k = mass.inverse_mass[row.a] + mass.inverse_mass[row.b];
  const double turn_a = mass.inverse_inertia[row.a];
  const double turn_b = mass.inverse_inertia[row.b];
  const double k_nn = k + turn_a * row.turn_na * row.turn_na + turn_b * row.turn_nb * row.turn_nb;
  const double k_tt = k + turn_a * row.turn_ta * row.turn_ta + turn_b * row.turn_tb * row.turn_tb;
  const double k_rr = turn_a + turn_b;
  // A direction in which nothing can move (bodies that only turn) gets no impulse.
  row.mass_n = k_nn > 0.0 ? 1.0 / k_nn : 1.0;
  row.mass_t = k_tt > 0.0 ? 1.0 / k_tt : 1.0;
  row.mass_r = k_rr > 0.0 ? 1.0 / k_rr : 0.0;
  row.target = k_nn > 0.0 ? 0.0 : -std::numeric_limits<double>::infinity();
  row.friction = k_tt > 0.0 ? 1.0 : 0.0;
  row.rolling = k_rr > 0.0 ? 1.0 : 0.0;
  return row;
}

void load_bodies(const MassProperties& mass, const Eigen::Matrix3Xd& v, std::vector<SolverBody>& bodies) {
  bodies.resize(v.cols());
  for (Eigen::Index i = 0; i < v.cols(); ++i) {
    bodies[i] = {v(0, i), v(1, i), v(2, i), mass.inverse_mass[i], mass.inverse_inertia[i],
                 v(0, i), v(1, i), v(2, i)};
  }
}

void store_bodies(const std::vector<SolverBody>& bodies, Eigen::Matrix3Xd& v) {
  for (std::size_t i = 0; i < bodies.size(); ++i)
    v.col(static_cast<Eigen::Index>(i)) << bodies[i].vx, bodies[i].vy, bodies[i].spin;
}

struct Swept {
  int sweeps = 0;
  double residual = 0.0;
};

// Sweeps until the tolerance is met or the budget spent; with `may_leave` also once the progress between two
// measurements shows that the budget will not do.
Swept gauss_seidel(std::span<ContactRow> rows, std::span<SolverBody> bodies, double tolerance, int max_sweeps,
                   bool may_leave) {
  Swept swept{0, residual(rows, bodies)};
  double measured = swept.residual;
  int at = 0;
  int next = may_leave ? 1 : kSweepsToMeasure;
  while (swept.sweeps < max_sweeps && !(swept.residual <= tolerance)) {
    sweep(rows, bodies, swept.sweeps % 2 == 1);
    ++swept.sweeps;
    if (swept.sweeps < next && swept.sweeps < max_sweeps) continue;
    swept.residual = residual(rows, bodies);
    if (may_leave && at >= kSweepsToMeasure && swept.residual > tolerance) {
      const double rate = std::log(swept.residual / measured) / (swept.sweeps - at);
      const double left = max_sweeps - swept.sweeps;
      if (!(std::log(swept.residual / tolerance) + rate * left < 0.0)) break;
    }
    measured = swept.residual;
    at = swept.sweeps;
    next = at + std::min(std::max(at, 1), kSweepsToMeasure);
  }
  return swept;
}

ContactSolverReport solve_islands(const ContactSolverOptions& options, ContactWorkspace& w) {
  ContactSolverReport report;
  report.islands = w.islands.size();
  for (int i = 0; i < w.islands.size(); ++i) {
    const int first = w.islands.first[i];
    const auto count = static_cast<std::size_t>(w.islands.first[i + 1] - first);
    const std::span<ContactRow> rows(w.rows.data() + first, count);
    apply_all(rows, w.bodies);
    const bool crowd = rows.size() > static_cast<std::size_t>(options.most_exact);
    const bool exact = options.max_newton > 0 && !crowd;
    const double tolerance = crowd ? options.crowd_tolerance : options.tolerance;
    const Swept swept =
        gauss_seidel(rows, w.bodies, tolerance, crowd ? options.crowd_sweeps : options.max_sweeps, exact);
    double left = swept.residual;
    bool missed = !(left <= tolerance);
    if (missed && exact) {
      apply_all(rows, w.bodies);
      const NewtonResult newton = w.newton.run(rows, w.bodies, {options.tolerance, options.max_newton});
      left = newton.residual;
      missed = !newton.settled;
      ++report.newton_islands;
      report.newton_iterations += newton.iterations;
    } else if (missed) {
      missed = !(left <= rounding_level(rows, w.bodies));
      apply_all(rows, w.bodies);
    }
    report.sweeps = std::max(report.sweeps, swept.sweeps);
    report.contact_sweeps += static_cast<std::int64_t>(swept.sweeps) * static_cast<std::int64_t>(count);
    report.missed_islands += missed ? 1 : 0;
    if (!(left <= report.residual)) report.residual = left;
  }
  return report;
}

}  // namespace

ContactSolverReport solve_contacts(const MassProperties& mass, Contacts& contacts, Eigen::Matrix3Xd& v,
                                   const ContactSolverOptions& options, ContactWorkspace& workspace) {
  find_islands(contacts.a, contacts.b, mass.inverse_mass, mass.inverse_inertia, workspace.islands);
  load_bodies(mass, v, workspace.bodies);
  const std::vector<int>& order = workspace.islands.contacts;
  workspace.rows.resize(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const int c = order[i];
    ContactRow row = geometry_row(contacts, c, mass);
    row.target += contacts.target[c];
    row.friction *= contacts.sticks[c] != 0 ? contacts.static_friction[c] : contacts.kinetic_friction[c];
    row.rolling *= contacts.rolling[c];
    row.normal = std::max(0.0, contacts.normal_impulse[c]);
    const double limit = row.friction * row.normal;
    const double most = row.rolling * row.normal;
    row.tangential = std::clamp(contacts.tangential_impulse[c], -limit, limit);
    row.moment = std::clamp(contacts.rolling_impulse[c], -most, most);
    workspace.rows[i] = row;
  }

  const ContactSolverReport report = solve_islands(options, workspace);

  store_bodies(workspace.bodies, v);
  // Contacts between immovable bodies are in no island.
  for (auto* impulses : {&contacts.normal_impulse, &contacts.tangential_impulse, &contacts.rolling_impulse})
    std::fill(impulses->begin(), impulses->end(), 0.0);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const ContactRow& row = workspace.rows[i];
    const int c = order[i];
    contacts.normal_impulse[c] = row.normal;
    contacts.tangential_impulse[c] = row.tangential;
    contacts.rolling_impulse[c] = row.moment;
    const RowVelocity u = row_velocity(row, workspace.bodies[row.a], workspace.bodies[row.b]);
    contacts.sticks[c] = std::abs(u.tangential) <= options.slip_speed ? 1 : 0;
  }
  return report;
}

ContactSolverReport project_overlaps(const MassProperties& mass, const Contacts& contacts, double fraction,
                                     Eigen::Matrix3Xd& dq, const ContactSolverOptions& options,
                                     ContactWorkspace& workspace) {
  find_islands(contacts.a, contacts.b, mass.inverse_mass, mass.inverse_inertia, workspace.islands);
  dq.setZero(3, mass.inverse_mass.size());
  load_bodies(mass, dq, workspace.bodies);
  const std::vector<int>& order = workspace.islands.contacts;
  workspace.rows.resize(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    ContactRow row = geometry_row(contacts, order[i], mass);
    const double gap = contacts.gap[order[i]];
    row.target += gap < 0.0 ? -fraction * gap : -gap;
    row.friction = row.rolling = 0.0;
    workspace.rows[i] = row;
  }
  const ContactSolverReport report = solve_islands(options, workspace);
  store_bodies(workspace.bodies, dq);
  return report;
}

}  // namespace carom
