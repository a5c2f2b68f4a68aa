#include "physics/step/resting_contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/collision/pair_contact.h"
#include "physics/contact/contact_velocity.h"
#include "physics/dynamics/integrators/integrators.h"
#include "physics/math/vectors.h"
#include "physics/step/contact_work.h"
#include "physics/step/pair_motion.h"

namespace carom {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
// Number of contacts up to which an island is solved exactly, always or where its contacts move by at most
// kSlow of the change of a speed by forces in a step. A larger island has the tolerance kLargeMotion of
// its speeds, at most kLargeSolved of that change: as it comes to rest its solution improves, each step
// starting from the forces of the one before.
constexpr int kMostExact = 64;
constexpr int kMostExactSlow = 400;
constexpr double kSlow = 0.01;
// Times the tolerance: as near, a solve that has failed is not tried again where there are more than few
// contacts.
constexpr double kEnough = 100.0;
constexpr double kLargeMotion = 0.1;
constexpr double kLargeSolved = 1e-2;
constexpr double kLargeRest = 1e-9;
// Sweeps over a large island; more while contacts times sweeps stay below kLargeContactSweeps.
constexpr int kLargeSweeps = 20;
constexpr int kLargeContactSweeps = 20'000;
// In a pile at rest, where less than one contact in kContactsPerHit is hit, up to kQuietSweeps: what is left
// there adds up from step to step and makes the pile creep.
constexpr int kQuietSweeps = 150;
constexpr int kContactsPerHit = 100;
// Of the size, or rad: how far bodies of a crowd may close or turn in a part of a step.
constexpr double kMostMotion = 0.1;
// Linear forces end where a contact's mode does: found in so many rounds, the last of which may be off by
// kAbout. Modes that last for kWhole of a part do for all of it.
constexpr int kMostEnds = 3;
constexpr double kAbout = 0.9;
constexpr double kWhole = 1.0 - 1e-6;
// Of a step: in a crowd, where something changes its mode nearly always, no shorter part begins and ends so.
constexpr double kShortest = 1e-3;
// Of a step: linear forces are not found again for a shorter part. They go on for so much of it, as what ends
// the part will be at another time under them.
constexpr double kLeastEnd = 1e-3;
constexpr double kGoesOn = 1e-4;
// Rounds in which contacts are kept that would sink in.
constexpr int kMostSinking = 8;
// Of the time until a face ends.
constexpr double kShortly = 0.99;

// s after the epoch: when an applied force on a body in contact changes its law first; h if none does within h.
double first_break(const World& world, const Contacts& contacts, double h) {
  if (!world.field().has_breaks()) return h;
  double first = h;
  const double epoch = world.trajectories.epoch();
  for (int i = 0; i < contacts.size(); ++i) {
    for (const BodyIndex body : {contacts.a[i], contacts.b[i]})
      first = std::min(first, world.field().next_break(body, epoch) - epoch);
  }
  return first;
}

}  // namespace

double RestingContacts::rest_speed(const World& world, BodyIndex a, BodyIndex b, const Vec2& point,
                                   const Vec2& normal, double restitution) const {
  return pressing_.rest_speed(world, pressing_.between(world, memory_, a, b, point, normal), restitution);
}

void RestingContacts::begin_step(World& world, double h) {
  whole_step_ = std::max(h, world.method.step);
  pressing_.calm(false);
  linear_.begin_part(world.clock.time, whole_step_);  // a step is found from its start alone
  world.trajectories.begin(world.clock.time);
}

void RestingContacts::take_off_forces(World& world) {
  for (const BodyIndex i : memory_.pushed)
    world.trajectories.set_contact_acceleration(i, Eigen::Vector3d::Zero());
  memory_.pushed.clear();
  world.trajectories.end_contact_rates();
}

void RestingContacts::support(World& world, double h, bool may_divide, bool hit) {
  may_divide_ = may_divide;
  hit_ = hit;
  finder_.begin_part(world, may_divide ? std::span<const ContactForce>() : memory_.forces);
  for (const Landing& landing : together_) finder_.keep(landing);
  together_.clear();
  linear_.begin_part(world.trajectories.epoch(), whole_step_);
  support_found(world, h);
  for (int k = 0; may_divide && k < kMostSinking && keep_what_sinks(world); ++k) support_found(world, h);
}

void RestingContacts::support_found(World& world, double h) {
  take_off_forces(world);
  const double unit = whole_step_ / kMostParts;
  step_length_ = may_divide_ ? whole_step_ : std::max(h, unit);
  find_contacts(world, h);
  supported_ = h;
  if (may_divide_) {
    supported_ = first_break(world, found_.contacts, h);
    find_touches_near_ends(world, found_, finder_.neighbours(), supported_, near_ends_);
    if (!near_ends_.empty()) {
      push_as_before(world);
      supported_ = end_of_faces(world, supported_);
    }
    if (supported_ < h) find_contacts(world, supported_);
  } else if (const double part = parts_at_once(world, unit) * unit; part < h - 0.5 * unit) {
    supported_ = step_length_ = part;
    find_contacts(world, supported_);
  }
  const double shortest = shortest_part(world);
  double holds = hold(world, supported_, may_divide_ ? std::min(shortest, supported_) : supported_);
  for (int round = 1; may_divide_ && round <= kMostEnds && holds < kWhole * supported_; ++round) {
    supported_ = holds;
    take_off_forces(world);
    find_contacts(world, supported_);
    holds = hold(world, supported_,
                 round < kMostEnds ? std::min(shortest, kAbout * supported_) : kAbout * supported_);
  }
}

