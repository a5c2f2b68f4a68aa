#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/math/sort_unique.h"
#include "physics/math/vectors.h"
#include "physics/step/contact_turning.h"
#include "physics/step/gauss_island.h"
#include "physics/step/gauss_modes.h"
#include "physics/step/pair_motion.h"
#include "physics/step/touch_on_face.h"

// How an island begins a part of a step: which contacts are closed, which of them stick, and whether constant
// forces do.
namespace carom {
namespace {

// Contacts of the largest island, without friction and with it.
constexpr std::size_t kMostSmooth = 64;
constexpr std::size_t kMostRubbing = 32;
// Of a step: a shorter part has constant forces, as gaps within rounding would need large ones to close in it.
constexpr double kShortest = 1e-5;
// Times the tolerance, and relative to the smaller body: constant forces that leave less are kept where nothing
// turns.
constexpr double kNeeded = 1e3;
constexpr double kLeft = 1e-11;
// Of what presses a contact in a step, times the step: a contact that is penetrated by more is none yet, nor is
// one that is open by more than a step closes of a gap that is left from before.
constexpr double kClosed = 0.05;
constexpr double kReturns = 0.01;
// Of full friction: what needs less on the mean of a step does not break away within it, and what needs so much
// may be at its limit from the start.
constexpr double kNearLimit = 0.75;
constexpr double kAtLimit = 1.0 - 1e-4;
// Relative: a difference from full friction.
constexpr double kFull = 1e-9;
// Of a face's load, times how far it moves relative to the size: what a contact loses within a step at most.
constexpr double kUnloads = 8.0;
// rad: contacts that turn by less have constant normals and arms.
constexpr double kStill = 1e-11;

// m: the gaps of a contact that is closed, and by how much it may close or open in this part of a step.
struct GapBounds {
  double deepest = 0.0, widest = 0.0, returns = 0.0;
};
GapBounds gap_bounds(const GaussStep& step, int i) {
  const World& world = step.world;
  const Contacts& found = step.found.contacts;
  const BodyIndex a = found.a[i];
  const BodyIndex b = found.b[i];
  const double answer = world.mass().inverse_mass[a] + world.mass().inverse_mass[b];
  // m/s²: by other forces, or by the constant one.
  const double press =
      std::max(step.found.press[static_cast<std::size_t>(i)], found.normal_impulse[i] / step.h * answer);
  if (!step.is_of_few()) {
    const double shut = press * step.h * step.h;
    return {kClosed * shut, kReturns * shut, kReturns * shut};
  }
  // What constant forces leave in a whole step.
  const double whole = std::max(step.h, world.method.step);
  const double shut = press * whole * whole;
  const double rounding = closed_within(step, a, b, step.found.point[static_cast<std::size_t>(i)]);
  const double left = 2.0 * (kLeft * smaller_size(world, a, b) + kNeeded * rounding);
  const double widest = std::max(kReturns * shut, left);
  return {std::max(kClosed * shut, left), widest, widest * (step.h / whole) * (step.h / whole)};
}

bool rubs(const GaussStep& step, const GaussContact& c) { return step.found.contacts.rubs(c.contact); }

}  // namespace

bool GaussIsland::begin(const GaussStep& step, std::span<const int> contacts) {
  contacts_ = contacts;
  const bool rub =
      std::any_of(contacts.begin(), contacts.end(), [&](int i) { return step.found.contacts.rubs(i); });
  if (contacts.size() > (rub ? kMostRubbing : kMostSmooth)) return false;
  if (step.h < kShortest * step.world.method.step || !list(step)) return false;
  constant_.resize(3, static_cast<Eigen::Index>(bodies_.size()));
  for (const BodyIndex body : bodies_)
    constant_.col(column(body)) = step.world.field().contact_acceleration(body);
  sampled_.resize(std::max(sampled_.size(), bodies_.size()));
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const BodyIndex body = bodies_[i];
    sampled_[i].start = posed(step.world, body, step.world.trajectories.at_start(body).head<kMotionRows>());
    sample(step, i);
  }
  const Geometry& g = step.world.shapes();
  for (GaussContact& c : closed_) {
    // At the ends it may be the end of its face.
    c.tip = tip_over_seam(step, c);
    if (c.tip) continue;
    c.tip = tip_on_face(g, c.a, sampled(c.a).halfway.pose, c.b, sampled(c.b).halfway.pose,
                        step.found.id[static_cast<std::size_t>(c.contact)]);
  }
  if (!look(step) || is_continued(step)) return false;
  for (GaussContact& c : closed_) {
    if (!start(step, c)) return false;
  }
  return is_needed(step);
}

