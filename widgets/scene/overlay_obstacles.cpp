#include "widgets/scene/body_path.h"
#include "widgets/scene/overlay.h"

// What a bubble beside the mouse stands clear of.
namespace carom {
namespace {

constexpr std::size_t kMostStoodClearOf = 60;  // handles or ghosts: more leave no room anyway
constexpr double kSignReach = 11.0;            // px, of the sign of an overlap from its middle

void add_aim(const Aim& aim, const Camera& camera, Obstacles& out) {
  for (const std::vector<Vec2>& path : aim.paths) {
    for (std::size_t k = 1; k < path.size(); ++k)
      out.lines.emplace_back(camera.to_screen(path[k - 1]), camera.to_screen(path[k]));
  }
  for (const Body& body : aim.meeting) {
    if (!body.fixed) out.areas.push_back(body_path(body, camera));
  }
  out.texts.push_back(text_place(aim, camera));
}

}  // namespace

Obstacles obstacles_of(const Overlay& overlay, const Camera& camera) {
  Obstacles out;
  const auto add_arrow = [&](const Body& body) {
    const Vec2 tip = body.position + overlay.arrow_seconds * body.velocity;
    if (tip != body.position) out.lines.emplace_back(camera.to_screen(body.position), camera.to_screen(tip));
  };
  if (overlay.ghosts.size() > kMostStoodClearOf) return out;
  add_handles(overlay.handles, out);
  bool arrows = false;
  for (const Handle& handle : overlay.grips) arrows |= handle.kind == HandleKind::kVelocity;
  for (const Body& body : overlay.selected) {
    if (arrows) add_arrow(body);
  }
  for (const Overlay::Ghost& ghost : overlay.ghosts) {
    if (ghost.arrow) {
      add_arrow(ghost.body);
    } else {
      out.areas.push_back(body_path(ghost.body, camera));
    }
  }
  for (const Overlay::Link& link : overlay.links)
    out.lines.emplace_back(camera.to_screen(link.from), camera.to_screen(link.to));
  if (overlay.direction) out.texts.push_back(text_place(*overlay.direction));
  if (overlay.aim) add_aim(*overlay.aim, camera, out);
  return out;
}

Obstacles obstacles_of_names(const Overlay& overlay, const Camera& camera) {
  Obstacles out;
  if (overlay.grips.size() <= kMostStoodClearOf) add_handles(overlay.grips, out);
  for (const Vec2& at : overlay.signs) {
    const QPointF half(kSignReach, kSignReach);
    out.rects.emplace_back(camera.to_screen(at) - half, camera.to_screen(at) + half);
  }
  return out;
}

}  // namespace carom
