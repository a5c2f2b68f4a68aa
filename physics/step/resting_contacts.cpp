#include "physics/step/resting_contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/contact/contact_velocity.h"
#include "physics/dynamics/integrators/integrators.h"
#include "physics/math/vectors.h"
#include "physics/step/contact_work.h"
#include "physics/step/island_spin.h"
#include "physics/step/pair_motion.h"
#include "physics/step/penetrations.h"

namespace carom {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
// Of the change of a speed by forces in a step: a contact that slips slower than this sticks.
constexpr double kStuck = 1e-6;
// Of what presses a contact in a step: the contact forces end slower approaches of supported contacts.
constexpr double kGentle = 0.1;
// Of what presses a contact in a step, times the step: smaller penetrations are left to the contact forces.
constexpr double kShallow = 0.5;
// Relative to the size: a smaller penetration is rounding, and one beyond kDeep is removed in several steps.
constexpr double kPenetration = 1e-12;
constexpr double kDeep = 0.05;
// Number of contacts up to which an island is solved exactly: always, or if its rms velocity is at most kSlow
// of the change of a speed by forces in a step. A large island has the tolerance kLargeMotion of its speeds,
// at most kLargeSolved of that change: as it comes to rest its solution improves, each step starting from the
// forces of the one before.
constexpr int kMostExact = 64;
constexpr int kMostExactAtRest = 64;
constexpr double kSlow = 1e-5;
constexpr double kLargeMotion = 0.1;
constexpr double kLargeSolved = 1e-2;
constexpr double kLargeRest = 1e-9;
constexpr double kLargePenetration = 1e-6;  // relative to the size
// Sweeps over a large island; more while contacts times sweeps stay below kLargeContactSweeps.
constexpr int kLargeSweeps = 20;
constexpr int kLargeContactSweeps = 20'000;
// In a pile at rest, where less than one contact in kContactsPerHit is hit, up to kQuietSweeps: what is left
// there adds up from step to step and makes the pile creep.
constexpr int kQuietSweeps = 150;
constexpr int kContactsPerHit = 100;
// Of the size, or rad: how far bodies of a crowd may close or turn in a part of a step.
constexpr double kMostMotion = 0.1;
// Guesses of the contact forces in a step, until the flight under them has end velocities that are off by at
// most kGuessed of the change of a speed by forces.
constexpr int kMostGuesses = 6;
constexpr int kMostGuessesOfMany = 2;  // of more than kFewContacts
constexpr int kFewContacts = 16;
constexpr double kGuessed = 1e-9;
// Rounds in which contacts break away from static friction in one step.
constexpr int kMostBreaks = 3;
// Linear forces end where a contact's mode does: found in so many rounds, the last of which may be off by
// kAbout. Where a step can't be divided, modes must last for kWhole of it.
constexpr int kMostEnds = 3;
constexpr double kAbout = 0.9;
constexpr double kWhole = 1.0 - 1e-6;
// Corrections of the contact forces where the integrator's flight is not linear in them.
constexpr int kMostRounds = 12;

// Of the change of a speed by forces in a step: a smaller residual is not worth a notice.
constexpr double kNotable = 1e-6;

// s after the epoch: when an applied force on a body in contact changes its law first; h if none does within h.
double first_break(const World& world, const Contacts& contacts, double h) {
  if (!world.field().has_breaks()) return h;
  double first = h;
  const double epoch = world.trajectories.epoch();
  for (int i = 0; i < contacts.size(); ++i) {
    for (const int body : {contacts.a[i], contacts.b[i]})
      first = std::min(first, world.field().next_break(body, epoch) - epoch);
  }
  return first;
}

void report_residual(World& world, const ContactSolverReport& report, double by_forces) {
  if (report.missed_islands == 0 || report.residual <= kNotable * by_forces) return;
  world.note(&Notices::contacts_left_since, world.clock.time);
  double& left = world.sums.notices.contacts_left;
  left = std::max(left, report.residual);
}

}  // namespace

double RestingContacts::rest_speed(const World& world, int a, int b, const Vec2& point, const Vec2& normal,
                                   double restitution) const {
  return pressing_.rest_speed(world, pressing_.between(world, memory_, a, b, point, normal), restitution);
}

void RestingContacts::begin_step(World& world, double h) {
  step_length_ = std::max(h, world.method.step);
  linear_.begin_part(world.clock.time, step_length_);  // a step is found from its start alone
  world.trajectories.begin(world.clock.time);
}

