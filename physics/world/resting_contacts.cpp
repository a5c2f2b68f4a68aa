#include "physics/world/resting_contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/collision/pair_contact.h"
#include "physics/collision/time_of_impact.h"
#include "physics/dynamics/integrators/integrators.h"
#include "physics/math/vectors.h"
#include "physics/scene/drive.h"
#include "physics/world/apply_impact.h"
#include "physics/world/pair_motion.h"
#include "physics/world/penetrations.h"

namespace carom {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
// Tolerance of the contact forces, relative to the change of a speed by forces in a step.
constexpr double kSolved = 1e-10;
// Likewise: a contact that slips slower than this sticks.
constexpr double kStuck = 1e-6;
// Relative to the size: a smaller penetration is rounding, and one beyond kDeep is removed in several steps.
constexpr double kPenetration = 1e-12;
constexpr double kDeep = 1e-3;
// Number of contacts up to which an island is solved exactly: always, or if its rms velocity is at most kSlow
// of the change of a speed by forces in a step. A large island has the tolerance kLargeMotion of its speeds,
// at most kLargeSolved of that change: as it comes to rest its solution improves, each step starting from the
// forces of the one before.
constexpr int kMostExact = 64;
constexpr int kMostExactAtRest = 400;
constexpr double kSlow = 1e-5;
constexpr double kLargeMotion = 0.1;
constexpr double kLargeSolved = 1e-2;
constexpr double kLargeRest = 1e-9;
constexpr double kLargePenetration = 1e-6;  // relative to the size
// Sweeps over a large island; more while contacts times sweeps stay below kLargeContactSweeps.
constexpr int kLargeSweeps = 20;
constexpr int kLargeContactSweeps = 10'000;
// Corrections of the contact forces where the integrator's flight is not linear in them.
constexpr int kMostRounds = 12;
// Initial capacity for contacts.
constexpr int kFewContacts = 64;

// Relative velocity at a contact for the velocities v of all bodies.
RowVelocity velocity_at(const Contacts& c, int i, const Eigen::Matrix3Xd& v) {
  const Eigen::Vector3d a = v.col(c.a[i]);
  const Eigen::Vector3d b = v.col(c.b[i]);
  const Vec2 n = c.normal[i];
  const Vec2 d = (b - a).head<2>();
  return {d.dot(n) + b[2] * cross(c.arm_b[i], n) - a[2] * cross(c.arm_a[i], n),
          cross(n, d) + b[2] * c.arm_b[i].dot(n) - a[2] * c.arm_a[i].dot(n), b[2] - a[2]};
}

// m: radius of the disc that would roll on a plane as these two roll on each other; 0 if neither is a disc.
double rolling_radius(const Geometry& shapes, int a, int b) {
  double curvature = 0.0;
  for (const int i : {a, b}) {
    if (shapes.is_disc(i) && shapes.shapes.rounding[i] > 0.0) curvature += 1.0 / shapes.shapes.rounding[i];
  }
  return curvature > 0.0 ? 1.0 / curvature : 0.0;
}

void report_residual(World& world, const ContactSolverReport& report) {
  if (report.missed_islands == 0) return;
  world.note(&Notices::contacts_left_since, world.clock.time);
  double& left = world.sums.notices.contacts_left;
  left = std::max(left, report.residual);
}

}  // namespace

double RestingContacts::rest_speed(const World& world, int a, int b, const Vec2& normal,
                                   double restitution) const {
  const Eigen::Matrix3Xd& by = acceleration_;
  double press = std::max(0.0, -normal.dot((by.col(b) - by.col(a)).head<2>()));
  for (const int i : {a, b}) {
    if (memory_.held[i] != 0) press = std::max(press, by.col(i).head<2>().norm());
  }
  if (!(press > 0.0)) return kRestSpeed;
  double share = 1.0;
  // Explicit Euler's rebounds don't die out below this.
  if (world.method.integrator == IntegratorId::kExplicitEuler && restitution < 1.0)
    share = std::clamp(kRestRebound * restitution / (1.0 - restitution), 1.0, kMostRestRebound);
  return std::max(kRestSpeed, share * press * step_length_);
}

void RestingContacts::begin_step(World& world, double h) {
  step_length_ = std::max(h, world.method.step);
  world.trajectories.begin(world.clock.time);
}

