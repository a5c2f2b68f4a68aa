#pragma once

#include <cstddef>
#include <optional>

#include "physics/scene/part_id.h"
#include "widgets/scene/joint_tools.h"

namespace carom {

// The end of a part that the mouse reaches: of a rod, a string or a spring that on its `body`, 0, or the other
// one, 1; of a force its tip, 1. None of a pin or a weld. `metres_per_newton` is the length of arrows.
[[nodiscard]] std::optional<std::size_t> end_of_part_at(const Frame& frame, const Camera& camera,
                                                        const PartId& part, const QPointF& at,
                                                        double metres_per_newton);

// The part with this end at the mouse. A rod is as long as its ends are apart, a string at least; a spring
// keeps its rest length.
[[nodiscard]] Joined with_end_at_mouse(const JointSight& sight, const PartId& part, std::size_t end);

}  // namespace carom
