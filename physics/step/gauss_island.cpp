#include "physics/step/gauss_island.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "physics/collision/pair_contact.h"
#include "physics/contact/contact_velocity.h"
#include "physics/dynamics/integrators/integrators.h"
#include "physics/math/vectors.h"
#include "physics/step/internal_edges.h"
#include "physics/step/pair_motion.h"

namespace carom {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kRoot3 = std::numbers::sqrt3;
// Rounds in which forces are corrected. Two leave at most kLeast of what was off before them, or they are the
// last; then at most kAccepted times the tolerance may be off.
constexpr int kMostRounds = 20;
constexpr double kLeast = 0.5;
constexpr double kAccepted = 1e4;

// The mean position on a path that is a cubic in time, weighted by the share of a Gauss point.
Vec2 weighted_mean(std::size_t point, const Kinematics& from, const Kinematics& to, double h) {
  // The integrals of Hermite's polynomials over the step, and of those times the time.
  constexpr std::array<double, 4> kWhole{0.5, 1.0 / 12.0, 0.5, -1.0 / 12.0};
  constexpr std::array<double, 4> kMoment{3.0 / 20.0, 1.0 / 30.0, 7.0 / 20.0, -1.0 / 20.0};
  const auto weight = [&](std::size_t i) {
    const double later = kMoment[i] - kGaussPoints[1 - point] * kWhole[i];
    return 2.0 * kRoot3 * (point == 0 ? -later : later);
  };
  return weight(0) * from.head<2>() + weight(1) * h * from.segment<2>(3) + weight(2) * to.head<2>() +
         weight(3) * h * to.segment<2>(3);
}

// By what share of h²/2 accelerations at the Gauss points move a body in a step: as the force that is linear
// through both does, or as its value at the start alone, in a step of velocity Verlet.
std::array<double, 2> moves_by(const World& world) {
  if (choice_of(kIntegrators, world.method.integrator).order == 2 && !world.trajectories.is_parabolic())
    return {gauss_share(0, 0.0), gauss_share(1, 0.0)};
  return {kGaussPoints[1], kGaussPoints[0]};
}

RowVelocity velocity_at(const Contact& contact, const Kinematics& a, const Kinematics& b) {
  return contact_velocity(contact.normal, contact.point - a.head<2>(), contact.point - b.head<2>(),
                          a.segment<3>(3), b.segment<3>(3));
}

}  // namespace

double gauss_share(std::size_t point, double time) {
  return point == 0 ? kRoot3 * (kGaussPoints[1] - time) : kRoot3 * (time - kGaussPoints[0]);
}

double gauss_share_until(std::size_t point, double time) {
  return point == 0 ? kRoot3 * time * (kGaussPoints[1] - 0.5 * time)
                    : kRoot3 * time * (0.5 * time - kGaussPoints[0]);
}

PosedMotion posed(const World& world, BodyIndex body, const Kinematics& y) {
  return {y, world.shapes().pose(body, y.head<3>())};
}

bool find_contact(const World& world, BodyIndex a, const PosedMotion& of_a, BodyIndex b,
                  const PosedMotion& of_b, std::uint32_t id, Contact& contact, RowVelocity& velocity) {
  const Geometry& g = world.shapes();
  const Manifold m = manifold_of(g, a, of_a.pose, b, of_b.pose, id, std::numeric_limits<double>::infinity());
  if (m.count == 0) return false;
  int best = 0;
  for (int k = 1; k < m.count; ++k) {
    const ManifoldPoint& at = m.points[static_cast<std::size_t>(k)];
    const ManifoldPoint& other = m.points[static_cast<std::size_t>(best)];
    if (at.id == id || (other.id != id && std::abs(at.gap) < std::abs(other.gap))) best = k;
  }
  contact = m.contact(best);
  velocity = velocity_at(contact, of_a.y, of_b.y);
  return true;
}

bool find_contact(const GaussStep& step, const GaussContact& c, const PosedMotion& of_a,
                  const PosedMotion& of_b, Contact& contact, RowVelocity& velocity) {
  const Geometry& g = step.world.shapes();
  if (!c.tip)
    return find_contact(step.world, c.a, of_a, c.b, of_b, step.found.id[static_cast<std::size_t>(c.contact)],
                        contact, velocity);
  contact = contact_on_line(g, c.a, of_a.pose, c.b, of_b.pose, *c.tip);
  velocity = velocity_at(contact, of_a.y, of_b.y);
  return true;
}

