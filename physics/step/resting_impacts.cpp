#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "physics/collision/time_of_impact.h"
#include "physics/collision/tip_on_face.h"
#include "physics/model/pair_size.h"
#include "physics/step/apply_impact.h"
#include "physics/step/coming_to_rest.h"
#include "physics/step/contact_patch.h"
#include "physics/step/internal_edges.h"
#include "physics/step/pair_motion.h"
#include "physics/step/resting_contacts.h"
#include "physics/step/run_clock.h"

// Impacts of bodies that contacts support: what closes too fast to rest rebounds by the law of impacts.
namespace carom {
namespace {

// Rounds of impacts in a step where they are not located in time. From kListed on also in the order of the
// list, in which impulses go farther in one round.
constexpr int kMostStrikes = 16;
constexpr int kListed = 8;
// Relative to the smaller body: less is left to the impacts at the step's end.
constexpr double kMovedIn = 1e-5;
// Times that a flight is halved in search of a point that its bodies have no longer at the end.
constexpr int kMostHalves = 30;

// All contacts that touch, beside the hits among them.
void add_touches(const World& world, const FoundContacts& found, std::vector<Hit>& hits) {
  const std::size_t count = hits.size();
  const Contacts& c = found.contacts;
  for (int i = 0; i < c.size(); ++i) {
    if (!world.can_collide(c.a[i], c.b[i]) || c.gap[i] > touch_tolerance(world, c.a[i], c.b[i])) continue;
    const auto end = hits.begin() + static_cast<std::ptrdiff_t>(count);
    if (std::any_of(hits.begin(), end, [&](const Hit& hit) { return hit.a == c.a[i] && hit.b == c.b[i]; }))
      continue;
    const auto k = static_cast<std::size_t>(i);
    const ShapePair parts = parts_at(world.shapes(), c.a[i], c.b[i], found.id[k]);
    hits.push_back({c.a[i], c.b[i], {c.gap[i], c.normal[i], found.point[k], parts}, 0.0});
  }
}

// Where neither part has an inside, the corner that lands on a face: within the step other corners may pass
// through, by the error of the forces that hold them, and then the parts' own contact is on the far side.
std::optional<TipOnFace> thin_tip_at_start(const World& world, const Landing& landing) {
  const auto& [a, b, id] = landing;
  const Geometry& g = world.shapes();
  const ShapePair parts = parts_at(g, a, b, id);
  if (g.shapes.has_inside(parts.a) || g.shapes.has_inside(parts.b)) return std::nullopt;
  return tip_on_face(g, a, pose_at_start(world, a), b, pose_at_start(world, b), id);
}

// Whether an impact between these surfaces does more than stop them.
bool leaves_or_sticks(const SurfaceLaw& law) { return law.restitution > 0.0 || law.sticks; }

// m: the largest gap where forces press one of these bodies against another one.
double held_apart(const World& world, const ContactMemory& memory, BodyIndex a, BodyIndex b) {
  double apart = 0.0;
  for (std::size_t i = 0; i < memory.support.size(); ++i) {
    const ContactForce& f = memory.forces[i];
    const auto has = [&f](BodyIndex body) { return f.a == body || f.b == body; };
    if (!(memory.support[i][0] > 0.0) ||
        !((has(a) && !world.is_immovable(a)) || (has(b) && !world.is_immovable(b))))
      continue;
    if (const auto contact = contact_at_start(world, {f.a, f.b, f.id})) apart = std::max(apart, contact->gap);
  }
  return apart;
}

}  // namespace

std::optional<LandingTime> RestingContacts::first_landing(World& world, double end) const {
  std::optional<LandingTime> first;
  double time = end;
  const Geometry& shapes = world.shapes();
  for (const Landing& landing : found_.landings) {
    const auto& [a, b, id] = landing;
    const double gone = shapes.size[a] + shapes.size[b];
    const std::optional<TipOnFace> thin = thin_tip_at_start(world, landing);
    const auto gap = [&, a = a, b = b, id = id](double t) {
      const Pose pose_a = shapes.pose(a, world.trajectories.place(a, t));
      const Pose pose_b = shapes.pose(b, world.trajectories.place(b, t));
      if (thin) return contact_on_line(shapes, a, pose_a, b, pose_b, *thin).gap;
      const Manifold m = manifold_of(shapes, a, pose_a, b, pose_b, id, std::numeric_limits<double>::infinity());
      const int k = point_with(m, id);
      return k >= 0 ? m.points[k].gap : gone;
    };
    const double at_start = gap(0.0);
    // A corner that has sunk in beside the end of a face is nearer to another one: it was on this face before.
    double until = time;
    double at_end = gap(until);
    double before = 0.0;
    for (int k = 0; at_end == gone && k < kMostHalves; ++k) {
      const double half = 0.5 * (before + until);
      const double there = gap(half);
      if (there < 0.0 || there == gone) {
        until = half;
        at_end = there;
      } else {
        before = half;
      }
    }
    if (!(at_end < 0.0 && at_end < at_start)) continue;
    double from = 0.0;
    double at_from = at_start;
    const double touching = touch_tolerance(world, a, b);
    if (at_start <= touching && at_start > -kMovedIn * smaller_size(world, a, b)) {
      // It hits now, or leaves and comes back; else bodies that were parted elsewhere have been moved into each
      // other here.
      if (hit_now(world, landing)) return LandingTime{landing, 0.0};
      for (int k = 0; at_from <= touching && k < kMostHalves; ++k) {
        from = 0.5 * until;
        at_from = gap(from);
        if (at_from > touching) break;
        until = from;
        at_end = at_from;
      }
      if (!(at_from > touching)) continue;
    }
    time = at_from > 0.0 ? bracketed_root(gap, from, at_from, until, at_end) : 0.0;
    first = {landing, time};
    if (time == 0.0) break;
  }
  return first;
}

std::optional<Contact> RestingContacts::hit_now(const World& world, const Landing& landing) const {
  const auto& [a, b, id] = landing;
  const auto pose = [&](BodyIndex i) { return pose_at_start(world, i); };
  const Manifold all =
      manifold_of(world.shapes(), a, pose(a), b, pose(b), id, std::numeric_limits<double>::infinity());
  const Manifold m =
      exposed_points(world, a, b, all, finder_.neighbours().of_pair(world, a, b), pose, [](const Contact&) {});
  const int k = point_with(m, id);
  if (k < 0) return std::nullopt;
  // The point that has landed, which need not be the deepest.
  const Contact contact = m.contact(k);
  const SurfaceLaw& material = world.material(contact, a, b);
  const double rest = rest_speed(world, a, b, contact.point, contact.normal, material.restitution);
  const double parting = world.parting_speed(a, b, contact);
  if (!(landing_speed(world, material, -parting) > rest) || passes_by(world, a, b, {contact, parting}))
    return std::nullopt;
  return contact;
}

bool RestingContacts::awaits(BodyIndex a, BodyIndex b) const {
  return std::any_of(found_.landings.begin(), found_.landings.end(), [&](const Landing& landing) {
    return landing.a == std::min(a, b) && landing.b == std::max(a, b);
  });
}

// Fills together_ with this landing and those at its moment whose bodies it moves, directly or through others;
// with nothing if they are of one pair, or if one rebounds.
void RestingContacts::list_landing_with(const World& world, const Landing& landing, const SurfaceLaw& law) {
  together_.assign(1, landing);
  const auto shares = [&](BodyIndex body, const Landing& other) {
    return !world.infinite_mass(body) &&
           (world.move_each_other(other.a, body) || world.move_each_other(other.b, body));
  };
  const auto is_listed = [&](const Landing& other) {
    return std::find(together_.begin(), together_.end(), other) != together_.end();
  };
  bool several = false;
  bool any_rebounds = leaves_or_sticks(law);
  for (std::size_t k = 0; k < together_.size() && !any_rebounds; ++k) {
    const Landing from = together_[k];
    for (const Landing& other : found_.landings) {
      if ((!shares(from.a, other) && !shares(from.b, other)) || is_listed(other)) continue;
      const std::optional<Contact> contact = hit_now(world, other);
      const double flush = kFlush * pair_size(world.shapes(), other.a, other.b);
      if (!contact || contact->gap > flush) continue;
      together_.push_back(other);
      several = several || other.a != landing.a || other.b != landing.b;
      any_rebounds = any_rebounds || leaves_or_sticks(world.material(*contact, other.a, other.b));
    }
  }
  if (!several || any_rebounds) together_.clear();
}

void RestingContacts::land(World& world, const LandingTime& landing) {
  const auto& [a, b, id] = landing.landing;
  const std::optional<Contact> contact = hit_now(world, landing.landing);
  if (!contact) return;
  const SurfaceLaw& law = world.material(*contact, a, b);
  list_landing_with(world, landing.landing, law);
  if (!together_.empty()) return;
  // A contact that is held touches, too: there the forces leave an error of the method.
  Contact touching = *contact;
  touching.gap = std::max(contact->gap, held_apart(world, memory_, a, b));
  apply_impact(world, a, b, pressed_contact(world, a, b, touching), law, landing.time);
}

// How two parts approach that rebound by the law of impacts, as they are faster than a contact may rest: in the
// middle of a face, or where an end of it still closes.
std::optional<Approach> RestingContacts::rebound(const World& world, BodyIndex a, BodyIndex b,
                                                 const ShapePair& parts) const {
  const double tolerance = touch_tolerance(world, a, b);
  const auto rebounds = [&](const Approach& at) {
    const SurfaceLaw& material = world.material(at.contact, a, b);
    return impact_speed(material, -at.speed) >
           rest_speed(world, a, b, at.contact.point, at.contact.normal, material.restitution);
  };
  Approach at = world.approach(a, b, tolerance, parts);
  if (rebounds(at)) return at;
  if (world.shapes().is_disc(a) || world.shapes().is_disc(b)) return std::nullopt;
  at = world.fastest_approach(a, b, tolerance, parts);
  if (rebounds(at)) return at;
  return std::nullopt;
}

// Where impacts are not located in time, pairs that would meet within the step rebound now by the law of
// impacts, before they can penetrate: in the order in which they would meet, those of one moment at once. In
// the next round so do those that close by then. What still closes after kMostStrikes rounds is stopped.
void RestingContacts::strike(World& world, double h) {
  if (found_.hits.empty()) return;
  struck_.assign(static_cast<std::size_t>(world.bodies()), 0);
  const auto pose = [&](BodyIndex i) { return pose_at_start(world, i); };
  // How two parts approach, if they would meet.
  const auto meeting = [&](BodyIndex a, BodyIndex b, const ShapePair& parts) -> std::optional<Approach> {
    const bool several = world.shapes().has_parts(a) || world.shapes().has_parts(b);
    if (!world.can_collide(a, b)) return std::nullopt;  // one body by now
    std::optional<Approach> at = rebound(world, a, b, parts);
    if (!at) return std::nullopt;
    // What comes to touch at the step's end, to rounding, meets in the next step.
    if (at->contact.gap > 0.0 && gap_in_flight(world, a, b, parts, h) > kSameMoment * h * at->speed)
      return std::nullopt;
    if (passes_by(world, a, b, *at)) return std::nullopt;
    if (several && on_internal_edge(world, a, b, at->contact, finder_.neighbours().of_pair(world, a, b), pose))
      return std::nullopt;
    return at;
  };
  // By body: in which round it was struck first, from 1 on; 0: not yet.
  const auto note_struck = [&](BodyIndex body, int round) {
    std::uint8_t& first = struck_[static_cast<std::size_t>(body)];
    if (first == 0) first = static_cast<std::uint8_t>(round);
  };
  const auto struck_before = [&](BodyIndex body, int round) {
    const std::uint8_t first = struck_[static_cast<std::size_t>(body)];
    return first != 0 && first < round;
  };
  // First those that would meet, then those that touch what was struck in an earlier round.
  const Contacts& c = found_.contacts;
  const auto each_pair = [&](int round, const auto& visit) {
    if (round == 1) {
      for (const auto& [a, b] : found_.hits) visit(a, b);
      return;
    }
    for (int i = 0; i < c.size(); ++i) {
      const bool again = i > 0 && c.a[i - 1] == c.a[i] && c.b[i - 1] == c.b[i];
      if (!again && (struck_before(c.a[i], round) || struck_before(c.b[i], round))) visit(c.a[i], c.b[i]);
    }
  };
  bool any = true;
  for (int round = 1; any && round <= kMostStrikes; ++round) {
    std::vector<Hit>& hits = in_order_.hits;
    hits.clear();
    each_pair(round, [&](BodyIndex a, BodyIndex b) {
      world.shapes().each_parts(a, b, [&](ShapeIndex part_a, ShapeIndex part_b) {
        const std::optional<Approach> at = meeting(a, b, {part_a, part_b});
        if (at) hits.push_back({a, b, at->contact, at->contact.gap / -at->speed});
      });
    });
    if (takes_touches(world) && !hits.empty()) add_touches(world, found_, hits);
    for (const Hit& hit : hits) {
      note_struck(hit.a, round);
      note_struck(hit.b, round);
    }
    any = !hits.empty();
    const auto strike_parts = [&](BodyIndex a, BodyIndex b, const ShapePair& parts) {
      const std::optional<Approach> at = meeting(a, b, parts);
      if (!at) return;
      apply_impact(world, a, b, pressed_contact(world, a, b, at->contact), world.material(at->contact, a, b),
                   0.0);
      note_struck(a, round);
      note_struck(b, round);
      any = true;
    };
    // By reference: a step allocates nothing.
    const auto strike_alone = [&](const Hit& hit) {
      strike_parts(hit.a, hit.b, world.shapes().parts_or_first(hit.contact.parts, hit.a, hit.b));
    };
    resolve_in_order(world, in_order_, h, 0.0, std::cref(strike_alone));
    if (round < kListed) continue;
    each_pair(round, [&](BodyIndex a, BodyIndex b) {
      world.shapes().each_parts(a, b, [&](ShapeIndex part_a, ShapeIndex part_b) {
        strike_parts(a, b, {part_a, part_b});
      });
    });
  }
}

// Surfaces that stick join also what has not hit them: what was put there, or has come there slowly.
void RestingContacts::join_what_rests(World& world) {
  if (!world.model->surfaces.stick) return;
  const Contacts& c = found_.contacts;
  for (int i = 0; i < c.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const bool touches = c.gap[i] <= touch_tolerance(world, c.a[i], c.b[i]);
    if (!touches || !(found_.press[k] > 0.0) || !world.can_collide(c.a[i], c.b[i])) continue;
    const ShapePair parts = parts_at(world.shapes(), c.a[i], c.b[i], found_.id[k]);
    const Contact contact{c.gap[i], c.normal[i], found_.point[k], parts};
    if (world.material(contact, c.a[i], c.b[i]).sticks) join_at_rest(world, c.a[i], c.b[i], contact);
  }
}

// Bodies that penetrate at the step's end and close faster than a contact may rest rebound by the law of
// impacts.
void RestingContacts::rebound_at_end(World& world, const std::vector<BodyPair>& pairs) const {
  const double now = world.clock.step_end - world.trajectories.epoch();
  const auto pose = [&](BodyIndex i) { return pose_at_start(world, i); };
  // Of two parts.
  const auto rebound_parts = [&](BodyIndex a, BodyIndex b, const ShapePair& parts) {
    ImpactEffect effect = ImpactEffect::kNone;
    const int most = world.shapes().is_disc(a) || world.shapes().is_disc(b) ? 1 : 3;
    for (int k = 0; k < most && effect != ImpactEffect::kJoined; ++k) {
      const std::optional<Approach> at = rebound(world, a, b, parts);
      if (!at || at->contact.gap >= 0.0) break;
      const SurfaceLaw& material = world.material(at->contact, a, b);
      if (!leaves_or_sticks(material)) break;
      if (may_be_continued(world, a, b) &&
          on_internal_edge(world, a, b, at->contact, finder_.neighbours().of_pair(world, a, b), pose))
        break;
      effect = apply_impact(world, a, b, pressed_contact(world, a, b, at->contact), material, now);
    }
    return effect;
  };
  for (const auto& [a, b] : pairs) {
    if (!world.can_collide(a, b)) continue;  // one body by now
    const bool one_surface = !world.shapes().has_parts(a) && !world.shapes().has_parts(b);
    if (one_surface && !leaves_or_sticks(world.material({}, a, b))) continue;
    ImpactEffect effect = ImpactEffect::kNone;
    world.shapes().each_parts(a, b, [&, a = a, b = b](ShapeIndex part_a, ShapeIndex part_b) {
      if (effect != ImpactEffect::kJoined) effect = rebound_parts(a, b, ShapePair{part_a, part_b});
    });
  }
}

}  // namespace carom
