#include "physics/world/lasting_contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/collision/pair_contact.h"
#include "physics/collision/time_of_impact.h"
#include "physics/dynamics/integrators/integrators.h"
#include "physics/scene/drive.h"
#include "physics/world/simulation.h"

// The contacts that last of a simulation: see LastingContacts.
namespace carom {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
// Of what the forces change of a speed in a step: to this the contact forces are solved.
constexpr double kSolved = 1e-10;
// Likewise: a contact that slips slower than this sticks.
constexpr double kStuck = 1e-6;
// Of the size: a smaller overlap is rounding, and one beyond kDeep is taken away in parts.
constexpr double kOverlap = 1e-12;
constexpr double kDeep = 1e-3;
// Contacts of an island up to which it is solved exactly, always or where its rms velocity is at most kSlow of
// what the forces change of a speed in a step. In a crowd, a larger one, the tolerance is kCrowdMotion of its
// speeds, at most kCrowdSolved of what the forces change of a speed in a step: as it comes to rest it is solved
// better and better, each step from the forces of the one before.
constexpr int kMostExact = 64;
constexpr int kMostExactAtRest = 400;
constexpr double kSlow = 1e-5;
constexpr double kCrowdMotion = 0.1;
constexpr double kCrowdSolved = 1e-2;
constexpr double kCrowdRest = 1e-9;
constexpr double kCrowdOverlap = 1e-6;  // of the size
// Sweeps of a crowd, more of a small one.
constexpr int kCrowdSweeps = 20;
constexpr int kCrowdContactSweeps = 10'000;
// Where the integrator's flight is not linear in the contact forces they are corrected this often.
constexpr int kMostRounds = 12;
// Room for contacts to begin with.
constexpr int kFewContacts = 64;

double cross(const Vec2& r, const Vec2& d) { return r.x() * d.y() - r.y() * d.x(); }

// Of a contact, for the velocities v of all bodies.
RowVelocity velocity_at(const Contacts& c, int i, const Eigen::Matrix3Xd& v) {
  const Eigen::Vector3d a = v.col(c.a[i]);
  const Eigen::Vector3d b = v.col(c.b[i]);
  const Vec2 n = c.normal[i];
  const Vec2 d = (b - a).head<2>();
  return {d.dot(n) + b[2] * cross(c.arm_b[i], n) - a[2] * cross(c.arm_a[i], n),
          cross(n, d) + b[2] * c.arm_b[i].dot(n) - a[2] * c.arm_a[i].dot(n), b[2] - a[2]};
}

// m/s: the most that the forces change of a speed in a step.
double change_by_forces(const LastingContacts& l, double step) {
  return step * l.acceleration.topRows<2>().colwise().norm().maxCoeff();
}

bool has_crowd(const LastingContacts& l) { return !l.workspace.crowds.blocks.empty(); }

}  // namespace

double Simulation::rest_speed(int a, int b, const Vec2& normal, double restitution) const {
  const Eigen::Matrix3Xd& by = lasting_.acceleration;
  double press = std::max(0.0, -normal.dot((by.col(b) - by.col(a)).head<2>()));
  for (const int i : {a, b}) {
    if (lasting_.held[i] != 0) press = std::max(press, by.col(i).head<2>().norm());
  }
  if (!(press > 0.0)) return kRestSpeed;
  double share = 1.0;
  // Explicit Euler's rebounds don't die out below this.
  if (method_.integrator == IntegratorId::kExplicitEuler && restitution < 1.0)
    share = std::clamp(kRestRebound * restitution / (1.0 - restitution), 1.0, kMostRestRebound);
  return std::max(kRestSpeed, share * press * step_length_);
}

void Simulation::hold_contacts(double h) {
  LastingContacts& l = lasting_;
  const int n = static_cast<int>(bodies().size());
  for (const int i : l.pushed) tracks_.set_contact_acceleration(i, Eigen::Vector3d::Zero());
  l.pushed.clear();
  l.acceleration.setZero(3, n);
  for (int i = 0; i < n; ++i) {
    if (!immovable(i)) {
      l.acceleration.col(i) = tracks_.acceleration(i);
    } else if (model_->driven[i] != 0) {
      l.acceleration.col(i).head<2>() = drive_acceleration(*bodies()[i].drive, tracks_.epoch());
    }
  }
  l.held.resize(n, 0);
  find_contacts(h);
  prepare_contacts(mass(), l.contacts,
                   {.most_exact = kMostExact,
                    .most_slow = kMostExactAtRest,
                    .slow_speed = kSlow * change_by_forces(l, step_length_),
                    .motion = &state_.v},
                   l.workspace);
  project_contacts();
  touch_down(h);
  find_contact_forces(h);
}

