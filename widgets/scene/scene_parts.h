#pragma once

#include <QPointF>
#include <optional>

#include "physics/record/frame.h"
#include "physics/scene/part_id.h"
#include "widgets/scene/camera.h"

namespace carom {

// Where a part of the frame's scene is shown.
struct PartLine {
  Vec2 from = Vec2::Zero();  // m
  Vec2 to = Vec2::Zero();    // m; `from` of a pin or a weld
  bool arrow = false;        // of a force
};

[[nodiscard]] bool has_part(const Scene& scene, const PartId& part);
[[nodiscard]] inline auto number_of(const PartId& part) {
  return std::visit([](const auto& id) { return id.number; }, part);
}
// The last one of the same kind; of number 0 if there is none.
[[nodiscard]] PartId newest_like(const Scene& scene, const PartId& part);
// Nothing without a scene, and for a force that does not act now. `metres_per_newton` is the length of arrows.
[[nodiscard]] std::optional<PartLine> line_of(const Frame& frame, const PartId& part, double metres_per_newton);
// The part whose line is nearest to a point of the screen, and near enough for a click.
[[nodiscard]] std::optional<PartId> part_at(const Frame& frame, const Camera& camera, const QPointF& at,
                                            double metres_per_newton);

}  // namespace carom
