#include "widgets/scene/scene_parts.h"

#include <algorithm>
#include <variant>

#include "physics/scene/edit_rules.h"
#include "widgets/scene/drawing_forces.h"
#include "widgets/scene/joint_tools.h"

namespace carom {
namespace {

constexpr double kReach = 6.0;  // px, of a click

const std::vector<Joint>& list_of(const Scene& scene, Id<Joint> /*id*/) { return scene.joints; }
const std::vector<Spring>& list_of(const Scene& scene, Id<Spring> /*id*/) { return scene.forces.springs; }
const std::vector<AppliedForce>& list_of(const Scene& scene, Id<AppliedForce> /*id*/) {
  return scene.forces.applied;
}

template <class Part>
const Part* find(const Scene& scene, Id<Part> id) {
  return part_of(list_of(scene, id), id);
}

std::optional<PartLine> line_of(const Frame& frame, const Joint& joint, double /*metres_per_newton*/) {
  PartLine line{place_of(frame, {joint.to, joint.anchor}), place_of(frame, {joint.body, joint.point})};
  const bool at_one_place = joint.kind == JointKind::kPin || joint.kind == JointKind::kWeld;
  if (at_one_place) line.from = line.to;
  return line;
}

std::optional<PartLine> line_of(const Frame& frame, const Spring& spring, double /*metres_per_newton*/) {
  return PartLine{place_of(frame, {spring.to, spring.anchor}), place_of(frame, {spring.body, spring.point})};
}

std::optional<PartLine> line_of(const Frame& frame, const AppliedForce& force, double metres_per_newton) {
  const Vec2 arrow = metres_per_newton * share_at(force, frame.time) * force.force;
  if (arrow.isZero(0.0)) return std::nullopt;
  const Vec2 from = place_of(frame, {force.body, force.point});
  return PartLine{from, from + arrow, true};
}

double distance_to(const PartLine& line, const Vec2& point) {
  const Vec2 along = line.to - line.from;
  const double square = along.squaredNorm();
  const double share = square > 0.0 ? std::clamp(along.dot(point - line.from) / square, 0.0, 1.0) : 0.0;
  return (point - line.from - share * along).norm();
}

}  // namespace

bool has_part(const Scene& scene, const PartId& part) {
  return std::visit([&](const auto& id) { return find(scene, id) != nullptr; }, part);
}

PartId newest_like(const Scene& scene, const PartId& part) {
  return std::visit(
      [&scene](auto newest) -> PartId {
        newest = {};
        for (const auto& each : list_of(scene, newest)) {
          if (each.id.number > newest.number) newest = each.id;
        }
        return newest;
      },
      part);
}

std::optional<PartLine> line_of(const Frame& frame, const PartId& part, double metres_per_newton) {
  if (!frame.scene) return std::nullopt;
  return std::visit(
      [&](const auto& id) -> std::optional<PartLine> {
        const auto* found = find(*frame.scene, id);
        return found == nullptr ? std::nullopt : line_of(frame, *found, metres_per_newton);
      },
      part);
}

std::optional<PartId> part_at(const Frame& frame, const Camera& camera, const QPointF& at,
                              double metres_per_newton) {
  if (!frame.scene) return std::nullopt;
  const Vec2 point = camera.to_world(at);
  std::optional<PartId> nearest;
  double distance = kReach / camera.scale;
  const auto look_at = [&](const auto& list) {
    for (const auto& part : list) {
      // A weld that a run makes has no id.
      const auto line = part.id.number == 0 ? std::nullopt : line_of(frame, part, metres_per_newton);
      if (!line || distance_to(*line, point) >= distance) continue;
      distance = distance_to(*line, point);
      nearest = part.id;
    }
  };
  look_at(frame.scene->joints);
  look_at(frame.scene->forces.springs);
  look_at(frame.scene->forces.applied);
  return nearest;
}

}  // namespace carom
