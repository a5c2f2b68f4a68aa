#include <algorithm>
#include <optional>
#include <vector>

#include "physics/contact/contact_velocity.h"
#include "physics/model/pair_size.h"
#include "physics/step/coming_to_rest.h"
#include "physics/step/contact_finder.h"
#include "physics/step/internal_edges.h"
#include "physics/step/pair_motion.h"

// Whether a point at which two bodies touch or nearly do is a contact of a step, a landing in it, or an impact.
namespace carom {
namespace {

// A cosine: a contact at the place of another of the last step, with about the same normal, goes on from it.
constexpr double kSameNormal = 0.95;

// Whether a point of a manifold takes over from one that was there a step before, though other features touch
// now: a corner has come to the end of an edge. One of other parts that is still there goes on itself.
bool continues(const World& world, const Manifold& m, const ManifoldPoint& at, const ContactForce& force) {
  if (point_with(m, force.id) >= 0 ||
      (at.point - force.point).norm() > kSamePlace * smaller_size(world, force.a, force.b) ||
      m.normal.dot(force.normal) < kSameNormal)
    return false;
  if (parts_of(force.id) == parts_of(at.id)) return true;
  const Manifold own = manifold_of(world.shapes(), force.a, pose_at_start(world, force.a), force.b,
                                   pose_at_start(world, force.b), force.id, at.gap);
  return point_with(own, force.id) < 0;
}

// Which of the pair's last forces, from `first` on, such a point goes on from.
std::optional<std::size_t> force_before(const World& world, const std::vector<ContactForce>& forces,
                                        std::size_t first, BodyIndex a, BodyIndex b, const Manifold& m,
                                        const ManifoldPoint& at) {
  std::optional<std::size_t> before;
  for (std::size_t j = first; j < forces.size() && forces[j].a == a && forces[j].b == b; ++j) {
    if (forces[j].id == at.id) return j;
    if (continues(world, m, at, forces[j])) before = j;
  }
  return before;
}

}  // namespace

// What a point of a manifold does in this part of a step; i is its place among the contacts.
ContactFinder::Touch ContactFinder::look_at(const Step& step, const PairInStep& pair, const Manifold& m, int k,
                                            int i) const {
  const World& world = step.world;
  const auto& [a, b, material, located, rounding, last] = pair;
  const ManifoldPoint& at = m.points[static_cast<std::size_t>(k)];
  Touch touch;
  touch.velocity = contact_velocity(step.found.contacts, i, world.state.v);
  touch.press = step.pressing.between(world, step.memory, a, b, at.point, m.normal);
  touch.rest = step.pressing.rest_speed(world, touch.press, material.restitution);
  touch.before = force_before(world, step.memory.forces, last, a, b, m, at);
  const double closing = -touch.velocity.normal;
  const double rest = touch.rest;
  // A particle on a half-plane has no size.
  const double held = std::max(rounding, held_gap(world, a, b));
  const bool kept = is_kept({a, b, at.id});
  const bool follows = step.pressing.follows_bounces();
  touch.pressed_before = touch.before && step.memory.support[*touch.before][0] > 0.0;
  // What has opened since, without any force, comes back as a landing.
  if (follows && touch.pressed_before && at.gap > held)
    touch.pressed_before = step.memory.forces[*touch.before].normal_force > 0.0;
  const bool open = at.gap > (follows && touch.pressed_before ? held : rounding);
  const bool outside = at.gap > -held;
  // Explicit Euler leaves a gap where what a body rests on turns away, and closes it within the next step.
  const bool euler_in_time = located && world.method.integrator == IntegratorId::kExplicitEuler &&
                             step.memory.forces.size() <= static_cast<std::size_t>(kFewContactsOfScene);
  const double follows_on = euler_in_time && touch.pressed_before && open ? at.gap / step.length : 0.0;
  touch.slow = kept || impact_speed(material, closing - follows_on) <= rest;
  // Other contacts may press it within the step as hard as any force.
  const double pressed = step.pressing.pressed_speed(a, b, rest);
  const bool near =
      !located || !open ||
      (at.gap <= (std::max(closing, 0.0) + pressed) * step.length && closing <= kGentlyClosed * pressed);
  // What is about to land does so at its own moment, with all that lands then.
  const bool about_to_land = open && moves_few(world) && closing > rest;
  const double flush = std::max(rounding, kFlush * pair_size(world.shapes(), a, b));
  const bool comes_later = !touch.pressed_before && (at.gap > flush || about_to_land);
  const bool leaves = may_bounce(world, a, b, touch.pressed_before) && closing < -rest;
  // The event queue knows no pair that the error of the forces that held it has left inside, nor one that a hit
  // parts and forces on others bring back at once.
  touch.supports = follows && !open && outside && (at.gap < -rounding || (leaves && touch.pressed_before));
  const bool begins_later =
      follows ? outside && (comes_later || leaves) && !kept : euler_in_time && comes_later;
  // Without rebound what is as good as closed lands with all that does at this moment.
  const bool closed = !open || material.restitution == 0.0;
  const bool lands = follows && outside && !kept &&
                     ((!open && !touch.slow) ||
                      (closed && !touch.pressed_before && landing_speed(world, material, closing) > rest));
  // With impacts at their own time fast ones are left to the event queue.
  if (near && !begins_later && !lands && (!located || touch.slow || at.gap < -rounding)) {
    touch.role = Touch::kContact;
  } else if (begins_later || lands || (located && open && closing > rest)) {
    touch.role = Touch::kLanding;
  }
  touch.hits_now = touch.role != Touch::kContact && located && !open && !touch.slow && !lands;
  return touch;
}

}  // namespace carom
