#include "physics/step/penetrations.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "physics/step/apply_impact.h"
#include "physics/step/contact_patch.h"
#include "physics/step/internal_edges.h"
#include "physics/step/neighbours.h"
#include "physics/step/pair_motion.h"
#include "physics/step/run_clock.h"

namespace carom {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
// Whose pushes add up.
constexpr std::size_t kFewNeighbours = 5;
constexpr double kFewSteps = 4.0;
// Rounds of impacts in a step.
constexpr int kMostRounds = 16;

// The deepest point (m) of a part against this direction.
Vec2 lowest_point(const ConvexShapes& shapes, ShapeIndex part, const Pose& pose, const Vec2& direction) {
  const Corner* corner = shapes.corners_of(part);
  Vec2 lowest = pose.position + pose.turned(corner[0].vertex);
  for (int k = 1; k < shapes.corners[part]; ++k) {
    const Vec2 vertex = pose.position + pose.turned(corner[k].vertex);
    if (direction.dot(vertex - lowest) < 0.0) lowest = vertex;
  }
  return lowest - shapes.rounding[part] * direction;
}

// Where two parts overlap least is on an edge that a neighbour continues, as with a corner that has sunk where
// two boxes of a floor meet. Then they overlap the common surface: the contact with that face of either which
// they overlap least, of those that neighbours leave.
std::optional<Contact> contact_with_face(const World& world, BodyIndex a, BodyIndex b, const ShapePair& parts,
                                         std::span<const BodyIndex> others, const auto& pose) {
  const Geometry& g = world.shapes();
  const auto& [part_a, part_b] = parts;
  const Pose of_a = g.part_pose(a, part_a, pose(a));
  const Pose of_b = g.part_pose(b, part_b, pose(b));
  std::optional<Contact> least;
  for (const bool of_first : {true, false}) {
    const ShapeIndex owner = of_first ? part_a : part_b;
    const Pose& of_owner = of_first ? of_a : of_b;
    for (int k = 0; k < g.shapes.edges(owner); ++k) {
      const Corner& corner = g.shapes.corners_of(owner)[k];
      if (corner.length == 0.0) continue;
      const Vec2 out = of_owner.turned(corner.normal);
      const Vec2 normal = of_first ? out : Vec2(-out);
      const double gap = separation(g.shapes, part_a, of_a, part_b, of_b, normal);
      if (!(gap < 0.0) || (least && gap <= least->gap)) continue;
      const Vec2 deepest = lowest_point(g.shapes, of_first ? part_b : part_a, of_first ? of_b : of_a, out);
      Contact contact{gap, normal, deepest - 0.5 * gap * out};
      if (g.has_parts(a) || g.has_parts(b)) contact.parts = parts;
      if (!on_internal_edge(world, a, b, contact, others, pose)) least = contact;
    }
  }
  return least;
}

// How two parts overlap, and approach there; without a contact the gap is not negative.
Approach overlap_of(const World& world, BodyIndex a, BodyIndex b, const ShapePair& parts,
                    const Neighbours& neighbours) {
  Approach at = world.approach(a, b, 0.0, parts);
  if (!(at.contact.gap < 0.0) || !may_be_continued(world, a, b)) return at;
  const auto pose = [&](BodyIndex i) { return pose_at_start(world, i); };
  const std::span<const BodyIndex> others = neighbours.of_pair(world, a, b);
  if (!on_internal_edge(world, a, b, at.contact, others, pose)) return at;
  const auto has_plane = [&](ShapeIndex part) { return world.shapes().shapes.core[part] == Core::kHalfPlane; };
  std::optional<Contact> face;
  if (!has_plane(parts.a) && !has_plane(parts.b)) face = contact_with_face(world, a, b, parts, others, pose);
  if (!face) return {};
  at.contact = *face;
  at.speed = world.parting_speed(a, b, *face);
  return at;
}

// Whether two parts close and have overlapped before now: what comes to touch at the step's end, to rounding,
// or closes from then on by another's impact, meets in the next step. So the order of impacts does not hang on
// rounding.
bool has_met(const World& world, BodyIndex a, BodyIndex b, const Approach& at, double h) {
  return at.speed < 0.0 && at.contact.gap < kSameMoment * h * at.speed &&
         at.contact.gap < -touch_tolerance(world, a, b);
}

// Whether two bodies are discs that are apart, or move apart: what most pairs that are near each other do.
enum class Discs { kApart, kParting, kClosing, kNone };
Discs discs_of(const World& world, BodyIndex a, BodyIndex b) {
  const Geometry& g = world.shapes();
  if (!g.is_disc(a) || !g.is_disc(b)) return Discs::kNone;
  const auto ya = world.trajectories.at_start(a);
  const auto yb = world.trajectories.at_start(b);
  const Vec2 d = yb.head<2>() - ya.head<2>();
  const auto [part_a, part_b] = g.first_parts(a, b);
  const double touch = g.shapes.rounding[part_a] + g.shapes.rounding[part_b];
  const double distance = d.squaredNorm();
  if (distance >= touch * touch) return Discs::kApart;
  const Vec2 u = yb.segment<2>(3) - ya.segment<2>(3);
  return distance > 0.0 && d.dot(u) >= 0.0 ? Discs::kParting : Discs::kClosing;
}

bool are_discs_that_miss(const World& world, BodyIndex a, BodyIndex b) {
  const Discs discs = discs_of(world, a, b);
  return discs == Discs::kApart || discs == Discs::kParting;
}

// Whether two parts close faster than gravity presses bodies together in a few steps.
bool is_true_impact(const World& world, BodyIndex a, BodyIndex b, const Contact& contact, double h) {
  const double closing = -world.parting_speed(a, b, contact);
  double least = kFewSteps * h * world.model->forces.gravity.norm();  // m/s
  if (closing <= least) return false;
  for (const BodyIndex i : {a, b}) {
    const auto motion = world.trajectories.at_start(i);
    least += 16.0 * kEpsilon * (motion.segment<2>(3).norm() + std::abs(motion[5]) * world.shapes().size[i]);
  }
  return closing > least;
}

// What overlaps and closes, where a body that moves is in several pairs or one of a pair has several shapes:
// all, or those that the impacts of struck bodies have set off. With these also what touches, if the scene says
// so.
void find_hits(World& world, const std::vector<WaitingPair>& pairs, bool all, double h,
               PenetrationScratch& scratch) {
  const Neighbours& neighbours = scratch.neighbours;
  std::vector<Hit>& hits = scratch.in_order.hits;
  hits.clear();
  const auto has_others = [&](BodyIndex body) {
    return !world.infinite_mass(body) && neighbours.of(body).size() > 1;
  };
  const auto may_be_several = [&](BodyIndex a, BodyIndex b) {
    return has_others(a) || has_others(b) || world.shapes().has_parts(a) || world.shapes().has_parts(b);
  };
  const auto marks = [&](BodyIndex body) { return scratch.marks[static_cast<std::size_t>(body)]; };
  for (const auto& [a, b, resting] : pairs) {
    // Nothing is new between bodies that have not been stirred since.
    if (!all && (marks(a) | marks(b)) != PenetrationScratch::kBoth) continue;
    if (resting || !world.can_collide(a, b) || !may_be_several(a, b) || are_discs_that_miss(world, a, b))
      continue;
    world.shapes().each_parts(a, b, [&, a = a, b = b](ShapeIndex part_a, ShapeIndex part_b) {
      const Approach at = overlap_of(world, a, b, {part_a, part_b}, neighbours);
      if (has_met(world, a, b, at, h) && (all || is_true_impact(world, a, b, at.contact, h)))
        hits.push_back({a, b, at.contact, -at.contact.gap / at.speed});
    });
  }
  if (!takes_touches(world) || hits.empty()) return;
  for (const auto& [a, b, resting] : pairs) {
    if (resting || !world.can_collide(a, b)) continue;
    world.shapes().each_parts(a, b, [&, a = a, b = b](ShapeIndex part_a, ShapeIndex part_b) {
      const double tolerance = touch_tolerance(world, a, b);
      const Approach at = world.approach(a, b, tolerance, {part_a, part_b});
      if (at.contact.gap <= tolerance && !has_met(world, a, b, at, h)) hits.push_back({a, b, at.contact, 0.0});
    });
  }
}

// Before a round, the first or another: marks the bodies of its hits, and those that joints may move with them.
void mark_hits(const World& world, bool first, double h, PenetrationScratch& scratch) {
  const auto marks = [&](BodyIndex body) -> std::uint8_t& {
    return scratch.marks[static_cast<std::size_t>(body)];
  };
  for (std::uint8_t& of_body : scratch.marks) of_body &= PenetrationScratch::kStruck;
  for (const Hit& hit : scratch.in_order.hits) {
    const bool struck = !first || is_true_impact(world, hit.a, hit.b, hit.contact, h);
    for (const BodyIndex body : {hit.a, hit.b}) {
      if (world.infinite_mass(body)) continue;
      if (struck) marks(body) |= PenetrationScratch::kStruck;
      for (const BodyIndex member : world.trajectories.members(world.trajectories.island_of(body)))
        marks(member) |= PenetrationScratch::kStirred;
    }
  }
}

// The impacts of a step in the order in which they met, and in more rounds those that these set off. `now` is
// in s after the epoch.
void resolve_in_rounds(World& world, const std::vector<WaitingPair>& pairs, PenetrationScratch& scratch,
                       double h, double now, const std::function<void(const Hit&)>& strike_alone) {
  scratch.marks.assign(static_cast<std::size_t>(world.bodies()), 0);
  for (int round = 1; round <= kMostRounds; ++round) {
    find_hits(world, pairs, round == 1, h, scratch);
    if (scratch.in_order.hits.empty()) break;
    mark_hits(world, round == 1, h, scratch);
    const std::size_t welds = world.trajectories.welds().size();
    resolve_in_order(world, scratch.in_order, h, now, strike_alone);
    if (world.trajectories.welds().size() == welds) continue;
    // What sticks has moved, and others may continue its surface.
    for (std::uint8_t& marks : scratch.marks) marks |= PenetrationScratch::kStirred;
  }
}

// `with_energy`: enters the change of energy.
void move_apart(World& world, const Push& push, bool with_energy) {
  const auto& [a, b, by] = push;
  for (const BodyIndex i : {a, b}) {
    if (world.infinite_mass(i)) continue;
    const Vec2 x = world.trajectories.at_start(i).head<2>();
    const Vec2 moved = x + (i == a ? -1.0 : 1.0) * world.mass().inverse_mass[i] * by;
    if (with_energy) {
      world.sums.ledger.penetration_correction += world.field().potential_energy_of(i, moved, world.state.q) -
                                                  world.field().potential_energy_of(i, x, world.state.q);
    }
    world.trajectories.set_pose(i, {moved.x(), moved.y(), world.trajectories.at_start(i)[2]});
    world.state.q.col(i).head<2>() = moved;
    if (world.trajectories.is_jointed(i)) world.restore_joints(world.trajectories.island_of(i));
  }
}

// Of the pushes of a body with many others, together no more than those of one with kFewNeighbours.
double crowding(const World& world, const Neighbours& neighbours, BodyIndex a, BodyIndex b) {
  std::size_t most = kFewNeighbours;
  for (const BodyIndex body : {a, b}) {
    if (!world.infinite_mass(body)) most = std::max(most, neighbours.of(body).size());
  }
  return static_cast<double>(kFewNeighbours) / static_cast<double>(most);
}

}  // namespace