void RestingContacts::support(World& world, double h) {
  const int n = world.bodies();
  for (const int i : memory_.pushed) world.trajectories.set_contact_acceleration(i, Eigen::Vector3d::Zero());
  memory_.pushed.clear();
  acceleration_.setZero(3, n);
  for (int i = 0; i < n; ++i) {
    if (!world.infinite_mass(i)) {
      acceleration_.col(i) = world.trajectories.acceleration(i);
    } else if (world.model->is_kinematic(i)) {
      acceleration_.col(i).head<2>() = drive_acceleration(world.model->drive(i), world.trajectories.epoch());
    }
  }
  memory_.held.resize(n, 0);
  find_contacts(world, h);
  prepare_contacts(world.mass(), contacts_,
                   {.most_exact = kMostExact,
                    .most_slow = kMostExactAtRest,
                    .slow_speed = kSlow * change_by_forces(),
                    .motion = &world.state.v},
                   workspace_);
  project_penetrations(world);
  stop_approaches(world, h);
  find_forces(world, h);
}

// Fills the contacts of this step, with the last forces of the previous step as initial guess.
void RestingContacts::find_contacts(World& world, double h) {
  const int n = world.bodies();
  const ConvexShapes& convex = world.shapes().shapes;
  // Part of a step looks as far as a whole step, so that no contact is forgotten.
  const double whole = step_length_;
  poses_.resize(n);
  reach_.resize(n);
  for (int i = 0; i < n; ++i) {
    const Eigen::Vector3d q = world.trajectories.at_start(i).head<3>();
    const Eigen::Vector3d v = world.trajectories.at_start(i).segment<3>(3);
    const double turning = v[2] != 0.0 ? std::abs(v[2]) * convex.core_radius[i] : 0.0;
    reach_[i] = (v.head<2>().norm() + turning) * whole + acceleration_.col(i).head<2>().norm() * whole * whole;
    poses_[i] = pose_of(convex, i, q);
  }
  id_.clear();
  guess_.clear();
  point_.clear();
  near_.clear();
  supported_.clear();
  landings_.clear();
  std::size_t last = 0;  // of the previous forces
  for (const auto& [a, b] : near_pairs_.find(world, [&](int i) { return reach_[i]; })) {
    if (!world.shapes().can_collide(a, b)) continue;
    near_.emplace_back(a, b);
    const double size = world.shapes().size[a] + world.shapes().size[b];
    const double rounding = kPenetration * (size + world.trajectories.at_start(a).head<2>().lpNorm<1>() +
                                            world.trajectories.at_start(b).head<2>().lpNorm<1>());
    const Manifold m = manifold(convex, a, poses_[a], b, poses_[b], reach_[a] + reach_[b] + rounding);
    if (m.count == 0) continue;
    const auto& forces = memory_.forces;
    while (last < forces.size() && std::pair(forces[last].a, forces[last].b) < std::pair(a, b)) ++last;
    const std::size_t landings = landings_.size();
    add_contacts(world, a, b, m, rounding, h, last);
    // A pair without support is left to the event queue.
    if (supported_.empty() || supported_.back() != std::pair(a, b)) landings_.resize(landings);
  }
  contacts_.resize(static_cast<int>(id_.size()));
}