GaussContact::AtTime at_time(const Contact& contact, const PosedMotion& of_a, const PosedMotion& of_b,
                             const RowVelocity& velocity) {
  return {contact.normal,
          contact.point - of_a.y.head<2>(),
          contact.point - of_b.y.head<2>(),
          contact.gap,
          velocity.normal,
          velocity.tangential};
}

double friction_of(const GaussStep& step, const GaussContact& c) {
  const Contacts& found = step.found.contacts;
  return c.at_limit ? found.static_friction[c.contact] : found.kinetic_friction[c.contact];
}

double closed_within(const GaussStep& step, BodyIndex a, BodyIndex b, const Vec2& point) {
  const double size = step.world.shapes().size[a] + step.world.shapes().size[b];
  return std::max(step.tolerance * step.h, 8.0 * kEpsilon * (point.lpNorm<1>() + size));
}

const GaussIsland::Sampled& GaussIsland::sampled(BodyIndex body) const {
  return sampled_[static_cast<std::size_t>(column(body))];
}

Eigen::Index GaussIsland::column(BodyIndex body) const {
  return std::lower_bound(bodies_.begin(), bodies_.end(), body) - bodies_.begin();
}

// Looks at a body on its present flight.
void GaussIsland::sample(const GaussStep& step, std::size_t place) {
  Trajectories& trajectories = step.world.trajectories;
  const BodyIndex body = bodies_[place];
  Sampled& s = sampled_[place];
  const auto at = [&](double time) {
    if (step.world.is_immovable(body)) return s.start;
    return posed(step.world, body, trajectories.kinematics(body, time));
  };
  s.end = at(step.h);
  s.halfway = at(0.5 * step.h);
  for (const std::size_t k : {0U, 1U}) {
    s.at[k] = at(kGaussPoints[k] * step.h);
    s.mean[k] = weighted_mean(k, s.start.y, s.end.y, step.h);
  }
}

// Reads the contacts off the present flights. False if one is not what it was.
bool GaussIsland::look(const GaussStep& step) {
  for (GaussContact& c : closed_) {
    const Sampled& a = sampled_[static_cast<std::size_t>(c.column_a)];
    const Sampled& b = sampled_[static_cast<std::size_t>(c.column_b)];
    Contact contact;
    RowVelocity velocity;
    for (const std::size_t k : {0U, 1U}) {
      if (!find_contact(step, c, a.at[k], b.at[k], contact, velocity)) return false;
      GaussContact::AtPoint& at = c.at[k];
      at.normal = contact.normal;
      at.point = contact.point;
      at.arm_a = contact.point - a.mean[k];
      at.arm_b = contact.point - b.mean[k];
      at.gap = contact.gap;
      at.slip = velocity.tangential;
    }
    if (!find_contact(step, c, a.halfway, b.halfway, contact, velocity)) return false;
    c.halfway = at_time(contact, a.halfway, b.halfway, velocity);
    if (!find_contact(step, c, a.end, b.end, contact, velocity)) return false;
    c.end = at_time(contact, a.end, b.end, velocity);
  }
  return true;
}

// Whether another body continues the surface of a contact that presses where it is at the end, and not along
// the face of a corner.
bool GaussIsland::is_continued(const GaussStep& step) const {
  const World& world = step.world;
  const auto pose = [&](BodyIndex body) {
    return world.shapes().pose(body, step.world.trajectories.place(body, step.h));
  };
  return std::any_of(closed_.begin(), closed_.end(), [&](const GaussContact& c) {
    Contact contact;
    RowVelocity velocity;
    if (c.tip || !c.presses || !may_be_continued(world, c.a, c.b) ||
        !find_contact(world, c.a, sampled(c.a).end, c.b, sampled(c.b).end,
                      step.found.id[static_cast<std::size_t>(c.contact)], contact, velocity))
      return false;
    const auto others = step.neighbours.of_pair(world, c.a, c.b);
    return on_internal_edge(world, c.a, c.b, contact, others, pose) &&
           !turns_about_corner(world, c.a, c.b, c.at[0].normal, contact, others, pose);
  });
}