// Fills the contacts of this step, with the impulses that the last one ended with.
void Simulation::find_contacts(double h) {
  LastingContacts& l = lasting_;
  const int n = static_cast<int>(bodies().size());
  const ConvexShapes& convex = shapes().shapes;
  const bool located = method_.impacts == ImpactsId::kLocated;
  // Part of a step looks as far as a whole one, so that it forgets no contact.
  const double whole = step_length_;
  l.poses.resize(n);
  l.reach.resize(n);
  for (int i = 0; i < n; ++i) {
    const Eigen::Vector3d q = tracks_.settled(i).head<3>();
    const Eigen::Vector3d v = tracks_.settled(i).segment<3>(3);
    const double turning = v[2] != 0.0 ? std::abs(v[2]) * convex.core_radius[i] : 0.0;
    l.reach[i] =
        (v.head<2>().norm() + turning) * whole + l.acceleration.col(i).head<2>().norm() * whole * whole;
    l.poses[i] = pose_of(convex, i, q);
    const Eigen::Array2d margin = shapes().extent.col(i).array() + l.reach[i];
    bounds_[i] = {q.head<2>().array() - margin, q.head<2>().array() + margin};
  }
  Contacts& c = l.contacts;
  int count = 0;
  l.id.clear();
  l.guess.clear();
  l.point.clear();
  l.near.clear();
  l.holds.clear();
  l.landings.clear();
  std::size_t last = 0;
  for (const auto& [a, b] : near_pairs()) {
    if (!shapes().can_meet(a, b)) continue;
    l.near.emplace_back(a, b);
    const double size = shapes().size[a] + shapes().size[b];
    const double rounding =
        kOverlap * (size + tracks_.settled(a).head<2>().lpNorm<1>() + tracks_.settled(b).head<2>().lpNorm<1>());
    const Manifold m = manifold(convex, a, l.poses[a], b, l.poses[b], l.reach[a] + l.reach[b] + rounding);
    if (m.count == 0) continue;
    const Material& material = material_between(a, b);
    const double rest = rest_speed(a, b, m.normal, material.restitution);
    while (last < l.forces.size() && std::pair(l.forces[last].a, l.forces[last].b) < std::pair(a, b)) {
      ++last;
    }
    const std::size_t landings = l.landings.size();
    for (int k = 0; k < m.count; ++k) {
      const ManifoldPoint& at = m.points[k];
      const int i = count;
      if (i == c.size()) c.resize(std::max(kFewContacts, 2 * i));
      c.a[i] = a;
      c.b[i] = b;
      c.normal[i] = m.normal;
      c.arm_a[i] = at.point - l.poses[a].position;
      c.arm_b[i] = at.point - l.poses[b].position;
      c.gap[i] = at.gap;
      const RowVelocity u = velocity_at(c, i, state_.v);
      const double closing = -u.normal;
      const bool slow = material.restitution * closing <= rest;
      // At their own time fast impacts are the event queue's matter.
      const bool open = at.gap > rounding;
      const bool near =
          !open || (at.gap <= (std::max(closing, 0.0) + rest) * whole && (!located || closing <= 2.0 * rest));
      if (!near || (!slow && at.gap >= -rounding)) {
        if (located && open && closing > rest) l.landings.push_back({a, b, at.id});
        continue;
      }
      ++count;
      // A fast one that overlaps is pushed out, and left to the impacts at the step's end.
      c.target[i] = slow ? -std::max(at.gap, 0.0) / h : -std::numeric_limits<double>::infinity();
      c.static_friction[i] = material.static_friction;
      c.kinetic_friction[i] = material.kinetic_friction;
      c.rolling[i] = material.rolling_resistance * rolling_radius(a, b);
      c.sticks[i] = std::abs(u.tangential) <= kRestSpeed ? 1 : 0;
      c.normal_impulse[i] = c.tangential_impulse[i] = c.rolling_impulse[i] = 0.0;
      l.guess.emplace_back(Eigen::Vector3d::Zero());
      for (std::size_t j = last; j < l.forces.size() && l.forces[j].a == a && l.forces[j].b == b; ++j) {
        if (l.forces[j].id != at.id) continue;
        c.sticks[i] = l.forces[j].sticks;
        l.guess.back() = l.hold[j];
      }
      l.id.push_back(at.id);
      l.point.push_back(at.point);
      if (slow && (l.holds.empty() || l.holds.back() != std::pair(a, b))) l.holds.emplace_back(a, b);
    }
    // What nothing holds yet is the event queue's matter.
    if (l.holds.empty() || l.holds.back() != std::pair(a, b)) l.landings.resize(landings);
  }
  c.resize(count);
}

