#include "widgets/scene/allowed_motion.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "physics/scene/edit_rules.h"
#include "widgets/scene/drag_limits.h"
#include "widgets/scene/edit_names.h"
#include "widgets/scene/joined_velocities.h"
#include "widgets/scene/joint_hold.h"

namespace carom {
namespace {

using Names = std::unordered_set<std::string>;

constexpr double kSame = 1e-12;  // of the speeds

// The changed body with the motion that it has in the scene; nothing if the edit changes no motion.
std::optional<Body> with_motion_before(const Scene& scene, const SceneEdit& edit) {
  const auto* replace = std::get_if<Replace<Body>>(&edit);
  const Body* was = replace == nullptr ? nullptr : part_of(scene.bodies, replace->part.id);
  if (was == nullptr || has_infinite_mass(replace->part)) return std::nullopt;
  if (was->velocity == replace->part.velocity && was->spin == replace->part.spin) return std::nullopt;
  Body before = replace->part;
  before.velocity = was->velocity;
  before.spin = was->spin;
  return before;
}

DragStart start_of(const Scene& scene, const Body& body, const Names& changed) {
  DragStart start{.kind = HandleKind::kVelocity, .bodies = {body}, .others = {}};
  Surroundings beside;
  std::copy_if(scene.bodies.begin(), scene.bodies.end(), std::back_inserter(beside.bodies),
               [&](const Body& other) { return other.name != body.name; });
  std::copy_if(
      scene.joints.begin(), scene.joints.end(), std::back_inserter(beside.joints),
      [&](const Joint& joint) { return !changed.contains(joint.body) || !changed.contains(joint.to); });
  set_beside(start, std::move(beside));
  return start;
}

// Whether nothing is left of the change.
bool stays(const Body& before, const Body& wanted, const Body& kept) {
  const double speeds = before.velocity.norm() + wanted.velocity.norm();
  return kept.spin == before.spin && (kept.velocity - before.velocity).norm() <= kSame * speeds;
}

bool joins_changed(const Joint& joint, const Names& changed) {
  return joint.kind != JointKind::kString && changed.contains(joint.body) && changed.contains(joint.to);
}

// Joints between changed bodies take from both what they don't allow.
void hold_pairs(const Scene& scene, AllowedMotion& out) {
  std::vector<Body> bodies;
  for (const SceneEdit& edit : out.edits) {
    if (const auto* replace = std::get_if<Replace<Body>>(&edit)) bodies.push_back(replace->part);
  }
  const std::vector<Body> asked = bodies;
  const std::vector<std::size_t> broken = hold_joined_velocities(scene, bodies);
  bool some_left = false;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Body* was = part_of(scene.bodies, bodies[i].id);
    some_left = some_left || (was != nullptr && !stays(*was, asked[i], bodies[i]));
  }
  if (broken.empty() || !some_left) return;
  double most = 0.0;  // m/s
  auto held = bodies.begin();
  for (SceneEdit& edit : out.edits) {
    auto* replace = std::get_if<Replace<Body>>(&edit);
    if (replace == nullptr) continue;
    most = std::max(most, (held->velocity - replace->part.velocity).norm());
    replace->part = *held++;
  }
  out.name = name_of_velocity(asked, bodies);
  out.sentence = QString::fromStdString(name_for_people(scene.joints[broken[0]], scene.joints)) +
                 " allows no others: velocities change by up to " + fixed_text(most, 2) + " m/s";
}

}  // namespace

AllowedMotion allowed_motion(const Scene& scene, const SceneEdits& edits) {
  AllowedMotion out;
  // A body that the edits leave as it moves is stated too.
  Names changed;
  for (const SceneEdit& edit : edits) {
    if (const auto* replace = std::get_if<Replace<Body>>(&edit)) changed.insert(replace->part.name);
  }
  const bool moves = std::any_of(edits.begin(), edits.end(), [&](const SceneEdit& edit) {
    return with_motion_before(scene, edit).has_value();
  });
  for (const SceneEdit& edit : edits) {
    const std::optional<Body> before = with_motion_before(scene, edit);
    out.edits.push_back(edit);
    if (!before) continue;
    const Body& wanted = std::get<Replace<Body>>(edit).part;
    const DragStart start = start_of(scene, *before, changed);
    Dragged asked;
    asked.bodies = {wanted};
    const Dragged kept = within_joints(start, asked, {});
    if (stays(*before, wanted, kept.bodies[0])) continue;
    out.edits.pop_back();
    for (SceneEdit& each : edits_of(kept, false)) out.edits.push_back(std::move(each));
    if (kept.detail.isEmpty() || !out.sentence.isEmpty()) continue;
    out.name = name_of_velocity(start.bodies, kept.bodies);
    out.sentence = kept.detail + ": " + kept.value;
  }
  const bool pairs = moves && std::any_of(scene.joints.begin(), scene.joints.end(),
                                          [&](const Joint& joint) { return joins_changed(joint, changed); });
  if (pairs) hold_pairs(scene, out);
  return out;
}

}  // namespace carom