void RestingContacts::take_off_forces(World& world) {
  for (const int i : memory_.pushed) world.trajectories.set_contact_acceleration(i, Eigen::Vector3d::Zero());
  memory_.pushed.clear();
  world.trajectories.end_contact_rates();
}

void RestingContacts::support(World& world, double h, bool may_divide) {
  take_off_forces(world);
  find_contacts(world, h);
  supported_ = h;
  if (may_divide) {
    supported_ = first_break(world, found_.contacts, h);
    find_discs_near_ends(world, found_, supported_, near_ends_);
    if (!near_ends_.empty()) {
      push_as_before(world);
      supported_ = first_face_end(world, near_ends_, finder_.neighbours(), supported_);
      take_off_forces(world);
    }
    if (supported_ < h) find_contacts(world, supported_);
  }
  linear_.begin_part(world.trajectories.epoch(), step_length_);
  double holds = hold(world, supported_, may_divide ? 0.0 : kWhole * supported_);
  for (int round = 1; may_divide && holds < kWhole * supported_; ++round) {
    supported_ = holds;
    take_off_forces(world);
    find_contacts(world, supported_);
    holds = hold(world, supported_, round < kMostEnds ? 0.0 : kAbout * supported_);
    if (round == kMostEnds) break;
  }
}

void RestingContacts::find_contacts(World& world, double h) {
  pressing_.find(world, step_length_, memory_);
  finder_.find(world, step_length_, h, pressing_, memory_, found_);
}

int RestingContacts::support_part(World& world, double step, int left) {
  take_off_forces(world);
  const double unit = step / kMostParts;
  const double whole = std::max(step, world.method.step) / step;
  step_length_ = whole * left * unit;
  find_contacts(world, left * unit);
  const int parts = std::min(left, parts_at_once(world, unit));
  if (parts < left) {
    step_length_ = whole * parts * unit;
    find_contacts(world, parts * unit);
  }
  hold(world, parts * unit, kWhole * parts * unit);
  return parts;
}

// For how many parts of h s the contacts found may be trusted, a power of two: until bodies have moved or
// turned so far against each other that other contacts, or other normals, are likely.
int RestingContacts::parts_at_once(const World& world, double h) {
  const Contacts& c = found_.contacts;
  partners_.assign(static_cast<std::size_t>(world.bodies()), 0);
  for (int i = 0; i < c.size(); ++i) {
    if (i > 0 && c.a[i - 1] == c.a[i] && c.b[i - 1] == c.b[i]) continue;
    ++partners_[static_cast<std::size_t>(c.a[i])];
    ++partners_[static_cast<std::size_t>(c.b[i])];
  }
  const auto crowded = [&](int i) {
    return !world.infinite_mass(i) && partners_[static_cast<std::size_t>(i)] > 1;
  };
  double fastest = 0.0;  // 1/s: moving by the size, or turning by 1 rad
  for (int i = 0; i < c.size(); ++i) {
    const int a = c.a[i];
    const int b = c.b[i];
    const Vec2 moving = world.state.v.col(b).head<2>() - world.state.v.col(a).head<2>();
    double speed = moving.norm();
    const double size = smaller_size(world, a, b);
    for (const int k : {a, b}) {
      if (world.state.v(2, k) != 0.0) speed += std::abs(world.state.v(2, k)) * world.shapes().core_reach[k];
    }
    if (speed * h * kMostParts < c.gap[i]) continue;
    // Over an immovable body others may slide far without turning the contact.
    const bool free = !world.infinite_mass(a) && !world.infinite_mass(b);
    const RowVelocity u = contact_velocity(c, i, world.state.v);
    if (free || crowded(a) || crowded(b))
      fastest = std::max(fastest, (free ? moving.norm() : -u.normal) / size);
    for (const int k : {a, b}) {
      if (!world.shapes().is_disc(k)) fastest = std::max(fastest, std::abs(world.state.v(2, k)));
    }
  }
  int parts = kMostParts;
  while (parts > 1 && fastest * parts * h > kMostMotion) parts /= 2;
  return parts;
}

double RestingContacts::hold(World& world, double h, double least) {
  linear_.clear();
  memory_.forces.clear();
  memory_.support.clear();
  if (found_.contacts.size() == 0) {
    pressing_.update(world, memory_);
    return h;
  }
  prepared_ = false;
  read_velocities(world);
  project_penetrations(world);
  strike(world, h);
  read_velocities(world);
  stop_approaches(world, h);
  find_forces(world, h);
  const double holds = improve_forces(world, h, least);
  remember_forces(h);
  pressing_.update(world, memory_);
  return holds;
}