// s within the epoch, before `end`: when the first landing is, on tracks that are laid; `end` if there is none.
double Simulation::first_landing(double end, Landing& first) {
  double time = end;
  for (const Landing& l : lasting_.landings) {
    const auto gap = [&](double t) {
      const ConvexShapes& convex = shapes().shapes;
      const Manifold m =
          manifold(convex, l.a, pose_of(convex, l.a, tracks_.at(l.a, t).head<3>()), l.b,
                   pose_of(convex, l.b, tracks_.at(l.b, t).head<3>()), std::numeric_limits<double>::infinity());
      for (int k = 0; k < m.count; ++k) {
        if (m.points[k].id == l.id) return m.points[k].gap;
      }
      return shapes().size[l.a] + shapes().size[l.b];
    };
    const double at_start = gap(0.0);
    const double at_end = gap(time);
    if (!(at_start > 0.0 && at_end < 0.0)) continue;
    time = bracketed_root(gap, 0.0, at_start, time, at_end);
    first = l;
  }
  return time;
}

// The landed pair rebounds by the law of impacts, if it does so faster than a contact that lasts.
void Simulation::land(const Landing& l, double within) {
  const Approach at = approach(l.a, l.b, touch_tolerance(l.a, l.b, within));
  const Material& material = material_between(l.a, l.b);
  if (material.restitution * -at.speed > rest_speed(l.a, l.b, at.contact.normal, material.restitution))
    collide(l.a, l.b, at.contact, material, within);
}

// m: of the disc that would roll on a plane as these two roll on each other; 0 if neither is a disc.
double Simulation::rolling_radius(int a, int b) const {
  double curvature = 0.0;
  for (const int i : {a, b}) {
    if (shapes().is_disc(i) && shapes().shapes.rounding[i] > 0.0)
      curvature += 1.0 / shapes().shapes.rounding[i];
  }
  return curvature > 0.0 ? 1.0 / curvature : 0.0;
}

ContactSolverOptions Simulation::contact_options() const {
  const LastingContacts& l = lasting_;
  const double by_forces = change_by_forces(l, step_length_);
  ContactSolverOptions options;
  const double rounding = 16.0 * kEpsilon * l.before.topRows<2>().cwiseAbs().maxCoeff();
  options.tolerance = kSolved * by_forces + rounding;
  options.crowd_sweeps = kCrowdSweeps;
  options.crowd_contact_sweeps = kCrowdContactSweeps;
  options.crowd_tolerance = kCrowdRest * by_forces + rounding;
  options.crowd_motion = &l.before;
  options.crowd_share = kCrowdMotion;
  options.crowd_coarsest = kCrowdSolved * by_forces + rounding;
  options.slip_speed = kStuck * by_forces + options.tolerance;
  return options;
}

