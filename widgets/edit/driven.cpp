#include "widgets/edit/driven.h"

#include "physics/scene/edit_rules.h"

namespace carom {
namespace {

// Whether the body has a velocity that its drive did not have before.
bool was_pulled(const Body& body, const Drive& before) {
  return body.drive && has_own_velocity(body) && body.velocity == body.drive->velocity &&
         body.velocity != before.velocity;
}

Body stated(Body body, const Body& before, double time, bool at_start) {
  const bool pulled = was_pulled(body, *before.drive);
  if (body.drive) body.velocity = Vec2::Zero();
  if (body.position != moved_by_drive(before, time).position) {
    if (body.drive) body.position -= drive_position(*body.drive, Vec2::Zero(), time);
    return body;
  }
  if (at_start && !body.drive) return body;  // it stays where it is seen
  body.position = before.position;           // without rounding: it was not moved
  if (body.drive && (at_start || pulled))
    body.position -= time * (body.drive->velocity - before.drive->velocity);
  return body;
}

}  // namespace

SceneEdits as_stated(SceneEdits edits, const Scene& scene, double time, bool at_start) {
  for (SceneEdit& edit : edits) {
    auto* replace = std::get_if<Replace<Body>>(&edit);
    if (replace == nullptr) continue;
    const Body* before = part_of(scene.bodies, replace->part.id);
    if (before != nullptr && before->drive) replace->part = stated(replace->part, *before, time, at_start);
  }
  return edits;
}

}  // namespace carom