// What comes over a seam stays on the line of the face before it.
std::optional<TipOnFace> GaussIsland::tip_over_seam(const GaussStep& step, const GaussContact& c) const {
  const Geometry& g = step.world.shapes();
  const auto others = step.neighbours.of_pair(step.world, c.a, c.b);
  if (!g.has_parts(c.a) && !g.has_parts(c.b) && others.empty()) return std::nullopt;
  const auto on = touch_on_face(step.world, step.found, c.contact);
  if (!on) return std::nullopt;
  const TipOnFace tip = on->on_line();
  const double beyond = beyond_face(g, c.a, at_end(c.a).pose, c.b, at_end(c.b).pose, tip);
  const auto pose = [&](BodyIndex body) { return g.pose(body, step.world.trajectories.place(body, step.h)); };
  if (beyond == 0.0 ||
      !goes_on_past(step.world, on->body, on->face, beyond > 0.0, on->toucher, on->toucher_part, others, pose))
    return std::nullopt;
  return tip;
}

// Lists the closed contacts and all bodies. False if there are none, or if one presses that is not closed.
bool GaussIsland::list(const GaussStep& step) {
  const Contacts& found = step.found.contacts;
  closed_.clear();
  bodies_.clear();
  held_.clear();
  for (const int i : contacts_) {
    for (const BodyIndex body : {found.a[i], found.b[i]}) bodies_.push_back(body);
    if (!std::isfinite(found.target[i])) continue;
    const bool presses = found.normal_impulse[i] > 0.0;
    const GapBounds bounds = gap_bounds(step, i);
    const bool closed = found.gap[i] >= -bounds.deepest && found.gap[i] <= bounds.widest;
    if (presses && (!closed || found.rolling_impulse[i] != 0.0)) return false;
    if (!closed) continue;
    GaussContact c;
    c.contact = i;
    c.a = found.a[i];
    c.b = found.b[i];
    GaussContact* same = presses ? same_contact(step, i) : nullptr;
    c.presses = presses && same == nullptr;
    c.stays_open = found.gap[i] - std::clamp(found.gap[i], -bounds.returns, bounds.returns);
    for (GaussContact::AtPoint& at : (same != nullptr ? *same : c).at) {
      at.normal_force += found.normal_impulse[i] / step.h;
      at.tangential_force += found.tangential_impulse[i] / step.h;
    }
    c.face = face_of(step, i);
    if (c.face == static_cast<int>(held_.size())) held_.push_back(false);
    closed_.push_back(c);
  }
  sort_unique(bodies_);
  jointed_ = step.world.trajectories.is_jointed(bodies_);
  for (GaussContact& c : closed_) {
    c.column_a = column(c.a);
    c.column_b = column(c.b);
  }
  return !closed_.empty();
}

// A contact at the start, and whether it sticks from there on. False if it turns too far within the step.
bool GaussIsland::start(const GaussStep& step, GaussContact& c) const {
  Contact contact;
  RowVelocity velocity;
  if (!find_contact(step, c, sampled(c.a).start, sampled(c.b).start, contact, velocity) ||
      contact.normal.dot(c.end.normal) <= kLeastCosine)
    return false;
  c.start = at_time(contact, sampled(c.a).start, sampled(c.b).start, velocity);
  if (!rubs(step, c)) return true;
  const Contacts& found = step.found.contacts;
  const bool larger = found.static_friction[c.contact] > found.kinetic_friction[c.contact];
  const auto slip = [&](double sign, bool at_limit) {
    c.sticks = false;
    c.slips = sign;
    c.at_limit = at_limit;
  };
  // What else can't stick is found out from its forces.
  c.sticks = std::abs(c.start.slip) <= step.slip_speed;
  if (!c.sticks) slip(std::copysign(1.0, c.start.slip), false);
  const auto [tangential, most] = friction_on(step, c.face);
  if (step.is_of_few() && c.sticks && c.presses && std::abs(tangential) >= kAtLimit * most)
    slip(-std::copysign(1.0, tangential), larger);
  const std::uint32_t id = step.found.id[static_cast<std::size_t>(c.contact)];
  for (const GaussBreak& past : step.breaks) {
    if (std::abs(c.start.slip) > step.slip_speed || past.a != c.a || past.b != c.b || past.id != id) continue;
    slip(past.slips, larger);
    c.broke_away = true;
  }
  return true;
}