// Positions move out of overlaps; velocities stay.
void Simulation::project_contacts() {
  LastingContacts& l = lasting_;
  double deepest = 0.0;  // of the size
  double size = 0.0;     // m, the least of an overlapping pair
  for (int i = 0; i < l.contacts.size(); ++i) {
    if (!(l.contacts.gap[i] < 0.0)) continue;
    const double of_pair = shapes().size[l.contacts.a[i]] + shapes().size[l.contacts.b[i]];
    deepest = std::max(deepest, -l.contacts.gap[i] / of_pair);
    size = size > 0.0 ? std::min(size, of_pair) : of_pair;
  }
  if (!(deepest > (has_crowd(l) ? kCrowdOverlap : 16.0 * kOverlap))) return;
  l.before = state_.v;
  ContactSolverOptions options = contact_options();
  options.tolerance = kOverlap * size;
  options.crowd_tolerance = kCrowdOverlap * size;
  options.crowd_motion = nullptr;
  project_prepared(mass(), l.contacts, deepest > kDeep ? kOverlapFraction : 1.0, l.moved, options, l.workspace);
  const double before = field().potential_energy(state_.q);
  for (int i = 0; i < state_.size(); ++i) {
    if (immovable(i) || l.moved.col(i).isZero(0.0)) continue;
    tracks_.set_pose(i, tracks_.settled(i).head<3>() + l.moved.col(i));
    state_.q.col(i) = tracks_.settled(i).head<3>();
  }
  ledger_.overlap_correction += field().potential_energy(state_.q) - before;
  for (int k = 0; k < tracks_.islands(); ++k) {
    if (tracks_.is_linked(tracks_.members(k).front())) restore_links(k);
  }
  for (int i = 0; i < l.contacts.size(); ++i) l.contacts.gap[i] += velocity_at(l.contacts, i, l.moved).normal;
}

// Books what the contact forces did up to `passed`, a share of the time that they were found for. Their work is
// theirs along the paths as they have become, with all impacts on the way. Under the Euler methods, whose paths
// are not those of their velocities, it is that along the velocities without impacts.
void Simulation::book_contact_forces(double passed, double share) {
  LastingContacts& l = lasting_;
  l.mean = l.before + 0.5 * share * (l.after - l.before);
  if (choice_of(kIntegrators, method_.integrator).exact_under_gravity) {
    for (int i = 0; i < state_.size(); ++i) {
      if (!immovable(i) || model_->driven[i] != 0)
        l.mean.col(i) = (tracks_.at(i, passed).head<3>() - state_.q.col(i)) / passed;
    }
  }
  book_contacts(share);
}

// Books what a share of the impulses of all contacts did at the velocities `mean`.
void Simulation::book_contacts(double share) {
  const Contacts& c = lasting_.contacts;
  for (int i = 0; i < c.size(); ++i) {
    const double jn = share * c.normal_impulse[i];
    const double jt = share * c.tangential_impulse[i];
    if (jn == 0.0) continue;
    const RowVelocity u = velocity_at(c, i, lasting_.mean);
    ledger_.lost_to_restitution -= jn * u.normal;
    ledger_.lost_to_friction -= jt * u.tangential;
    ledger_.lost_to_rolling -= share * c.rolling_impulse[i] * u.spin;
    const Vec2 j = jn * c.normal[i] + jt * Vec2(-c.normal[i].y(), c.normal[i].x());
    for (const auto& [body, sign] : {std::pair(c.a[i], -1.0), std::pair(c.b[i], 1.0)}) {
      if (!immovable(body)) continue;
      ledger_.momentum_to_walls += sign * j;
      ledger_.put_in_by_drives -= sign * j.dot(lasting_.mean.col(body).head<2>());
    }
  }
}

// What touches, or would within the step, loses its closing speed now.
void Simulation::touch_down(double h) {
  LastingContacts& l = lasting_;
  Contacts& c = l.contacts;
  const int n = static_cast<int>(bodies().size());
  l.before.resize(3, n);
  for (int i = 0; i < n; ++i) l.before.col(i) = tracks_.settled(i).segment<3>(3);
  l.forces.clear();
  const ContactSolverOptions options = contact_options();
  double worst = 0.0;
  for (int i = 0; i < c.size(); ++i) {
    if (std::isfinite(c.target[i])) c.target[i] = -std::max(c.gap[i], 0.0) / h;
    worst = std::max(worst, c.target[i] - velocity_at(c, i, l.before).normal);
  }
  l.after = l.before;
  if (worst > 2.0 * (has_crowd(l) ? options.crowd_tolerance : options.tolerance)) {
    tell_residual(solve_prepared(mass(), c, l.after, options, l.workspace));
    l.mean = 0.5 * (l.before + l.after);
    book_contacts(1.0);
    for (int i = 0; i < n; ++i) {
      if (immovable(i) || l.after.col(i) == l.before.col(i)) continue;
      tracks_.set_velocity(i, l.after.col(i).head<2>(), l.after(2, i));
    }
  }
  for (int i = 0; i < c.size(); ++i) {
    l.forces.push_back({c.a[i], c.b[i], l.id[i], l.point[i], c.normal[i], c.normal_impulse[i] / h,
                        c.tangential_impulse[i] / h, c.rolling_impulse[i] / h, true});
  }
}