void RestingContacts::read_velocities(const World& world) {
  before_.resize(3, world.bodies());
  for (int i = 0; i < world.bodies(); ++i) before_.col(i) = world.trajectories.at_start(i).segment<3>(3);
}

void RestingContacts::prepare(const World& world) {
  prepare_contacts(world.mass(), found_.contacts,
                   {.most_exact = kMostExact,
                    .most_slow = kMostExactAtRest,
                    .slow_speed = kSlow * pressing_.change_by_forces(),
                    .motion = &world.state.v},
                   workspace_);
  prepared_ = true;
}

ContactSolverOptions RestingContacts::solver_options() const {
  const double by_forces = pressing_.change_by_forces();
  ContactSolverOptions options;
  const double rounding = 16.0 * kEpsilon * before_.topRows<2>().cwiseAbs().maxCoeff();
  options.tolerance = kContactTolerance * by_forces + rounding;
  options.large_sweeps = kLargeSweeps;
  options.large_contact_sweeps = kLargeContactSweeps;
  const int contacts = found_.contacts.size();
  if (static_cast<int>(found_.hits.size()) * kContactsPerHit < contacts)
    options.large_contact_sweeps = std::max(kLargeContactSweeps, kQuietSweeps * contacts);
  options.large_tolerance = kLargeRest * by_forces + rounding;
  options.large_motion = &before_;
  options.large_share = kLargeMotion;
  options.large_coarsest = kLargeSolved * by_forces + rounding;
  options.slip_speed = kStuck * by_forces + options.tolerance;
  return options;
}

// Projects positions out of penetrations that the contact forces don't remove; velocities stay.
void RestingContacts::project_penetrations(World& world) {
  Contacts& c = found_.contacts;
  double deepest = 0.0;  // of the size
  double size = 0.0;     // m, the least of a penetrating pair
  for (int i = 0; i < c.size(); ++i) {
    const double shallow =
        found_.is_new(i) ? 0.0
                         : kShallow * found_.press[static_cast<std::size_t>(i)] * step_length_ * step_length_;
    const double of_pair = world.shapes().size[c.a[i]] + world.shapes().size[c.b[i]];
    if (!(c.gap[i] < -std::max(shallow, 16.0 * kPenetration * of_pair))) continue;
    deepest = std::max(deepest, -c.gap[i] / of_pair);
    size = size > 0.0 ? std::min(size, of_pair) : of_pair;
  }
  if (!(deepest > 0.0)) return;
  prepare(world);
  if (has_large_island() && !(deepest > kLargePenetration)) return;
  ContactSolverOptions options = solver_options();
  options.tolerance = kPenetration * size;
  options.large_tolerance = kLargePenetration * size;
  options.large_motion = nullptr;
  project_prepared(world.mass(), c, deepest > kDeep ? kPenetrationFraction : 1.0, moved_, options, workspace_);
  const double before = world.field().potential_energy(world.state.q);
  for (int i = 0; i < world.state.size(); ++i) {
    if (world.infinite_mass(i) || moved_.col(i).isZero(0.0)) continue;
    world.trajectories.set_pose(i, world.trajectories.at_start(i).head<3>() + moved_.col(i));
    world.state.q.col(i) = world.trajectories.at_start(i).head<3>();
  }
  world.sums.ledger.penetration_correction += world.field().potential_energy(world.state.q) - before;
  keep_angular_momentum(world, c, workspace_.islands, moved_, bodies_);
  for (int k = 0; k < world.trajectories.islands(); ++k) {
    if (world.trajectories.is_jointed(world.trajectories.members(k).front())) world.restore_joints(k);
  }
  for (int i = 0; i < c.size(); ++i) c.gap[i] += contact_velocity(c, i, moved_).normal;
}

// The work of the contact forces is taken along the actual paths, with all impacts on the way. Under the
// Euler methods, whose paths are not those of their velocities, it is the work along the velocities without
// impacts.
void RestingContacts::record_forces(World& world, double passed, double share) {
  if (found_.contacts.size() == 0) return;
  moved_ = before_ + 0.5 * share * (after_ - before_);
  if (choice_of(kIntegrators, world.method.integrator).exact_under_gravity) {
    for (int i = 0; i < world.state.size(); ++i) {
      if (!world.infinite_mass(i) || world.model->is_kinematic(i))
        moved_.col(i) = (world.trajectories.at(i, passed).head<3>() - world.state.q.col(i)) / passed;
    }
  }
  record_support(world, found_.contacts, linear_, share, moved_, passed, flight_);
  linear_.record(world, passed);
}