// The points of a manifold that rest, and those that will land; `last` is the pair's first previous force.
void RestingContacts::add_contacts(World& world, int a, int b, const Manifold& m, double rounding, double h,
                                   std::size_t last) {
  Contacts& c = contacts_;
  const auto& forces = memory_.forces;
  const Material& material = world.material(a, b);
  const double rest = rest_speed(world, a, b, m.normal, material.restitution);
  const bool located = world.method.impacts == ImpactsId::kLocated;
  for (int k = 0; k < m.count; ++k) {
    const ManifoldPoint& at = m.points[k];
    const int i = static_cast<int>(id_.size());
    if (i == c.size()) c.resize(std::max(kFewContacts, 2 * i));
    c.a[i] = a;
    c.b[i] = b;
    c.normal[i] = m.normal;
    c.arm_a[i] = at.point - poses_[a].position;
    c.arm_b[i] = at.point - poses_[b].position;
    c.gap[i] = at.gap;
    const RowVelocity u = velocity_at(c, i, world.state.v);
    const double closing = -u.normal;
    const bool slow = material.restitution * closing <= rest;
    // With impacts at their own time fast ones are left to the event queue.
    const bool open = at.gap > rounding;
    const bool near = !open || (at.gap <= (std::max(closing, 0.0) + rest) * step_length_ &&
                                (!located || closing <= 2.0 * rest));
    if (!near || (!slow && at.gap >= -rounding)) {
      if (located && open && closing > rest) landings_.push_back({a, b, at.id});
      continue;
    }
    // A fast one that penetrates is projected out and left to the impacts at the step's end.
    c.target[i] = slow ? -std::max(at.gap, 0.0) / h : -std::numeric_limits<double>::infinity();
    c.static_friction[i] = material.static_friction;
    c.kinetic_friction[i] = material.kinetic_friction;
    c.rolling[i] = material.rolling_resistance * rolling_radius(world.shapes(), a, b);
    c.sticks[i] = std::abs(u.tangential) <= kRestSpeed ? 1 : 0;
    c.normal_impulse[i] = c.tangential_impulse[i] = c.rolling_impulse[i] = 0.0;
    guess_.emplace_back(Eigen::Vector3d::Zero());
    for (std::size_t j = last; j < forces.size() && forces[j].a == a && forces[j].b == b; ++j) {
      if (forces[j].id != at.id) continue;
      c.sticks[i] = forces[j].sticks;
      guess_.back() = memory_.support[j];
    }
    id_.push_back(at.id);
    point_.push_back(at.point);
    if (slow && (supported_.empty() || supported_.back() != std::pair(a, b))) supported_.emplace_back(a, b);
  }
}

std::optional<LandingTime> RestingContacts::first_landing(World& world, double end) const {
  std::optional<LandingTime> first;
  double time = end;
  const ConvexShapes& convex = world.shapes().shapes;
  for (const Landing& landing : landings_) {
    const auto& [a, b, id] = landing;
    const auto gap = [&, a = a, b = b, id = id](double t) {
      const Manifold m = manifold(convex, a, pose_of(convex, a, world.trajectories.at(a, t).head<3>()), b,
                                  pose_of(convex, b, world.trajectories.at(b, t).head<3>()),
                                  std::numeric_limits<double>::infinity());
      for (int k = 0; k < m.count; ++k) {
        if (m.points[k].id == id) return m.points[k].gap;
      }
      return world.shapes().size[a] + world.shapes().size[b];
    };
    const double at_start = gap(0.0);
    const double at_end = gap(time);
    if (!(at_start > 0.0 && at_end < 0.0)) continue;
    time = bracketed_root(gap, 0.0, at_start, time, at_end);
    first = {landing, time};
  }
  return first;
}

void RestingContacts::land(World& world, const LandingTime& landing) const {
  const auto& [a, b, id] = landing.landing;
  const Approach at = world.approach(a, b, touch_tolerance(world, a, b, landing.time));
  const Material& material = world.material(a, b);
  if (material.restitution * -at.speed > rest_speed(world, a, b, at.contact.normal, material.restitution))
    apply_impact(world, a, b, at.contact, material, landing.time);
}

ContactSolverOptions RestingContacts::solver_options() const {
  const double by_forces = change_by_forces();
  ContactSolverOptions options;
  const double rounding = 16.0 * kEpsilon * before_.topRows<2>().cwiseAbs().maxCoeff();
  options.tolerance = kSolved * by_forces + rounding;
  options.large_sweeps = kLargeSweeps;
  options.large_contact_sweeps = kLargeContactSweeps;
  options.large_tolerance = kLargeRest * by_forces + rounding;
  options.large_motion = &before_;
  options.large_share = kLargeMotion;
  options.large_coarsest = kLargeSolved * by_forces + rounding;
  options.slip_speed = kStuck * by_forces + options.tolerance;
  return options;
}

