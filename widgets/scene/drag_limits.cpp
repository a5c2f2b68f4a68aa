#include "widgets/scene/drag_limits.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "widgets/edit/driven.h"
#include "widgets/scene/corner_drag.h"
#include "widgets/scene/edit_names.h"

namespace carom {
namespace {

constexpr int kTries = 64;        // places on the way back
constexpr double kShare = 1e-16;  // of the way: a shorter step is rounding
// Of a place: bodies that move by the same way to this rounding move as one.
constexpr double kRounding = 1e-14;

bool resizes(const DragStart& start) {
  return start.kind != HandleKind::kBody && start.kind != HandleKind::kTurn &&
         start.kind != HandleKind::kVelocity && start.kind != HandleKind::kSpin;
}

// Springs and forces stay where they are in the scene when a handle moves the centre of their body.
void keep_ends(const DragStart& start, Dragged& dragged) {
  if (!resizes(start)) return;
  const Body& body = start.bodies[0];
  const Vec2 moved = turned_by(-body.angle, dragged.bodies[0].position - body.position);
  dragged.attached = kept_ends({{}, start.forces.springs, start.forces.applied}, body.name, moved);
}

DragPoint finely(DragPoint point) {
  point.snapping = false;
  return point;
}

std::vector<Body> all_bodies(const DragStart& start) {
  std::vector<Body> bodies = start.bodies;
  if (!resizes(start)) bodies.insert(bodies.end(), start.followers.begin(), start.followers.end());
  return bodies;
}

// Followers are none that a resized body stays clear of, but those that it is joined to.
Surroundings surroundings_of(const DragStart& start) {
  Surroundings out{start.others, start.joints};
  if (resizes(start)) out.bodies.insert(out.bodies.end(), start.followers.begin(), start.followers.end());
  return out;
}

void say_value(const DragStart& start, const DragPoint& point, Dragged& dragged) {
  const Body& body = dragged.bodies[0];
  if (start.kind == HandleKind::kBody) {
    dragged.value = place_text(body.position, point.scale);
  } else if (start.kind == HandleKind::kCorner) {
    dragged.value = place_text(corner_at(body, start.corner), point.scale);
  } else if (resizes(start)) {
    dragged.value = size_text(body.shape, finely(point));
  }
}

QString name_of(const Hold& hold) { return QString::fromStdString(hold.name); }

bool keeps_length(const Hold& hold) {
  return hold.joint.kind == JointKind::kRod || hold.joint.kind == JointKind::kString;
}

void block(const DragStart& start, const Hold& hold, const DragPoint& point, Dragged& dragged) {
  const double length = length_of(hold, dragged.bodies);
  const Vec2 end = dragged.bodies[hold.body].position + turned_by(dragged.bodies[hold.body].angle, hold.point);
  const QString who = QString::fromStdString(dragged.bodies[hold.body].name);
  dragged.blocked = {hold.anchor, end};
  dragged.guides.clear();
  dragged.bodies = all_bodies(start);
  dragged.value = keeps_length(hold) ? name_of(hold) + " would be " + small_length_text(length, finely(point))
                                     : name_of(hold) + " holds " + who;
  dragged.detail = QStringLiteral("Let go: it stays. Ctrl: the joint gives way.");
  dragged.fault = true;
}

// The joint takes what the bodies need.
void refit(std::span<const Hold> holds, const DragPoint& point, Dragged& dragged) {
  for (const Hold& hold : holds) {
    if (keeps(hold, dragged.bodies)) continue;
    dragged.refits = true;
    dragged.detail = keeps_length(hold) ? name_of(hold) + " is " +
                                              small_length_text(length_of(hold, dragged.bodies), point) + " now"
                                        : name_of(hold) + " has a new place";
  }
  for (Joint& joint : dragged.joints) {
    for (const Hold& hold : holds) {
      if (hold.joint.id == joint.id) joint = refitted(hold, dragged.bodies);
    }
  }
  hold_velocities(dragged.bodies, holds);
}

// rad, by which a body that one rod alone holds goes round its other end; nothing for other holds.
std::optional<double> turn_about(const Hold& hold, std::span<const Hold> holds, const Body& from,
                                 const Body& to) {
  const auto holds_it = [&hold](const Hold& other) { return other.body == hold.body; };
  if (hold.moves.size() > 1 || std::count_if(holds.begin(), holds.end(), holds_it) > 1) return std::nullopt;
  if (hold.joint.kind != JointKind::kRod) return std::nullopt;
  const Vec2 before = from.position + turned_by(from.angle, hold.point) - hold.anchor;
  const Vec2 after = to.position + turned_by(to.angle, hold.point) - hold.anchor;
  return std::atan2(cross(before, after), before.dot(after));
}

// A bob that is moved keeps its speed along its circle.
void turn_velocities(const DragStart& start, std::span<const Hold> holds, std::vector<Body>& bodies) {
  const std::vector<Body> before = all_bodies(start);
  for (const Hold& hold : holds) {
    const Body& from = before[hold.body];
    Body& to = bodies[hold.body];
    if (const auto turn = turn_about(hold, holds, from, to))
      to.velocity = hold.velocity + turned_by(*turn, from.velocity - hold.velocity);
  }
  hold_velocities(bodies, holds);
}

void hold_by_joints(const DragStart& start, std::span<const Hold> holds, const DragPoint& point,
                    Dragged& dragged) {
  const auto broken =
      std::find_if(holds.begin(), holds.end(), [&](const Hold& hold) { return !keeps(hold, dragged.bodies); });
  if (broken == holds.end()) return turn_velocities(start, holds, dragged.bodies);
  if (is_forced(point)) return refit(holds, point, dragged);
  const auto bodies = held(all_bodies(start), dragged.bodies, holds, start.press);
  if (!bodies) return block(start, *broken, point, dragged);
  dragged.bodies = *bodies;
  turn_velocities(start, holds, dragged.bodies);
  dragged.guides.clear();
  say_value(start, point, dragged);
  dragged.detail = name_of(*broken) + " holds it. Ctrl: the joint gives way.";
}

// A body at the other end that moves too.
bool is_free_pair(const DragStart& start, const Hold& hold) {
  const std::string& other = hold.at_body ? hold.joint.to : hold.joint.body;
  return std::any_of(start.others.begin(), start.others.end(),
                     [&](const Body& body) { return body.name == other && !has_infinite_mass(body); });
}

void hold_motion(const DragStart& start, std::span<const Hold> holds, Dragged& dragged) {
  if (!hold_velocities(dragged.bodies, holds)) return;
  if (start.kind == HandleKind::kSpin) {
    dragged.value = spin_text(dragged.bodies[0].spin);
    dragged.detail = name_of(holds[0]) + " allows no other spin";
  } else {
    dragged.value = velocity_text(dragged.bodies[0].velocity, 2);
    const auto pair =
        std::find_if(holds.begin(), holds.end(), [&](const Hold& hold) { return is_free_pair(start, hold); });
    dragged.detail = name_of(holds[0]) + " allows no other direction";
    if (pair != holds.end()) {
      const std::string& other = pair->at_body ? pair->joint.to : pair->joint.body;
      dragged.detail = QString::fromStdString(dragged.bodies[pair->body].name + " moves only with " + other) +
                       ": select both";
    }
  }
}

bool move_as_one(const DragStart& start, std::span<const Body> before, std::span<const Body> after) {
  if (start.kind != HandleKind::kBody) return false;
  const Vec2 moved = after[0].position - before[0].position;
  for (std::size_t k = 1; k < before.size(); ++k) {
    const double rounding = kRounding * (before[k].position.norm() + after[k].position.norm());
    if ((after[k].position - before[k].position - moved).norm() > rounding) return false;
  }
  return true;
}

// Of the bodies with each other, as joints lead them different ways, or as each turns or grows by itself; not
// those that were there before.
std::vector<Overlap> own_overlaps(const DragStart& start, std::span<const Body> bodies) {
  const std::vector<Body> before = all_bodies(start);
  if (bodies.size() < 2 || move_as_one(start, before, bodies)) return {};
  const Surroundings alone{{}, start.joints};
  std::vector<Overlap> overlaps = overlaps_of(bodies, alone, true);
  if (overlaps.empty()) return overlaps;
  const std::vector<Overlap> old = overlaps_of(before, alone, true);
  std::erase_if(overlaps, [&old](const Overlap& each) {
    return std::any_of(old.begin(), old.end(), [&each](const Overlap& was) {
      return was.body.name == each.body.name && was.other.name == each.other.name;
    });
  });
  return overlaps;
}

void say_overlap(const DragStart& start, const DragPoint& point, Dragged& dragged) {
  if (dragged.fault) return;
  dragged.overlaps = overlaps_of(dragged.bodies, surroundings_of(start));
  const std::vector<Overlap> own = own_overlaps(start, dragged.bodies);
  dragged.overlaps.insert(dragged.overlaps.end(), own.begin(), own.end());
  if (dragged.overlaps.empty()) return;
  std::stable_sort(dragged.overlaps.begin(), dragged.overlaps.end(),
                   [](const Overlap& a, const Overlap& b) { return a.depth > b.depth; });
  const QString who = QString::fromStdString(start.bodies[0].name);
  dragged.value = overlap_text(dragged.overlaps[0], point);
  dragged.detail = is_forced(point) ? QStringLiteral("They stay so; play parts them.")
                   : resizes(start) ? "Let go: " + who + " shrinks until they touch. Ctrl: it stays."
                                    : "Let go: " + who + " moves out. Ctrl: it stays.";
  dragged.fault = true;
}

// On their way from the start, as joints allow it, the last place before the overlaps.
std::optional<std::vector<Body>> backed_off(const DragStart& start, std::span<const Body> bodies,
                                            const Surroundings& surroundings, std::span<const Hold> holds) {
  const std::vector<Body> from = all_bodies(start);
  std::optional<std::vector<Body>> last;
  const auto clear = [&](double share) {
    std::vector<Body> wanted = from;
    for (std::size_t k = 0; k < from.size(); ++k) {
      wanted[k].position += share * (bodies[k].position - from[k].position);
      if (start.kind == HandleKind::kTurn) wanted[k].angle += share * (bodies[k].angle - from[k].angle);
    }
    std::optional<std::vector<Body>> kept = held(from, wanted, holds, from[0].position);
    if (!kept || !overlaps_of(*kept, surroundings).empty() || !own_overlaps(start, *kept).empty()) return false;
    last = std::move(kept);
    return true;
  };
  double share = 1.0 - 1.0 / kTries;
  while (share > 0.0 && !clear(share)) share -= 1.0 / kTries;
  if (!last) return std::nullopt;
  for (double step = 0.5 / kTries; step > kShare; step *= 0.5) {
    if (clear(share + step)) share += step;
  }
  return last;
}

// The bodies moved out as one or, where joints do not let them or they are in each other's way, back along
// their own.
std::optional<std::vector<Body>> parted(const DragStart& start, std::span<const Body> bodies,
                                        const Surroundings& surroundings, std::span<const Hold> holds) {
  const bool clear_of_each_other = own_overlaps(start, bodies).empty();
  std::optional<std::vector<Body>> out;
  if (clear_of_each_other) out = moved_out(bodies, surroundings);
  if (clear_of_each_other && holds.empty()) return out;
  const bool kept =
      out && std::all_of(holds.begin(), holds.end(), [&](const Hold& h) { return keeps(h, *out); });
  if (!kept) out = backed_off(start, bodies, surroundings, holds);
  if (out) turn_velocities(start, holds, *out);
  return out;
}

// A corner on its straight way from where it was, the last place before the overlaps.
std::optional<Dragged> corner_backed_off(const DragStart& start, const Dragged& dragged,
                                         const Surroundings& surroundings, double scale) {
  const Vec2 from = corner_at(start.bodies[0], start.corner);
  const Vec2 way = corner_at(dragged.bodies[0], start.corner) - from;
  const auto clear = [&](double share) {
    return overlaps_of(with_corner(start, from + share * way, scale).bodies, surroundings).empty();
  };
  if (!clear(0.0)) return std::nullopt;
  double share = 0.0;
  for (double step = 0.5; step > kShare; step *= 0.5) {
    if (clear(share + step)) share += step;
  }
  return with_corner(start, from + share * way, scale);
}

std::optional<std::vector<Body>> shrunk(const DragStart& start, std::span<const Body> bodies,
                                        const Surroundings& neighbours, std::span<const Hold> holds) {
  std::vector<Body> less = grown_to_touch(start.bodies, bodies, neighbours);
  for (std::size_t k = 0; k < less.size(); ++k) {
    const Vec2 position = less[k].position;
    less[k] = resized(start.bodies[k], less[k].shape, start.keeps);
    less[k].position = position;
  }
  std::optional<std::vector<Body>> kept = held(start.bodies, less, holds, start.press);
  if (!kept || !overlaps_of(*kept, neighbours).empty()) return std::nullopt;
  return kept;
}

}  // namespace

void set_beside(DragStart& start, Surroundings beside, bool may_follow) {
  if (may_follow) start.followers = followers_of(start.bodies, beside);
  std::erase_if(beside.bodies, [&](const Body& body) {
    return std::any_of(start.followers.begin(), start.followers.end(),
                       [&](const Body& follower) { return follower.name == body.name; });
  });
  start.others = std::move(beside.bodies);
  start.joints = std::move(beside.joints);
}

Dragged within_joints(const DragStart& start, Dragged wanted, const DragPoint& point) {
  if (!resizes(start)) {
    std::vector<Body> followers = start.followers;
    move_along(followers, start.bodies[0], wanted.bodies[0]);
    wanted.bodies.insert(wanted.bodies.end(), followers.begin(), followers.end());
  }
  if (start.kind == HandleKind::kCorner) {  // the ends of joints stay where they are
    say_overlap(start, point, wanted);
    return wanted;
  }
  const std::vector<Hold> holds = holds_of(all_bodies(start), surroundings_of(start));
  for (const Hold& hold : holds) wanted.joints.push_back(hold.joint);
  if (start.kind == HandleKind::kVelocity || start.kind == HandleKind::kSpin) {
    hold_motion(start, holds, wanted);
    return wanted;
  }
  hold_by_joints(start, holds, point, wanted);
  keep_ends(start, wanted);
  say_overlap(start, point, wanted);
  return wanted;
}

std::optional<Dragged> without_overlaps(const DragStart& start, const Dragged& dragged,
                                        const DragPoint& point) {
  if (dragged.overlaps.empty()) return dragged;
  Dragged out = dragged;
  if (is_forced(point)) {
    out.value.prepend(QStringLiteral("⚠ "));
    return out;
  }
  const Surroundings neighbours = surroundings_of(start);
  const QString touching = "touches " + QString::fromStdString(dragged.overlaps[0].other.name);
  if (start.kind == HandleKind::kCorner) {
    std::optional<Dragged> back = corner_backed_off(start, dragged, neighbours, point.scale);
    if (back) back->detail = touching;
    return back;
  }
  const std::vector<Hold> holds = holds_of(all_bodies(start), neighbours);
  const std::optional<std::vector<Body>> bodies = resizes(start)
                                                      ? shrunk(start, dragged.bodies, neighbours, holds)
                                                      : parted(start, dragged.bodies, neighbours, holds);
  if (!bodies) return std::nullopt;
  out.bodies = *bodies;
  keep_ends(start, out);
  say_value(start, point, out);
  if (start.kind == HandleKind::kTurn) out.value = angle_text(out.bodies[0].angle);
  out.detail = touching;
  out.overlaps.clear();
  out.fault = false;
  return out;
}

SceneEdits edits_of(const Dragged& change, bool joints) {
  SceneEdits edits;
  for (const Body& body : change.bodies) edits.emplace_back(Replace<Body>{body});
  for (const Joint& joint : change.joints) {
    if (joints && joint.id.number != 0) edits.emplace_back(Replace<Joint>{joint});
  }
  edits.insert(edits.end(), change.attached.begin(), change.attached.end());
  return edits;
}

SceneEdits edits_as_seen(Dragged change, bool joints) {
  for (Body& body : change.bodies) body = driven_so(std::move(body));
  return edits_of(change, joints);
}

QString overlap_text(const Overlap& overlap, const DragPoint& point) {
  return QString::fromStdString(overlap.body.name) + " and " + QString::fromStdString(overlap.other.name) +
         " overlap by " + small_length_text(overlap.depth, finely(point));
}

}  // namespace carom
