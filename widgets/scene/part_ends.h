#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "physics/scene/part_id.h"
#include "widgets/scene/joint_tools.h"
#include "widgets/scene/scene_parts.h"

namespace carom {

// Of a force: where it acts.
inline constexpr std::size_t kFoot = 0;

// The end of a part that the mouse reaches: of a rod, a string or a spring that on its `body`, 0, or the other
// one, 1; of a force its foot, 0, or its tip, 1. None of a pin or a weld. `metres_per_newton` is the length of
// arrows.
[[nodiscard]] std::optional<std::size_t> end_of_part_at(const Frame& frame, const Camera& camera,
                                                        const PartId& part, const QPointF& at,
                                                        double metres_per_newton);

// The drag of an end. All that it makes comes from the scene in which it began, however that changes meanwhile.
class EndDrag {
 public:
  // `began` tells the frame, with its scene, and where the mouse was pressed; its `metres_per_newton` is the
  // length of arrows.
  EndDrag(const JointSight& began, const PartId& part, std::size_t end);

  // The part with this end at the mouse, and what an earlier place of it has changed beside it as it was. A rod
  // is as long as its ends are apart, a string at least; a spring keeps its rest length; the ends of a
  // force keep their distance from the mouse. Where it can't be, the edits put all back.
  [[nodiscard]] Joined to(const DragPoint& mouse);

  // The edits of an earlier place, once more.
  [[nodiscard]] SceneEdits with_others_back(SceneEdits edits);

  [[nodiscard]] const JointSight& began() const { return began_; }
  [[nodiscard]] const PartId& part() const { return part_; }
  [[nodiscard]] std::size_t end() const { return end_; }
  // The part as it was.
  [[nodiscard]] const PartLine& line() const { return line_; }

 private:
  JointSight began_;
  PartId part_;
  std::size_t end_;
  PartLine line_;
  std::vector<Body> changed_;  // as they were
};

}  // namespace carom