// Projects positions out of penetrations; velocities stay.
void RestingContacts::project_penetrations(World& world) {
  double deepest = 0.0;  // of the size
  double size = 0.0;     // m, the least of a penetrating pair
  for (int i = 0; i < contacts_.size(); ++i) {
    if (!(contacts_.gap[i] < 0.0)) continue;
    const double of_pair = world.shapes().size[contacts_.a[i]] + world.shapes().size[contacts_.b[i]];
    deepest = std::max(deepest, -contacts_.gap[i] / of_pair);
    size = size > 0.0 ? std::min(size, of_pair) : of_pair;
  }
  if (!(deepest > (has_large_island() ? kLargePenetration : 16.0 * kPenetration))) return;
  before_ = world.state.v;
  ContactSolverOptions options = solver_options();
  options.tolerance = kPenetration * size;
  options.large_tolerance = kLargePenetration * size;
  options.large_motion = nullptr;
  project_prepared(world.mass(), contacts_, deepest > kDeep ? kPenetrationFraction : 1.0, moved_, options,
                   workspace_);
  const double before = world.field().potential_energy(world.state.q);
  for (int i = 0; i < world.state.size(); ++i) {
    if (world.infinite_mass(i) || moved_.col(i).isZero(0.0)) continue;
    world.trajectories.set_pose(i, world.trajectories.at_start(i).head<3>() + moved_.col(i));
    world.state.q.col(i) = world.trajectories.at_start(i).head<3>();
  }
  world.sums.ledger.penetration_correction += world.field().potential_energy(world.state.q) - before;
  for (int k = 0; k < world.trajectories.islands(); ++k) {
    if (world.trajectories.is_jointed(world.trajectories.members(k).front())) world.restore_joints(k);
  }
  for (int i = 0; i < contacts_.size(); ++i) contacts_.gap[i] += velocity_at(contacts_, i, moved_).normal;
}

// The work of the contact forces is taken along the actual paths, with all impacts on the way. Under the
// Euler methods, whose paths are not those of their velocities, it is the work along the velocities without
// impacts.
void RestingContacts::record_forces(World& world, double passed, double share) {
  mean_ = before_ + 0.5 * share * (after_ - before_);
  if (choice_of(kIntegrators, world.method.integrator).exact_under_gravity) {
    for (int i = 0; i < world.state.size(); ++i) {
      if (!world.infinite_mass(i) || world.model->is_kinematic(i))
        mean_.col(i) = (world.trajectories.at(i, passed).head<3>() - world.state.q.col(i)) / passed;
    }
  }
  record_impulses(world, share);
}

// Enters the work of a share of all contacts' impulses at the velocities `mean`.
void RestingContacts::record_impulses(World& world, double share) const {
  const Contacts& c = contacts_;
  for (int i = 0; i < c.size(); ++i) {
    const double jn = share * c.normal_impulse[i];
    const double jt = share * c.tangential_impulse[i];
    if (jn == 0.0) continue;
    const RowVelocity u = velocity_at(c, i, mean_);
    world.sums.ledger.lost_to_restitution -= jn * u.normal;
    world.sums.ledger.lost_to_friction -= jt * u.tangential;
    world.sums.ledger.lost_to_rolling -= share * c.rolling_impulse[i] * u.spin;
    const Vec2 j = jn * c.normal[i] + jt * Vec2(-c.normal[i].y(), c.normal[i].x());
    for (const auto& [body, sign] : {std::pair(c.a[i], -1.0), std::pair(c.b[i], 1.0)}) {
      if (!world.infinite_mass(body)) continue;
      world.sums.ledger.momentum_to_walls += sign * j;
      world.sums.ledger.put_in_by_drives -= sign * j.dot(mean_.col(body).head<2>());
    }
  }
}

// Contacts that close, or would within the step, lose their closing speed now.
void RestingContacts::stop_approaches(World& world, double h) {
  Contacts& c = contacts_;
  const int n = world.bodies();
  before_.resize(3, n);
  for (int i = 0; i < n; ++i) before_.col(i) = world.trajectories.at_start(i).segment<3>(3);
  memory_.forces.clear();
  const ContactSolverOptions options = solver_options();
  double worst = 0.0;
  for (int i = 0; i < c.size(); ++i) {
    if (std::isfinite(c.target[i])) c.target[i] = -std::max(c.gap[i], 0.0) / h;
    worst = std::max(worst, c.target[i] - velocity_at(c, i, before_).normal);
  }
  after_ = before_;
  if (worst > 2.0 * (has_large_island() ? options.large_tolerance : options.tolerance)) {
    report_residual(world, solve_prepared(world.mass(), c, after_, options, workspace_));
    mean_ = 0.5 * (before_ + after_);
    record_impulses(world, 1.0);
    for (int i = 0; i < n; ++i) {
      if (world.infinite_mass(i) || after_.col(i) == before_.col(i)) continue;
      world.trajectories.set_velocity(i, after_.col(i).head<2>(), after_(2, i));
    }
  }
  for (int i = 0; i < c.size(); ++i) {
    memory_.forces.push_back({c.a[i], c.b[i], id_[i], point_[i], c.normal[i], c.normal_impulse[i] / h,
                              c.tangential_impulse[i] / h, c.rolling_impulse[i] / h, true});
  }
}

