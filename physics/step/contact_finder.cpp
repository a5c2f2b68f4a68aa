#include "physics/step/contact_finder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "physics/collision/tips.h"
#include "physics/math/vectors.h"
#include "physics/model/pair_size.h"
#include "physics/step/coming_to_rest.h"
#include "physics/step/impact_cluster.h"
#include "physics/step/internal_edges.h"
#include "physics/step/pair_motion.h"

namespace carom {
namespace {

// Relative to the size and the coordinates: a smaller gap is rounding.
constexpr double kRounding = 1e-12;
// Relative to the size: a body that moves farther in a step may push others as fast.
constexpr double kFast = 0.02;
// So many bodies in a row may be pushed within a step.
constexpr int kPushes = 2;
constexpr int kFirstCapacity = 64;  // for contacts
// Of the smaller body's size, in a part of a step: what moves farther against another one meets it in time.
constexpr double kMostPassing = 0.2;

// m: radius of the disc that would roll on a plane as these two parts roll on each other; 0 if neither is a
// disc.
double rolling_radius(const ConvexShapes& shapes, const ShapePair& parts) {
  double curvature = 0.0;
  for (const ShapeIndex i : {parts.a, parts.b}) {
    if (shapes.core[i] == Core::kPoint && shapes.rounding[i] > 0.0) curvature += 1.0 / shapes.rounding[i];
  }
  return curvature > 0.0 ? 1.0 / curvature : 0.0;
}

// And no impulses yet.
void set_friction(const World& world, Contacts& c, int i, const SurfaceLaw& material, const ShapePair& parts) {
  const ShapePair touching = world.shapes().parts_or_first(parts, c.a[i], c.b[i]);
  c.slip_target[i] = 0.0;
  c.static_friction[i] = material.static_friction;
  c.kinetic_friction[i] = material.kinetic_friction;
  c.rolling[i] = material.rolling_resistance * rolling_radius(world.shapes().shapes, touching);
  c.normal_impulse[i] = c.tangential_impulse[i] = c.rolling_impulse[i] = 0.0;
}

// Whether contact forces held one of two bodies in the last step.
bool was_held(const World& world, const std::vector<ContactForce>& forces, BodyIndex a, BodyIndex b) {
  if (forces.size() > static_cast<std::size_t>(kFewContactsOfScene)) return true;
  return std::any_of(forces.begin(), forces.end(), [&](const ContactForce& f) {
    const auto holds = [&](BodyIndex body) {
      return !world.infinite_mass(body) && (f.a == body || f.b == body);
    };
    return f.normal_force > 0.0 && (holds(a) || holds(b));
  });
}

// m/s: no point of the one passes the other one faster.
double most_speed(const World& world, BodyIndex a, BodyIndex b) {
  const Vec2 u = world.trajectories.at_start(b).segment<2>(3) - world.trajectories.at_start(a).segment<2>(3);
  double speed = u.norm();
  for (const BodyIndex i : {a, b}) {
    const double spin = world.trajectories.at_start(i)[5];
    if (spin != 0.0) speed += std::abs(spin) * world.shapes().core_reach[i];
  }
  return speed;
}

// Whether two bodies move so far against each other within h s that they may come past each other.
bool is_fast(const World& world, BodyIndex a, BodyIndex b, double h) {
  return most_speed(world, a, b) * h > kMostPassing * smaller_size(world, a, b);
}

}  // namespace

void FoundContacts::clear() {
  id.clear();
  point.clear();
  guess.clear();
  old.clear();
  press.clear();
  rest.clear();
  turned_away.clear();
  returns.clear();
  landings.clear();
  hits.clear();
}

void set_place(Contacts& c, int i, const BodyPair& pair, const Vec2& normal, const ManifoldPoint& at,
               const Vec2& of_a, const Vec2& of_b) {
  c.a[i] = pair.first;
  c.b[i] = pair.second;
  c.normal[i] = normal;
  c.arm_a[i] = at.point - of_a;
  c.arm_b[i] = at.point - of_b;
  c.gap[i] = at.gap;
}

std::optional<Contact> contact_at_start(const World& world, const Landing& landing) {
  const auto& [a, b, id] = landing;
  const Manifold m = manifold_of(world.shapes(), a, pose_at_start(world, a), b, pose_at_start(world, b), id,
                                 std::numeric_limits<double>::infinity());
  const int k = point_with(m, id);
  return k >= 0 ? std::optional<Contact>(m.contact(k)) : std::nullopt;
}

double landing_speed(const World& world, const SurfaceLaw& law, double closing) {
  return moves_few(world) && !is_of_clay(law) ? closing : impact_speed(law, closing);
}

bool may_bounce(const World& world, BodyIndex a, BodyIndex b, bool pressed) {
  const bool cornered = !world.shapes().is_disc(a) && !world.shapes().is_disc(b);
  return cornered || (moves_few(world) && !pressed);
}

void ContactFinder::begin_part(const World& world, std::span<const ContactForce> forces) {
  kept_.clear();
  presses_.assign(forces.empty() ? 0 : static_cast<std::size_t>(world.bodies()), 0);
  for (const ContactForce& f : forces) {
    if (!(f.normal_force > 0.0)) continue;
    for (const BodyIndex body : {f.a, f.b}) {
      if (!world.infinite_mass(body)) presses_[static_cast<std::size_t>(body)] = 1;
    }
  }
}

void ContactFinder::find(World& world, double step_length, double h, const ContactPressing& pressing,
                         const ContactMemory& memory, FoundContacts& found) {
  const int n = world.bodies();
  const Geometry& shapes = world.shapes();
  poses_.resize(n);
  reach_.resize(n);
  for (BodyIndex i{0}; i < n; ++i) {
    const Eigen::Vector3d q = world.trajectories.at_start(i).head<3>();
    const Eigen::Vector3d v = world.trajectories.at_start(i).segment<3>(3);
    const double turning = v[2] != 0.0 ? std::abs(v[2]) * shapes.core_reach[i] : 0.0;
    // A part that impacts divide looks as far as a whole step, so that no contact is forgotten.
    reach_[i] =
        (v.head<2>().norm() + turning) * step_length + pressing.acceleration(i) * step_length * step_length;
    poses_[i] = shapes.pose(i, q);
  }
  let_fast_bodies_push(world);
  found.clear();
  near_.clear();
  supported_.clear();
  supported_parts_.clear();
  supported_rest_.clear();
  hit_.clear();
  kept_apart_.clear();
  part_ = h;
  const Step step{world, step_length, h, pressing, memory, found};
  const auto& forces = memory.forces;
  std::size_t last = 0;
  const auto& pairs = near_pairs_.find(world, [&](BodyIndex i) { return reach_[i]; });
  neighbours_.build(n, pairs);
  for (const auto& [a, b] : pairs) {
    if (!world.can_collide(a, b)) continue;
    near_.emplace_back(a, b);
    const double rounding = kRounding * (world.shapes().size[a] + world.shapes().size[b] +
                                         world.trajectories.at_start(a).head<2>().lpNorm<1>() +
                                         world.trajectories.at_start(b).head<2>().lpNorm<1>());
    each_manifold(shapes, a, poses_[a], b, poses_[b], reach_[a] + reach_[b] + rounding,
                  [&, a = a, b = b](const Manifold& m) {
                    while (last < forces.size() && std::pair(forces[last].a, forces[last].b) < std::pair(a, b))
                      ++last;
                    add(step, a, b, where_tips_meet(world, a, b, exposed(step, a, b, m)), rounding, last);
                  });
  }
  found.contacts.resize(static_cast<int>(found.id.size()));
  // What has no support yet is left to the event queue.
  std::erase_if(found.landings,
                [&](const Landing& landing) { return !is_supported(world, landing.a, landing.b); });
}

// A body that a fast one may hit within the step may go on as fast as that.
void ContactFinder::let_fast_bodies_push(World& world) {
  const auto is_fast = [&](BodyIndex i) {
    return !world.infinite_mass(i) && reach_[i] > kFast * world.shapes().size[i];
  };
  for (int push = 0; push < kPushes; ++push) {
    bool any = false;
    for (BodyIndex i{0}; i < world.bodies() && !any; ++i) any = is_fast(i);
    if (!any) return;
    std::vector<double>& pushed = pushed_reach_;
    pushed = reach_;
    for (const auto& [a, b] : near_pairs_.find(world, [&](BodyIndex i) { return reach_[i]; })) {
      if (!world.can_collide(a, b)) continue;
      if (is_fast(a) && !world.infinite_mass(b)) pushed[b] = std::max(pushed[b], reach_[a]);
      if (is_fast(b) && !world.infinite_mass(a)) pushed[a] = std::max(pushed[a], reach_[b]);
    }
    reach_.swap(pushed);
  }
}

// The points that no other part continues; past such an edge that part will be what supports a body that slides
// there, but not one that lands.
Manifold ContactFinder::exposed(const Step& step, BodyIndex a, BodyIndex b, const Manifold& m) {
  const World& world = step.world;
  const double size = pair_size(world.shapes(), a, b);
  const auto pose = [&](BodyIndex body) { return poses_[body]; };
  // Whether it is not a body that moves on at once that continues the surface.
  const auto stays = [&](const Contact& contact) {
    staying_.clear();
    for (const BodyIndex other : neighbours_.of_pair(world, a, b)) {
      const double speed = std::min(most_speed(world, a, other), most_speed(world, b, other));
      if (speed * step.h <= kFlush * size) staying_.push_back(other);
    }
    return on_internal_edge(world, a, b, contact, staying_, pose);
  };
  return exposed_points(world, a, b, m, neighbours_.of_pair(world, a, b), pose, [&](const Contact& continued) {
    if (continued.gap <= kFlush * size || (was_held(world, step.memory.forces, a, b) && stays(continued)))
      support(a, b, world.shapes().parts_or_first(m.parts, a, b), 0.0);
  });
}

// Tips that meet do so along the middle of their normals, as in impacts. What slides along a face past a corner
// that is flush with it has no contact there: the face beyond it will be what supports it.
Manifold ContactFinder::where_tips_meet(const World& world, BodyIndex a, BodyIndex b, const Manifold& m) const {
  const Geometry& shapes = world.shapes();
  // The one point that touches, or the ends of a stretch that is none.
  const double touching = kTogether * pair_size(shapes, a, b);
  const auto is_open = [&](int k) { return m.points[static_cast<std::size_t>(k)].gap > touching; };
  const int at = is_open(0) ? 1 : 0;
  if (at >= m.count || is_open(at)) return m;
  const bool has_stretch =
      m.count == 2 && !is_open(1 - at) && (m.points[1].point - m.points[0].point).norm() > touching;
  if (has_stretch) return m;
  const Contact contact = m.contact(at);
  const double closing = -world.parting_speed(a, b, contact);
  if (!(closing > 0.0)) return m;
  const ShapePair parts = shapes.parts_or_first(m.parts, a, b);
  const auto tips = tip_normals(shapes.shapes, parts.a, shapes.part_pose(a, parts.a, poses_[a]), parts.b,
                                shapes.part_pose(b, parts.b, poses_[b]));
  if (!tips) return m;
  const auto along = [&](const Vec2& normal) {
    return world.parting_speed(a, b, {contact.gap, normal, contact.point});
  };
  Manifold met = m;
  if (const auto normal = passes_along(*tips, along)) {
    if (std::abs(cross(*normal, m.normal)) > kTogether && closing * part_ > touching) met.count = 0;
    return met;
  }
  const Contact middle = contact_again(shapes, a, poses_[a], b, poses_[b], contact);
  const bool apart = (middle.point - contact.point).norm() > touching;
  if (apart || std::abs(cross(middle.normal, m.normal)) <= kTogether) return m;
  met.count = 1;
  met.normal = middle.normal;
  met.points[0] = {middle.point, middle.gap, m.points[static_cast<std::size_t>(at)].id};
  return met;
}

// Adds the points of a manifold that rest, and those that will land; `last` is the pair's first last force.
void ContactFinder::add(const Step& step, BodyIndex a, BodyIndex b, const Manifold& m, double rounding,
                        std::size_t last) {
  const World& world = step.world;
  FoundContacts& found = step.found;
  Contacts& c = found.contacts;
  const SurfaceLaw& material = world.material(m.contact(0), a, b);
  const PairInStep pair{a, b, material, is_located(world, a, b, material), rounding, last};
  const ShapePair parts = world.shapes().parts_or_first(m.parts, a, b);
  const double slip = kStuck * step.pressing.change_by_forces() + step.pressing.noise();
  bool hits_now = false;
  for (int k = 0; k < m.count; ++k) {
    const ManifoldPoint& at = m.points[static_cast<std::size_t>(k)];
    const int i = static_cast<int>(found.id.size());
    if (i == c.size()) c.resize(std::max(kFirstCapacity, 2 * i));
    set_place(c, i, {a, b}, m.normal, at, poses_[a].position, poses_[b].position);
    const Touch touch = look_at(step, pair, m, k, i);
    const double closing = -touch.velocity.normal;
    if (touch.supports) support(a, b, parts, touch.rest);
    if (touch.role == Touch::kLanding) found.landings.push_back({a, b, at.id});
    hits_now |= touch.hits_now;
    if (touch.role != Touch::kContact) continue;
    // A fast one that penetrates is projected out and left to the impacts at the step's end.
    const bool hits = !touch.slow && !pair.located;
    if (hits && passes_by(world, a, b, {m.contact(k), -closing})) continue;
    found.turned_away.push_back(stays_away(step, a, b, m, at.gap, closing, hits, rounding));
    found.returns.push_back(0.0);
    c.target[i] = touch.slow || hits ? -found.room(i) / step.h : -std::numeric_limits<double>::infinity();
    if (hits && (found.hits.empty() || found.hits.back() != std::pair(a, b))) found.hits.emplace_back(a, b);
    set_friction(world, c, i, material, m.parts);
    c.sticks[i] = std::abs(touch.velocity.tangential) <= slip ? 1 : 0;
    found.guess.emplace_back(Eigen::Vector3d::Zero());
    if (touch.before) {
      c.sticks[i] = step.memory.forces[*touch.before].sticks;
      found.guess.back() = step.memory.support[*touch.before];
    }
    found.old.push_back(touch.pressed_before ? 1 : 0);
    found.id.push_back(at.id);
    found.point.push_back(at.point);
    found.press.push_back(touch.press);
    found.rest.push_back(touch.rest);
    if (touch.slow) support(a, b, parts, touch.rest);
    if (!pair.located) keep_apart(a, b);
  }
  if (hits_now && !supported_.empty() && supported_.back() == std::pair(a, b))
    hit_.push_back(supported_.back());
}

// m: how much farther apart two parts are at the end than a point at this gap would be that goes on closing at
// this speed (m/s); 0 unless it would be closed by then.
double ContactFinder::stays_away(const Step& step, BodyIndex a, BodyIndex b, const Manifold& m, double gap,
                                 double closing, bool hits, double rounding) const {
  const double along_normal = gap - closing * step.h;
  if (!(gap > rounding) || !(along_normal < 0.0)) return 0.0;
  // Contact forces may hold what is slow against all other forces.
  const double away = hits ? gap_in_flight(step.world, a, b, m.parts, step.h) - along_normal
                           : turned_away(step, a, b, m, along_normal, rounding);
  return away > rounding ? away : 0.0;
}

// m: how much farther from each other than along the normal of now, where they would be at the gap `along_it`
// (m), two parts are that go straight on for h s. As a disc passes a corner the normal turns away.
double ContactFinder::turned_away(const Step& step, BodyIndex a, BodyIndex b, const Manifold& m,
                                  double along_it, double rounding) const {
  const Geometry& shapes = step.world.shapes();
  const auto straight_on = [&](BodyIndex i) {
    const Motion from = step.world.trajectories.at_start(i);
    return shapes.pose(i, from.head<3>() + step.h * from.segment<3>(3));
  };
  Contact now;
  now.parts = m.parts;
  const double gap = contact_again(shapes, a, straight_on(a), b, straight_on(b), now).gap;
  return gap - along_it > rounding ? gap - along_it : 0.0;
}

void ContactFinder::keep_apart(BodyIndex a, BodyIndex b) {
  if (kept_apart_.empty() || kept_apart_.back() != std::pair(a, b)) kept_apart_.emplace_back(a, b);
}

void ContactFinder::support(BodyIndex a, BodyIndex b, const ShapePair& parts, double rest) {
  const std::tuple supported(a, b, parts.a, parts.b);
  if (supported_parts_.empty() || supported_parts_.back() != supported) supported_parts_.push_back(supported);
  if (supported_.empty() || supported_.back() != std::pair(a, b)) {
    supported_.emplace_back(a, b);
    supported_rest_.push_back(rest);
  }
  supported_rest_.back() = std::min(supported_rest_.back(), rest);
}

// Whether one of them supports the other or, where few move, another tile of the same floor does.
bool ContactFinder::is_supported(const World& world, BodyIndex a, BodyIndex b) const {
  if (std::binary_search(supported_.begin(), supported_.end(), std::pair(a, b))) return true;
  if (!moves_few(world) || world.infinite_mass(a) == world.infinite_mass(b)) return false;
  const auto [floor, mover] = world.infinite_mass(a) ? std::pair(a, b) : std::pair(b, a);
  return std::any_of(supported_.begin(), supported_.end(),
                     [&, floor = floor, mover = mover](const BodyPair& pair) {
                       return (pair.first == mover && world.stay_together(pair.second, floor)) ||
                              (pair.second == mover && world.stay_together(pair.first, floor));
                     });
}

bool ContactFinder::is_kept(const Landing& contact) const {
  return std::find(kept_.begin(), kept_.end(), contact) != kept_.end();
}

bool ContactFinder::supports(BodyIndex a, BodyIndex b, const ShapePair& parts) const {
  return std::binary_search(supported_parts_.begin(), supported_parts_.end(),
                            std::tuple(a, b, parts.a, parts.b));
}

bool ContactFinder::is_hit(BodyIndex a, BodyIndex b) const {
  return std::find(hit_.begin(), hit_.end(), std::pair(a, b)) != hit_.end();
}

// Bodies that stick do so where they meet.
bool ContactFinder::is_located(const World& world, BodyIndex a, BodyIndex b, const SurfaceLaw& law) const {
  if (world.method.impacts != ImpactsId::kLocated) return false;
  const auto presses = [&](BodyIndex i) {
    return !presses_.empty() && presses_[static_cast<std::size_t>(i)] != 0;
  };
  return (!presses(a) && !presses(b)) || law.sticks || is_fast(world, a, b, part_);
}

bool ContactFinder::needs_no_search(const World& world, BodyIndex a, BodyIndex b) const {
  if (std::binary_search(kept_apart_.begin(), kept_apart_.end(), std::pair(a, b)) &&
      !is_fast(world, a, b, part_))
    return true;
  const auto pair = std::lower_bound(supported_.begin(), supported_.end(), std::pair(a, b));
  if (pair == supported_.end() || *pair != std::pair(a, b) || is_hit(a, b)) return false;
  return most_speed(world, a, b) <= supported_rest_[static_cast<std::size_t>(pair - supported_.begin())];
}

}  // namespace carom
