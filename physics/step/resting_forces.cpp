#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "physics/contact/contact_velocity.h"
#include "physics/dynamics/integrators/integrators.h"
#include "physics/math/sort_unique.h"
#include "physics/math/vectors.h"
#include "physics/step/contact_work.h"
#include "physics/step/pair_motion.h"
#include "physics/step/resting_contacts.h"
#include "physics/step/stop_with_joints.h"

// The forces of resting contacts: what stops approaches, constant forces, and linear ones in their place.
namespace carom {
namespace {

// Of what presses a contact in a step: the contact forces end slower approaches of supported contacts.
constexpr double kGentle = 0.1;
// Likewise where bodies have been hit.
constexpr double kGentleHit = 1e-3;
// Of the hardest hit that is stopped: impulses by which contacts pass it on.
constexpr double kPassedOn = 1e-3;
// Times the tolerance of the velocities: contacts that slip.
constexpr double kSlips = 4.0;
// Guesses of the contact forces in a step, until the flight under them has end velocities that are off by at
// most kGuessed of the change of a speed by forces.
constexpr int kFewContacts = 16;
int most_guesses(int contacts) {
  if (contacts <= kFewContacts) return 6;
  return contacts <= kFewContactsOfScene ? 4 : 2;
}
constexpr double kGuessed = 1e-9;
// Likewise where linear forces are to replace them, which find out themselves what the contacts do, for so many
// contacts at most.
constexpr double kRoughlyGuessed = 1e-4;
constexpr int kMostRough = 4;
// Of a body's acceleration by other forces: so much counts as pressing it, so that a change of its speed by no
// more than those forces make is not sudden (see turn_contacts).
constexpr double kHeld = 1.0 / 30.0;
// Rounds in which contacts break away from static friction in one step.
constexpr int kMostBreaks = 3;
// A residual of so much of the change of a speed by forces is no solution; nor is a round of these that leaves
// one, if it is so many times larger than that of the round before.
constexpr double kUnsolved = 0.01;
constexpr double kWorse = 16.0;
// Corrections of the contact forces where the integrator's flight is not linear in them; joints take as many.
constexpr int kMostRounds = AndersonMixing::kMixed + 60;
// Of the full moment of rolling resistance: a difference from it.
constexpr double kFullMoment = 1e-9;
// Of the change of a speed by forces in a step: a smaller residual is not worth a notice.
constexpr double kNotable = 1e-6;
// Times the solver's tolerance, likewise, where no forces act.
constexpr double kNotableRounding = 1e3;

// s: when the first of the contacts that stop rolling within h does so, or rolls back from then on; h if none
// does. The solver gives such a contact one moment for all of h, which acts too weakly, or the wrong way, until
// then. `before` and `after` are the velocities at the start and the end; what rolls slower than `still` (m/s,
// at the size of the smaller body) does not.
double rolling_ends(const World& world, const Contacts& c, const Eigen::Matrix3Xd& before,
                    const Eigen::Matrix3Xd& after, double h, double still) {
  double first = h;
  for (int i = 0; i < c.size(); ++i) {
    const double full = c.rolling[i] * c.normal_impulse[i];
    if (!(full > 0.0)) continue;
    const double spin = contact_velocity(c, i, before).spin;
    const double rolls = std::abs(spin);
    if (!(rolls * smaller_size(world, c.a[i], c.b[i]) > still)) continue;
    const double missing = full + std::copysign(1.0, spin) * c.rolling_impulse[i];
    if (!(missing > kFullMoment * full)) continue;
    const double stops = rolls - std::copysign(1.0, spin) * contact_velocity(c, i, after).spin;
    double gives_way = 0.0;  // 1/(kg m²)
    for (const auto& [body, arm] : {std::pair(c.a[i], c.arm_a[i]), std::pair(c.b[i], c.arm_b[i])}) {
      if (!(world.mass().inverse_inertia[body] > 0.0)) continue;
      const double slides_too = c.sticks[i] != 0 ? arm.squaredNorm() * world.mass().mass[body] : 0.0;
      gives_way += 1.0 / (world.mass().inertia[body] + slides_too);
    }
    first = std::min(first, h * rolls / (stops + gives_way * missing));
  }
  return first;
}

void report_residual(World& world, const ContactSolverReport& report, double by_forces, double tolerance) {
  if (report.missed_islands == 0 || report.residual <= kNotable * by_forces + kNotableRounding * tolerance)
    return;
  world.note(&Notices::contacts_left_since, world.clock.time);
  double& left = world.sums.notices.contacts_left;
  left = std::max(left, report.residual);
}

// The bodies that these contacts may move, in rising order.
void list_moved(const World& world, const Contacts& c, std::vector<BodyIndex>& bodies) {
  for (int i = 0; i < c.size(); ++i) {
    for (const BodyIndex body : {c.a[i], c.b[i]}) {
      if (!world.infinite_mass(body)) bodies.push_back(body);
    }
  }
  sort_unique(bodies);
}

}  // namespace

// Solves the contacts from these velocities into after_. What static friction can't hold slides from the start,
// under kinetic friction: it is solved again.
ContactSolverReport RestingContacts::solve(const World& world, const Eigen::Matrix3Xd& from,
                                           const ContactSolverOptions& options) {
  Contacts& c = found_.contacts;
  sticks_ = c.sticks;
  const auto once = [&] {
    after_ = from;
    c.sticks = sticks_;
    return solve_prepared(world.mass(), c, after_, options, workspace_);
  };
  // m/s: bodies that come back onto their surfaces slip so fast at most.
  const Eigen::Map<const Eigen::VectorXd> returns(found_.returns.data(), c.size());
  const double coming_back = c.size() <= GaussStep::kFew ? returns.lpNorm<1>() : 0.0;
  ContactSolverReport report;
  for (int round = 0; round < kMostBreaks; ++round) {
    const ContactSolverReport now = once();
    if (round > 0 && is_unsolved(now) && now.residual > kWorse * report.residual) {
      c = solved_;
      after_ = solved_after_;
      return report;
    }
    report = now;
    const double still = kSlips * options.tolerance;
    list_breaking(still + coming_back);
    if (breaking_.empty() && coming_back > 0.0) {
      list_breaking(still);
      if (breaking_.empty()) break;
      // What only comes back does not break away.
      Eigen::Map<Eigen::VectorXd> targets(c.target.data(), c.size());
      targets -= returns;
      once();
      list_breaking(still);
      targets += returns;
      if (breaking_.empty()) return once();
    }
    if (breaking_.empty()) break;
    solved_ = c;
    solved_after_ = after_;
    for (const int i : breaking_) sticks_[static_cast<std::size_t>(i)] = 0;
  }
  return report;
}

// The contacts whose static friction is full and that slip faster than `still` (m/s): those at their limit may
// be held by others.
void RestingContacts::list_breaking(double still) {
  const Contacts& c = found_.contacts;
  breaking_.clear();
  for (int i = 0; i < c.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const bool full = sticks_[k] != 0 && c.sticks[k] == 0 && c.static_friction[k] > c.kinetic_friction[k] &&
                      c.normal_impulse[k] > 0.0;
    if (full && (!is_few() || std::abs(contact_velocity(c, i, after_).tangential) > still))
      breaking_.push_back(i);
  }
}

// Which contacts are stopped by an impact without rebound, as they closed faster than forces have just made
// them, and which pass it on. Where impacts are not located in time, a landing takes more than one step.
void RestingContacts::find_impacts(const World& world) {
  const Contacts& c = found_.contacts;
  impacts_.assign(static_cast<std::size_t>(c.size()), std::nullopt);
  if (world.method.impacts != ImpactsId::kLocated) return;
  const auto closing = [&](int i) { return -contact_velocity(c, i, before_).normal; };
  double hardest = 0.0;  // N s
  for (int i = 0; i < c.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double rest = found_.rest[k];
    const bool lands = finder_.is_kept({c.a[i], c.b[i], found_.id[k]});
    const double gentle = lands ? rest : kGentlyClosed * pressing_.pressed_speed(c.a[i], c.b[i], rest);
    if (!(closing(i) > gentle) || !(c.normal_impulse[i] > 0.0)) continue;
    impacts_[k] = closing(i);
    hardest = std::max(hardest, c.normal_impulse[i]);
  }
  if (hardest == 0.0) return;
  for (int i = 0; i < c.size(); ++i) {
    if (c.normal_impulse[i] >= kPassedOn * hardest) impacts_[static_cast<std::size_t>(i)] = closing(i);
  }
}

// Contacts that close, or would within the step, lose their closing speed now. Whether any did.
bool RestingContacts::stop_approaches(World& world, double h) {
  Contacts& c = found_.contacts;
  const ContactSolverOptions options = solver_options();
  const double gentle = hit_ ? kGentleHit : kGentle;
  double worst = 0.0;
  for (int i = 0; i < c.size(); ++i) {
    if (!std::isfinite(c.target[i])) continue;
    c.target[i] = -found_.room(i) / h;
    const double closing = c.target[i] - contact_velocity(c, i, before_).normal;
    const double press = found_.press[static_cast<std::size_t>(i)];
    if (found_.is_new(i) || closing > gentle * press * step_length_) worst = std::max(worst, closing);
  }
  after_ = before_;
  bool stopped = false;
  if (worst > 2.0 * options.tolerance) {
    if (!prepared_) prepare(world);
    if (worst > 2.0 * (has_large_island() ? options.large_tolerance : options.tolerance)) {
      const auto solve_from = [&](const Eigen::Matrix3Xd& from) { return solve(world, from, options); };
      bodies_.clear();
      list_moved(world, c, bodies_);
      JumpsOfMoment jumps(world, 0.0);
      const ContactSolverReport report =
          world.trajectories.is_jointed(bodies_)
              ? stop_with_joints(world, bodies_, before_, options.tolerance, solve_from, free_, after_)
              : solve_from(before_);
      report_residual(world, report, pressing_.change_by_forces(), options.tolerance);
      for (BodyIndex i{0}; i < world.bodies(); ++i) {
        if (world.infinite_mass(i) || after_.col(i) == before_.col(i)) continue;
        world.trajectories.set_velocity(i, after_.col(i).head<2>(), after_.col(i)[2]);
        world.state.v.col(i) = after_.col(i);
      }
      moved_ = 0.5 * (before_ + after_);
      find_impacts(world);
      record_stops(world, found_, impacts_, moved_, jumps);
      before_ = after_;
      stopped = true;
    }
  }
  for (int i = 0; i < c.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    memory_.forces.push_back({c.a[i], c.b[i], found_.id[k], found_.point[k], c.normal[i],
                              c.normal_impulse[i] / h, c.tangential_impulse[i] / h, c.rolling_impulse[i] / h,
                              true});
  }
  return stopped;
}

// Puts the accelerations by the last contact forces on the trajectories.
void RestingContacts::push_as_before(World& world) {
  const Contacts& c = found_.contacts;
  const int n = world.bodies();
  flight_.by.setZero(3, n);
  flight_.press.setZero(n);
  std::vector<BodyIndex>& pushed = memory_.pushed;
  for (int i = 0; i < c.size(); ++i) {
    const Eigen::Vector3d& guess = found_.guess[static_cast<std::size_t>(i)];
    const Vec2 force = guess[0] * c.normal[i] + guess[1] * crossed(c.normal[i]);
    const double press = std::abs(found_.press[static_cast<std::size_t>(i)]) + turning_press(world, c, i);
    const auto push = [&](BodyIndex body, double sign, const Vec2& arm) {
      flight_.by.col(body).head<2>() += sign * world.mass().inverse_mass[body] * force;
      flight_.by.col(body)[2] += sign * world.mass().inverse_inertia[body] * (cross(arm, force) + guess[2]);
      flight_.press[body] = std::max(flight_.press[body], press);
    };
    push(c.a[i], -1.0, c.arm_a[i]);
    push(c.b[i], 1.0, c.arm_b[i]);
  }
  list_moved(world, c, pushed);
  for (const BodyIndex i : pushed) {
    // What nothing pressed before may be held by its contacts now.
    flight_.press[i] = std::max(flight_.press[i], kHeld * pressing_.acceleration(i));
    world.trajectories.set_contact_acceleration(i, flight_.by.col(i));
  }
}

// The flight of bodies under the contact forces that are on the trajectories.
void RestingContacts::fly(World& world, double h) {
  const int n = world.bodies();
  flight_.position.resize(3, n);
  flight_.velocity = before_;
  for (BodyIndex i{0}; i < n; ++i) flight_.position.col(i) = world.trajectories.at_start(i).head<3>();
  const auto move = [&](BodyIndex i) {
    const Motion end = world.trajectories.at(i, h);
    flight_.position.col(i) = end.head<3>();
    flight_.velocity.col(i) = end.segment<3>(3);
  };
  for (const BodyIndex i : memory_.pushed) move(i);
  for (BodyIndex i{0}; i < n; ++i) {
    if (world.model->is_kinematic(i)) move(i);
  }
  flight_.pose.resize(static_cast<std::size_t>(n));
  for (BodyIndex i{0}; i < n; ++i)
    flight_.pose[static_cast<std::size_t>(i)] = world.shapes().pose(i, flight_.position.col(i));
  free_ = flight_.velocity - h * flight_.by;
}

// As guess_forces(), without guessed forces, from which contacts turn: where those press jammed bodies hard,
// the guessed flight is far off.
ContactSolverReport RestingContacts::solve_going_straight_on(World& world, double h,
                                                             const ContactSolverOptions& options) {
  found_.contacts = at_start_;
  std::fill(found_.guess.begin(), found_.guess.end(), Eigen::Vector3d::Zero());
  push_as_before(world);
  fly(world, h);
  flight_.goes_on.assign(static_cast<std::size_t>(world.bodies()), 0);
  turn_contacts(world, h, flight_, finder_.neighbours(), found_);
  prepare(world);
  return solve_flight(world, h, options);
}

bool RestingContacts::is_unsolved(const ContactSolverReport& report) const {
  return report.missed_islands > 0 && report.residual > kUnsolved * pressing_.change_by_forces();
}

// Finds the forces of a part of h s, constant or linear, on the trajectories. Returns for how long their
// contacts stay what they are.
double RestingContacts::find_forces(World& world, double h, double least) {
  const double holds = find_best_forces(world, h, least);
  if (!linear_.replaces_all(found_.contacts))
    report_residual(world, guessed_, pressing_.change_by_forces(), solver_options().tolerance);
  return holds;
}

// Likewise: at first by rough guesses, where linear forces are likely to replace them.
double RestingContacts::find_best_forces(World& world, double h, double least) {
  at_start_ = found_.contacts;
  support_before_ = found_.guess;
  if (may_guess_roughly(world)) {
    const double off = guess_forces(world, h, kRoughlyGuessed);
    const double holds = improve_forces(world, h, least);
    if (off <= kGuessed * pressing_.change_by_forces() || linear_.replaces_all(found_.contacts)) return holds;
    found_.contacts = at_start_;
    found_.guess = support_before_;
    take_off_forces(world);
  }
  guess_forces(world, h, kGuessed);
  return improve_forces(world, h, least);
}

// Whether linear forces are likely to replace constant ones that are not found at once: those of few contacts
// that do not roll, nor break away from a larger friction.
bool RestingContacts::may_guess_roughly(const World& world) const {
  const Contacts& c = found_.contacts;
  if (c.size() > kMostRough || choice_of(kIntegrators, world.method.integrator).order <= 2) return false;
  for (int i = 0; i < c.size(); ++i) {
    if (c.static_friction[i] > c.kinetic_friction[i] || c.rolling[i] > 0.0) return false;
  }
  return true;
}

// Finds constant forces on the trajectories such that the velocities satisfy the contacts at the step's end. If
// the flight under these forces is far from the guessed one, they are the next guess, until they are off by at
// most `accuracy` of the change of a speed by forces. Returns how far they are off, in m/s.
double RestingContacts::guess_forces(World& world, double h, double accuracy) {
  Contacts& c = found_.contacts;
  const ContactSolverOptions options = solver_options();
  double off = std::numeric_limits<double>::infinity();
  ContactSolverReport report;
  const int most = most_guesses(c.size());
  for (int guess = 0; guess < most; ++guess) {
    if (guess > 0) {
      for (int i = 0; i < c.size(); ++i) {
        found_.guess[static_cast<std::size_t>(i)] =
            Eigen::Vector3d(c.normal_impulse[i], c.tangential_impulse[i], c.rolling_impulse[i]) / h;
      }
      c = at_start_;
      for (const BodyIndex i : memory_.pushed) flight_.by.col(i) = (after_.col(i) - free_.col(i)) / h;
    } else {
      push_as_before(world);
    }
    fly(world, h);
    note_going_on(world, h, flight_);
    turn_contacts(world, h, flight_, finder_.neighbours(), found_);
    prepare(world);
    report = solve_flight(world, h, options);
    if (has_large_island()) break;
    off = 0.0;
    for (const BodyIndex i : memory_.pushed) {
      const Eigen::Vector3d by = after_.col(i) - flight_.velocity.col(i);
      off = std::max(off, by.head<2>().norm() + std::abs(by[2]) * world.shapes().size[i]);
    }
    if (off <= accuracy * pressing_.change_by_forces()) break;
  }
  if (!has_large_island() && is_unsolved(report)) report = solve_going_straight_on(world, h, options);
  guessed_ = report;
  return off;
}

// Replaces the constant forces by linear ones where those are better. Returns for how long their contacts stay
// what they are.
double RestingContacts::improve_forces(World& world, double h, double least) {
  const int order = choice_of(kIntegrators, world.method.integrator).order;
  if (order == 1) return h;
  const ContactSolverOptions options = solver_options();
  const double holds = linear_.improve(world, h, finder_.neighbours(), options.tolerance, options.slip_speed,
                                       workspace_.islands, least, found_);
  // In a pile something stops rolling nearly always: to follow it costs more than it is worth.
  if (found_.contacts.size() > kFewContacts) return holds;
  const double rolls = rolling_ends(world, found_.contacts, before_, after_, h, options.slip_speed);
  return rolls < least ? holds : std::min(holds, rolls);
}

void RestingContacts::remember_forces(const World& world, double h) {
  const Contacts& c = found_.contacts;
  // In a crowd what acts for a short time supports little: it may be stopping what closes.
  const std::vector<Eigen::Vector3d>& supports = moves_few(world) ? found_.guess : support_before_;
  for (int i = 0; i < c.size(); ++i) {
    const Eigen::Vector3d by =
        Eigen::Vector3d(c.normal_impulse[i], c.tangential_impulse[i], c.rolling_impulse[i]) / h;
    ContactForce& f = memory_.forces[static_cast<std::size_t>(i)];
    f.normal = c.normal[i];
    f.normal_force += by[0];
    f.tangential_force += by[1];
    f.rolling_moment += by[2];
    f.sticks = c.sticks[i] != 0;
    const Eigen::Vector3d& before = supports[static_cast<std::size_t>(i)];
    memory_.support.push_back(before + h / step_length_ * (by - before));
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
  const auto unknowns = 3 * static_cast<Eigen::Index>(memory_.pushed.size());
  off_.resize(unknowns);
  mixing_.start(unknowns);
  for (int round = 0; round < kMostRounds; ++round) {
    report = solve(world, free_, options);
    for (const BodyIndex i : memory_.pushed)
      world.trajectories.set_contact_acceleration(i, (after_.col(i) - free_.col(i)) / h);
    if (world.trajectories.is_parabolic()) break;
    double off = 0.0;
    for (std::size_t k = 0; k < memory_.pushed.size(); ++k) {
      const BodyIndex i = memory_.pushed[k];
      const Eigen::Vector3d by = world.trajectories.at(i, h).segment<3>(3) - after_.col(i);
      off = std::max(off, by.head<2>().norm());
      off_.segment<3>(3 * static_cast<Eigen::Index>(k)) = by;
    }
    const Eigen::VectorXd& change = mixing_.change(off_);
    for (std::size_t k = 0; k < memory_.pushed.size(); ++k)
      free_.col(memory_.pushed[k]) += change.segment<3>(3 * static_cast<Eigen::Index>(k));
    if (off <= options.tolerance) break;
    report.residual = std::max(report.residual, off);
    if (round == kMostRounds - 1) ++report.missed_islands;
  }
  return report;
}

}  // namespace carom
