#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <vector>

#include "widgets/edit/inspected.h"

namespace carom {

// The corners of a polygon: the body's own shape or, with a number, one of a compound. None of another shape.
// Where there are many they are listed if `unfolded` contains the name of their list. An edit of one leaves the
// others where they are.
[[nodiscard]] std::vector<InspectedRow> inspected_corners(const Scene& scene, const Body& body,
                                                          std::optional<std::size_t> shape,
                                                          const std::set<QString>& unfolded,
                                                          Keeps keeps = Keeps::kDensity);

}  // namespace carom