bool RestingContacts::end_part(World& world, double time) {
  if (!moves_few(world)) return false;
  if (!(time > kLeastEnd * whole_step_ && time < kWhole * supported_)) return false;
  supported_ = std::min((1.0 + kGoesOn) * time, supported_);
  take_off_forces(world);
  find_contacts(world, supported_);
  supported_ = std::min(supported_, hold(world, supported_, kAbout * supported_));
  return true;
}

// s: no mode divides a shorter one.
double RestingContacts::shortest_part(const World& world) const {
  return moves_few(world) ? 0.0 : kShortest * whole_step_;
}

// A contact that was leaving is one that presses, if the forces on the others bring it back at once.
bool RestingContacts::keep_what_sinks(const World& world) {
  bool any = false;
  for (const Landing& landing : found_.landings) {
    const std::optional<Contact> contact = contact_at_start(world, landing);
    if (!contact || contact->gap > touch_tolerance(world, landing.a, landing.b)) continue;
    if (world.parting_speed(landing.a, landing.b, *contact) > pressing_.noise() || hit_now(world, landing))
      continue;
    finder_.keep(landing);
    any = true;
  }
  return any;
}

// The first end of a face within h s, first on the forces that are on the trajectories, and then on those found
// until shortly before: past the end a corner's contact is another one. Where a mode ends before, that.
double RestingContacts::end_of_faces(World& world, double h) {
  double end = first_face_end(world, near_ends_, finder_.neighbours(), h);
  take_off_forces(world);
  if (!(end < h)) return h;
  find_contacts(world, kShortly * end);
  const double holds = hold(world, kShortly * end, std::min(shortest_part(world), kShortly * end));
  if (holds < kWhole * kShortly * end) {
    end = holds;
  } else {
    end = first_face_end(world, near_ends_, finder_.neighbours(), h);
  }
  take_off_forces(world);
  return end;
}

void RestingContacts::find_contacts(World& world, double h) {
  pressing_.find(world, step_length_, may_divide_, memory_);
  finder_.find(world, step_length_, h, pressing_, memory_, found_);
  Contacts& c = found_.contacts;
  for (int i = 0; i < c.size(); ++i) {
    const bool leaves = leaves_corner(world, found_, i, finder_.neighbours(), h);
    if (!leaves && !has_passed_on(world, found_, i)) continue;
    c.target[i] = -std::numeric_limits<double>::infinity();
    // What leaves a corner may come back to it, with another face.
    if (leaves) found_.landings.push_back({c.a[i], c.b[i], found_.id[static_cast<std::size_t>(i)]});
  }
}

int RestingContacts::support_part(World& world, double step, int left) {
  take_off_forces(world);
  may_divide_ = false;
  const double unit = step / kMostParts;
  const double whole = std::max(step, world.method.step) / step;
  step_length_ = whole * left * unit;
  find_contacts(world, left * unit);
  const int parts = std::min(left, parts_at_once(world, unit));
  if (parts < left) {
    step_length_ = whole * parts * unit;
    find_contacts(world, parts * unit);
  }
  hold(world, parts * unit, parts * unit);
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
  const auto crowded = [&](BodyIndex i) {
    return !world.infinite_mass(i) && partners_[static_cast<std::size_t>(i)] > 1;
  };
  double fastest = 0.0;  // 1/s: moving by the size, or turning by 1 rad
  for (int i = 0; i < c.size(); ++i) {
    const BodyIndex a = c.a[i];
    const BodyIndex b = c.b[i];
    const Vec2 moving = world.state.v.col(b).head<2>() - world.state.v.col(a).head<2>();
    double speed = moving.norm();
    const double size = smaller_size(world, a, b);
    for (const BodyIndex k : {a, b}) {
      if (world.state.v.col(k)[2] != 0.0)
        speed += std::abs(world.state.v.col(k)[2]) * world.shapes().core_reach[k];
    }
    if (speed * h * kMostParts < c.gap[i]) continue;
    // Over a body of infinite mass others may slide far without turning the contact.
    const bool free = !world.infinite_mass(a) && !world.infinite_mass(b);
    const RowVelocity u = contact_velocity(c, i, world.state.v);
    if (free || crowded(a) || crowded(b))
      fastest = std::max(fastest, (free ? moving.norm() : -u.normal) / size);
    for (const BodyIndex k : {a, b}) {
      if (!world.shapes().is_disc(k)) fastest = std::max(fastest, std::abs(world.state.v.col(k)[2]));
    }
  }
  int parts = kMostParts;
  while (parts > 1 && fastest * parts * h > kMostMotion) parts /= 2;
  return parts;
}