// How far the contacts that press are off what they are to be at the end, of what may be left; gaps by more
// than `left` of the smaller body.
double GaussIsland::off(const GaussStep& step, double left) const {
  double most = 0.0;
  const auto add = [&most](double part) {
    if (!std::isnan(most) && !(part <= most)) most = part;
  };
  for (const GaussContact& c : closed_) {
    if (!c.presses) continue;
    const double gap = std::abs(c.end.gap - c.stays_open) - left * smaller_size(step.world, c.a, c.b);
    add(gap / closed_within(step, c.a, c.b, c.at[0].point));
    add(std::abs(c.end.parting) / step.tolerance);
    if (!c.sticks) continue;
    add(std::abs(c.end.slip) / step.tolerance);
    add(std::abs(c.halfway.slip) / step.tolerance);
  }
  return most;
}

void GaussIsland::build(const GaussStep& step) {
  rows_ = 0;
  std::fill(held_.begin(), held_.end(), false);
  for (GaussContact& c : closed_) {
    c.row = rows_;
    c.holds = c.presses && c.sticks && !held_[static_cast<std::size_t>(c.face)];
    if (c.holds) held_[static_cast<std::size_t>(c.face)] = true;
    if (c.presses) rows_ += c.holds ? 2 : 1;
    if (c.holds) hold_face(c);
  }
  if (rows_ == 0) return;
  for (const std::size_t k : {0U, 1U}) {
    matrix_.setZero(rows_, rows_);
    for (const GaussContact& c : closed_) {
      if (!c.presses) continue;
      add_column(step, c, k, c.row, 1.0, c.sticks ? 0.0 : -c.slips * friction_of(step, c));
      if (c.holds) add_column(step, c, k, c.row + 1, 0.0, 1.0);
    }
    solver_[k].compute(matrix_);
  }
}

// How all contacts answer to this force of one at a Gauss point, which joints pass on.
void GaussIsland::add_column(const GaussStep& step, const GaussContact& c, std::size_t point, int to,
                             double normal, double tangential) {
  const World& world = step.world;
  const GaussContact::AtPoint& at = c.at[point];
  const Vec2& n = at.normal;
  const Vec2 force = normal * n + tangential * crossed(n);
  answers_.setZero(3, static_cast<Eigen::Index>(bodies_.size()));
  const auto push = [&](BodyIndex body, Eigen::Index column, double sign, const Vec2& arm) {
    answers_.col(column) << sign * world.mass().inverse_mass[body] * force,
        sign * world.mass().inverse_inertia[body] * cross(arm, force);
  };
  push(c.a, c.column_a, -1.0, at.arm_a);
  push(c.b, c.column_b, 1.0, at.arm_b);
  if (jointed_) step.world.trajectories.project_changes(bodies_, answers_);
  const auto answers = [&](const GaussContact& other) {
    const auto is_of = [&](BodyIndex body) {
      return !world.infinite_mass(body) && (other.a == body || other.b == body);
    };
    return jointed_ || is_of(c.a) || is_of(c.b);
  };
  for (const GaussContact& other : closed_) {
    if (!other.presses || !answers(other)) continue;
    const RowVelocity u = contact_velocity(other.end.normal, other.end.arm_a, other.end.arm_b,
                                           answers_.col(other.column_a), answers_.col(other.column_b));
    matrix_(other.row, to) = u.normal;
    if (other.holds) matrix_(other.row + 1, to) = u.tangential;
  }
}

// Corrects the forces by what the contacts are off at the end, and halfway: changes d of their accelerations at
// the Gauss points change velocities by h/2 (d_0 + d_1) at the end, and places by h²/2 times the sum by
// moves_by().
void GaussIsland::correct(const GaussStep& step) {
  const double h = step.h;
  const std::array<double, 2> by = moves_by(step.world);
  wanted_.setZero(rows_, 2);
  for (const GaussContact& c : closed_) {
    if (!c.presses) continue;
    const double parts = -2.0 * c.end.parting / h;
    const double moves = 2.0 * (c.stays_open - c.end.gap) / (h * h);
    wanted_(c.row, 0) = (moves - by[1] * parts) / (by[0] - by[1]);
    wanted_(c.row, 1) = parts - wanted_(c.row, 0);
    if (!c.holds) continue;
    // At a half of the step, velocities have changed by h/2 times the accelerations at a quarter of it.
    const double slips = -2.0 * c.end.slip / h;
    const double early = gauss_share(0, 0.25);
    const double late = gauss_share(1, 0.25);
    wanted_(c.row + 1, 0) = (-2.0 * c.halfway.slip / h - late * slips) / (early - late);
    wanted_(c.row + 1, 1) = slips - wanted_(c.row + 1, 0);
  }
  change_.resize(rows_, 2);
  for (const std::size_t k : {0U, 1U}) {
    const auto point = static_cast<Eigen::Index>(k);
    if (rows_ > 0) change_.col(point) = solver_[k].solve(wanted_.col(point));
  }
  for (GaussContact& c : closed_) {
    for (const std::size_t k : {0U, 1U}) {
      GaussContact::AtPoint& at = c.at[k];
      const auto point = static_cast<Eigen::Index>(k);
      at.normal_force = c.presses ? at.normal_force + change_(c.row, point) : 0.0;
      if (c.holds) {
        at.tangential_force += change_(c.row + 1, point);
      } else if (!c.held_still || !c.presses) {
        at.tangential_force = c.sticks ? 0.0 : -c.slips * friction_of(step, c) * at.normal_force;
      }
    }
  }
}