ImpactEffect resolve_penetrations(World& world, const std::vector<WaitingPair>& pairs,
                                  PenetrationScratch& scratch, double h) {
  ImpactEffect effect = ImpactEffect::kNone;
  if (pairs.empty()) return effect;
  Neighbours& neighbours = scratch.neighbours;
  neighbours.build(world.bodies(), pairs);
  Trajectories& trajectories = world.trajectories;
  const ForceField& field = world.field();
  double& correction = world.sums.ledger.penetration_correction;
  const double now = world.clock.step_end - trajectories.epoch();
  // Each push changes the energy of attraction to all bodies: for many pairs the sum is taken once.
  const bool all_at_once = field.attracts() && world.model->joint_terms.all.empty() &&
                           !world.model->surfaces.stick && pairs.size() > world.model->bodies();
  const auto strike_at = [&](const WaitingPair& pair, const Contact& contact, double speed) {
    const auto [a, b, resting] = pair;
    SurfaceLaw material = world.material(contact, a, b);
    // A closing speed from the forces of this step must not bounce; a true impact on a resting pair must.
    if (resting && -speed <= pressed_in(world, a, b, h)) material.restitution = 0.0;
    const ImpactEffect of_pair =
        apply_impact(world, a, b, pressed_contact(world, a, b, contact), material, now);
    effect = std::max(effect, of_pair);
    return of_pair;
  };
  // Two parts of a pair, if they penetrate; the contact at which they are to be moved apart.
  const auto strike = [&](const WaitingPair& pair, const ShapePair& parts) -> std::optional<Contact> {
    const auto [a, b, resting] = pair;
    if (!world.can_collide(a, b)) return std::nullopt;  // one body by now
    if (discs_of(world, a, b) == Discs::kApart) return std::nullopt;
    Approach at = overlap_of(world, a, b, parts, neighbours);
    const Contact contact = at.contact;
    if (contact.gap >= 0.0 || (!resting && at.speed < 0.0 && !has_met(world, a, b, at, h))) return std::nullopt;

    // Bodies with corners may penetrate at two points: one impact for the middle, then one for the point that
    // still approaches.
    const int most = world.shapes().is_disc(a) || world.shapes().is_disc(b) ? 1 : 3;
    for (int k = 0; k < most; ++k) {
      if (k > 0) at = world.approach(a, b, -contact.gap, parts);
      if (at.contact.normal != contact.normal) break;  // there a neighbour continues the surface
      if (!(at.speed < -16.0 * kEpsilon * at.scale)) break;
      if (strike_at(pair, at.contact, at.speed) == ImpactEffect::kJoined) return std::nullopt;
    }
    return contact;
  };
  const auto strike_alone = [&](const Hit& hit) {
    const auto& [a, b, contact, moment] = hit;
    if (!is_true_impact(world, a, b, contact, h)) return;
    if ((world.shapes().is_disc(a) || world.shapes().is_disc(b)) && !world.model->surfaces.stick) {
      // Where a disc touches does not depend on velocities, and nothing has moved.
      strike_at({a, b, false}, contact, 0.0);
    } else {
      strike({a, b, false}, world.shapes().parts_or_first(contact.parts, a, b));
    }
  };
  // By reference: a step allocates nothing.
  resolve_in_rounds(world, pairs, scratch, h, now, std::cref(strike_alone));

  if (all_at_once) correction -= field.potential_energy(world.state.q);
  scratch.pushes.clear();
  if (scratch.pushes.capacity() < pairs.size()) scratch.pushes.reserve(2 * pairs.size());
  for (const WaitingPair& pair : pairs) {
    const auto [a, b, resting] = pair;
    world.work.pass(1);
    if (!world.can_collide(a, b)) continue;
    const double share = world.mass().inverse_mass[a] + world.mass().inverse_mass[b];
    const double part = resting ? 1.0 : kPenetrationFraction * crowding(world, neighbours, a, b);
    world.shapes().each_parts(a, b, [&](ShapeIndex part_a, ShapeIndex part_b) {
      const std::optional<Contact> contact = strike(pair, {part_a, part_b});
      if (!contact) return;
      const Push push{pair.a, pair.b, part * -contact->gap / share * contact->normal};
      if (pair.resting) {
        move_apart(world, push, !all_at_once);
      } else {
        scratch.pushes.push_back(push);
      }
    });
  }
  for (const Push& push : scratch.pushes) move_apart(world, push, !all_at_once);
  if (all_at_once) correction += field.potential_energy(world.state.q);
  return effect;
}

}  // namespace carom