double RestingContacts::hold(World& world, double h, double least) {
  linear_.clear();
  const auto forget = [this] {
    memory_.forces.clear();
    memory_.support.clear();
  };
  if (found_.contacts.size() == 0) {
    forget();
    pressing_.update(world, memory_);
    return h;
  }
  prepared_ = false;
  read_velocities(world);
  project_penetrations(world);
  const std::size_t welds = world.trajectories.welds().size();
  strike(world, h);
  join_what_rests(world);
  if (world.trajectories.welds().size() != welds) {
    // Bodies that have stuck together are one, with other contacts.
    find_contacts(world, h);
    return hold(world, h, least);
  }
  forget();
  read_velocities(world);
  if (stop_approaches(world, h)) let_leave(world);
  const double holds = find_forces(world, h, least);
  remember_forces(world, h);
  pressing_.update(world, memory_);
  return holds;
}

// What leaves as others are stopped comes back as a landing.
void RestingContacts::let_leave(const World& world) {
  if (!pressing_.follows_bounces()) return;
  Contacts& c = found_.contacts;
  for (int i = 0; i < c.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Landing landing{c.a[i], c.b[i], found_.id[k]};
    if (!std::isfinite(c.target[i]) || finder_.is_kept(landing) ||
        !may_bounce(world, landing.a, landing.b, !found_.is_new(i)))
      continue;
    if (!(contact_velocity(c, i, before_).normal > found_.rest[k])) continue;
    c.target[i] = -std::numeric_limits<double>::infinity();
    found_.landings.push_back(landing);
  }
}

void RestingContacts::read_velocities(const World& world) {
  before_.resize(3, world.bodies());
  for (BodyIndex i{0}; i < world.bodies(); ++i) before_.col(i) = world.trajectories.at_start(i).segment<3>(3);
}

void RestingContacts::prepare(const World& world) {
  prepare_contacts(world.mass(), found_.contacts,
                   {kMostExact, kMostExactSlow, kSlow * pressing_.change_by_forces(), &before_}, workspace_);
  prepared_ = true;
}

ContactSolverOptions RestingContacts::solver_options() const {
  const double by_forces = pressing_.change_by_forces();
  ContactSolverOptions options;
  const double rounding = 16.0 * kEpsilon * before_.topRows<2>().cwiseAbs().maxCoeff();
  options.tolerance = kContactTolerance * by_forces + rounding;
  if (found_.contacts.size() > GaussStep::kFew) options.enough = kEnough * options.tolerance;
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

// The work of the contact forces is taken along the actual paths, with all impacts on the way. Under the
// Euler methods, whose paths are not those of their velocities, it is the work along the velocities without
// impacts.
void RestingContacts::record_forces(World& world, double passed, double share) {
  if (found_.contacts.size() == 0 || !(passed > 0.0)) return;
  moved_ = before_ + 0.5 * share * (after_ - before_);
  if (choice_of(kIntegrators, world.method.integrator).exact_under_gravity) {
    for (BodyIndex i{0}; i < world.state.size(); ++i) {
      if (!world.infinite_mass(i) || world.model->is_kinematic(i))
        moved_.col(i) = (world.trajectories.place(i, passed) - world.state.q.col(i)) / passed;
    }
  }
  record_support(world, found_, linear_, share, moved_, passed, flight_);
  linear_.record(world, passed);
  carry_forces(world, passed, finder_.neighbours(), memory_);
}

bool RestingContacts::holds(BodyIndex a, BodyIndex b) const {
  if (!pressing_.follows_bounces()) return false;
  const std::vector<ContactForce>& forces = memory_.forces;
  for (std::size_t k = first_force_of(forces, a, b); k < forces.size() && forces[k].a == a && forces[k].b == b;
       ++k) {
    if (forces[k].normal_force > 0.0) return true;
  }
  return false;
}

bool RestingContacts::is_disturbed(const World& world, BodyIndex a, BodyIndex b) const {
  const auto pushes = [&](BodyIndex i) {
    return std::binary_search(memory_.pushed.begin(), memory_.pushed.end(), i);
  };
  const auto lands = [&](BodyIndex i) {
    return std::any_of(found_.landings.begin(), found_.landings.end(),
                       [i](const Landing& landing) { return landing.a == i || landing.b == i; });
  };
  const auto is_off = [&](BodyIndex i) {
    return pushes(i) || (moves_few(world) && !world.is_immovable(i) && lands(i));
  };
  // With a body, what is joined to it.
  const auto any_off = [&](BodyIndex i) {
    if (!world.trajectories.is_jointed(i)) return is_off(i);
    const auto& members = world.trajectories.members(world.trajectories.island_of(i));
    return std::any_of(members.begin(), members.end(), is_off);
  };
  return is_few() && (any_off(a) || any_off(b));
}

void RestingContacts::release(World& world) {
  take_off_forces(world);
  *this = {};
}

}  // namespace carom