// Puts the forces on the trajectories.
void GaussIsland::push(const GaussStep& step) {
  World& world = step.world;
  for (auto& by : by_) by.setZero(3, static_cast<Eigen::Index>(bodies_.size()));
  for (const GaussContact& c : closed_) {
    for (const std::size_t k : {0U, 1U}) {
      const GaussContact::AtPoint& at = c.at[k];
      const Vec2 force = at.normal_force * at.normal + at.tangential_force * crossed(at.normal);
      const auto add = [&](BodyIndex body, Eigen::Index column, double sign, const Vec2& arm) {
        auto sum = by_[k].col(column);
        sum.head<2>() += sign * world.mass().inverse_mass[body] * force;
        sum[2] += sign * world.mass().inverse_inertia[body] * cross(arm, force);
      };
      add(c.a, c.column_a, -1.0, at.arm_a);
      add(c.b, c.column_b, 1.0, at.arm_b);
    }
  }
  for (Eigen::Index i = 0; i < std::ssize(bodies_); ++i) {
    const BodyIndex body = bodies_[static_cast<std::size_t>(i)];
    if (world.infinite_mass(body)) continue;
    world.trajectories.set_contact_acceleration(
        body, gauss_share(0, 0.0) * by_[0].col(i) + gauss_share(1, 0.0) * by_[1].col(i));
    world.trajectories.set_contact_rate(body, kRoot3 / step.h * (by_[1].col(i) - by_[0].col(i)));
  }
}

// Puts the forces on the trajectories and reads the contacts off the flights. False if one is not what it was,
// or infinitely far off.
bool GaussIsland::fly(const GaussStep& step) {
  push(step);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!step.world.infinite_mass(bodies_[i])) sample(step, i);
  }
  return look(step) && std::all_of(closed_.begin(), closed_.end(), [](const GaussContact& c) {
           return std::isfinite(c.end.gap) && std::isfinite(c.end.parting);
         });
}

bool GaussIsland::take_back(const GaussStep& step) {
  for (std::size_t i = 0; i < closed_.size(); ++i) closed_[i].at = before_[i];
  return fly(step);
}

bool GaussIsland::solve(const GaussStep& step) {
  before_.clear();
  for (GaussContact& c : closed_) {
    c.breaks_at = 0.0;
    before_.push_back(c.at);
  }
  build(step);
  std::array<double, 2> before{std::numeric_limits<double>::infinity(),
                               std::numeric_limits<double>::infinity()};
  for (int round = 0; round < kMostRounds; ++round) {
    correct(step);
    if (!fly(step)) return false;
    const double now = off(step, 0.0);
    if (!std::isfinite(now)) return false;
    const bool met = now <= 1.0 && round > 0;
    if (met || (round > 3 && !(now < kLeast * before[1]))) return now <= kAccepted && !is_continued(step);
    before = {now, before[0]};
  }
  return before[0] <= kAccepted && !is_continued(step);
}

bool GaussIsland::is_redundant() const { return rows_ > 0 && solver_[0].rank() < rows_; }

void GaussIsland::note_break(int face, double time, double slips) {
  for (GaussContact& c : closed_) {
    if (c.face != face) continue;
    c.breaks_at = time;
    c.breaks_to = slips;
  }
}

void GaussIsland::put_back(const GaussStep& step) const {
  for (const BodyIndex body : bodies_) {
    if (!step.world.infinite_mass(body))
      step.world.trajectories.set_contact_acceleration(body, constant_.col(column(body)));
  }
}

}  // namespace carom