// N s: the constant tangential force of a face, and what it can be at most.
std::pair<double, double> GaussIsland::friction_on(const GaussStep& step, int face) const {
  const Contacts& found = step.found.contacts;
  std::pair<double, double> sum;
  for (const GaussContact& c : closed_) {
    if (c.face != face || !c.presses) continue;
    sum.first += found.tangential_impulse[c.contact];
    sum.second += found.static_friction[c.contact] * found.normal_impulse[c.contact];
  }
  return sum;
}

// Whether contacts turn, or constant forces don't do what they should. Under an integrator of order 2 those are
// as good where nothing rubs, and keep angular momentum.
bool GaussIsland::is_needed(const GaussStep& step) const {
  const auto changes = [&](const GaussContact& c) {
    if (!c.presses || !rubs(step, c)) return false;
    const Contacts& found = step.found.contacts;
    if (std::abs(c.start.slip) <= step.slip_speed) {
      const auto [tangential, most] = friction_on(step, c.face);
      return found.sticks[c.contact] == 0 || (step.is_of_few() && std::abs(tangential) > kNearLimit * most);
    }
    const double full = friction_of(step, c) * found.normal_impulse[c.contact];
    return std::abs(found.tangential_impulse[c.contact] + c.slips * full) > kFull * full;
  };
  // Constant ones keep the order of velocity Verlet, and angular momentum to rounding, between discs that don't
  // rub: there is no corner and no end of a face to find the moment of.
  const auto may_rub = [&](const GaussContact& c) { return rubs(step, c) && (c.presses || closes(step, c)); };
  const auto has_corners = [&](const GaussContact& c) {
    return !step.world.shapes().is_disc(c.a) || !step.world.shapes().is_disc(c.b);
  };
  if (choice_of(kIntegrators, step.world.method.integrator).order == 2 &&
      std::none_of(closed_.begin(), closed_.end(),
                   [&](const GaussContact& c) { return may_rub(c) || has_corners(c); }))
    return false;
  if (off(step, kLeft) > kNeeded) return true;
  const auto turns = [&](BodyIndex body) {
    return !step.world.shapes().is_disc(body) &&
           std::abs(sampled(body).end.y[2] - sampled(body).start.y[2]) > kStill;
  };
  // Of the size, in about half of the step: how far a contact moves along a body.
  const auto moves_along = [&](const GaussContact& c, BodyIndex body) {
    const World& world = step.world;
    if (world.infinite_mass(body) || world.shapes().is_disc(body)) return 0.0;
    const auto place = [&](std::size_t k) {
      const Kinematics& at = sampled(body).at[k].y;
      return turned_by(-at[2], Vec2(c.at[k].point - at.head<2>()));
    };
    return (place(1) - place(0)).norm() / world.shapes().size[body];
  };
  // A place on a body that moves along it shifts the load between its contacts, which matters where they rub,
  // or where one of them may be without load before the step's end.
  const auto shifts_load = [&](const GaussContact& c) {
    if (!c.presses) return false;
    const double moved = std::max(moves_along(c, c.a), moves_along(c, c.b));
    if (!(moved > kStill)) return false;
    if (rubs(step, c)) return true;
    double load = 0.0;  // N s
    double least = std::numeric_limits<double>::infinity();
    for (const GaussContact& other : closed_) {
      if (other.face != c.face || !other.presses) continue;
      const double of_other = step.found.contacts.normal_impulse[other.contact];
      load += of_other;
      least = std::min(least, of_other);
    }
    return least < load && least < kUnloads * moved * load;
  };
  return std::any_of(closed_.begin(), closed_.end(), [&](const GaussContact& c) {
    return (c.start.normal - c.end.normal).norm() > kStill || turns(c.a) || turns(c.b) || changes(c) ||
           (!c.presses && closes(step, c)) || shifts_load(c);
  });
}

}  // namespace carom
