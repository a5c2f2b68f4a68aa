#pragma once

#include <optional>
#include <vector>

#include "physics/scene/part_id.h"
#include "widgets/edit/inspected.h"

namespace carom {

// What the inspector shows of a joint, a spring or a force.
struct InspectedPart {
  QString title;  // its name, or else "Rod 1", "Force on light"
  QString kind;   // "rod"
  std::vector<InspectedRow> rows;
};

// Nothing if the scene has no such part.
[[nodiscard]] std::optional<InspectedPart> inspected_part(const Scene& scene, const PartId& part);

// Buttons that open the parts of a scene, "Rod 1, from A to B"; the first ones of many.
[[nodiscard]] std::vector<InspectedRow> listed_parts(const Scene& scene);

}  // namespace carom
