#include "widgets/scene/allowed_place.h"

#include <algorithm>
#include <utility>

#include "physics/scene/edit_rules.h"
#include "widgets/scene/drag_limits.h"
#include "widgets/scene/edit_names.h"
#include "widgets/scene/joint_hold.h"

namespace carom {
namespace {

constexpr double kSame = 1e-9;     // of the lengths: less is rounding
constexpr double kScale = 1000.0;  // px/m: places are said to the millimetre

// The bodies that get another place or angle, before and after.
struct Moves {
  std::vector<Body> before;
  std::vector<Body> after;

  [[nodiscard]] bool has(const std::string& name) const {
    return std::any_of(before.begin(), before.end(), [&](const Body& body) { return body.name == name; });
  }
  // As one: all by the same way.
  [[nodiscard]] bool rigid() const {
    const Vec2 way = after[0].position - before[0].position;
    for (std::size_t i = 0; i < before.size(); ++i) {
      const Vec2 own = after[i].position - before[i].position;
      if (after[i].angle != before[i].angle && before.size() > 1) return false;
      if ((own - way).norm() > kSame * (way.norm() + before[i].position.norm())) return false;
    }
    return true;
  }
};

Moves moves_of(const Scene& scene, const SceneEdits& edits) {
  Moves moves;
  for (const SceneEdit& edit : edits) {
    const auto* replace = std::get_if<Replace<Body>>(&edit);
    const Body* was = replace == nullptr ? nullptr : part_of(scene.bodies, replace->part.id);
    if (was == nullptr || is_half_plane(was->shape)) continue;
    const Body& is = replace->part;
    if (was->position == is.position && was->angle == is.angle) continue;
    Body before = is;
    before.name = was->name;  // by which the joints know it
    before.position = was->position;
    before.angle = was->angle;
    moves.before.push_back(before);
    moves.after.push_back(is);
    moves.after.back().name = was->name;
  }
  return moves;
}

DragStart start_of(const Scene& scene, const Moves& moves) {
  const bool turns = moves.before[0].position == moves.after[0].position;
  DragStart start{.kind = turns ? HandleKind::kTurn : HandleKind::kBody,
                  .bodies = moves.before,
                  .others = {},
                  .press = moves.before[0].position};
  Surroundings beside{{}, scene.joints};
  std::copy_if(scene.bodies.begin(), scene.bodies.end(), std::back_inserter(beside.bodies),
               [&](const Body& body) { return !moves.has(body.name); });
  // What is joined to one of several that go their own ways does not follow.
  set_beside(start, std::move(beside), moves.rigid());
  return start;
}

const Body* named(const std::vector<Body>& bodies, const std::string& name) {
  const auto found = std::find_if(bodies.begin(), bodies.end(), [&](const Body& b) { return b.name == name; });
  return found == bodies.end() ? nullptr : &*found;
}

QString would_be(const std::string& name, const Joint& joint, double length) {
  const bool has_length = joint.kind == JointKind::kRod || joint.kind == JointKind::kString;
  const QString who = QString::fromStdString(name);
  if (has_length)
    return who + " would be " + small_length_text(length, {.scale = kScale, .snapping = false}) + ".";
  const std::string other = joint.to.empty() ? "the plane" : joint.to;
  return who + " holds " + QString::fromStdString(joint.body + " and " + other) + " together.";
}

// A joint between two of the bodies that would be broken; empty if there is none.
QString broken_pair(const Scene& scene, const Moves& moves, const std::vector<Body>& after) {
  const auto apart = [](const Joint& joint, const Body& body, const Body& to) {
    return (body.position + turned_by(body.angle, joint.point) - to.position -
            turned_by(to.angle, joint.anchor))
        .norm();
  };
  for (const Joint& joint : scene.joints) {
    const Body* body = named(after, joint.body);
    const Body* to = named(after, joint.to);
    if (body == nullptr || to == nullptr || !moves.has(joint.body) || !moves.has(joint.to)) continue;
    const double before = apart(joint, *named(moves.before, joint.body), *named(moves.before, joint.to));
    const double now = apart(joint, *body, *to);
    const double allowed = joint.length.value_or(before);
    const double rounding = kSame * (allowed + body->position.norm() + to->position.norm());
    if (now > allowed + rounding || (joint.kind != JointKind::kString && now < allowed - rounding))
      return would_be(name_for_people(joint, scene.joints), joint, now);
  }
  return {};
}

}  // namespace

AllowedPlace allowed_place(const Scene& scene, const SceneEdits& edits) {
  AllowedPlace out{edits, {}, {}};
  const Moves moves = moves_of(scene, edits);
  if (moves.before.empty() || scene.joints.empty()) return out;
  const DragStart start = start_of(scene, moves);
  Dragged asked;
  asked.bodies = moves.after;
  const Dragged kept = within_joints(start, asked, {.at = start.press, .scale = kScale});
  std::vector<Body> all = moves.before;
  all.insert(all.end(), start.followers.begin(), start.followers.end());
  const std::vector<Hold> holds = holds_of(all, {start.others, start.joints});
  std::vector<Body> wanted = moves.after;
  std::vector<Body> followers = start.followers;
  move_along(followers, moves.before[0], moves.after[0]);
  wanted.insert(wanted.end(), followers.begin(), followers.end());
  const auto broken =
      std::find_if(holds.begin(), holds.end(), [&](const Hold& hold) { return !keeps(hold, wanted); });
  const auto same = [](const Body& a, const Body& b) {
    return (a.position - b.position).norm() <= kSame * (1.0 + a.position.norm()) && a.angle == b.angle;
  };
  const bool stays =
      std::equal(moves.before.begin(), moves.before.end(), kept.bodies.begin(), same) && broken != holds.end();
  out.refusal = kept.blocked || stays ? would_be(broken->name, broken->joint, length_of(*broken, wanted))
                                      : broken_pair(scene, moves, kept.bodies);
  if (!out.refusal.isEmpty()) return out;
  if (broken != holds.end()) {
    const Body& body = kept.bodies[0];
    out.sentence =
        QString::fromStdString(broken->name + " holds " + body.name) + ": " +
        (start.kind == HandleKind::kTurn ? angle_text(body.angle) : place_text(body.position, kScale));
  }
  for (SceneEdit& edit : out.edits) {
    auto* replace = std::get_if<Replace<Body>>(&edit);
    const Body* was = replace == nullptr ? nullptr : part_of(scene.bodies, replace->part.id);
    const Body* held = was == nullptr ? nullptr : named(kept.bodies, was->name);
    if (held == nullptr) continue;
    const Body typed = std::exchange(replace->part, *held);
    replace->part.name = typed.name;
    if (typed.velocity != was->velocity) replace->part.velocity = typed.velocity;
  }
  for (std::size_t i = moves.before.size(); i < kept.bodies.size(); ++i)
    out.edits.emplace_back(Replace<Body>{kept.bodies[i]});
  return out;
}

}  // namespace carom
