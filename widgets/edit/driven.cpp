#include "widgets/edit/driven.h"

#include "physics/scene/edit_rules.h"

namespace carom {

SceneEdits as_stated(SceneEdits edits, const Scene& scene, double time) {
  for (SceneEdit& edit : edits) {
    auto* replace = std::get_if<Replace<Body>>(&edit);
    if (replace == nullptr) continue;
    Body& body = replace->part;
    const Body* stated = part_of(scene.bodies, body.id);
    if (stated == nullptr || !stated->drive) continue;
    if (body.drive) body.velocity = Vec2::Zero();
    if (body.position == as_seen(*stated, time).position) {
      body.position = stated->position;  // without rounding: it was not moved
    } else if (body.drive) {
      body.position -= drive_position(*body.drive, Vec2::Zero(), time);
    }
  }
  return edits;
}

}  // namespace carom