// Solves the contacts from these velocities into after_. What static friction can't hold slides from the start,
// under kinetic friction: it is solved again.
ContactSolverReport RestingContacts::solve(const World& world, const Eigen::Matrix3Xd& from,
                                           const ContactSolverOptions& options) {
  Contacts& c = found_.contacts;
  sticks_ = c.sticks;
  ContactSolverReport report;
  for (int round = 0; round < kMostBreaks; ++round) {
    after_ = from;
    c.sticks = sticks_;
    report = solve_prepared(world.mass(), c, after_, options, workspace_);
    bool breaks = false;
    for (int i = 0; i < c.size(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (sticks_[k] == 0 || c.sticks[k] != 0 || !(c.static_friction[k] > c.kinetic_friction[k])) continue;
      if (!(c.normal_impulse[k] > 0.0)) continue;
      sticks_[k] = 0;
      breaks = true;
    }
    if (!breaks) break;
  }
  return report;
}

// Contacts that close, or would within the step, lose their closing speed now.
void RestingContacts::stop_approaches(World& world, double h) {
  Contacts& c = found_.contacts;
  const ContactSolverOptions options = solver_options();
  double worst = 0.0;
  for (int i = 0; i < c.size(); ++i) {
    if (!std::isfinite(c.target[i])) continue;
    c.target[i] = -std::max(c.gap[i], 0.0) / h;
    const double closing = c.target[i] - contact_velocity(c, i, before_).normal;
    const double press = found_.press[static_cast<std::size_t>(i)];
    if (found_.is_new(i) || closing > kGentle * press * step_length_) worst = std::max(worst, closing);
  }
  after_ = before_;
  if (worst > 2.0 * options.tolerance) {
    if (!prepared_) prepare(world);
    if (worst > 2.0 * (has_large_island() ? options.large_tolerance : options.tolerance)) {
      report_residual(world, solve(world, before_, options), pressing_.change_by_forces());
      moved_ = 0.5 * (before_ + after_);
      record_stops(world, c, moved_);
      for (int i = 0; i < world.bodies(); ++i) {
        if (world.infinite_mass(i) || after_.col(i) == before_.col(i)) continue;
        world.trajectories.set_velocity(i, after_.col(i).head<2>(), after_(2, i));
      }
      before_ = after_;
    }
  }
  for (int i = 0; i < c.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    memory_.forces.push_back({c.a[i], c.b[i], found_.id[k], found_.point[k], c.normal[i],
                              c.normal_impulse[i] / h, c.tangential_impulse[i] / h, c.rolling_impulse[i] / h,
                              true});
  }
}

// Puts the accelerations by the last contact forces on the trajectories.
void RestingContacts::push_as_before(World& world) {
  const Contacts& c = found_.contacts;
  const int n = world.bodies();
  flight_.by.setZero(3, n);
  flight_.press.setZero(n);
  std::vector<int>& pushed = memory_.pushed;
  for (int i = 0; i < c.size(); ++i) {
    const Eigen::Vector3d& guess = found_.guess[static_cast<std::size_t>(i)];
    const Vec2 force = guess[0] * c.normal[i] + guess[1] * crossed(c.normal[i]);
    const auto push = [&](int body, double sign, const Vec2& arm) {
      flight_.by.col(body).head<2>() += sign * world.mass().inverse_mass[body] * force;
      flight_.by(2, body) += sign * world.mass().inverse_inertia[body] * (cross(arm, force) + guess[2]);
      flight_.press[body] = std::max(flight_.press[body], std::abs(found_.press[static_cast<std::size_t>(i)]));
      if (!world.infinite_mass(body)) pushed.push_back(body);
    };
    push(c.a[i], -1.0, c.arm_a[i]);
    push(c.b[i], 1.0, c.arm_b[i]);
  }
  std::sort(pushed.begin(), pushed.end());
  pushed.erase(std::unique(pushed.begin(), pushed.end()), pushed.end());
  for (const int i : pushed) world.trajectories.set_contact_acceleration(i, flight_.by.col(i));
}

// The flight of bodies under the contact forces that are on the trajectories.
void RestingContacts::fly(World& world, double h) {
  const int n = world.bodies();
  flight_.position.resize(3, n);
  flight_.velocity = before_;
  for (int i = 0; i < n; ++i) flight_.position.col(i) = world.trajectories.at_start(i).head<3>();
  const auto move = [&](int i) {
    const Motion end = world.trajectories.at(i, h);
    flight_.position.col(i) = end.head<3>();
    flight_.velocity.col(i) = end.segment<3>(3);
  };
  for (const int i : memory_.pushed) move(i);
  for (int i = 0; i < n; ++i) {
    if (world.model->is_kinematic(i)) move(i);
  }
  free_ = flight_.velocity - h * flight_.by;
}

// Finds forces on the trajectories such that the velocities satisfy the contacts at the step's end. If the
// flight under these forces is far from the guessed one, they are the next guess.
void RestingContacts::find_forces(World& world, double h) {
  Contacts& c = found_.contacts;
  at_start_ = c;
  const ContactSolverOptions options = solver_options();
  ContactSolverReport report;
  const int most = c.size() <= kFewContacts ? kMostGuesses : kMostGuessesOfMany;
  for (int guess = 0; guess < most; ++guess) {
    if (guess > 0) {
      for (int i = 0; i < c.size(); ++i) {
        found_.guess[static_cast<std::size_t>(i)] =
            Eigen::Vector3d(c.normal_impulse[i], c.tangential_impulse[i], c.rolling_impulse[i]) / h;
      }
      c = at_start_;
      for (const int i : memory_.pushed) flight_.by.col(i) = (after_.col(i) - free_.col(i)) / h;
    } else {
      push_as_before(world);
    }
    fly(world, h);
    turn_contacts(world, h, flight_, finder_.neighbours(), found_);
    prepare(world);
    report = solve_flight(world, h, options);
    if (has_large_island()) break;
    double off = 0.0;
    for (const int i : memory_.pushed) {
      const Eigen::Vector3d by = after_.col(i) - flight_.velocity.col(i);
      off = std::max(off, by.head<2>().norm() + std::abs(by[2]) * world.shapes().size[i]);
    }
    if (off <= kGuessed * pressing_.change_by_forces()) break;
  }
  report_residual(world, report, pressing_.change_by_forces());
}

// Replaces the constant forces by linear ones where that is of a higher order. Returns for how long their
// contacts stay what they are.
double RestingContacts::improve_forces(World& world, double h, double least) {
  const int order = choice_of(kIntegrators, world.method.integrator).order;
  if (order == 1 || order == 2) return h;
  const ContactSolverOptions options = solver_options();
  return linear_.improve(world, h, finder_.neighbours(), options.tolerance, options.slip_speed,
                         workspace_.islands, least, found_);
}

void RestingContacts::remember_forces(double h) {
  const Contacts& c = found_.contacts;
  for (int i = 0; i < c.size(); ++i) {
    const Eigen::Vector3d by =
        Eigen::Vector3d(c.normal_impulse[i], c.tangential_impulse[i], c.rolling_impulse[i]) / h;
    ContactForce& f = memory_.forces[static_cast<std::size_t>(i)];
    f.normal = c.normal[i];
    f.normal_force += by[0];
    f.tangential_force += by[1];
    f.rolling_moment += by[2];
    f.sticks = c.sticks[i] != 0;
    const Eigen::Vector3d& guess = found_.guess[static_cast<std::size_t>(i)];
    memory_.support.push_back(guess + h / step_length_ * (by - guess));
  }
}

// The impulses with which the flight from the guess on satisfies the contacts, and their accelerations on the
// trajectories.
ContactSolverReport RestingContacts::solve_flight(World& world, double h, const ContactSolverOptions& options) {
  Contacts& c = found_.contacts;
  for (int i = 0; i < c.size(); ++i) {
    const Eigen::Vector3d impulse = h * found_.guess[static_cast<std::size_t>(i)];
    c.normal_impulse[i] = impulse[0];
    c.tangential_impulse[i] = impulse[1];
    c.rolling_impulse[i] = impulse[2];
  }
  ContactSolverReport report;
  for (int round = 0; round < kMostRounds; ++round) {
    report = solve(world, free_, options);
    for (const int i : memory_.pushed)
      world.trajectories.set_contact_acceleration(i, (after_.col(i) - free_.col(i)) / h);
    if (world.trajectories.is_parabolic()) break;
    double off = 0.0;
    for (const int i : memory_.pushed) {
      const Eigen::Vector3d by = world.trajectories.at(i, h).segment<3>(3) - after_.col(i);
      off = std::max(off, by.head<2>().norm());
      free_.col(i) += by;
    }
    if (off <= options.tolerance) break;
    report.residual = std::max(report.residual, off);
    if (round == kMostRounds - 1) ++report.missed_islands;
  }
  return report;
}

void RestingContacts::release(World& world) {
  take_off_forces(world);
  *this = {};
}

}  // namespace carom
