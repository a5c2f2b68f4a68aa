#include "physics/contact/contact_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "physics/contact/contact_velocity.h"
#include "physics/model/coulomb_friction.h"
#include "physics/model/mass.h"

namespace carom {

namespace {

// The residual is measured after 1, 2, 4, 8 sweeps and then every 8 (only every 8 if nothing follows the
// sweeps): measuring costs about half a sweep.
constexpr int kSweepsToMeasure = 8;
// The last sweeps of a large island's budget are without momentum, which spreads the remaining error over
// many contacts but makes it rough.
constexpr int kSweepsToSmooth = 2;
// Times the momentum that contacts change: larger impulses than these, between bodies that are jammed so that
// friction alone would hold them at any pressure, are no solution but what rounding has built up.
constexpr double kMostStress = 1e3;

// Directions in which an impulse has an effect: bodies that can only turn do not move along every normal.
enum Moves : std::uint8_t { kAlongNormal = 1, kAlongTangent = 2, kTurns = 4 };

std::uint8_t set_geometry(const Contacts& contacts, int c, const MassProperties& mass, ContactRow& row) {
  row.a = contacts.a[c];
  row.b = contacts.b[c];
  const Vec2& n = contacts.normal[c];
  row.nx = n.x();
  row.ny = n.y();
  row.arm_na = cross(contacts.arm_a[c], n);
  row.arm_nb = cross(contacts.arm_b[c], n);
  row.arm_ta = contacts.arm_a[c].dot(n);
  row.arm_tb = contacts.arm_b[c].dot(n);
  const double k = mass.inverse_mass[row.a] + mass.inverse_mass[row.b];
  const double turn_a = mass.inverse_inertia[row.a];
  const double turn_b = mass.inverse_inertia[row.b];
  const double k_nn = k + turn_a * row.arm_na * row.arm_na + turn_b * row.arm_nb * row.arm_nb;
  const double k_tt = k + turn_a * row.arm_ta * row.arm_ta + turn_b * row.arm_tb * row.arm_tb;
  const double k_rr = turn_a + turn_b;
  row.mass_n = k_nn > 0.0 ? 1.0 / k_nn : 1.0;
  row.mass_t = k_tt > 0.0 ? 1.0 / k_tt : 1.0;
  row.mass_r = k_rr > 0.0 ? 1.0 / k_rr : 0.0;
  return static_cast<std::uint8_t>((k_nn > 0.0 ? kAlongNormal : 0) | (k_tt > 0.0 ? kAlongTangent : 0) |
                                   (k_rr > 0.0 ? kTurns : 0));
}

// A direction in which nothing can move gets no impulse.
void set_law(const Contacts& contacts, int c, std::uint8_t moves, ContactRow& row) {
  constexpr double kNever = -std::numeric_limits<double>::infinity();
  row.target = (moves & kAlongNormal) != 0 ? contacts.target[c] : kNever;
  row.slip_target = contacts.slip_target[c];
  const double friction = contacts.sticks[c] != 0 ? contacts.static_friction[c] : contacts.kinetic_friction[c];
  row.friction = (moves & kAlongTangent) != 0 ? friction : 0.0;
  row.rolling = (moves & kTurns) != 0 ? contacts.rolling[c] : 0.0;
  row.normal = std::max(0.0, contacts.normal_impulse[c]);
  row.tangential = limited_by_friction(contacts.tangential_impulse[c], row.friction, row.normal);
  row.moment = limited_by_friction(contacts.rolling_impulse[c], row.rolling, row.normal);
}

void set_projection(const Contacts& contacts, int c, std::uint8_t moves, double fraction, ContactRow& row) {
  constexpr double kNever = -std::numeric_limits<double>::infinity();
  const double gap = contacts.gap[c];
  row.target = (moves & kAlongNormal) == 0 ? kNever : gap < 0.0 ? -fraction * gap : -gap;
  row.slip_target = row.friction = row.rolling = 0.0;
  row.normal = row.tangential = row.moment = 0.0;
}

void load_bodies(const MassProperties& mass, const Eigen::Matrix3Xd& v, std::vector<SolverBody>& bodies) {
  bodies.resize(v.cols());
  for (Eigen::Index i = 0; i < v.cols(); ++i) {
    bodies[i] = {v(0, i), v(1, i), v(2, i), mass.inverse_mass[i], mass.inverse_inertia[i],
                 v(0, i), v(1, i), v(2, i)};
  }
}

struct Swept {
  int sweeps = 0;
  double residual = 0.0;
};

// Sweeps until the tolerance is met or the budget spent; with `may_leave` also until the progress between two
// measurements shows that the budget will not suffice.
template <class Sweep, class Measure>
Swept gauss_seidel(const Sweep& sweep_once, const Measure& measure, double tolerance, int max_sweeps,
                   bool may_leave) {
  Swept swept{0, measure()};
  double measured = swept.residual;
  int at = 0;
  int next = may_leave ? 1 : kSweepsToMeasure;
  while (swept.sweeps < max_sweeps && !(swept.residual <= tolerance)) {
    sweep_once(swept.sweeps % 2 == 1);
    ++swept.sweeps;
    if (swept.sweeps < next && swept.sweeps < max_sweeps) continue;
    swept.residual = measure();
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

bool in_blocks(const ContactWorkspace& w, int island) {
  return w.in_blocks[static_cast<std::size_t>(island)] != 0;
}

// Of more contacts than islands that are solved exactly at any speed.
bool is_large(const ContactWorkspace& w, int island) {
  return w.first_block[island + 1] > w.first_block[island];
}

std::span<ContactRow> rows_of(ContactWorkspace& w, int island) {
  const std::span<const int> contacts = w.islands.of(island);
  return {w.rows.data() + w.islands.first[island], contacts.size()};
}

std::span<ContactBlock> blocks_of(ContactWorkspace& w, int island) {
  const int first = w.first_block[island];
  return {w.large_islands.blocks.data() + first, static_cast<std::size_t>(w.first_block[island + 1] - first)};
}

std::span<const BodyIndex> bodies_of(const ContactWorkspace& w, int island) {
  const int first = w.first_body[island];
  return {w.large_islands.bodies.data() + first, static_cast<std::size_t>(w.first_body[island + 1] - first)};
}

// Calls visit(contact, block, lane) for the contacts of the blocks from..to - 1.
template <class Visit>
void each_lane(ContactBlocks& large_islands, int from, int to, const Visit& visit) {
  for (int k = from; k < to; ++k) {
    for (std::size_t lane = 0; lane < kLanes && large_islands.contacts[k][lane] >= 0; ++lane)
      visit(large_islands.contacts[k][lane], large_islands.blocks[k], lane);
  }
}

// Loads the bodies with their velocities and the contacts with rows from set(contact, row).
template <class Set>
void load(const MassProperties& mass, const Eigen::Matrix3Xd& v, ContactWorkspace& w, const Set& set) {
  load_bodies(mass, v, w.bodies);
  for (Eigen::Index i = 0; i < v.cols(); ++i)
    w.large_islands.velocity[static_cast<std::size_t>(i)] = {v(0, i), v(1, i), v(2, i)};
  for (int i = 0; i < w.islands.size(); ++i) {
    if (!in_blocks(w, i)) {
      for (int k = w.islands.first[i]; k < w.islands.first[i + 1]; ++k) set(w.islands.contacts[k], w.rows[k]);
    }
    if (!is_large(w, i)) continue;
    double rubs = 0.0;
    double rolls = 0.0;
    each_lane(w.large_islands, w.first_block[i], w.first_block[i + 1],
              [&](int c, ContactBlock& block, std::size_t k) {
                ContactRow row;
                set(c, row);
                set_law(row, k, block);
                rubs = std::max(rubs, row.friction);
                rolls = std::max(rolls, row.rolling);
              });
    w.law[i] = rolls > 0.0 ? BlockLaw::kRolling : rubs > 0.0 ? BlockLaw::kFriction : BlockLaw::kNormal;
  }
}

void store_bodies(const ContactWorkspace& w, Eigen::Matrix3Xd& v) {
  for (std::size_t i = 0; i < w.bodies.size(); ++i)
    v.col(static_cast<Eigen::Index>(i)) << w.bodies[i].vx, w.bodies[i].vy, w.bodies[i].spin;
  for (int island = 0; island < w.islands.size(); ++island) {
    if (!in_blocks(w, island)) continue;
    for (const BodyIndex i : bodies_of(w, island)) {
      const BodyVelocity& u = w.large_islands.velocity[static_cast<std::size_t>(i)];
      v.col(i) << u.x, u.y, u.spin;
    }
  }
}

struct Solved {
  Swept swept;
  double left = 0.0;
  bool missed = false;
};

// N s
double most_impulse(std::span<const ContactRow> rows, std::span<const SolverBody> bodies) {
  const bool rubs =
      std::any_of(rows.begin(), rows.end(), [](const ContactRow& row) { return row.friction > 0.0; });
  return rubs ? kMostStress * momentum_to_change(rows, bodies) : std::numeric_limits<double>::infinity();
}

Solved solve_exactly(const ContactSolverOptions& options, int island, ContactWorkspace& w,
                     ContactSolverReport& report) {
  const std::span<ContactRow> rows = rows_of(w, island);
  const double most = most_impulse(rows, w.bodies);
  if (largest_impulse(rows) > most) {
    for (ContactRow& row : rows) row.normal = row.tangential = row.moment = 0.0;
  }
  apply_all(rows, w.bodies);
  const bool exact = options.max_newton > 0;
  const Swept swept =
      gauss_seidel([&](bool backwards) { sweep(rows, w.bodies, backwards); },
                   [&] { return residual(rows, w.bodies); }, options.tolerance, options.max_sweeps, exact);
  Solved solved{swept, swept.residual, !(swept.residual <= options.tolerance)};
  if (solved.missed && exact) {
    apply_all(rows, w.bodies);
    NewtonOptions newton_options{options.tolerance, options.max_newton, most, options.enough};
    if (is_large(w, island)) newton_options.max_sweeps = options.slow_sweeps;
    const NewtonResult newton = w.newton.run(rows, w.bodies, newton_options);
    solved.left = newton.residual;
    solved.missed = !newton.settled;
    ++report.newton_islands;
    report.newton_iterations += newton.iterations;
  } else if (solved.missed) {
    solved.missed = !(solved.left <= rounding_level(rows, w.bodies));
    apply_all(rows, w.bodies);
  }
  return solved;
}

double large_tolerance(const ContactSolverOptions& options, std::span<const BodyIndex> bodies) {
  if (options.large_motion == nullptr) return options.large_tolerance;
  double squares = 0.0;
  for (const BodyIndex i : bodies) squares += options.large_motion->col(i).head<2>().squaredNorm();
  const double rms = std::sqrt(squares / static_cast<double>(bodies.size()));
  return std::clamp(options.large_share * rms, options.large_tolerance, options.large_coarsest);
}

Solved solve_large(const ContactSolverOptions& options, int island, ContactWorkspace& w) {
  const std::span<ContactBlock> blocks = blocks_of(w, island);
  block_kernels().apply(blocks, &w.large_islands.velocity.data()->x);
  const int contacts = static_cast<int>(w.islands.of(island).size());
  const int budget = std::max(options.large_sweeps, options.large_contact_sweeps / contacts);
  const double tolerance = large_tolerance(options, bodies_of(w, island));
  BlockSweeps sweeps(blocks, bodies_of(w, island), w.law[island], w.large_islands.velocity, w.momentum);
  int left = budget;
  const Swept swept = gauss_seidel([&](bool backwards) { sweeps.sweep(backwards, --left >= kSweepsToSmooth); },
                                   [&] { return sweeps.residual(); }, tolerance, budget, false);
  return {swept, swept.residual, !(swept.residual <= tolerance)};
}

// A large island that is slow. In blocks, too, if the exact solve is not even as good as that is to be; the
// better of both counts.
Solved solve_slow(const ContactSolverOptions& options, int island, ContactWorkspace& w,
                  ContactSolverReport& report) {
  const Solved exactly = solve_exactly(options, island, w, report);
  if (!exactly.missed || exactly.left <= large_tolerance(options, bodies_of(w, island))) return exactly;
  const Solved solved = solve_large(options, island, w);
  if (exactly.left <= solved.left) return exactly;
  w.in_blocks[static_cast<std::size_t>(island)] = 1;
  return solved;
}

bool is_exact(const ExactIslands& exact, const Contacts& contacts, std::span<const int> island) {
  const int size = static_cast<int>(island.size());
  if (size <= exact.most) return true;
  if (size > exact.most_slow || exact.motion == nullptr) return false;
  double squares = 0.0;
  for (const int c : island) {
    const RowVelocity u = contact_velocity(contacts, c, *exact.motion);
    squares += u.normal * u.normal + u.tangential * u.tangential;
  }
  return squares <= size * exact.slow_speed * exact.slow_speed;
}

ContactSolverReport solve_islands(const ContactSolverOptions& options, ContactWorkspace& w) {
  ContactSolverReport report;
  report.islands = w.islands.size();
  for (int i = 0; i < w.islands.size(); ++i) {
    const Solved solved = in_blocks(w, i)  ? solve_large(options, i, w)
                          : is_large(w, i) ? solve_slow(options, i, w, report)
                                           : solve_exactly(options, i, w, report);
    report.sweeps = std::max(report.sweeps, solved.swept.sweeps);
    report.contact_sweeps += solved.swept.sweeps * static_cast<std::int64_t>(w.islands.of(i).size());
    report.missed_islands += solved.missed ? 1 : 0;
    if (!(solved.left <= report.residual)) report.residual = solved.left;
  }
  return report;
}

}  // namespace

void prepare_contacts(const MassProperties& mass, const Contacts& contacts, const ExactIslands& exact,
                      ContactWorkspace& w) {
  find_islands(contacts.a, contacts.b, mass.inverse_mass, mass.inverse_inertia, w.islands);
  clear_blocks(static_cast<int>(mass.inverse_mass.size()), w.large_islands);
  w.rows.resize(w.islands.contacts.size());
  w.moves.resize(contacts.a.size());
  w.law.resize(w.islands.size());
  w.in_blocks.assign(w.islands.size(), 0);
  w.first_block.assign(1, 0);
  w.first_body.assign(1, 0);
  for (int i = 0; i < w.islands.size(); ++i) {
    const std::span<const int> of_island = w.islands.of(i);
    const int first = w.first_block.back();
    const bool exactly = is_exact(exact, contacts, of_island);
    w.in_blocks[static_cast<std::size_t>(i)] = exactly ? 0 : 1;
    if (static_cast<int>(of_island.size()) > exact.most) {
      add_blocks(contacts.a, contacts.b, mass.inverse_mass, mass.inverse_inertia, of_island, w.large_islands);
      each_lane(w.large_islands, first, static_cast<int>(w.large_islands.blocks.size()),
                [&](int c, ContactBlock& block, std::size_t lane) {
                  ContactRow row;
                  w.moves[c] = set_geometry(contacts, c, mass, row);
                  const auto body = [&](int k) {
                    SolverBody s;
                    s.inverse_mass = mass.inverse_mass[k];
                    s.inverse_inertia = mass.inverse_inertia[k];
                    return s;
                  };
                  set_geometry(row, body(row.a), body(row.b), lane, block);
                });
    }
    if (exactly) {
      ContactRow* row = w.rows.data() + w.islands.first[i];
      for (const int c : of_island) w.moves[c] = set_geometry(contacts, c, mass, *row++);
    }
    w.first_block.push_back(static_cast<int>(w.large_islands.blocks.size()));
    w.first_body.push_back(static_cast<int>(w.large_islands.bodies.size()));
  }
}

ContactSolverReport solve_prepared(const MassProperties& mass, Contacts& contacts, Eigen::Matrix3Xd& v,
                                   const ContactSolverOptions& options, ContactWorkspace& w) {
  load(mass, v, w, [&](int c, ContactRow& row) { set_law(contacts, c, w.moves[c], row); });
  const ContactSolverReport report = solve_islands(options, w);
  store_bodies(w, v);
  // Contacts without a movable body are in no island.
  for (auto* impulses : {&contacts.normal_impulse, &contacts.tangential_impulse, &contacts.rolling_impulse})
    std::fill(impulses->begin(), impulses->end(), 0.0);
  const auto keep = [&](int c, const ContactRow& row, double slip) {
    contacts.normal_impulse[c] = row.normal;
    contacts.tangential_impulse[c] = row.tangential;
    contacts.rolling_impulse[c] = row.moment;
    contacts.sticks[c] = std::abs(slip - contacts.slip_target[c]) <= options.slip_speed ? 1 : 0;
  };
  const auto keep_lane = [&](int c, const ContactBlock& block, std::size_t lane) {
    const ContactRow row = row_of(block, lane);
    const auto body = [&](BodyIndex i) {
      const auto of = v.col(i);
      return SolverBody{.vx = of[0], .vy = of[1], .spin = of[2]};
    };
    keep(c, row, row_velocity(row, body(row.a), body(row.b)).tangential);
  };
  for (int i = 0; i < w.islands.size(); ++i) {
    if (in_blocks(w, i)) {
      each_lane(w.large_islands, w.first_block[i], w.first_block[i + 1], keep_lane);
      continue;
    }
    const std::span<const ContactRow> rows = rows_of(w, i);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const RowVelocity u = row_velocity(rows[k], w.bodies[rows[k].a], w.bodies[rows[k].b]);
      keep(w.islands.of(i)[k], rows[k], u.tangential);
    }
  }
  return report;
}

ContactSolverReport solve_contacts(const MassProperties& mass, Contacts& contacts, Eigen::Matrix3Xd& v,
                                   const ContactSolverOptions& options, ContactWorkspace& workspace) {
  prepare_contacts(mass, contacts, {.most = options.most_exact}, workspace);
  return solve_prepared(mass, contacts, v, options, workspace);
}

ContactSolverReport project_prepared(const MassProperties& mass, const Contacts& contacts, double fraction,
                                     Eigen::Matrix3Xd& dq, const ContactSolverOptions& options,
                                     ContactWorkspace& w) {
  dq.setZero(3, mass.inverse_mass.size());
  load(mass, dq, w, [&](int c, ContactRow& row) { set_projection(contacts, c, w.moves[c], fraction, row); });
  const ContactSolverReport report = solve_islands(options, w);
  store_bodies(w, dq);
  return report;
}

ContactSolverReport project_penetrations(const MassProperties& mass, const Contacts& contacts, double fraction,
                                         Eigen::Matrix3Xd& dq, const ContactSolverOptions& options,
                                         ContactWorkspace& workspace) {
  prepare_contacts(mass, contacts, {.most = options.most_exact}, workspace);
  return project_prepared(mass, contacts, fraction, dq, options, workspace);
}

}  // namespace carom