// Finds forces on the trajectories such that the velocities satisfy the contacts at the step's end.
void RestingContacts::find_forces(World& world, double h) {
  Contacts& c = contacts_;
  const int n = world.bodies();
  std::fill(memory_.held.begin(), memory_.held.end(), 0);
  memory_.support.clear();
  if (c.size() == 0) return;
  before_ = after_;
  for (int i = 0; i < c.size(); ++i) {
    c.normal_impulse[i] = h * guess_[i][0];
    c.tangential_impulse[i] = h * guess_[i][1];
    c.rolling_impulse[i] = h * guess_[i][2];
    for (const int body : {c.a[i], c.b[i]}) {
      if (world.infinite_mass(body) || memory_.held[body] != 0) continue;
      memory_.held[body] = 1;
      memory_.pushed.push_back(body);
    }
  }
  free_.resize(3, n);
  for (int i = 0; i < n; ++i) free_.col(i) = world.trajectories.at(i, h).segment<3>(3);
  const ContactSolverOptions options = solver_options();
  sticks_ = c.sticks;
  ContactSolverReport report;
  for (int round = 0; round < kMostRounds; ++round) {
    after_ = free_;
    c.sticks = sticks_;
    report = solve_prepared(world.mass(), c, after_, options, workspace_);
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
  report_residual(world, report);
  std::fill(memory_.held.begin(), memory_.held.end(), 0);
  for (int i = 0; i < c.size(); ++i) {
    const Eigen::Vector3d by =
        Eigen::Vector3d(c.normal_impulse[i], c.tangential_impulse[i], c.rolling_impulse[i]) / h;
    ContactForce& f = memory_.forces[i];
    f.normal_force += by[0];
    f.tangential_force += by[1];
    f.rolling_moment += by[2];
    f.sticks = c.sticks[i] != 0;
    memory_.support.push_back(guess_[i] + h / step_length_ * (by - guess_[i]));
    if (memory_.support[i][0] > 0.0) memory_.held[c.a[i]] = memory_.held[c.b[i]] = 1;
  }
}

void RestingContacts::release(World& world) {
  for (const int i : memory_.pushed) world.trajectories.set_contact_acceleration(i, Eigen::Vector3d::Zero());
  *this = {};
}

double RestingContacts::change_by_forces() const {
  return step_length_ * acceleration_.topRows<2>().colwise().norm().maxCoeff();
}

bool RestingContacts::supports(int a, int b) const {
  return std::binary_search(supported_.begin(), supported_.end(), std::pair(a, b));
}

bool RestingContacts::stays_supported(const World& world, int a, int b) const {
  if (!supports(a, b)) return false;
  const Vec2 u = world.trajectories.at_start(b).segment<2>(3) - world.trajectories.at_start(a).segment<2>(3);
  double speed = u.norm();
  double press = 0.0;
  for (const int i : {a, b}) {
    const double spin = world.trajectories.at_start(i)[5];
    if (spin != 0.0) speed += std::abs(spin) * world.shapes().shapes.core_radius[i];
    press = std::max(press, acceleration_.col(i).head<2>().norm());
  }
  return speed <= press * step_length_;
}

// Bodies that penetrate at the step's end and close faster than a contact may rest rebound by the law of
// impacts.
void RestingContacts::rebound_at_end(World& world, const std::vector<std::pair<int, int>>& pairs) const {
  const double now = world.clock.step_end - world.trajectories.epoch();
  for (const auto& [a, b] : pairs) {
    const double restitution = world.material(a, b).restitution;
    if (restitution == 0.0 || !world.shapes().can_collide(a, b)) continue;  // or joined in the meantime
    const int most = world.shapes().is_disc(a) || world.shapes().is_disc(b) ? 1 : 3;
    for (int k = 0; k < most; ++k) {
      const Approach at = world.approach(a, b, 0.0);
      if (at.contact.gap >= 0.0) break;
      const double rest = rest_speed(world, a, b, at.contact.normal, restitution);
      if (!(-restitution * at.speed > rest)) break;
      apply_impact(world, a, b, at.contact, world.material(a, b), now);
      if (!world.shapes().can_collide(a, b)) break;
    }
  }
}

}  // namespace carom