// Forces on the tracks such that velocities fit the contacts again at the step's end.
void Simulation::find_contact_forces(double h) {
  LastingContacts& l = lasting_;
  Contacts& c = l.contacts;
  const int n = static_cast<int>(bodies().size());
  std::fill(l.held.begin(), l.held.end(), 0);
  l.hold.clear();
  if (c.size() == 0) return;
  l.before = l.after;
  for (int i = 0; i < c.size(); ++i) {
    c.normal_impulse[i] = h * l.guess[i][0];
    c.tangential_impulse[i] = h * l.guess[i][1];
    c.rolling_impulse[i] = h * l.guess[i][2];
    for (const int body : {c.a[i], c.b[i]}) {
      if (immovable(body) || l.held[body] != 0) continue;
      l.held[body] = 1;
      l.pushed.push_back(body);
    }
  }
  l.free.resize(3, n);
  for (int i = 0; i < n; ++i) l.free.col(i) = tracks_.at(i, h).segment<3>(3);
  const ContactSolverOptions options = contact_options();
  l.sticks = c.sticks;
  ContactSolverReport report;
  for (int round = 0; round < kMostRounds; ++round) {
    l.after = l.free;
    c.sticks = l.sticks;
    report = solve_prepared(mass(), c, l.after, options, l.workspace);
    for (const int i : l.pushed) tracks_.set_contact_acceleration(i, (l.after.col(i) - l.free.col(i)) / h);
    if (tracks_.is_parabolic()) break;
    double off = 0.0;
    for (const int i : l.pushed) {
      const Eigen::Vector3d by = tracks_.at(i, h).segment<3>(3) - l.after.col(i);
      off = std::max(off, by.head<2>().norm());
      l.free.col(i) += by;
    }
    if (off <= options.tolerance) break;
    report.residual = std::max(report.residual, off);
    if (round == kMostRounds - 1) ++report.missed_islands;
  }
  tell_residual(report);
  std::fill(l.held.begin(), l.held.end(), 0);
  for (int i = 0; i < c.size(); ++i) {
    const Eigen::Vector3d by =
        Eigen::Vector3d(c.normal_impulse[i], c.tangential_impulse[i], c.rolling_impulse[i]) / h;
    ContactForce& f = l.forces[i];
    f.normal_force += by[0];
    f.tangential_force += by[1];
    f.rolling_moment += by[2];
    f.sticks = c.sticks[i] != 0;
    l.hold.push_back(l.guess[i] + h / step_length_ * (by - l.guess[i]));
    if (l.hold[i][0] > 0.0) l.held[c.a[i]] = l.held[c.b[i]] = 1;
  }
}

void Simulation::tell_residual(const ContactSolverReport& report) {
  if (report.missed_islands == 0) return;
  if (notices_.contacts_left_since < 0.0) notices_.contacts_left_since = time_;
  notices_.contacts_left = std::max(notices_.contacts_left, report.residual);
}

bool Simulation::holds(int a, int b) const {
  return lasts_ && std::binary_search(lasting_.holds.begin(), lasting_.holds.end(), std::pair(a, b));
}

// Bodies that overlap at the step's end and close faster than contacts take up rebound by the law of impacts.
void Simulation::rebound_at_end(const std::vector<std::pair<int, int>>& pairs) {
  const double now = step_end_ - tracks_.epoch();
  for (const auto& [a, b] : pairs) {
    const Material& material = material_between(a, b);
    if (material.restitution == 0.0 || !shapes().can_meet(a, b)) continue;  // or joined meanwhile
    const int most = shapes().is_disc(a) || shapes().is_disc(b) ? 1 : 3;
    for (int k = 0; k < most; ++k) {
      const Approach at = approach(a, b, 0.0);
      if (at.contact.gap >= 0.0) break;
      const double rest = rest_speed(a, b, at.contact.normal, material.restitution);
      if (!(-material.restitution * at.speed > rest)) break;
      collide(a, b, at.contact, material, now);
    }
  }
}

}  // namespace carom
